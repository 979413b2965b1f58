#include "pellucida/simulation/VirtualSpecimen.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "SectionField.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"

namespace pellucida {

VirtualSpecimen::VirtualSpecimen(const Scenario& scenario)
    : sections_(std::make_unique<SectionField>(scenario.cell.reference, scenario.tools.configuration)),
      scale_(scenario.cell.size_scale),
      stiffness_ratio_(scenario.cell.stiffness_ratio) {
  // The membrane must never be asked for more than was computed.
  const auto& puncture = scenario.puncture;
  const double limit_um = scale_ * reference().max_indentation_um();
  const bool punctures = puncture.enabled && puncture.indentation_um <= scenario.motion.indentation_um;
  const double deepest_um = punctures ? puncture.indentation_um : scenario.motion.indentation_um;
  if (deepest_um > limit_um + 1e-9)
    throw UsageError("scenario '" + scenario.name + "': " + (punctures ? "puncture" : "motion") +
                     ".indentation_um is " + csv_number(deepest_um) + "; the reference of this cell ends at " +
                     csv_number(limit_um) + " um");

  // The needle's side follows from the holder's and the configuration. Mirrored: the other turn.
  const double holder_rad = scenario.tools.holder_angle_deg * std::numbers::pi / 180;
  const double turn = scenario.tools.mirrored ? -1.0 : 1.0;
  holder_direction_ = {std::cos(holder_rad), std::sin(holder_rad)};
  // The section has the holder along (sin phi, -cos phi) of (across, axis): solve for both with a right angle between
  // them.
  const double axis_rad = holder_rad + turn * (std::numbers::pi - reference().holder_angle_rad());
  pose_.axis = {std::cos(axis_rad), std::sin(axis_rad)};
  pose_.across = turn * Eigen::Vector2d(pose_.axis.y(), -pose_.axis.x());
  pose_.center_um = {scenario.cell.center_x_um, scenario.cell.center_y_um};

  const SpecimenForce::Frame frame{{pose_.center_um.x(), pose_.center_um.y(), 0.0},
                                   {pose_.axis.x(), pose_.axis.y(), 0.0},
                                   {pose_.across.x(), pose_.across.y(), 0.0},
                                   scale_,
                                   stiffness_ratio_};
  contact_ =
      SpecimenContact(SpecimenForce::load(scenario.cell.reference, scenario.tools.configuration, frame), scenario);
}

VirtualSpecimen::~VirtualSpecimen() = default;
VirtualSpecimen::VirtualSpecimen(VirtualSpecimen&&) noexcept = default;
VirtualSpecimen& VirtualSpecimen::operator=(VirtualSpecimen&&) noexcept = default;

const CellReference& VirtualSpecimen::reference() const noexcept {
  return sections_->reference();
}

double VirtualSpecimen::rest_z_um(double offset_um) const noexcept {
  // The configuration's own line meets it where the reference says, to the last digit.
  if (std::abs(offset_um - this->offset_um()) < 1e-9) return scale_ * reference().apex_z_um();
  const double radius_um = outer_radius_um();
  return std::sqrt(std::max(0.0, radius_um * radius_um - offset_um * offset_um));
}

SpecimenState VirtualSpecimen::show(const SpecimenMoment& moment) const {
  const SpecimenReply& reply = moment.reply;
  SpecimenState now;
  now.moment = moment;
  now.state = moment.state;
  now.tip_depth_um = reply.depth_um;
  now.tip_offset_um = reply.offset_um;
  now.tip_out_of_plane_um = reply.out_of_plane_um;
  now.membrane_depth_um = reply.indentation_um;
  now.contact_force_uN = reply.axial_force_uN;
  now.lateral_force_uN = reply.lateral_force_uN;
  now.in_range = reply.in_range;
  now.pressure_Pa = stiffness_ratio_ * reference().pressure_Pa(moment.pressure_depth_um / scale_);
  // Lengths scale the shape, E stays: forces go with the square of the size.
  now.apex_angle_rad = sections_->apex_angle_rad(reply.offset_um / scale_);
  now.section = sections_->at(reply.offset_um / scale_, reply.indentation_um / scale_);
  now.section.outer_um *= scale_;
  now.section.inner_um *= scale_;
  return now;
}

SpecimenState VirtualSpecimen::advance(const PlainVector3& tip_um, double time_s, double expelled_pL) {
  return show(contact_.advance(tip_um, time_s, expelled_pL));
}

SpecimenState VirtualSpecimen::advance(double tip_depth_um, double time_s) {
  // There and back through frame W costs a digit; the straight push needs it.
  SpecimenMoment moment = contact_.advance(force().tip_at(offset_um(), tip_depth_um), time_s);
  SpecimenReply& reply = moment.reply;
  const bool follows = reply.indentation_um == std::clamp(reply.depth_um, 0.0, force().max_indentation_um());
  reply.offset_um = offset_um();
  reply.out_of_plane_um = 0.0;
  reply.depth_um = tip_depth_um;
  if (follows) reply.indentation_um = std::clamp(tip_depth_um, 0.0, force().max_indentation_um());
  if (moment.state == CellState::kContact) {
    const double units = stiffness_ratio_ * scale_ * scale_;
    reply.axial_force_uN = units * reference().force_uN(reply.indentation_um / scale_);
    reply.lateral_force_uN = units * reference().lateral_force_uN(reply.indentation_um / scale_);
    moment.pressure_depth_um = reply.indentation_um;
  }
  return show(moment);
}

double dimple_radius_um(const Contour_um& outer) {
  // The apex is the middle point; from there each side climbs to its crest, the first highest point.
  const Eigen::Index n = outer.cols(), apex = n / 2;
  auto crest = [&](int direction) {
    Eigen::Index best = apex;
    for (Eigen::Index step = 1; step < n / 3; ++step) {
      const Eigen::Index i = apex + direction * step;
      if (outer(1, i) > outer(1, best) + 1e-9) best = i;
    }
    // The crest's place between points: the parabola through it and its neighbours.
    if (best == apex) return outer(0, apex);
    const double a = outer(1, best - 1), b = outer(1, best), c = outer(1, best + 1), curve = a - 2 * b + c;
    const double part = curve < 0 ? std::clamp(0.5 * (a - c) / curve, -0.5, 0.5) : 0.0;
    const double x_before = outer(0, best - 1), x_after = outer(0, best + 1);
    return outer(0, best) + part * (x_after - x_before) / 2;
  };
  return std::max(0.0, (crest(+1) - crest(-1)) / 2);
}

double revolved_volume_um3(const Contour_um& section) {
  // V = pi * integral of x^2 dz over a half; the sign of x gives the half, and both are averaged.
  double sum = 0;
  const Eigen::Index n = section.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d a = section.col(i), b = section.col((i + 1) % n);
    const double side = a.x() + b.x() >= 0 ? -1.0 : 1.0;
    sum += side * (b.y() - a.y()) * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x()) / 3;
  }
  return std::numbers::pi * std::abs(sum) / 2;
}

}  // namespace pellucida
