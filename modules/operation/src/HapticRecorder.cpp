#include "pellucida/operation/HapticRecorder.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>

namespace pellucida {
namespace {

constexpr auto kDrainPeriod = std::chrono::milliseconds(50);

}  // namespace

HapticRecorder::HapticRecorder(HapticServo& servo, LiveRun& run)
    : servo_(servo),
      run_(run),
      writer_([this](const Event& event) { run_.add_event(event); },
              [this](const Frozen<vtkPolyData>& paths, double time_s) { return run_.record_hand(paths, time_s); }),
      thread_([this](std::stop_token stop) { this->run(stop); }) {}

HapticRecorder::~HapticRecorder() = default;

void HapticRecorder::run(std::stop_token stop) {
  std::mutex mutex;
  std::condition_variable_any wake;
  while (!stop.stop_requested()) {
    drain();
    writer_.flush(run_.clock().now_s(), run_.session_lag_s());
    std::unique_lock lock(mutex);
    wake.wait_for(lock, stop, kDrainPeriod, [] { return false; });
  }
  drain();
  writer_.finish(run_.session_lag_s());
}

void HapticRecorder::drain() {
  while (const auto limit = servo_.events().pop()) writer_.add(*limit);
  while (const auto tick = servo_.records().pop()) writer_.add(*tick);
}

}  // namespace pellucida
