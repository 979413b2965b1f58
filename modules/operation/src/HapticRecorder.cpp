#include "pellucida/operation/HapticRecorder.h"

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <stop_token>
#include <string>

#include "pellucida/operation/HapticPathBlock.h"

namespace pellucida {
namespace {

constexpr std::size_t kBlockCount = 1000;  // ticks of a block
constexpr auto kDrainPeriod = std::chrono::milliseconds(50);

// Unit of what a limit compares; empty where it compares nothing.
const char* unit_of(LimitKind kind) {
  switch (kind) {
    case LimitKind::kDepth:
    case LimitKind::kTravel:
    case LimitKind::kFollowing:
      return "um";
    case LimitKind::kForce:
      return "uN";
    case LimitKind::kSpeed:
      return "um/s";
    case LimitKind::kHandForce:
      return "N";
    case LimitKind::kHandStiffness:
      return "N/m";
    case LimitKind::kContactStale:
    case LimitKind::kLateTick:
      return "s";
    default:
      return "";
  }
}

}  // namespace

Event to_event(const LimitEvent& limit, double session_lag_s) {
  std::string detail(to_string(limit.kind));
  const std::string unit = unit_of(limit.kind);
  if (!limit.begun) {
    detail += ": over";
  } else if (!unit.empty() && limit.limit != 0.0) {
    char text[96];
    std::snprintf(text, sizeof text, ": %.3g %s, limit %.3g %s", limit.value, unit.c_str(), limit.limit, unit.c_str());
    detail += text;
  }
  return {limit.time_s - session_lag_s, "limit", detail};
}

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
  while (const auto event = servo_.events().pop()) run_.add_event(to_event(*event, lag_s));
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
