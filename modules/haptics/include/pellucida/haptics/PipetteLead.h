#pragma once
#include <Eigen/Core>

#include "pellucida/haptics/CellGuards.h"
#include "pellucida/haptics/Fixtures.h"
#include "pellucida/haptics/ForceGuards.h"
#include "pellucida/haptics/HapticSettings.h"
#include "pellucida/haptics/MotionMap.h"
#include "pellucida/haptics/VirtualCoupling.h"

namespace pellucida {

/// What leading the pipette came to in a tick. Frame W.
struct LeadOutput {
  Eigen::Vector3d wanted_um = Eigen::Vector3d::Zero();  ///< where the hand wants the tip, without smoothing
  GuardOutput pipette;                                  ///< the pipette's proxy: where it shall be
  GuardOutput hand;                                     ///< the hand's proxy: where the hand meets the cell
  FixtureResult fixtures;
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();  ///< of fixtures and link on the hand
};

/// How the hand leads the pipette: from the motion map through fixtures and the cell's guards to two proxies. The
/// pipette's proxy follows the map's smooth target, the hand's proxy the hand itself, which a smoothing map lags: a
/// force that lagged would make any contact swing. Without such a map the two are one place.
///
/// The 1 kHz thread only. Nothing allocates, locks or throws.
class PipetteLead {
 public:
  /// `map` must outlive it.
  PipetteLead(MotionMap& map, const HapticSettings& settings, const DeviceSpecification& device) noexcept;

  /// Changed fixtures fade out and the new ones in.
  void set(const HapticSettings& settings) noexcept;

  /// Puts the pipette's proxy there: it was out of our hands.
  void place(const Eigen::Vector3d& tip_um) noexcept { pipette_.place(tip_um); }
  /// Engages the hand as it is with the pipette as it is; link and fixtures start from nothing.
  void engage(const HandSample& hand) noexcept;
  /// The same with the hand already `ahead_um` beyond the pipette: so far it comes back before it takes the pipette.
  void engage_ahead(const HandSample& hand, const Eigen::Vector3d& ahead_um) noexcept;

  /// The map's scale for this tick; fixtures fade on.
  void begin_tick(double dt_s) noexcept;
  /// Where the hand wants the tip in this tick.
  TipTarget target(const HandSample& hand, double dt_s) noexcept { return map_.update(hand, dt_s); }

  // What comes of it, one a tick.

  /// Nobody leads: what link and fixtures gave last is left to fade out.
  LeadOutput rest() const noexcept;
  /// The hand takes the pipette where it is.
  LeadOutput take(const HandSample& hand) noexcept;
  /// The pipette is held, and the hand meets the fixtures there.
  LeadOutput hold() noexcept;
  LeadOutput retract(const HandSample& hand, const GuardInput& guard) noexcept;
  LeadOutput follow(const TipTarget& target, const Eigen::Vector3d& hand_velocity_m_per_s, GuardInput guard) noexcept;

  /// A force of the map's own on the hand, frame W, N.
  Eigen::Vector3d map_force_N(const HandSample& hand) const noexcept {
    return world_from_hand(map_.hand_force_N(hand)).eigen();
  }
  /// Between the hand and the pipette's proxy.
  VirtualCoupling& link() noexcept { return link_; }
  double scale_um_per_m() const noexcept { return scale_um_per_m_; }
  const Eigen::Vector3d& pipette_um() const noexcept { return pipette_.tip_um(); }
  const Eigen::Vector3d& hand_um() const noexcept { return hand_.tip_um(); }

 private:
  MotionMap& map_;
  FixtureSet wanted_fixtures_, fixtures_;  ///< as set; in force
  Ramp fixture_part_;
  CellGuards pipette_, hand_;
  VirtualCoupling link_;
  double scale_um_per_m_ = 1.0;
  Eigen::Vector3d force_N_ = Eigen::Vector3d::Zero();  ///< fixtures and link, as last led; frame W
};

}  // namespace pellucida
