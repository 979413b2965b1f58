#pragma once
#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "BackgroundTask.h"
#include "presenters/SessionComparison.h"
#include "presenters/StepLoader.h"

namespace pellucida {

class ComparePanel;
class ReviewExport;
class ReviewViews;

/// The session that the one shown is held against: opened in the background, its frames read on a thread of their own,
/// its curves laid over the charts, all of it aligned with the frame shown.
class ComparisonReview : public QObject {
 public:
  /// `closed`: nothing is compared any more. `refused`: why a session can't be compared.
  ComparisonReview(ReviewViews& views, ReviewExport& exports, std::function<void()> closed,
                   std::function<void(const QString&)> refused, QObject* parent);
  ~ComparisonReview() override;

  /// To be put into the window; hidden while nothing is compared. Belongs to the widget it is put into.
  ComparePanel& panel() noexcept { return *panel_; }
  /// Whether a session is being compared, or opened for it.
  bool active() const noexcept { return opening_.running() || comparison_ != nullptr; }
  /// Nothing before the session was opened.
  const SessionComparison* comparison() const noexcept { return comparison_.get(); }
  Alignment alignment() const noexcept { return alignment_; }
  /// The other session's step that the panel shows; nothing where it has none.
  std::optional<std::size_t> shown_partner() const noexcept { return shown_partner_; }

  /// Opens `folder` and compares `shown` with it, which must outlive that.
  void choose(const RecordedSession& shown, const std::filesystem::path& folder);
  void clear();
  void align(Alignment alignment);
  /// The step that the window shows.
  void show_step(std::size_t step);
  /// Shows what was read since; true when the charts are to be drawn.
  bool tick();
  void draw_chart();

 private:
  struct OpenedOther;
  void adopt(const RecordedSession& shown, OpenedOther& opened);
  void fill_chart();

  ReviewViews& views_;
  ComparePanel* panel_;
  std::function<void()> closed_;
  std::function<void(const QString&)> refused_;
  std::unique_ptr<RecordedSession> other_;
  std::unique_ptr<SessionComparison> comparison_;
  std::unique_ptr<StepLoader> loader_;
  Alignment alignment_ = Alignment::kTime;
  std::size_t step_ = 0;
  std::optional<std::size_t> partner_, shown_partner_;
  BackgroundTask opening_;
};

}  // namespace pellucida
