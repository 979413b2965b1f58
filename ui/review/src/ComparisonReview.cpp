#include "ComparisonReview.h"

#include "ReviewExport.h"
#include "ReviewViews.h"
#include "Words.h"
#include "presenters/SessionCurves.h"
#include "widgets/ComparePanel.h"
#include "widgets/CurvePanel.h"

namespace pellucida {

struct ComparisonReview::OpenedOther {
  std::unique_ptr<RecordedSession> session;
  std::unique_ptr<StepLoader> loader;
};

ComparisonReview::ComparisonReview(ReviewViews& views, ReviewExport& exports, std::function<void()> closed,
                                   std::function<void(const QString&)> refused, QObject* parent)
    : QObject(parent), views_(views), closed_(std::move(closed)), refused_(std::move(refused)) {
  ComparePanel::Actions actions;
  actions.align = [this](Alignment alignment) { align(alignment); };
  actions.close = [this] { closed_(); };
  actions.save_chart = [this, &exports] {
    exports.save_chart(panel_->curve().chart(), words("Difference of the forces"), "difference");
  };
  actions.save_table = [this, &exports] {
    if (!comparison_) return;
    exports.save_table(words("Difference of the forces"), "difference", [this](const std::filesystem::path& file) {
      comparison_->write_difference(step_, alignment_, file);
    });
  };
  panel_ = new ComparePanel(std::move(actions), nullptr);
  panel_->setObjectName("comparePanel");
  panel_->hide();
}

ComparisonReview::~ComparisonReview() = default;

void ComparisonReview::choose(const RecordedSession& shown, const std::filesystem::path& folder) {
  clear();
  panel_->set_session(QString::fromStdString(session_name_of(folder)), {});
  panel_->show_text(words("Opening ") + QString::fromStdString(folder.string()));
  panel_->show_rows({});
  panel_->show();
  opening_.run(
      [this, folder, &shown](const BackgroundTask::Control&) -> std::function<void()> {
        SessionReader reader(folder);
        auto opened = std::make_shared<OpenedOther>();
        opened->session = std::make_unique<RecordedSession>(recorded_session(reader));
        opened->loader = std::make_unique<StepLoader>(std::move(reader));
        return [this, opened, &shown] { adopt(shown, *opened); };
      },
      {},
      [this](const std::string& error) {
        closed_();
        refused_(QString::fromStdString(error));
      });
}

void ComparisonReview::adopt(const RecordedSession& shown, OpenedOther& opened) {
  other_ = std::move(opened.session);
  loader_ = std::move(opened.loader);
  comparison_ = std::make_unique<SessionComparison>(shown, *other_);
  const std::string name = session_name_of(other_->folder), caution = session_caution(*other_);
  panel_->set_session(QString::fromStdString(name + " · " + other_->profile.name),
                      QString::fromStdString(other_->folder.string() + "\n" + session_facts(*other_) +
                                             (caution.empty() ? "" : "\n" + caution)));
  align(alignment_);
}

void ComparisonReview::clear() {
  opening_.cancel();
  panel_->hide();
  panel_->show_scene(Scene{});
  views_.compare(nullptr, alignment_);
  comparison_.reset();
  loader_.reset();
  other_.reset();
  partner_.reset();
  shown_partner_.reset();
}

void ComparisonReview::align(Alignment alignment) {
  alignment_ = alignment;
  if (!comparison_) return;
  views_.compare(comparison_.get(), alignment);
  fill_chart();
  show_step(step_);
}

void ComparisonReview::show_step(std::size_t step) {
  const bool other_touch = comparison_ && alignment_ == Alignment::kIndentation &&
                           touch_of(comparison_->shown(), step) != touch_of(comparison_->shown(), step_);
  step_ = step;
  if (!comparison_) return;
  if (other_touch) fill_chart();
  partner_ = comparison_->partner(step, alignment_);
  panel_->show_rows(comparison_->rows(step, partner_));
  if (partner_) {
    loader_->request(*partner_);
  } else {
    shown_partner_.reset();
    panel_->show_scene(Scene{});
  }
  const Measurement& row = comparison_->shown().rows[step];
  const bool by_depth = alignment_ == Alignment::kIndentation;
  panel_->curve().chart().set_cursor(by_depth ? row.indentation_um : comparison_->shown().times_s[step],
                                     CurveChart::kNowhere, true);
}

bool ComparisonReview::tick() {
  if (!loader_) return false;
  const auto loaded = loader_->take();
  // What was read for a frame that has none here any more is late.
  if (!loaded || !partner_) return false;
  shown_partner_ = loaded->step;
  panel_->show_scene(loaded->scene);
  return true;
}

void ComparisonReview::fill_chart() {
  panel_->curve().chart().set_data(comparison_->difference(step_, alignment_));
}

void ComparisonReview::draw_chart() {
  if (comparison_) panel_->render();
}

}  // namespace pellucida
