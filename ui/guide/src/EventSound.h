#pragma once
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "presenters/SoundCue.h"

namespace pellucida {

/// The desktop's own sounds for events (libcanberra), on a thread of its own: `play` never waits, and without a sound
/// device nothing is heard and nothing goes wrong.
class EventSound {
 public:
  EventSound();
  ~EventSound();
  EventSound(const EventSound&) = delete;
  EventSound& operator=(const EventSound&) = delete;

  /// Of several at a time the newest.
  void play(SoundCue cue);

 private:
  void run(std::stop_token stop);

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<SoundCue> wanted_;
  std::jthread thread_;
};

}  // namespace pellucida
