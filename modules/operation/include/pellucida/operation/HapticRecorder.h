#pragma once
#include <thread>
#include <vector>

#include "pellucida/haptics/HapticServo.h"
#include "pellucida/operation/LimitDigest.h"
#include "pellucida/pipeline/LiveRun.h"

namespace pellucida {

/// Carries what the 1 kHz loop did into the run's events and its recording, on a thread of its own: ticks in blocks of
/// about a second, limits as events. Nothing is dropped while the disk is slower: blocks wait.
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
  LimitDigest limits_;
  std::vector<HapticRecord> records_;
  std::vector<Block> waiting_;  // blocks waiting for the disk, oldest first
  std::jthread thread_;
};

}  // namespace pellucida
