#pragma once
#include <atomic>
#include <memory>

#include "pellucida/haptics/HapticDevice.h"
#include "pellucida/simulation/SimulatedHand.h"
#include "pellucida/teleoperation/TouchCue.h"

namespace pellucida {

/// An input device with the window's buttons beside its own: from the window, any hand can deposit, retract or
/// disengage.
class ConsoleDevice final : public HapticDevice {
 public:
  explicit ConsoleDevice(std::unique_ptr<HapticDevice> device)
      : device_(std::move(device)),
        person_(dynamic_cast<SimulatedHand*>(device_.get())),
        cue_(dynamic_cast<TouchCueDevice*>(device_.get())) {}

  HapticDevice& device() noexcept { return *device_; }
  SimulatedHand* person() noexcept { return person_; }
  TouchCueDevice* cue() noexcept { return cue_; }

  /// Any thread: masks of HandButton held at the window, and of those to be ignored wherever they are held.
  void set_buttons(std::uint32_t held, std::uint32_t withheld) noexcept {
    held_.store(held, std::memory_order_relaxed);
    withheld_.store(withheld, std::memory_order_relaxed);
  }
  /// Any thread: what the simulated operator did at the last reading.
  OperatorPhase phase() const noexcept { return phase_.load(std::memory_order_relaxed); }

  const DeviceSpecification& specification() const noexcept override { return device_->specification(); }

  bool read(double now_s, HandSample& sample) noexcept override {
    const bool there = device_->read(now_s, sample);
    if (person_) phase_.store(person_->person().phase(), std::memory_order_relaxed);
    sample.buttons |= held_.load(std::memory_order_relaxed);
    sample.buttons &= ~withheld_.load(std::memory_order_relaxed);
    return there;
  }

  bool write(const PlainVector3& force_N) noexcept override { return device_->write(force_N); }

 private:
  std::unique_ptr<HapticDevice> device_;
  SimulatedHand* person_;
  TouchCueDevice* cue_;
  std::atomic<std::uint32_t> held_{0}, withheld_{0};
  std::atomic<OperatorPhase> phase_{OperatorPhase::kLook};
};

}  // namespace pellucida
