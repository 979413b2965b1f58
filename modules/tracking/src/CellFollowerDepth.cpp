// How far tip and membrane are past the resting membrane, and how surely; how sure the whole frame is.
#include <algorithm>
#include <cmath>

#include "CellFollower.h"
#include "Dent.h"

namespace pellucida {
namespace {

// The most confidence in what one way of seeing has shown: nothing independent confirms where the boundaries lie.
constexpr double kMostOfOneWay = 0.75;

// Standard deviations, px: of the resting outline along the needle, the membrane's uneven edge included; where it was
// not seen undisturbed; of the shift known from the far side of the cell alone.
constexpr double kRestSigma_px = 0.12, kUnknownSigma_px = 1.5, kFarSideSigma_px = 0.1;

}  // namespace

// How far the tip is past the resting membrane, px.
double CellFollower::tip_depth() const {
  const NeedleEstimate& n = needle_.estimate();
  return (n.tip - rest_.entry_point(center_now(), n.tip, n.direction)).dot(n.direction);
}

double CellFollower::measure_membrane_depth() const {
  if (!needle_.valid()) return 0.0;
  const NeedleEstimate& n = needle_.estimate();
  const Eigen::Vector2d entry = rest_.entry_point(center_now(), n.tip, n.direction);
  return first_crossing(snakes_.outer().points, entry, n.direction, 0.0);
}

void CellFollower::measure_dent() {
  dent_ = dent_ratio(snakes_.outer().points, center_now(), holder_ ? std::optional(holder_direction()) : std::nullopt);
  least_dent_ = std::min(least_dent_, dent_);
}

double CellFollower::membrane_sigma() const {
  if (!needle_.valid()) return 0.0;
  // The few points beside the axis share what the rigidity ties together: their mean sigma represents all.
  const NeedleEstimate& n = needle_.estimate();
  const SnakeContour& outer = snakes_.outer();
  double sum = 0.0;
  int count = 0;
  for (Eigen::Index i = 0; i < outer.points.cols(); ++i) {
    const Eigen::Vector2d d = outer.points.col(i) - n.tip;
    const double across = std::abs(n.direction.x() * d.y() - n.direction.y() * d.x());
    if (across > n.tip_half_width + 4.0 || (outer.points.col(i) - center_now()).dot(n.direction) > 0.0) continue;
    sum += outer.sigma_px[i];
    ++count;
  }
  return count > 0 ? sum / count : kUnknownSigma_px;
}

double CellFollower::rest_sigma() const {
  const double rest = rest_.seen_free ? kRestSigma_px : kUnknownSigma_px;
  const double rigid = rigid_.valid() ? rigid_.sigma_px(needle_.estimate().direction) : kFarSideSigma_px;
  return std::hypot(rest, rigid);
}

double CellFollower::depth_sigma() const {
  // Where the membrane under the needle is hidden, the tip that it wraps gives its depth.
  const double tip =
      needle_.valid() && needle_.estimate().tip_sigma > 0.0 ? needle_.estimate().tip_sigma : kUnknownSigma_px;
  return std::hypot(std::min(membrane_sigma(), tip), rest_sigma());
}

double CellFollower::confidence() const {
  const double sides = std::min(snakes_.outer().score, 0.3 + 0.7 * local_score());
  const double sudden = usual_quality_ > 0.0 ? std::clamp(quality_ / usual_quality_, 0.0, 1.0) : 1.0;
  const double first_sight = rest_.seen_free ? 1.0 : 0.7;
  const double most = is_read_ || is_doubtful_ ? kMostOfOneWay : 1.0;
  const double all = std::clamp(sides * sudden * sudden * first_sight * detection_score_, 0.0, most);
  return bad_frames_ > 0 ? 0.3 * all : all;
}

}  // namespace pellucida
