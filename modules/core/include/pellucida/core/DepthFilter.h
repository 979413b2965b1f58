#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>

namespace pellucida {

/// Filter of the indentation by two interacting models of how a needle moves (IMM; Blom and Bar-Shalom, IEEE Trans.
/// Autom. Control 33, 780, 1988): on as before, or changing its speed. Each is a Kalman filter of depth and speed; how
/// well they foretell what is measured says how far each counts. No lag on a steady ramp, less noise on a hold, and a
/// start, stop or reversal is followed within a frame or two, however vaguely the depth is measured.
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
  struct Motion {
    double share = 0.5;                               // 0..1: how likely it is
    Eigen::Vector2d state = Eigen::Vector2d::Zero();  // depth um, speed um/s
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
  };
  using Motions = std::array<Motion, 2>;
  static Motion mean_of(const Motions& motions);
  void interact();

  std::optional<double> time_s_;
  Motions motions_;
};

}  // namespace pellucida
