#pragma once
#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>
#include <optional>

#include "BackgroundTask.h"
#include "presenters/HintDraft.h"

class QFrame;
class QLabel;
class QPushButton;

namespace pellucida {

struct RecordedSession;

/// Corrects a recorded session: hints by clicks on its frames, then the whole session measured again with them, into a
/// new one beside it. Frames before the first hint keep their numbers. In the background, with progress and cancel.
class HintReview : public QObject {
 public:
  struct Actions {
    std::function<void(const QString& text, bool problem)> notify;
    /// Progress; an empty text at the end.
    std::function<void(const QString& text, std::size_t done, std::size_t all)> work;
    std::function<void(const std::filesystem::path&)> open;  ///< the session that was written
    std::function<void()> changed;                           ///< the marks on the image
  };

  HintReview(Actions actions, QObject* parent);

  /// The strip that lists the hints; hidden without any. Belongs to the widget it is put into.
  QFrame& strip() noexcept { return *strip_; }
  const HintDraft& draft() const noexcept { return draft_; }

  /// `session` must outlive its showing; hints about another are dropped.
  void set_session(const RecordedSession* session);
  /// A hint about the frame at `time_s`.
  void add(PersonHint hint, double time_s);
  void take_back();
  /// Measures the session again; nothing without hints, or while that is being done.
  void measure();
  void cancel();
  bool measuring() const noexcept { return task_.running(); }

 private:
  void show_draft();

  Actions actions_;
  const RecordedSession* session_ = nullptr;
  HintDraft draft_;
  QFrame* strip_;
  QLabel* text_;
  QPushButton* measure_;
  std::filesystem::path folder_;  // being written
  BackgroundTask task_;
};

}  // namespace pellucida
