#pragma once
#include "pellucida/core/ContactModel.h"
#include "pellucida/haptics/CellContact.h"
#include "pellucida/haptics/Engagement.h"
#include "pellucida/haptics/HandForce.h"
#include "pellucida/haptics/HapticRecord.h"
#include "pellucida/haptics/HapticSettings.h"
#include "pellucida/haptics/LimitLog.h"
#include "pellucida/haptics/MotionMap.h"
#include "pellucida/haptics/Pipette.h"
#include "pellucida/haptics/PipetteLead.h"
#include "pellucida/haptics/Readings.h"

namespace pellucida {

/// Input of a tick.
struct HapticInput {
  double now_s = 0.0;      ///< the run's clock
  double dt_s = 0.0;       ///< since the last tick; 0 at the first
  bool hand_read = false;  ///< the device delivered a reading
  HandSample hand;
  bool stop = false;          ///< emergency stop, from anywhere; wins over its release
  bool release_stop = false;  ///< of the emergency stop, at the user's request
  bool release_hand = false;  ///< the loop is about to end: pipette held, force released
};

/// Output of a tick.
struct HapticOutput {
  PlainVector3 force_N;  ///< for the device: frame H, finite, within its limits
  PipetteCommand command;
  HapticRecord record;
  LimitLog::Changes changes;  ///< limits that began or ceased to act
};

/// The computation of one tick, without thread, clock and device: hand and newest contact in, force and pipette's
/// command out. In this order, each a class of its own:
///     emergency stop; hand and pipette checked (`HandReader`, `PipetteReader`); who leads (`Engagement`);
///     motion map, fixtures, cell guards, link (`PipetteLead`); contact at the hand's proxy (`CellContact`);
///     fading, passivity, finite, low-pass, slope, saturation, finite (`HandForce`).
///
/// The force on the hand, frame W, with the scales S_f (N/uN) and S_p (um/m):
///     F = g (S_f f_contact + F_fixtures + F_link) - alpha v
/// g fades in when the hand engages and out on clutch, loss and stop; alpha is the passivity controller's.
///
/// One thread at a time. Deterministic. No call allocates, locks or throws.
class HapticStep {
 public:
  /// `map` must outlive the step. The settings must have no fault (`fault_of`). `known`: what is known of cell and
  /// camera before the first frame, from the hand before (`contact()`).
  HapticStep(const DeviceSpecification& device, MotionMap& map, const HapticSettings& settings,
             const CellContact& known = CellContact{}) noexcept;

  /// New settings; changed fixtures fade out and the new ones in.
  void set(const HapticSettings& settings) noexcept;
  void see(const ContactModel& model) noexcept { contact_.see(model); }
  void see(const PipetteState& pipette) noexcept;

  HapticOutput compute(const HapticInput& input) noexcept;

  /// What is known of cell and camera now: outlives the hand.
  const CellContact& contact() const noexcept { return contact_; }

 private:
  // Intermediate results of a tick.
  struct Tick {
    HandReadout hand;
    LeadOutput lead;
    Eigen::Vector3d force_W_N = Eigen::Vector3d::Zero();
    HandState state = HandState::kWaiting;
  };

  void latch_stop(const HapticInput& input, ActingLimits& acting) noexcept;
  void check_readings(const HapticInput& input, const HandReadout& hand, ActingLimits& acting) noexcept;
  LeadOutput lead(const HapticInput& input, const HandReadout& hand, ActingLimits& acting) noexcept;
  EngagementEvent asked_by(const HapticInput& input, const TipTarget& target) const noexcept;
  LeadOutput hold_ahead(const HapticInput& input, const TipTarget& target, ActingLimits& acting) noexcept;
  GuardInput guard_input(double dt_s) const noexcept;
  void meet_cell(const HapticInput& input, Tick& tick, ActingLimits& acting) noexcept;
  void note_contact(const ContactForce& contact, ActingLimits& acting) const noexcept;
  void explain_limits(const Tick& tick, ActingLimits& acting) const noexcept;
  HandState hand_state() const noexcept;
  void fill(const HapticInput& input, const Tick& tick, std::uint32_t acting, HapticOutput& output) const noexcept;

  DeviceSpecification device_;
  HapticSettings settings_;

  HandReader hand_reader_;
  PipetteReader pipette_;
  CellContact contact_;
  PipetteLead lead_;
  HandForce force_;
  LimitLog limits_;

  bool stopped_ = false;  ///< the emergency stop's latch
  Engagement engagement_ = Engagement::kWaiting;
  double force_scale_N_per_uN_ = 0.0;
};

}  // namespace pellucida
