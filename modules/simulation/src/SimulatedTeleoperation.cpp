#include "pellucida/simulation/SimulatedTeleoperation.h"

namespace pellucida {

SimulatedTeleoperation::SimulatedTeleoperation(Manipulator& manipulator, const TeleoperationSettings& motion)
    : map_(motion), stage_(manipulator, clock_) {}

void SimulatedTeleoperation::start(const OperatorOptions& options, const OperatorPlan& plan, const ArmOptions& arm,
                                   std::uint64_t seed, const SettingsFor& settings_for) {
  hand_ = std::make_unique<SimulatedHand>(options, plan, arm, seed);
  servo_ = std::make_unique<HapticServo>(*hand_, map_, HapticPorts{contacts_, stage_.states(), stage_.commands()},
                                         settings_for(hand_->specification()));
}

double SimulatedTeleoperation::begin_tick() noexcept {
  const double now_s = static_cast<double>(tick_count_++) * kTick_s;
  clock_.set(now_s);
  return now_s;
}

void SimulatedTeleoperation::turn_manipulator() {
  if ((tick_count_ - 1) % kManipulatorTicks == 0) stage_.turn();
}

void SimulatedTeleoperation::show(const ContactModel& contact, const OperatorView& view) noexcept {
  contacts_.publish(contact);
  if (hand_) hand_->see(view);
}

const HapticRecord& SimulatedTeleoperation::turn_hand() noexcept {
  servo_->turn(clock_.now_s());
  while (const auto record = servo_->records().pop()) record_ = *record;
  return record_;
}

std::optional<LimitEvent> SimulatedTeleoperation::take_event() noexcept {
  return servo_ ? servo_->events().pop() : std::nullopt;
}

}  // namespace pellucida
