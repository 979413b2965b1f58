#include "pellucida/teleoperation/PolledHand.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>

namespace pellucida {
namespace {

constexpr double kLongestGap_s = 0.1;      // of the 1 kHz thread: the hand does not leap after one
constexpr double kLongestSilence_s = 0.5;  // a polling thread that gives no reading for this long is stuck

}  // namespace

void wait_for(std::stop_token stop, double duration_s) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  never.wait_for(lock, stop, std::chrono::duration<double>(duration_s), [] { return false; });
}

PolledHand::~PolledHand() {
  stop();
}

void PolledHand::start() {
  thread_ = std::jthread([this](std::stop_token stop) {
    std::uint64_t number = 0;
    while (!stop.stop_requested()) {
      cues_.refresh();
      Reading reading = poll(cues_.value(), stop);
      reading.number = ++number;
      readings_.publish(reading);
      reading_count_.store(number, std::memory_order_relaxed);
    }
  });
}

void PolledHand::stop() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

bool PolledHand::read(double now_s, HandSample& sample) noexcept {
  const bool fresh = readings_.refresh();
  if (fresh || !read_once_) heard_s_ = now_s;
  const double dt_s = read_once_ ? std::min(now_s - last_read_s_, kLongestGap_s) : 0.0;
  last_read_s_ = now_s;
  read_once_ = true;
  const Reading& reading = readings_.value();
  // Before the first reading the device, which was opened, rests.
  connected_ = (reading.connected || reading.number == 0) && now_s - heard_s_ <= kLongestSilence_s;
  smoother_.update(reading.position_m.eigen(), dt_s);
  sample.time_s = now_s;
  sample.position_m = smoother_.position_m();
  sample.velocity_m_per_s = smoother_.velocity_m_per_s();
  sample.velocity_known = true;
  sample.buttons = connected_ ? reading.buttons : 0;
  return connected_;
}

bool PolledHand::write(const PlainVector3&) noexcept {
  return connected_;
}

void PolledHand::show(const TouchCue& cue) noexcept {
  if (cue.force_N.eigen().allFinite() && std::isfinite(cue.stiffness_N_per_m)) cues_.publish(cue);
}

}  // namespace pellucida
