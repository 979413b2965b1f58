#include "pellucida/haptics/HapticServo.h"

#include <algorithm>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

const HapticSettings& checked(const HapticSettings& settings, const DeviceSpecification& device, double scale) {
  if (const auto fault = fault_of(settings, device, scale)) {
    throw UsageError("haptic settings for \"" + device.name + "\": " + *fault);
  }
  return settings;
}

}  // namespace

HapticServo::HapticServo(HapticDevice& device, MotionMap& map, const HapticPorts& ports, const HapticSettings& settings,
                         const CellContact& known)
    : device_(device),
      ports_(ports),
      step_(device.specification(), map, checked(settings, device.specification(), map.scale_um_per_m()), known),
      scale_um_per_m_(map.scale_um_per_m()) {}

void HapticServo::set(const HapticSettings& settings) {
  settings_.publish(checked(settings, device_.specification(), scale_um_per_m_.load(std::memory_order_relaxed)));
}

void HapticServo::turn(double now_s, bool release_hand) noexcept {
  HapticInput input;
  input.now_s = now_s;
  input.dt_s = started_ ? std::max(0.0, now_s - last_s_) : 0.0;
  last_s_ = now_s;
  started_ = true;

  // A device that failed to take the last force is as lost as one that doesn't answer.
  input.hand_read = device_.read(now_s, input.hand) && !write_failed_;
  input.release_hand = release_hand;
  if (settings_.refresh()) step_.set(settings_.value());
  if (ports_.pipette.refresh()) step_.see(ports_.pipette.value());
  if (ports_.contact.refresh()) step_.see(ports_.contact.value());
  input.stop = stop_.exchange(false, std::memory_order_acq_rel);
  input.release_stop = release_.exchange(false, std::memory_order_acq_rel);

  const HapticOutput output = step_.compute(input);
  write_failed_ = !device_.write(output.force_N);
  if (write_failed_) device_fault_count_.fetch_add(1, std::memory_order_relaxed);
  ports_.command.publish(output.command);
  records_.push(output.record);
  newest_.publish(output.record);
  for (std::size_t k = 0; k < output.changes.count; ++k) events_.push(output.changes.events[k]);
  scale_um_per_m_.store(output.record.scale_um_per_m, std::memory_order_relaxed);
  tick_count_.fetch_add(1, std::memory_order_relaxed);
}

void HapticServo::release() noexcept {
  device_.write(PlainVector3{});
}

}  // namespace pellucida
