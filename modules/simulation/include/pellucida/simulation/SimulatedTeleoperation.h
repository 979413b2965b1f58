#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "pellucida/core/Clock.h"
#include "pellucida/haptics/HapticServo.h"
#include "pellucida/simulation/SimulatedHand.h"
#include "pellucida/teleoperation/ManipulatorStage.h"
#include "pellucida/teleoperation/TeleoperationMap.h"

namespace pellucida {

/// A simulated operator at the workstation, in simulated time: hand -> `HapticServo` at 1 kHz -> `TeleoperationMap` ->
/// manipulator at 100 Hz, put together as a live run does. The owner has the cell and the camera, turns the parts in
/// the order in which its world needs them, and brings in what was measured. The same calls give the same bits.
///
///     SimulatedTeleoperation teleoperation(injector, motion);
///     teleoperation.start(operator_options, plan, ArmOptions{}, seed, settings_for);
///     while (...) {                                  // a millisecond each
///       const double now_s = teleoperation.begin_tick();
///       teleoperation.turn_manipulator();            // every tenth tick
///       if (measured) teleoperation.show(contact, {now_s, contact.tip_um, true, punctured});
///       const HapticRecord& tick = teleoperation.turn_hand();
///     }
class SimulatedTeleoperation {
 public:
  static constexpr double kTick_s = 1e-3;
  static constexpr long kManipulatorTicks = 10;  ///< from one turn of the manipulator to the next

  using SettingsFor = std::function<HapticSettings(const DeviceSpecification&)>;

  /// `manipulator` must be open when it is turned, and outlive this. Throws as TeleoperationMap.
  SimulatedTeleoperation(Manipulator& manipulator, const TeleoperationSettings& motion);

  /// The operator takes the hand: from the next `turn_hand` on. Throws as SimulatedHand and HapticServo do.
  void start(const OperatorOptions& options, const OperatorPlan& plan, const ArmOptions& arm, std::uint64_t seed,
             const SettingsFor& settings_for);
  bool started() const noexcept { return servo_ != nullptr; }

  /// The next millisecond: its time, s; the first is 0.
  double begin_tick() noexcept;
  /// Hands on commands and reports, in every tenth tick.
  void turn_manipulator();
  /// A measured frame reaches the 1 kHz loop, and the operator's eyes once there is one.
  void show(const ContactModel& contact, const OperatorView& view) noexcept;
  /// The operator's and the loop's millisecond, once started; its record.
  const HapticRecord& turn_hand() noexcept;

  /// Limits that began or ceased to act, oldest first; nothing when all were taken.
  std::optional<LimitEvent> take_event() noexcept;

  /// Once started.
  const SimulatedOperator& simulated_operator() const noexcept { return hand_->simulated_operator(); }

  PipetteState reported() const { return stage_.newest_state(); }  ///< the manipulator's newest
  double scale_um_per_m() const noexcept { return map_.scale_um_per_m(); }
  long tick_count() const noexcept { return tick_count_; }

  /// What a practised operator knows of the way from hand to picture, s: the map's filter, the manipulator's lag, the
  /// camera's delay and half a frame.
  double learnt_lag_s(double manipulator_lag_s, double vision_delay_s, double frame_rate_hz) const noexcept {
    return map_.lag_s() + manipulator_lag_s + vision_delay_s + 0.5 / frame_rate_hz;
  }

 private:
  ManualClock clock_;
  TeleoperationMap map_;
  ManipulatorStage stage_;
  LatestValue<ContactModel> contacts_;
  std::unique_ptr<SimulatedHand> hand_;
  std::unique_ptr<HapticServo> servo_;
  HapticRecord record_;
  long tick_count_ = 0;
};

}  // namespace pellucida
