#include "HintReview.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <memory>
#include <utility>

#include "Words.h"
#include "pellucida/core/Error.h"
#include "pellucida/pipeline/Counterfactual.h"
#include "pellucida/pipeline/RunProvenance.h"
#include "presenters/RecordedSession.h"
#include "widgets/ButtonKey.h"

namespace pellucida {
namespace {

constexpr const char* kHintVariant = "hints";

CounterfactualResult measure_with(const std::filesystem::path& session, const std::vector<PersonHint>& hints,
                                  const std::filesystem::path& folder, const BackgroundTask::Control& control) {
  CounterfactualOptions options;
  options.pipeline = recorded_options(SessionReader(session).info());
  options.pipeline.hints = hints;
  options.keep_frames = true;
  options.command_line = "pellucida workstation --mode review";
  // Cancelled: what was measured so far is a whole session.
  bool going_on = true;
  options.progress = [&](long done, std::optional<long> all) {
    going_on = control.go_on(static_cast<std::size_t>(done), static_cast<std::size_t>(all.value_or(0)));
  };
  options.stopped = [&] { return !going_on; };
  const CellProfile profile = profile_of(options.pipeline);
  return run_counterfactual(session, options,
                            {{.name = kHintVariant, .profile = profile, .changes_json = {}, .folder = folder}});
}

}  // namespace

HintReview::HintReview(Actions actions, QObject* parent)
    : QObject(parent), actions_(std::move(actions)), strip_(new QFrame), text_(new QLabel), measure_(nullptr) {
  strip_->setObjectName("hintStrip");
  strip_->setAttribute(Qt::WA_StyledBackground);
  strip_->setFixedHeight(44);
  auto* row = new QHBoxLayout(strip_);
  row->setContentsMargins(16, 6, 16, 6);
  row->setSpacing(10);
  text_->setObjectName("hintText");
  text_->setTextFormat(Qt::PlainText);
  text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(text_, 1);
  auto* drop = new QPushButton(words("Drop the hints"));
  drop->setObjectName("hintDrop");
  drop->setFixedHeight(30);
  drop->setFocusPolicy(Qt::TabFocus);
  connect(drop, &QPushButton::clicked, this, [this] {
    draft_.clear();
    show_draft();
  });
  row->addWidget(drop);
  measure_ = new QPushButton(words("Measure again"));
  measure_->setObjectName("hintMeasure");
  measure_->setFixedHeight(30);
  measure_->setFocusPolicy(Qt::TabFocus);
  bind_key(*measure_, Qt::Key_M,
           words("Measures the session once more with these hints, into a new session, and opens it"));
  connect(measure_, &QPushButton::clicked, this, [this] { measure(); });
  row->addWidget(measure_);
  show_draft();
}

void HintReview::set_session(const RecordedSession* session) {
  cancel();
  session_ = session;
  draft_.clear();
  show_draft();
}

void HintReview::add(PersonHint hint, double time_s) {
  if (measuring()) {
    actions_.notify(words("Wait: the session is being measured again"), true);
    return;
  }
  hint.since_s = time_s;
  draft_.add(hint);
  show_draft();
}

void HintReview::take_back() {
  if (measuring() || !draft_.take_back()) {
    actions_.notify(words("There is no hint to take back"), false);
    return;
  }
  show_draft();
}

void HintReview::show_draft() {
  text_->setText(QString::fromStdString(draft_.text()));
  text_->setToolTip(text_->text());
  strip_->setVisible(!draft_.empty());
  measure_->setEnabled(!draft_.empty() && !measuring());
  if (actions_.changed) actions_.changed();
}

void HintReview::measure() {
  if (!session_ || draft_.empty() || measuring()) return;
  folder_ = corrected_folder(session_->folder);
  measure_->setEnabled(false);
  actions_.work(words("Measuring again"), 0, 0);
  task_.run(
      [this, session = session_->folder, hints = draft_.hints(),
       folder = folder_](const BackgroundTask::Control& control) -> std::function<void()> {
        const CounterfactualResult result = measure_with(session, hints, folder, control);
        const int changed =
            result.variants.front().changes.frame_count - result.variants.front().changes.equal_row_count;
        return [this, folder, changed] {
          actions_.work({}, 0, 0);
          draft_.clear();
          show_draft();
          actions_.open(folder);
          actions_.notify(
              words("%1 frames changed; written to %2").arg(changed).arg(QString::fromStdString(folder.string())),
              false);
        };
      },
      [this](std::size_t done, std::size_t all) { actions_.work(words("Measuring again"), done, all); },
      [this](const std::string& error) {
        actions_.work({}, 0, 0);
        show_draft();
        actions_.notify(QString::fromStdString(error), true);
      });
}

void HintReview::cancel() {
  if (!measuring()) return;
  task_.cancel();
  actions_.work({}, 0, 0);
  show_draft();
  actions_.notify(words("Cancelled; what was measured so far is in ") + QString::fromStdString(folder_.string()),
                  false);
}

}  // namespace pellucida
