#include "pellucida/microscopy/OoplasmFlow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pellucida {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// How much the membrane's own motion counts at a ratio of the way to it.
float membrane_share(float ratio) noexcept {
  const float r2 = std::min(1.0f, ratio * ratio);
  return r2 * r2;
}

// The inverse of a rising table y(i) from 0 to a full turn: i, as a direction, at even steps of y.
template <class Value>
void invert(std::vector<float>& inverse, int count, Value value) {
  int i = 0;
  for (int k = 0; k <= count; ++k) {
    const double wanted = kTurn * k / count;
    while (i < count - 1 && value(i + 1) < wanted) ++i;
    const double low = value(i), high = value(i + 1);
    const double part = high > low ? std::clamp((wanted - low) / (high - low), 0.0, 1.0) : 0.0;
    inverse[static_cast<std::size_t>(k)] = static_cast<float>(kTurn * (i + part) / count);
  }
}

}  // namespace

void OoplasmFlow::update(const Contour_um& boundary, const Eigen::VectorXd& angle_rad) {
  // The centre: across, the area's centroid; along the axis, midway between the dimple and the far side, so that the
  // material before the needle is squeezed no more than need be.
  const Eigen::Index n = boundary.cols(), apex = n / 2;
  double area = 0, moment = 0;
  for (Eigen::Index i = 0, j = n - 1; i < n; j = i++) {
    const double cross = boundary(0, j) * boundary(1, i) - boundary(0, i) * boundary(1, j);
    area += cross / 2;
    moment += cross / 6 * (boundary(0, j) + boundary(0, i));
  }
  center_ = {moment / area, (boundary(1, apex) + boundary.row(1).minCoeff()) / 2};

  // From the apex round: each piece of the boundary fills the directions it spans. Directions count from that of +z;
  // the first and last entry are the same direction.
  auto direction_of = [&](Eigen::Index i) {
    const Eigen::Vector2d from = boundary.col(i % n) - center_;
    return std::pair(std::atan2(from.x(), from.y()), from.norm());
  };
  auto material_of = [&](Eigen::Index i) { return angle_rad(i % n) + (i >= n ? kTurn : 0.0); };
  auto [angle0, radius0] = direction_of(apex);
  double material0 = material_of(apex);
  for (Eigen::Index i = apex; i < apex + n; ++i) {
    auto [angle1, radius1] = direction_of(i + 1);
    angle1 = angle0 + std::remainder(angle1 - angle0, kTurn);
    const double material1 = material_of(i + 1);
    const int first = static_cast<int>(std::ceil(angle0 / kTurn * kCount));
    const int last = static_cast<int>(std::floor(angle1 / kTurn * kCount));
    for (int k = first; k <= last; ++k) {
      const double part = (kTurn * k / kCount - angle0) / (angle1 - angle0);
      const double turns = std::floor(static_cast<double>(k) / kCount);
      Direction& direction = directions_[static_cast<std::size_t>(((k % kCount) + kCount) % kCount)];
      direction.membrane_angle = static_cast<float>(material0 + part * (material1 - material0) - kTurn * turns);
      direction.radius_um = static_cast<float>(radius0 + part * (radius1 - radius0));
    }
    angle0 = angle1;
    radius0 = radius1;
    material0 = material1;
  }
  directions_[kCount] = directions_[0];
  directions_[kCount].membrane_angle += static_cast<float>(kTurn);

  // Deep inside the rest angle grows with the sector's area.
  double whole = 0;
  for (int k = 0; k < kCount; ++k) whole += std::pow(directions_[static_cast<std::size_t>(k)].radius_um, 2);
  double sector = 0;
  for (int k = 0; k <= kCount; ++k) {
    Direction& direction = directions_[static_cast<std::size_t>(k)];
    direction.angle = static_cast<float>(kTurn * sector / whole);
    sector += std::pow(direction.radius_um, 2);
  }
  invert(direction_inside_, kCount,
         [&](int k) { return static_cast<double>(directions_[static_cast<std::size_t>(k)].angle); });
  invert(direction_membrane_, kCount,
         [&](int k) { return static_cast<double>(directions_[static_cast<std::size_t>(k)].membrane_angle); });
}

OoplasmFlow::Rest OoplasmFlow::rest_of(float x_um, float z_um) const noexcept {
  float turns = std::atan2(x_um, z_um) * static_cast<float>(kCount / kTurn);
  if (turns < 0) turns += static_cast<float>(kCount);
  const Direction& direction = directions_[std::min<std::size_t>(static_cast<std::size_t>(turns), kCount)];
  const float ratio = std::sqrt(x_um * x_um + z_um * z_um) / direction.radius_um;
  return {ratio, direction.angle + (direction.membrane_angle - direction.angle) * membrane_share(ratio),
          direction.radius_um};
}

Eigen::Vector2f OoplasmFlow::place_of(float ratio, float angle) const noexcept {
  const float place = angle * static_cast<float>(kCount / kTurn);
  const auto k = std::min<std::size_t>(static_cast<std::size_t>(place), kCount - 1);
  const float part = place - static_cast<float>(k);
  auto between = [&](const std::vector<float>& table) { return table[k] + part * (table[k + 1] - table[k]); };
  const float inside = between(direction_inside_), membrane = between(direction_membrane_);
  const float direction = inside + (membrane - inside) * membrane_share(ratio);

  const float way = std::max(0.0f, direction) * static_cast<float>(kCount / kTurn);
  const auto d = std::min<std::size_t>(static_cast<std::size_t>(way), kCount - 1);
  const float radius_um = directions_[d].radius_um +
                          (way - static_cast<float>(d)) * (directions_[d + 1].radius_um - directions_[d].radius_um);
  return ratio * radius_um * Eigen::Vector2f(std::sin(direction), std::cos(direction));
}

}  // namespace pellucida
