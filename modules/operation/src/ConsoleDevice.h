#pragma once
#include <atomic>
#include <memory>

#include "pellucida/haptics/HapticDevice.h"
#include "pellucida/simulation/SimulatedHand.h"
#include "pellucida/teleoperation/MouseHand.h"

namespace pellucida {

/// An input device with the window's buttons beside its own: from the window, any hand can deposit, retract or
/// disengage. `read` and `write` as of every device; all else may be called from any thread.
class ConsoleDevice final : public HapticDevice {
 public:
  explicit ConsoleDevice(std::unique_ptr<HapticDevice> device)
      : device_(std::move(device)),
        simulated_(dynamic_cast<SimulatedHand*>(device_.get())),
        mouse_(dynamic_cast<MouseHand*>(device_.get())),
        cue_(dynamic_cast<TouchCueDevice*>(device_.get())) {}

  // What it is; nullptr where it isn't.
  SimulatedHand* simulated_hand() noexcept { return simulated_; }
  MouseHand* mouse() const noexcept { return mouse_; }
  TouchCueDevice* cue() noexcept { return cue_; }

  /// Masks of HandButton: those held at the window, and those to be ignored wherever they are held.
  void set_buttons(std::uint32_t held, std::uint32_t withheld) noexcept {
    held_.store(held, std::memory_order_relaxed);
    withheld_.store(withheld, std::memory_order_relaxed);
  }
  /// What the simulated operator did at the last reading.
  OperatorPhase phase() const noexcept { return phase_.load(std::memory_order_relaxed); }

  const DeviceSpecification& specification() const noexcept override { return device_->specification(); }

  bool read(double now_s, HandSample& sample) noexcept override {
    const bool there = device_->read(now_s, sample);
    if (simulated_) phase_.store(simulated_->simulated_operator().phase(), std::memory_order_relaxed);
    sample.buttons |= held_.load(std::memory_order_relaxed);
    sample.buttons &= ~withheld_.load(std::memory_order_relaxed);
    return there;
  }

  bool write(const PlainVector3& force_N) noexcept override { return device_->write(force_N); }

 private:
  std::unique_ptr<HapticDevice> device_;
  SimulatedHand* simulated_;
  MouseHand* mouse_;
  TouchCueDevice* cue_;
  std::atomic<std::uint32_t> held_{0}, withheld_{0};
  std::atomic<OperatorPhase> phase_{OperatorPhase::kLook};
};

}  // namespace pellucida
