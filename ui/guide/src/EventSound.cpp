#include "EventSound.h"

#include <canberra.h>

#include <memory>

namespace pellucida {
namespace {

// Names of the freedesktop sound theme.
const char* sound_name(SoundCue cue) {
  switch (cue) {
    case SoundCue::kContact:
      return "message";
    case SoundCue::kPuncture:
      return "complete";
    case SoundCue::kAlarm:
      break;
  }
  return "dialog-warning";
}

}  // namespace

EventSound::EventSound() : thread_([this](std::stop_token stop) { run(stop); }) {}

EventSound::~EventSound() = default;

void EventSound::play(SoundCue cue) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = cue;
  }
  wake_.notify_one();
}

void EventSound::run(std::stop_token stop) {
  struct Destroy {
    void operator()(ca_context* context) const noexcept { ca_context_destroy(context); }
  };
  std::unique_ptr<ca_context, Destroy> player;
  std::unique_lock lock(mutex_);
  while (wake_.wait(lock, stop, [this] { return wanted_.has_value(); })) {
    const SoundCue cue = *wanted_;
    wanted_.reset();
    lock.unlock();
    ca_context* made = nullptr;
    if (!player && ca_context_create(&made) == CA_SUCCESS) player.reset(made);
    // A failure is silence: no device, no server, no theme.
    if (player)
      ca_context_play(player.get(), 0, CA_PROP_EVENT_ID, sound_name(cue), CA_PROP_MEDIA_ROLE, "event", nullptr);
    lock.lock();
  }
}

}  // namespace pellucida
