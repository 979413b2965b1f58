#pragma once
#include <array>
#include <limits>

#include "pellucida/core/ContactModel.h"
#include "pellucida/haptics/HandMotion.h"
#include "pellucida/haptics/HapticRecord.h"
#include "pellucida/haptics/HapticSettings.h"
#include "pellucida/haptics/LimitLog.h"
#include "pellucida/haptics/MotionMap.h"
#include "pellucida/haptics/PassivityObserver.h"
#include "pellucida/haptics/Pipette.h"

namespace pellucida {

/// Input of a tick.
struct HapticInput {
  double now_s = 0.0;      ///< the run's clock
  double dt_s = 0.0;       ///< since the last tick; 0 at the first
  bool hand_read = false;  ///< the device delivered a reading
  HandSample hand;
  bool stop_requested = false;     ///< emergency stop, from anywhere; wins over the release
  bool release_requested = false;  ///< of the emergency stop, at the user's request
  bool let_go = false;             ///< the loop is about to end: pipette held, force released
};

/// Output of a tick.
struct HapticOutput {
  PlainVector3 force_N;  ///< for the device: frame H, finite, within its limits
  PipetteCommand command;
  HapticRecord record;
  LimitLog::Changes changes;  ///< limits that began or ceased to act
};

/// The computation of one tick, without thread, clock and device: hand and newest contact in, force and pipette's
/// command out. Order: emergency stop; reading of the hand checked; motion map; fixtures; cell guards; contact force at
/// the proxy; link; passivity; then, on the force: finite, low-pass, slope, saturation, finite.
///
/// The force on the hand, frame W, with the scales S_f (N/uN) and S_p (um/m):
///     F = g (S_f f_contact + F_fixtures + F_link) - alpha v
/// g fades in when the hand engages and out on clutch, loss and stop; alpha is the passivity controller's.
///
/// One thread at a time. Deterministic. No call allocates, locks, logs or throws.
class HapticStep {
 public:
  /// `map` must outlive the step. The settings must have no fault (`fault_of`).
  HapticStep(const DeviceSpecification& device, MotionMap& map, const HapticSettings& settings) noexcept;

  /// New settings; changed fixtures fade out and the new ones in.
  void set(const HapticSettings& settings) noexcept;
  void see(const ContactModel& model) noexcept;
  void see(const PipetteState& pipette) noexcept;

  HapticOutput compute(const HapticInput& input) noexcept;

  const HapticSettings& settings() const noexcept { return settings_; }

 private:
  // Intermediate results of a tick.
  struct Tick {
    Eigen::Vector3d hand_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d hand_velocity_m_per_s = Eigen::Vector3d::Zero();
    bool hand_good = false;
    bool tie_anew = false;
    double scale_um_per_m = 1.0;
    Eigen::Vector3d wanted_um = Eigen::Vector3d::Zero();
    FixtureResult fixtures;
    GuardOutput guard;  ///< the pipette's proxy
    GuardOutput felt;   ///< the hand's
    Eigen::Vector3d force_W_N = Eigen::Vector3d::Zero();
    std::uint32_t acting = 0;  ///< mask of limits
  };

  void act(Tick& tick, LimitKind kind, double value = 0.0, double limit = 0.0) noexcept;
  void latch_stop(const HapticInput& input, Tick& tick) noexcept;
  void read_hand(const HapticInput& input, Tick& tick) noexcept;
  HandState decide(const HapticInput& input, Tick& tick) noexcept;
  void tie(const HapticInput& input) noexcept;
  void move(const HapticInput& input, Tick& tick, HandState& state) noexcept;
  bool blind() const noexcept;
  bool just_punctured(double now_s) const noexcept;
  bool pushes(const TipTarget& target) const noexcept;
  void stand(Tick& tick) noexcept;
  void lead(const TipTarget& target, Tick& tick, GuardInput& guard) noexcept;
  void take_over(const HandSample& hand) noexcept;
  void feel(const HapticInput& input, Tick& tick, HandState state) noexcept;
  void fade_fixtures(double dt_s) noexcept;
  Eigen::Vector3d guarded_force_N(const HapticInput& input, Tick& tick) noexcept;
  void note_limits(const Tick& tick) noexcept;
  void fill(const HapticInput& input, const Tick& tick, HandState state, HapticOutput& output) noexcept;

  DeviceSpecification device_;
  MotionMap& map_;
  HapticSettings settings_;
  FixtureSet fixtures_;  ///< in force; the settings' own once faded over

  HandGuard hand_guard_;
  HandVelocity hand_velocity_;
  PipetteGuard pipette_guard_;
  CellGuards guards_;  ///< of the pipette's proxy
  CellGuards felt_;    ///< of the hand's
  ContactPredictor predictor_;
  VirtualCoupling coupling_;
  PassivityObserver passivity_;
  TipHistory history_;
  LimitLog limits_;

  PipetteState pipette_;
  bool pipette_known_ = false, pipette_jumped_ = false;
  bool stopped_ = false;
  bool tied_ = false;    ///< the map is tied to hand and proxy
  bool placed_ = false;  ///< the proxy is where the pipette is
  bool was_clutched_ = false;
  bool held_ = false;  ///< pipette held because the contact is unknown, or the membrane has just given way
  double punctured_s_ = -std::numeric_limits<double>::infinity();  ///< when it was seen to
  bool worked_ = false;                                            ///< the pipette has followed the hand before
  Eigen::Vector3d push_ = Eigen::Vector3d::Zero();
  ContactForce contact_;
  double force_scale_N_per_uN_ = 0.0;
  Eigen::Vector3d leading_force_N_ = Eigen::Vector3d::Zero();  ///< fixtures and link, when last engaged; frame W
  Ramp work_, fixture_part_;
  Eigen::Vector3d filtered_N_ = Eigen::Vector3d::Zero();  ///< frame H
  Eigen::Vector3d written_N_ = Eigen::Vector3d::Zero();   ///< frame H
};

}  // namespace pellucida
