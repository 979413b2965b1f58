#include "pellucida/operation/DepositTracker.h"

namespace pellucida {
namespace {

constexpr double kAwhile_s = 1.0;  // without a cell in view
constexpr double kAtDroplet_um = 2.0;

}  // namespace

void DepositTracker::see(const PipetteState& pipette, CellState state, const std::optional<Eigen::Vector2d>& center_um,
                         double time_s) {
  if (center_um) {
    center_um_ = *center_um;
    seen_s_ = time_s;
  } else if (time_s - seen_s_ > kAwhile_s) {
    forget();
  }
  if (!pipette.known) return;
  const double before_pL = expelled_pL_;
  expelled_pL_ = pipette.expelled_pL;
  if (before_pL < 0.0 || expelled_pL_ <= before_pL || !center_um || state != CellState::kPunctured) return;
  const Eigen::Vector3d center(center_um_.x(), center_um_.y(), 0.0);
  expel(expelled_pL_ - before_pL, pipette.tip_um.eigen() - center);
}

void DepositTracker::expel(double volume_pL, const Eigen::Vector3d& offset_um) {
  if (droplets_.empty() ||
      (offset_um - droplets_.back().center_um.eigen()).norm() > droplets_.back().radius_um() + kAtDroplet_um) {
    droplets_.push_back({PlainVector3(offset_um), 0.0});
  }
  droplets_.back().volume_pL += volume_pL;
}

std::vector<Droplet> DepositTracker::droplets() const {
  std::vector<Droplet> placed = droplets_;
  for (Droplet& droplet : placed) {
    droplet.center_um.x += center_um_.x();
    droplet.center_um.y += center_um_.y();
  }
  return placed;
}

}  // namespace pellucida
