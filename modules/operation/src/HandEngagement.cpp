#include "HandEngagement.h"

namespace pellucida {

HandEngagement::HandEngagement(LiveRun& run, Manipulator& manipulator, const HapticLoopOptions& loop)
    : live_run_(run), manipulator_(manipulator), loop_(loop), contacts_(run) {}

HandEngagement::~HandEngagement() {
  disengage();
}

void HandEngagement::set_device(std::unique_ptr<HapticDevice> device) {
  disengage();
  device_ = device ? std::make_unique<ConsoleDevice>(std::move(device)) : nullptr;
}

void HandEngagement::engage(const TeleoperationSettings& motion, const HapticSettings& settings) {
  disengage();
  map_ = std::make_unique<TeleoperationMap>(motion);
  auto run = std::make_unique<TeleoperationRun>(live_run_, contacts_, *device_, *map_, manipulator_,
                                                TeleoperationRun::Options{settings, loop_, {}});
  {
    const std::lock_guard lock(mutex_);
    run_ = std::move(run);
    if (stopped_) run_->emergency_stop();
  }
  try {
    run_->start();
  } catch (...) {
    disengage();
    throw;
  }
}

void HandEngagement::disengage() {
  if (!run_) return;
  const bool stopped_by_device = run_->status().tick.hand_state == HandState::kStopped;
  std::unique_ptr<TeleoperationRun> ending;
  {
    const std::lock_guard lock(mutex_);
    stopped_ = stopped_ || stopped_by_device;
    ending = std::move(run_);
  }
}

void HandEngagement::set(const HapticSettings& settings) {
  if (run_) run_->set(settings);
}

void HandEngagement::emergency_stop() noexcept {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  if (run_) run_->emergency_stop();
}

void HandEngagement::release_emergency_stop() noexcept {
  const std::lock_guard lock(mutex_);
  stopped_ = false;
  if (run_) run_->release_emergency_stop();
}

HandStatus HandEngagement::status() {
  if (run_) return run_->status();
  HandStatus status;
  const std::lock_guard lock(mutex_);
  status.tick.hand_state = stopped_ ? HandState::kStopped : HandState::kWaiting;
  return status;
}

}  // namespace pellucida
