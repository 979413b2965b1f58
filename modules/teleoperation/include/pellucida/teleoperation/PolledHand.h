#pragma once
#include <atomic>
#include <cstdint>
#include <thread>

#include "pellucida/core/LatestValue.h"
#include "pellucida/haptics/HapticDevice.h"
#include "pellucida/teleoperation/HandSmoother.h"
#include "pellucida/teleoperation/TouchCue.h"

namespace pellucida {

/// A device whose library may wait or allocate: a thread of its own reads it (a few hundred times a second) and the 1
/// kHz thread takes the newest reading, wait-free, with its steps smoothed (HandSmoother). A thread that falls silent
/// counts as a lost device.
///
/// A derived class overrides `poll`, calls `start` at the end of its constructor and `stop` in its destructor.
class PolledHand : public HapticDevice, public TouchCueDevice {
 public:
  ~PolledHand() override;
  PolledHand(const PolledHand&) = delete;
  PolledHand& operator=(const PolledHand&) = delete;

  const DeviceSpecification& specification() const noexcept final { return specification_; }
  bool read(double now_s, HandSample& sample) noexcept final;

  /// It gives no force; false when it is lost. The contact is shown through `show`.
  bool write(const PlainVector3& force_N) noexcept final;
  void show(const TouchCue& cue) noexcept final;

  /// Readings received since the device was opened. Any thread.
  std::uint64_t reading_count() const noexcept { return reading_count_.load(std::memory_order_relaxed); }

 protected:
  struct Reading {
    bool connected = false;
    PlainVector3 position_m;
    std::uint32_t buttons = 0;
    std::uint64_t number = 0;  ///< of the reading, so that silence is noticed
  };

  explicit PolledHand(DeviceSpecification specification) : specification_(std::move(specification)) {}
  void start();
  void stop();

  /// Reads the device once and paces itself: waits for its next event, some milliseconds at most. On the polling
  /// thread; a lost device is searched for again here. `cue` is the newest of the contact.
  virtual Reading poll(const TouchCue& cue, std::stop_token stop) = 0;

 private:
  DeviceSpecification specification_;
  LatestValue<Reading> readings_;
  LatestValue<TouchCue> cues_;
  std::atomic<std::uint64_t> reading_count_{0};
  std::jthread thread_;

  // The 1 kHz thread.
  HandSmoother smoother_;
  double heard_s_ = 0.0, last_read_s_ = 0.0;
  bool read_once_ = false;
  bool connected_ = false;
};

/// Waits `duration_s`, or until `stop` is requested.
void wait_for(std::stop_token stop, double duration_s);

}  // namespace pellucida
