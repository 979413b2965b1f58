#include "pellucida/simulation/StageMotion.h"

#include <cmath>
#include <numbers>

namespace pellucida {

Eigen::Vector2d StagePose::turn(const Eigen::Vector2d& direction) const {
  if (rotation_rad == 0.0) return direction;
  const double c = std::cos(rotation_rad), s = std::sin(rotation_rad);
  return {c * direction.x() - s * direction.y(), s * direction.x() + c * direction.y()};
}

Eigen::Vector2d StagePose::place(const Eigen::Vector2d& point_um) const {
  if (rotation_rad == 0.0) return point_um + shift_um;
  return pivot_um + turn(point_um - pivot_um) + shift_um;
}

SpecimenPose StagePose::place(const SpecimenPose& pose) const {
  return {place(pose.center_um), turn(pose.axis), turn(pose.across)};
}

StagePose stage_pose(const Scenario& scenario, double time_s) {
  const auto& drift = scenario.drift;
  StagePose pose;
  pose.shift_um = Eigen::Vector2d(drift.x_um_per_s * time_s, drift.y_um_per_s * time_s);
  // The epsilon forgives a product that falls short of a whole number.
  const bool knocked = std::fmod(std::floor(time_s / drift.jump_period_s + 1e-9), 2.0) == 1.0;
  if (knocked) pose.shift_um += scenario.image.pixel_size_um * Eigen::Vector2d(drift.jump_x_px, drift.jump_y_px);
  pose.rotation_rad = drift.rotation_deg_per_s * time_s * std::numbers::pi / 180;
  pose.pivot_um =
      scenario.image.pixel_size_um / 2 * Eigen::Vector2d(scenario.image.width_px - 1, scenario.image.height_px - 1);
  return pose;
}

double lamp_ratio(const Scenario::Lamp& lamp, double time_s) noexcept {
  const double step = time_s >= lamp.step_time_s ? lamp.step_ratio : 1.0;
  return step * (1 + lamp.flicker_ratio * std::sin(2 * std::numbers::pi * lamp.flicker_hz * time_s));
}

}  // namespace pellucida
