#include "MembraneBackdrop.h"

#include <cmath>
#include <limits>

namespace pellucida {
namespace {

// As far from the tip as its end is looked at, across and along.
constexpr double kReach_px = 60.0;

}  // namespace

void MembraneBackdrop::set(const Eigen::Matrix2Xd& outline, const EdgeTemplate& edge, double step_px,
                           const Eigen::Vector2d& tip, const Eigen::Vector2d& shift, double wrapped_px) {
  count_ = 0;
  const Eigen::Index n = outline.cols();
  if (!edge.valid() || n < 3) return;
  edge_ = &edge;
  step_px_ = static_cast<float>(step_px);
  shift_ = shift;
  points_.resize(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d p = outline.col(i) + shift;
    const double away = (p - tip).norm();
    if (away > kReach_px) continue;
    const Eigen::Vector2d along = outline.col(i + 1 == n ? 0 : i + 1) - outline.col(i == 0 ? n - 1 : i - 1);
    const double length = along.norm();
    if (!(length > 0.0)) continue;
    const double t = wrapped_px > 0.0 ? away / wrapped_px : std::numeric_limits<double>::infinity();
    const auto normal_x = along.y() / length, normal_y = -along.x() / length;
    points_[count_++] = {static_cast<float>(p.x()),
                         static_cast<float>(p.y()),
                         static_cast<float>(p.x()),
                         static_cast<float>(p.y()),
                         static_cast<float>(std::exp(-0.5 * t * t)),
                         static_cast<float>(normal_x),
                         static_cast<float>(normal_y),
                         EdgeTemplate::direction_of(normal_x, normal_y)};
  }
}

void MembraneBackdrop::push(const Eigen::Vector2d& way) noexcept {
  const auto x = static_cast<float>(way.x() - shift_.x()), y = static_cast<float>(way.y() - shift_.y());
  for (std::size_t i = 0; i < count_; ++i) {
    Point& p = points_[i];
    p.x = p.was_x + p.goes * x;
    p.y = p.was_y + p.goes * y;
  }
}

float MembraneBackdrop::at(const Eigen::Vector2d& p) const noexcept {
  if (count_ == 0) return 1.0F;
  const auto x = static_cast<float>(p.x()), y = static_cast<float>(p.y());
  float least = std::numeric_limits<float>::max();
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const float dx = points_[i].x - x, dy = points_[i].y - y, squared = dx * dx + dy * dy;
    if (squared < least) {
      least = squared;
      nearest = i;
    }
  }
  const Point& at = points_[nearest];
  return edge_->relative((x - at.x) * at.normal_x + (y - at.y) * at.normal_y, step_px_, at.direction);
}

}  // namespace pellucida
