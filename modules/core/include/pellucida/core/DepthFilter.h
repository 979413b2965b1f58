#pragma once
#include <Eigen/Core>
#include <optional>

namespace pellucida {

/// Kalman filter of the indentation with a constant-velocity model: no lag on a steady ramp, less noise on a hold. A
/// jump beyond what the model expects (start, stop, reversal of the needle) opens the filter instead of lagging behind.
class DepthFilter {
 public:
  struct Estimate {
    double depth_um = 0.0;  ///< >= 0
    double sigma_um = 0.0;  ///< standard deviation of what noise is left
  };

  /// `time_s` since the session's start, `sigma_um` > 0 of this measurement. Preconditions: finite numbers.
  Estimate update(double time_s, double depth_um, double sigma_um);
  void reset() { time_s_.reset(); }
  /// Where it expects the depth at `time_s`, um; nothing where it would begin anew.
  std::optional<double> expected_um(double time_s) const;

 private:
  std::optional<double> time_s_;
  Eigen::Vector2d state_ = Eigen::Vector2d::Zero();  // depth um, speed um/s
  Eigen::Matrix2d covariance_ = Eigen::Matrix2d::Identity();
};

}  // namespace pellucida
