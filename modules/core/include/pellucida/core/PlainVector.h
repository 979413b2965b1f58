#pragma once
#include <Eigen/Core>

namespace pellucida {

/// Three numbers that travel through wait-free exchanges, which copy bytes (Eigen's own vectors are not trivially
/// copyable). Compute with `eigen()`; store with the constructor.
struct PlainVector3 {
  double x = 0.0, y = 0.0, z = 0.0;

  PlainVector3() = default;
  PlainVector3(double x_value, double y_value, double z_value) noexcept : x(x_value), y(y_value), z(z_value) {}
  PlainVector3(const Eigen::Vector3d& v) noexcept : x(v.x()), y(v.y()), z(v.z()) {}  // NOLINT: meant to convert
  Eigen::Vector3d eigen() const noexcept { return {x, y, z}; }
  bool operator==(const PlainVector3&) const = default;
};

}  // namespace pellucida
