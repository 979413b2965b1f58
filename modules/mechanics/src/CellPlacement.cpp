#include "CellPlacement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// A needle's line that passes the centre nearer than this goes through it, as far as a tracker can tell.
constexpr double kCentred_um = 1.5;
/// A line that passes farther out than this, in radii, isn't the pushing needle's.
constexpr double kFarthest_ratio = 0.8;
/// How fast the line's offset, and the holder's direction, follow the tracker, per frame.
constexpr double kOffsetFollow = 0.2;
constexpr double kHolderFollow = 0.2;

Eigen::Vector3d in_plane(const Eigen::Vector2d& v) {
  return {v.x(), v.y(), 0.0};
}

bool is_direction(const Eigen::Vector2d& v) {
  return v.allFinite() && v.norm() > 0.5;
}

}  // namespace

void CellPlacement::update(const Observation& observation) {
  follow_needle(observation);
  const double sine = std::clamp(used_offset_um_ / observation.rest_outer_radius_um, -0.9, 0.9);
  const Eigen::Vector2d along = -axis_, left(-along.y(), along.x());
  const Eigen::Vector3d z = in_plane(-sine * left - std::sqrt(1.0 - sine * sine) * along);
  const Eigen::Vector3d y = Eigen::Vector3d::UnitZ();
  rotation_WC_.col(0) = y.cross(z);
  rotation_WC_.col(1) = y;
  rotation_WC_.col(2) = z;
  center_um_ = in_plane(observation.center_um);
  push_ = rotation_WC_.transpose() * in_plane(along);
  follow_holder(observation);
  holder_ = holder_W_ ? Eigen::Vector3d(rotation_WC_.transpose() * in_plane(*holder_W_)) : push_;
}

bool CellPlacement::enters_at_holder(double mouth_radius_um, double tip_radius_um,
                                     double cell_radius_um) const noexcept {
  if (holder_assumed()) return false;
  const double sine = std::min(1.0, (mouth_radius_um + tip_radius_um) / cell_radius_um);
  return holder_.z() > std::sqrt(1.0 - sine * sine);
}

void CellPlacement::follow_needle(const Observation& o) {
  if (!o.needle || !is_direction(o.needle->direction) || !o.needle->tip_um.allFinite()) return;
  if (is_direction(o.axis)) axis_ = o.axis.normalized();

  // How far beside the centre the needle's line runs: followed until contact, then kept.
  contact_ = needle_contact(o);
  const bool within = std::abs(contact_.offset_um) < kFarthest_ratio * o.rest_outer_radius_um;
  if (within && !offset_um_) offset_um_ = contact_.offset_um;
  if (within && o.state == CellState::kFree) *offset_um_ += kOffsetFollow * (contact_.offset_um - *offset_um_);
  if (offset_um_ && o.state == CellState::kContact) {
    slipped_um_ += kOffsetFollow * (contact_.offset_um - *offset_um_ - slipped_um_);
  }
  used_offset_um_ = offset_um_ && std::abs(*offset_um_) > kCentred_um ? *offset_um_ : 0.0;
}

void CellPlacement::follow_holder(const Observation& o) {
  // Smoothed while seen, remembered while hidden; from the other side it is another one.
  if (!o.holder || !is_direction(o.holder->direction)) return;
  const Eigen::Vector2d seen = o.holder->direction.normalized();
  const bool is_same = holder_W_ && seen.dot(*holder_W_) > 0.0;
  holder_W_ = is_same ? ((1.0 - kHolderFollow) * *holder_W_ + kHolderFollow * seen).normalized() : seen;
}

}  // namespace pellucida
