#include "pellucida/mechanics/ContactModelBuilder.h"

#include <algorithm>
#include <cmath>

#include "pellucida/mechanics/ForceInterval.h"

namespace pellucida {
namespace {

PlainVector3 at_height_zero(const Eigen::Vector2d& v) noexcept {
  return {v.x(), v.y(), 0.0};
}

double at_least_zero(double value) noexcept {
  return std::isfinite(value) ? std::max(value, 0.0) : 0.0;
}

}  // namespace

ContactModel contact_model(const Observation& observation, const ForceEstimate& estimate, double arrival_s) noexcept {
  ContactModel model;
  model.time_s = arrival_s;
  model.frame_index = observation.frame_index;
  model.state = estimate.judged_state(observation.state);
  model.confidence = observation.confidence;
  model.depth_um = at_least_zero(estimate.depth_um);

  if (observation.outer) {
    model.cell_seen = true;
    model.center_um = at_height_zero(observation.center_um);
    model.outer_radius_um = observation.rest_outer_radius_um;
    model.inner_radius_um = observation.rest_inner_radius_um;
  }
  if (observation.holder) {
    model.holder_seen = true;
    model.holder_mouth_um = at_height_zero(observation.holder->mouth_um);
    model.holder_direction = at_height_zero(observation.holder->direction);
  }
  if (!observation.needle) return model;
  model.tip_um = at_height_zero(observation.needle->tip_um);
  model.push = at_height_zero(observation.needle->direction);

  if (!std::isfinite(estimate.contact_force_uN) || !estimate.tip_force_uN.allFinite()) return model;
  model.valid = true;
  if (model.state != CellState::kContact) return model;
  model.force_uN = PlainVector3(-estimate.tip_force_uN);
  model.force_sigma_uN =
      at_least_zero((estimate.contact_force_upper_uN - estimate.contact_force_lower_uN) / (2.0 * kSigmas95));
  model.stiffness_uN_per_um = at_least_zero(estimate.stiffness_uN_per_um);
  model.damping_uN_s_per_um = at_least_zero(estimate.damping_uN_s_per_um);
  return model;
}

}  // namespace pellucida
