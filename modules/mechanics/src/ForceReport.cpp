#include "ForceReport.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ErrorBudget.h"
#include "NodalField.h"
#include "pellucida/mechanics/RevolvedContour.h"

namespace pellucida {
namespace {

/// The finite-element table is another model of one shape; so far from it (about 12 % of force) it has no opinion.
constexpr double kTableShapeDistance = 0.1;

double sphere_volume_um3(double radius_um) {
  return 4.0 / 3.0 * std::numbers::pi * std::pow(radius_um, 3);
}

}  // namespace

ForceReport::ForceReport(const CellProfile& profile, const ForceOptions& options)
    : profile_(profile),
      naive_readout_(options.naive_readout),
      tables_(profile.name),
      relaxing_(profile, options.hand_frequency_Hz) {}

// All forces go with the cell's scale, and with what relaxation leaves.
RelaxingContact::Force ForceReport::force_of(const SolvedFrame& frame, const ForceEstimate& estimate) {
  RelaxingContact::Force force;
  if (!frame.contact) return force;
  const double push_uN = frame.state.push_force_uN, stiffness_uN_per_um = frame.state.stiffness_uN_per_um;
  force.force_uN = frame.scale.ratio * std::max(0.0, frame.sizes.ratio * push_uN);
  force.stiffness_uN_per_um =
      frame.scale.ratio * std::max(0.0, frame.sizes.ratio * stiffness_uN_per_um + frame.sizes.slope_per_um * push_uN);
  if (!estimate.converged) return force;
  return relaxing_.advance(frame.observation.time_s, force.force_uN, force.stiffness_uN_per_um);
}

void ForceReport::write(const SolvedFrame& frame, ForceEstimate& estimate) {
  const CellModelCache& cell = frame.cell;
  const MembraneModel& model = cell.model();
  const Eigen::Matrix3Xd& x = cell.indenter().positions_um();
  const Eigen::Matrix3d& R = estimate.rotation_WC;

  // The shape, in the world.
  estimate.rest_um = (R * model.rest().points_um).colwise() + estimate.center_um;
  estimate.solved_um = (R * x).colwise() + estimate.center_um;
  estimate.triangles = model.rest().triangles;

  // The force with what makes it uncertain.
  const RelaxingContact::Force force = force_of(frame, estimate);
  if (frame.contact) {
    const double model_uN = std::max(0.0, frame.state.push_force_uN);
    fill_errors({profile_, cell, frame.placement, frame.scale, frame.depth_um, model_uN, force, frame.sizes}, estimate);
  }
  if (frame.touch_um > 0.0) {
    estimate.errors.scale_ratio = frame.scale.relative_sigma;
    estimate.errors.geometry_ratio = frame.cell.geometry().force_sigma_ratio();
  }
  const double scale_as_seen = frame.scale.ratio * force.ratio, scale = scale_as_seen * frame.sizes.ratio;
  fill_nodes(cell.indenter(), scale, frame.sizes.push_ratio / frame.sizes.ratio, frame.contact, estimate);

  // The outer surface encloses what it did at rest, but for the little the liquid gives.
  estimate.volume_um3 =
      sphere_volume_um3(cell.outer_radius_um()) * (frame.state.volume_um3 / model.volume().rest_volume_um3());
  estimate.pressure_Pa = scale_as_seen * frame.sizes.pressure_ratio * frame.state.pressure_Pa;

  // A model that isn't where the needle is says nothing of its force.
  if (!estimate.converged) return;
  const auto interval_by = [&](const ForceErrors& errors) {
    return frame.contact ? interval_95(force.force_uN, errors) : interval_of_touch(frame, errors);
  };
  const ForceInterval interval = interval_by(estimate.errors);
  estimate.depth_um = frame.depth_um;
  estimate.stiffness_uN_per_um = force.stiffness_uN_per_um;
  estimate.damping_uN_s_per_um =
      frame.contact ? force.damping_uN_s_per_um + damping_uN_s_per_um(cell.indenter(), profile_.damping_uN_s_per_um)
                    : 0.0;
  estimate.force_rate_uN_per_s = force.rate_uN_per_s;
  estimate.relaxed_force_uN = force.relaxed_uN;
  estimate.tip_force_uN = scale * (R * frame.state.tip_force_uN);
  const Eigen::Vector3d across = frame.state.tip_force_uN - frame.state.push_force_uN * model.setup().push;
  estimate.lateral_force_uN = scale * across.norm();
  estimate.contact_force_uN = force.force_uN;
  estimate.contact_force_lower_uN = interval.lower_uN;
  estimate.contact_force_upper_uN = interval.upper_uN;
  estimate.by_picture = interval_by(estimate.errors.of_picture());
  estimate.by_scale = interval_by(estimate.errors.of_scale());
  if (frame.contact) ask_others(frame, scale_as_seen, estimate);
}

// From nothing up to what the deepest touch that can't be told from none would take, its errors included.
ForceInterval ForceReport::interval_of_touch(const SolvedFrame& frame, const ForceErrors& errors) {
  if (frame.touch_um <= 0.0) return {};
  const double force_uN = frame.scale.ratio * frame.cell.rest_stiffness_uN_per_um() * frame.touch_um;
  const double upper_uN = interval_95(force_uN, errors).upper_uN;
  return {0.0, upper_uN, 0.5 * upper_uN / kSigmas95};
}

void ForceReport::ask_others(const SolvedFrame& frame, double scale, ForceEstimate& estimate) const {
  const MembraneModel& model = frame.cell.model();
  const MembraneSetup& setup = model.setup();
  const MembraneGeometry& geometry = frame.cell.built_geometry();
  const auto point_load =
      point_load_force_uN(profile_.young_modulus_kPa, profile_.poisson_ratio, setup.thickness_um, frame.depth_um,
                          frame.observation.dimple_radius_um, geometry.tip_radius_um);
  const double angle_rad = std::acos(std::clamp(setup.push.dot(setup.holder), -1.0, 1.0));
  const bool has_table =
      frame.cell.offset_um() == 0.0 && shape_distance(geometry, geometry_of(profile_)) < kTableShapeDistance;
  const auto table = has_table
                         ? tables_.force_uN(frame.depth_um, angle_rad, setup.mid_radius_um / profile_.mid_radius_um)
                         : std::nullopt;
  if (point_load) estimate.opinions.point_load_uN = scale * *point_load;
  if (table) estimate.opinions.table_uN = scale * *table;
  estimate.opinions.spread_percent = spread_percent(estimate.contact_force_uN, estimate.opinions);
  if (!naive_readout_) return;
  const Eigen::Matrix3Xd laid = lay_on_contour(model.rest(), frame.cell.indenter().positions_um(), frame.auditor);
  estimate.naive_force_uN = scale * naive_force_uN(model, laid);
}

}  // namespace pellucida
