#pragma once
#include <thread>
#include <vector>

#include "pellucida/core/Event.h"
#include "pellucida/haptics/HapticServo.h"
#include "pellucida/pipeline/LiveRun.h"

namespace pellucida {

/// A limit that began or ceased to act, as a row of `events.csv`: "depth: 46.1 um, limit 46.0 um", "depth: over".
/// `session_lag_s`: subtracted from its time.
Event to_event(const LimitEvent& limit, double session_lag_s);

/// Writes the activity of the 1 kHz loop to the run's events and recording, on a thread of its own: ticks in blocks of
/// about a second, limits as events. Nothing is dropped while the disk is slow: blocks wait.
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
  void drain(bool last);
  void hand_on();

  struct Block {
    Frozen<vtkPolyData> paths;
    double time_s = 0.0;
  };

  HapticServo& servo_;
  LiveRun& run_;
  std::vector<HapticRecord> records_;
  std::vector<Block> waiting_;  // blocks waiting for the disk, oldest first
  std::jthread thread_;
};

}  // namespace pellucida
