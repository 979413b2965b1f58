#pragma once
#include <Eigen/Core>

namespace pellucida {

/// How the tremor of the hand (8 to 12 Hz, 50 to 200 um at the hand) is removed from its motion.
struct TremorOptions {
  bool enabled = true;
  double rest_cutoff_Hz = 3.0;  ///< of the low-pass when the hand is slow; above 0
  /// Rise of the cut-off with the hand's mean speed, Hz per m/s: less lag in fast moves, where tremor does not matter.
  /// 0: a plain second-order low-pass.
  double cutoff_rise_Hz_s_per_m = 150.0;
  double max_cutoff_Hz = 20.0;
};

/// Second-order Butterworth low-pass of a point, whose cut-off follows the mean speed of the hand (the idea of Casiez,
/// Roussel, Vogel, "1 euro filter", CHI 2012, here of second order). The mean speed is low-passed at 1 Hz first, so
/// that tremor, whose velocity averages to zero, does not open the filter. Trapezoidal integration: stable while the
/// cut-off moves. Never allocates nor throws; a non-finite input is ignored.
class TremorFilter {
 public:
  explicit TremorFilter(const TremorOptions& options = {}) noexcept : options_(options) {}

  /// Starts at rest at `position_m`, without lag.
  void reset(const Eigen::Vector3d& position_m) noexcept;

  /// The next position, `dt_s` after the last; with `dt_s` of 0 or less nothing moves.
  void update(const Eigen::Vector3d& position_m, double dt_s) noexcept;

  const Eigen::Vector3d& position_m() const noexcept { return position_m_; }
  const Eigen::Vector3d& velocity_m_per_s() const noexcept { return velocity_m_per_s_; }

  double cutoff_Hz() const noexcept { return cutoff_Hz_; }

  /// Present lag of slow motion, sqrt(2) / (2 pi cut-off). 0 when off.
  double lag_s() const noexcept;

  const TremorOptions& options() const noexcept { return options_; }
  void set_options(const TremorOptions& options) noexcept { options_ = options; }

 private:
  TremorOptions options_;
  Eigen::Vector3d input_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d mean_velocity_m_per_s_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d band_ = Eigen::Vector3d::Zero();  ///< the two integrators' states
  Eigen::Vector3d low_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d position_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_m_per_s_ = Eigen::Vector3d::Zero();
  double cutoff_Hz_ = 3.0;
};

}  // namespace pellucida
