#pragma once
#include <limits>

#include "pellucida/core/LatestValue.h"
#include "pellucida/core/PlainVector.h"
#include "pellucida/haptics/MotionMap.h"
#include "pellucida/teleoperation/TremorFilter.h"

namespace pellucida {

/// Tip motion per metre of hand motion, um: 10 mm of the hand are 100 um, 20 um, 5 um.
inline constexpr double kCoarseScale_um_per_m = 10000.0;
inline constexpr double kFineScale_um_per_m = 2000.0;
inline constexpr double kFinestScale_um_per_m = 500.0;

/// A box the target is kept in, frame W, um.
struct TargetBox {
  PlainVector3 lower_um{-kFree, -kFree, -kFree};
  PlainVector3 upper_um{kFree, kFree, kFree};

  static constexpr double kFree = std::numeric_limits<double>::infinity();
};

/// Settings the user may change while the hand moves. Trivially copyable.
struct TeleoperationSettings {
  /// Position: the tip follows the hand. Rate: the tip's speed follows how far the hand is from its centre, for devices
  /// that spring back (gamepad, SpaceMouse) and for long distances.
  enum class Control { kPosition, kRate };
  Control control = Control::kPosition;

  double scale_um_per_m = kFineScale_um_per_m;  ///< of position control, above 0
  double rate_um_per_s_per_m = 4000.0;          ///< of rate control: tip speed for a metre of deflection, above 0
  double dead_zone_m = 0.002;                   ///< of rate control: no motion within; speed starts from 0 at its edge

  /// Rate control: the device returns to its own centre by itself, which is then the centre of the control; the tip
  /// stays until the device has been within the dead zone once. False: the centre is where the hand was engaged.
  bool self_centring = false;
  double centring_N_per_m = 20.0;  ///< rate control: stiffness of the soft return, see `centring_force_N`
  double max_centring_force_N = 0.5;

  TargetBox box;
};

/// The same settings at another scale: position and rate control alike, whose rate is twice the scale each second.
inline TeleoperationSettings at_scale(TeleoperationSettings settings, double scale_um_per_m) noexcept {
  settings.scale_um_per_m = scale_um_per_m;
  settings.rate_um_per_s_per_m = 2.0 * scale_um_per_m;
  return settings;
}

/// Hand motion to tip motion: position or rate control, clutch, scales, tremor low-pass, all three axes at once.
///
/// Position control: tip = anchor + scale * (hand - hand's anchor), both in frame W. Clutch, engage and a change of
/// scale or control reset the two anchors, so none of them moves the target. Rate control: tip' = rate * shaped
/// deflection, the deflection less the dead zone.
///
/// `engage`, `update`, the getters: the 1 kHz thread. `request`: one other thread, wait-free.
class TeleoperationMap final : public MotionMap {
 public:
  explicit TeleoperationMap(const TeleoperationSettings& settings = {}, const TremorOptions& tremor = {});

  /// Throws UsageError for a scale, rate or dead zone out of range, or a box upside down.
  static void check(const TeleoperationSettings& settings);

  /// New settings from the window's thread, in force from the next update, without a jump. Throws as `check`.
  void request(const TeleoperationSettings& settings);

  /// The same with another tremor low-pass. Throws UsageError for a cut-off out of range too.
  void request(const TeleoperationSettings& settings, const TremorOptions& tremor);

  void engage(const HandSample& hand, const PlainVector3& tip_um) noexcept override;
  TipTarget update(const HandSample& hand, double dt_s) noexcept override;

  /// In rate control too, the scale converts forces at the cell into forces at the hand, though motion is not scaled by
  /// it.
  double scale_um_per_m() const noexcept override { return settings_.scale_um_per_m; }

  /// Rate control: the soft return of the hand to its centre, frame H, N: a spring, limited; zero in position control,
  /// in the dead zone and for devices that spring back by themselves. Added by the loop.
  PlainVector3 centring_force_N(const HandSample& hand) const noexcept;

  PlainVector3 hand_force_N(const HandSample& hand) const noexcept override { return centring_force_N(hand); }

  /// The origin of the hand's motion, frame H, m: the middle of the workspace after an engage there; every clutch moves
  /// it.
  const PlainVector3& centre_m() const noexcept { return centre_m_; }

  /// Lag of the tip behind slow hand motion due to the tremor low-pass.
  double lag_s() const noexcept { return filter_.lag_s(); }

 private:
  struct Request {
    TeleoperationSettings settings;
    TremorOptions tremor;
  };
  void apply(const Request& request, const HandSample& hand) noexcept;
  void anchor(const Eigen::Vector3d& hand_m) noexcept;
  Eigen::Vector3d clamped(const Eigen::Vector3d& tip_um) const noexcept;
  Eigen::Vector3d shaped_deflection_m(const Eigen::Vector3d& hand_m) const noexcept;

  TeleoperationSettings settings_;
  TremorOptions asked_tremor_;  ///< the requesting thread's
  LatestValue<Request> requested_;
  TremorFilter filter_;
  Eigen::Vector3d anchor_um_ = Eigen::Vector3d::Zero();  ///< tip that belongs to the hand at `centre_m_`
  Eigen::Vector3d tip_um_ = Eigen::Vector3d::Zero();
  PlainVector3 centre_m_;
  bool clutched_ = false;
  bool fresh_ = true;      ///< engaged since the last update: its target is the tip itself
  bool seen_rest_ = true;  ///< a self-centring device was within the dead zone since it was engaged
};

}  // namespace pellucida
