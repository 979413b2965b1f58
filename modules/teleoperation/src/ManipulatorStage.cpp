#include "pellucida/teleoperation/ManipulatorStage.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

bool usable(const PipetteCommand& command) noexcept {
  return command.stop || (command.tip_um.eigen().allFinite() && command.velocity_um_per_s.eigen().allFinite() &&
                          std::isfinite(command.max_speed_um_per_s));
}

/// The same command, but held and not injecting.
PipetteCommand holding(PipetteCommand command) noexcept {
  if (!command.tip_um.eigen().allFinite()) command.tip_um = {};
  command.velocity_um_per_s = {};
  command.max_speed_um_per_s = 0.0;
  command.inject = false;
  return command;
}

}  // namespace

ManipulatorStage::ManipulatorStage(Manipulator& manipulator, const Clock& clock, const ManipulatorStageOptions& options)
    : manipulator_(manipulator), clock_(clock), options_(options) {
  for (const double value : {options.rate_Hz, options.command_timeout_s, options.reopen_after_s}) {
    if (value > 0.0 && std::isfinite(value)) continue;
    throw UsageError("manipulator stage: rate and times must be above 0, not " + std::to_string(value));
  }
}

ManipulatorStage::~ManipulatorStage() {
  stop();
}

void ManipulatorStage::start() {
  manipulator_.open();
  thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
}

void ManipulatorStage::stop() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
  manipulator_.close();
}

void ManipulatorStage::run(std::stop_token stop) {
  const double own_rate_Hz = manipulator_.specification().rate_Hz;
  const double rate_Hz = own_rate_Hz > 0.0 ? std::min(options_.rate_Hz, own_rate_Hz) : options_.rate_Hz;
  const auto period =
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(1.0 / rate_Hz));
  auto next = std::chrono::steady_clock::now();
  while (!stop.stop_requested()) {
    turn();
    // A late turn is not made up for in a burst.
    next = std::max(next + period, std::chrono::steady_clock::now());
    std::unique_lock lock(mutex_);
    wake_.wait_until(lock, stop, next, [] { return false; });
  }
}

void ManipulatorStage::turn() {
  const double now_s = clock_.now_s();
  try {
    if (manipulator_.is_open()) {
      serve(now_s);
    } else if (now_s >= try_again_s_) {
      reopen(now_s);
    }
  } catch (const std::exception& fault) {
    lose(fault.what(), now_s);
  }
}

void ManipulatorStage::serve(double now_s) {
  const bool fresh = commands_.refresh();
  if (fresh && usable(commands_.value())) {
    has_command_ = true;
    held_ = false;
    command_seen_s_ = now_s;
    manipulator_.command(commands_.value(), now_s);
    std::lock_guard lock(mutex_);
    ++counts_.command_count;
  } else if (has_command_ && !held_ && (fresh || now_s - command_seen_s_ > options_.command_timeout_s)) {
    // Silence, or impossible numbers: stop.
    held_ = true;
    manipulator_.command(holding(commands_.value()), now_s);
    std::lock_guard lock(mutex_);
    ++counts_.hold_count;
  }
  publish(manipulator_.state(now_s));
}

void ManipulatorStage::reopen(double now_s) {
  try {
    manipulator_.open();
  } catch (const DeviceError&) {
    // Still away: said once, when it was lost.
    try_again_s_ = now_s + options_.reopen_after_s;
    return;
  }
  // What was asked of it while it was away is not caught up with.
  commands_.refresh();
  has_command_ = false;
  held_ = false;
  {
    std::lock_guard lock(mutex_);
    ++counts_.reopen_count;
  }
  publish(manipulator_.state(now_s));
}

void ManipulatorStage::lose(const std::string& reason, double now_s) {
  manipulator_.close();
  try_again_s_ = now_s + options_.reopen_after_s;
  PipetteState state = newest_state();
  state.known = false;
  state.moving = false;
  state.velocity_um_per_s = {};
  publish(state);
  std::lock_guard lock(mutex_);
  ++counts_.lost_count;
  counts_.last_fault = reason;
}

void ManipulatorStage::publish(const PipetteState& state) {
  states_.publish(state);
  if (options_.report) options_.report(state);
  std::lock_guard lock(mutex_);
  newest_ = state;
}

PipetteState ManipulatorStage::newest_state() const {
  std::lock_guard lock(mutex_);
  return newest_;
}

ManipulatorStageCounts ManipulatorStage::counts() const {
  std::lock_guard lock(mutex_);
  return counts_;
}

}  // namespace pellucida
