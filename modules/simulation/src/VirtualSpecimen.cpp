#include "pellucida/simulation/VirtualSpecimen.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"

namespace pellucida {

VirtualSpecimen::VirtualSpecimen(const Scenario& scenario)
    : reference_(CellReference::load(scenario.cell.reference, scenario.tools.configuration)),
      puncture_(scenario.puncture),
      scale_(scenario.cell.size_scale) {
  // The membrane must never be asked for more than was computed.
  const double limit_um = scale_ * reference_.max_indentation_um();
  const bool punctures = puncture_.enabled && puncture_.indentation_um <= scenario.motion.indentation_um;
  const double deepest_um = punctures ? puncture_.indentation_um : scenario.motion.indentation_um;
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
  const double axis_rad = holder_rad + turn * (std::numbers::pi - reference_.holder_angle_rad());
  pose_.axis = {std::cos(axis_rad), std::sin(axis_rad)};
  pose_.across = turn * Eigen::Vector2d(pose_.axis.y(), -pose_.axis.x());
  pose_.center_um = {scenario.cell.center_x_um, scenario.cell.center_y_um};
}

SpecimenState VirtualSpecimen::advance(double tip_depth_um, double time_s) {
  SpecimenState now;
  now.tip_depth_um = tip_depth_um;

  // Has the membrane given way, or the needle left it?
  if (puncture_.enabled && puncture_time_s_ < 0 && tip_depth_um >= puncture_.indentation_um) {
    // At the moment the depth passed, between the last call and this one.
    const double way_um = tip_depth_um - last_depth_um_;
    const double left_ratio = last_time_s_ && way_um > 0 ? (tip_depth_um - puncture_.indentation_um) / way_um : 0.0;
    puncture_time_s_ = time_s - std::clamp(left_ratio, 0.0, 1.0) * (last_time_s_ ? time_s - *last_time_s_ : 0.0);
  }
  if (tip_depth_um <= 0) puncture_time_s_ = -1.0;
  last_time_s_ = time_s;
  last_depth_um_ = tip_depth_um;

  double depth_um = std::max(tip_depth_um, 0.0);
  if (puncture_time_s_ >= 0) {
    const double decay = std::exp(-(time_s - puncture_time_s_) / puncture_.relaxation_s);
    // The depth at the break is the scenario's.
    const double relaxed = puncture_.residual_um + (puncture_.indentation_um - puncture_.residual_um) * decay;
    depth_um = std::clamp(tip_depth_um, 0.0, relaxed);
    now.state = CellState::kPunctured;
  } else if (depth_um > 0) {
    now.state = CellState::kContact;
    // Lengths scale the shape, E stays: forces go with the square of the size.
    now.contact_force_uN = scale_ * scale_ * reference_.force_uN(depth_um / scale_);
    now.pressure_Pa = reference_.pressure_Pa(depth_um / scale_);
  }
  now.membrane_depth_um = depth_um;
  now.section = reference_.section(depth_um / scale_);
  now.section.outer_um *= scale_;
  now.section.inner_um *= scale_;
  return now;
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
  // V = pi * integral of x^2 dz over a half; the sign of x tells the half, and both are averaged.
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
