#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <type_traits>

#include "pellucida/haptics/CellStrength.h"
#include "pellucida/haptics/HapticDevice.h"
#include "pellucida/haptics/LimitEvent.h"
#include "pellucida/haptics/Pipette.h"

namespace pellucida {

/// The limits that protect the cell and the pipette. Trivially copyable. Force and depth are those of a mouse oocyte;
/// `limits_of` gives those of another kind.
struct CellLimits {
  double max_depth_um = kPunctureMargin * CellStrength{}.puncture_depth_um;  ///< indentation; in contact only
  double soft_depth_um = 5.0;  ///< the push slows this far before it, and the pipette is drawn back this far beyond
  double max_force_uN = kPunctureMargin * CellStrength{}.puncture_force_uN;  ///< of the cell on the needle
  double slow_ratio = 0.8;     ///< share of the largest force from which the push slows; held at it ...
  double retract_ratio = 1.2;  ///< ... and drawn back above this multiple of it
  double retract_speed_um_per_s = 50.0;

  double max_speed_um_per_s = 2000.0;         ///< of the tip
  double max_contact_speed_um_per_s = 500.0;  ///< of the tip along the push in contact
  PlainVector3 lower_um{-1e4, -1e4, -1e4};    ///< the box the tip may be in
  PlainVector3 upper_um{1e4, 1e4, 1e4};
  double max_lag_um = 60.0;  ///< the manipulator may lag by this much; beyond, the tip slows, and it stops at twice

  double blind_age_s = 0.25;  ///< no deeper when the newest usable frame is older (infinity: never)

  /// No deeper for this long after the membrane gave way; drawing back is free. The arm that leaned on it falls forward
  /// meanwhile, without the pipette.
  double puncture_hold_s = 0.4;

  double max_hand_speed_m_per_s = 5.0;          ///< anything faster is a jump of the reading
  double max_pipette_speed_um_per_s = 20000.0;  ///< the same for the manipulator's reports
  double pipette_age_limit_s = 0.5;             ///< without a report for this long the manipulator counts as lost
  double late_tick_s = 0.02;                    ///< a tick later than this re-anchors the motion
};
static_assert(std::is_trivially_copyable_v<CellLimits>);

/// The default limits with force and depth for a kind of cell: `kPunctureMargin` times its puncture's.
CellLimits limits_of(const CellStrength& cell) noexcept;

/// Input of the guards in a tick. Frame W.
struct GuardInput {
  Eigen::Vector3d wanted_um = Eigen::Vector3d::Zero();  ///< where hand and fixtures want the tip
  Eigen::Vector3d push = Eigen::Vector3d::Zero();       ///< direction of the needle's push; zero: unknown
  bool in_contact = false;
  double contact_force_uN = 0.0;
  double depth_um = 0.0;
  PipetteState pipette;
  double dt_s = 1e-3;
};

enum class GuardMode : std::uint8_t { kFollow, kSlow, kHold, kRetract };

struct GuardOutput {
  Eigen::Vector3d tip_um = Eigen::Vector3d::Zero();  ///< the proxy: where the pipette should be
  Eigen::Vector3d velocity_um_per_s = Eigen::Vector3d::Zero();
  GuardMode mode = GuardMode::kFollow;
  std::uint32_t limits = 0;  ///< mask of those that acted
};

/// Moves the pipette's proxy after the hand, within the limits: first slowed, then held, then drawn back against the
/// push. The proxy moves at most `max_speed_um_per_s` times dt a tick whatever happens, so its motion is continuous.
/// Drawing back is never limited by depth or force. The 1 kHz thread only; nothing allocates, locks or throws.
class CellGuards {
 public:
  explicit CellGuards(const CellLimits& limits = {}) noexcept : limits_(limits) {}
  void set(const CellLimits& limits) noexcept { limits_ = limits; }
  const CellLimits& limits() const noexcept { return limits_; }

  /// Sets the proxy: at the start, and to the pipette's position after a time without control.
  void place(const Eigen::Vector3d& tip_um) noexcept;
  const Eigen::Vector3d& tip_um() const noexcept { return tip_um_; }

  GuardOutput follow(const GuardInput& input) noexcept;

  /// The proxy does not move.
  GuardOutput hold() const noexcept;

  /// Draws the pipette back along the push at the retraction speed.
  GuardOutput retract(const GuardInput& input) noexcept;

 private:
  double push_part(const GuardInput& input, std::uint32_t& acting) noexcept;
  Eigen::Vector3d move(const Eigen::Vector3d& step_um, double dt_s, std::uint32_t& acting) noexcept;

  CellLimits limits_;
  Eigen::Vector3d tip_um_ = Eigen::Vector3d::Zero();
  bool retracting_ = false;
};

/// Accepts only reports a manipulator can make.
class PipetteGuard {
 public:
  enum class Report { kGood, kUnknown, kJump };
  Report check(const PipetteState& state, double max_speed_um_per_s) noexcept;

 private:
  PipetteState last_;
};

}  // namespace pellucida
