#include "pellucida/operation/HapticRecorder.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>

#include "pellucida/operation/HapticPathBlock.h"

namespace pellucida {
namespace {

constexpr std::size_t kBlockCount = 1000;  // ticks of a block
constexpr auto kDrainPeriod = std::chrono::milliseconds(50);

}  // namespace

HapticRecorder::HapticRecorder(HapticServo& servo, LiveRun& run)
    : servo_(servo), run_(run), thread_([this](std::stop_token stop) { this->run(stop); }) {}

HapticRecorder::~HapticRecorder() = default;

void HapticRecorder::run(std::stop_token stop) {
  std::mutex mutex;
  std::condition_variable_any wake;
  while (!stop.stop_requested()) {
    drain(false);
    std::unique_lock lock(mutex);
    wake.wait_for(lock, stop, kDrainPeriod, [] { return false; });
  }
  drain(true);
}

void HapticRecorder::drain(bool last) {
  const double lag_s = run_.session_lag_s();
  while (const auto limit = servo_.events().pop()) limits_.add(*limit);
  for (const Event& event : last ? limits_.finish(lag_s) : limits_.take(run_.clock().now_s(), lag_s)) {
    run_.add_event(event);
  }
  while (const auto record = servo_.records().pop()) {
    records_.push_back(*record);
    if (records_.size() < kBlockCount) continue;
    waiting_.push_back({make_haptic_path_block(records_, lag_s), records_.front().time_s - lag_s});
    records_.clear();
  }
  if (last && !records_.empty()) {
    waiting_.push_back({make_haptic_path_block(records_, lag_s), records_.front().time_s - lag_s});
    records_.clear();
  }
  hand_on();
}

void HapticRecorder::hand_on() {
  auto next = waiting_.begin();
  while (next != waiting_.end() && run_.record_hand(next->paths, next->time_s)) ++next;
  waiting_.erase(waiting_.begin(), next);
}

}  // namespace pellucida
