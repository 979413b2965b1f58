#pragma once
#include <thread>

#include "pellucida/haptics/HapticServo.h"
#include "pellucida/operation/HapticWriter.h"
#include "pellucida/pipeline/LiveRun.h"

namespace pellucida {

/// Writes the activity of the 1 kHz loop to the run's events and recording (`HapticWriter`), on a thread of its own.
class HapticRecorder {
 public:
  /// Both must outlive the recorder, which is the only one to drain the servo's records and events.
  HapticRecorder(HapticServo& servo, LiveRun& run);
  /// Writes what is left, then ends.
  ~HapticRecorder();
  HapticRecorder(const HapticRecorder&) = delete;
  HapticRecorder& operator=(const HapticRecorder&) = delete;

 private:
  void run(std::stop_token stop);
  void drain();

  HapticServo& servo_;
  LiveRun& run_;
  HapticWriter writer_;
  std::jthread thread_;
};

}  // namespace pellucida
