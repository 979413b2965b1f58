#include "ModelReview.h"

#include <memory>
#include <utility>

namespace pellucida {

ModelReview::ModelReview(std::function<void()> changed, QObject* parent)
    : QObject(parent), changed_(std::move(changed)) {}

void ModelReview::set_session(const RecordedSession* session) {
  computing_.cancel();
  session_ = session;
  known_.clear();
  touch_ = 0;
}

void ModelReview::set_on(bool on) {
  on_ = on;
  if (on) compute();
  changed_();
}

void ModelReview::show_touch(std::size_t touch) {
  touch_ = touch;
  compute();
}

const TouchModel* ModelReview::shown() const noexcept {
  const auto found = known_.find(touch_);
  return on_ && found != known_.end() ? &found->second : nullptr;
}

// A touch that was left before its curves were there is begun again when it is shown next.
void ModelReview::compute() {
  if (!on_ || !session_ || touch_ == 0 || known_.contains(touch_)) return;
  // The work outlives no session: `set_session` waits for its end.
  computing_.run(
      [this, session = session_, touch = touch_](const BackgroundTask::Control& control) -> std::function<void()> {
        const auto model = std::make_shared<TouchModel>(touch_model(*session, touch, [&] {
          control.progress(0, 0);
          return true;
        }));
        return [this, touch, model] {
          known_[touch] = std::move(*model);
          changed_();
        };
      },
      {}, [this, touch = touch_](const std::string&) { known_[touch] = {}; });
}

}  // namespace pellucida
