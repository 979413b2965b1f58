#pragma once
#include <Eigen/Core>

namespace pellucida {

/// The guards between any computed force and the device, in this order, each a function of its own. Hand side, N.

/// True when all three numbers are finite. Checked before a filter's memory is changed, and again before the write.
bool is_finite(const Eigen::Vector3d& v) noexcept;

/// One step of a first-order low-pass of cut-off `cutoff_Hz` (above 0) by backward Euler: its delay at low frequency is
/// 1 / (2 pi cutoff). `previous` and `wanted` must be finite.
Eigen::Vector3d low_pass(const Eigen::Vector3d& previous, const Eigen::Vector3d& wanted, double cutoff_Hz,
                         double dt_s) noexcept;

/// `wanted`, or as far towards it from `previous` as `max_change` allows.
Eigen::Vector3d limit_change(const Eigen::Vector3d& previous, const Eigen::Vector3d& wanted,
                             double max_change) noexcept;

/// `wanted`, shortened to the length `limit` (>= 0).
Eigen::Vector3d saturate(const Eigen::Vector3d& wanted, double limit) noexcept;

/// 0 below 0, 1 above 1, a cubic between, with slope 0 at both ends.
double smooth_step(double x) noexcept;

/// A number that moves to its goal with a bounded slope; for fading forces in and out.
class Ramp {
 public:
  explicit Ramp(double value = 0.0) noexcept : value_(value) {}
  double value() const noexcept { return value_; }
  void set(double value) noexcept { value_ = value; }

  /// One step of `dt_s` towards `goal`; the whole way from 0 to 1 takes `time_s` (0: at once).
  double step(double goal, double time_s, double dt_s) noexcept;

 private:
  double value_;
};

}  // namespace pellucida
