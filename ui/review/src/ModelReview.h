#pragma once
#include <QObject>
#include <functional>
#include <map>
#include <optional>

#include "BackgroundTask.h"
#include "presenters/TouchModel.h"

namespace pellucida {

/// The model's curves of the touches of a session, computed in the background as touches are shown, each once.
class ModelReview : public QObject {
 public:
  /// `changed`: the curves of the touch shown are there.
  ModelReview(std::function<void()> changed, QObject* parent);

  /// `session` must outlive its showing; null: none.
  void set_session(const RecordedSession* session);
  /// Off: nothing is computed.
  void set_on(bool on);
  bool on() const noexcept { return on_; }
  void show_touch(std::size_t touch);
  /// Null while they are being computed, or off.
  const TouchModel* shown() const noexcept;
  bool computing() const noexcept { return computing_.running(); }

 private:
  void compute();

  std::function<void()> changed_;
  const RecordedSession* session_ = nullptr;
  std::map<std::size_t, TouchModel> known_;
  std::size_t touch_ = 0;
  bool on_ = true;
  BackgroundTask computing_;
};

}  // namespace pellucida
