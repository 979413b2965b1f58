#include "RunControl.h"

#include <QDir>
#include <QFileInfo>
#include <QInputDialog>
#include <QPixmap>

#include "Words.h"
#include "pellucida/core/Error.h"
#include "pellucida/pipeline/LiveRun.h"
#include "presenters/ScalePresenter.h"
#include "widgets/ScaleDialog.h"

namespace pellucida {
namespace {

constexpr double kRepeatPause_s = 2.0;

}  // namespace

RunControl::RunControl(LiveRun& run, QWidget& window, const std::string& session_folder, Notify notify)
    : run_(run),
      window_(window),
      recordings_(session_folder, QDir::homePath().toStdString()),
      notify_(std::move(notify)) {}

void RunControl::toggle_recording() {
  try {
    if (run_.status().recording) {
      run_.stop_recording();
    } else {
      run_.start_recording(recordings_.next_folder(RecordingPresenter::utc_stamp()));
    }
  } catch (const Error& error) {
    notify_(words_of(error), true);
  }
}

void RunControl::toggle_pause() {
  run_.set_paused(!run_.paused());
}

void RunControl::restart() {
  run_.set_paused(false);
  run_.restart();
  hint_count_ = 0;
}

void RunControl::ask_for_note() {
  bool given = false;
  const QString text = QInputDialog::getText(&window_, words("Note"), words("Remark for the session's events:"),
                                             QLineEdit::Normal, {}, &given);
  if (!given || text.trimmed().isEmpty()) return;
  const bool written = run_.note(text.trimmed().toStdString());
  notify_(written ? words("Note written into the recording")
                  : words("Nothing is recording: the note goes into the next recording"),
          false);
}

void RunControl::ask_for_scale(const Scene* scene) {
  ScaleDialog::Actions actions;
  actions.measured = [this](const ScaleMeasurement& measurement) {
    run_.add_scale_measurement(measurement);
    notify_(words("Scale: ") + QString::fromStdString(describe(measurement)), false);
  };
  actions.forget = [this] {
    run_.forget_scale();
    notify_(words("The kind's scale again"), false);
  };
  const bool has_own_scale = scene && scene->remarks.has_own_scale;
  ScaleDialog(run_.profile(), seen_for_scale(scene), has_own_scale, std::move(actions), &window_).exec();
}

void RunControl::give_hint(PersonHint::Kind kind, const Eigen::Vector2d& place_um) {
  run_.add_hint({.kind = kind, .x_um = place_um.x(), .y_um = place_um.y()});
  ++hint_count_;
}

void RunControl::take_back_hint() {
  if (hint_count_ == 0) {
    notify_(words("There is no hint to take back"), false);
    return;
  }
  --hint_count_;
  run_.add_hint({.kind = PersonHint::Kind::kTakeBack});
}

void RunControl::save_picture() {
  const QString file = QString::fromStdString(recordings_.picture_file(RecordingPresenter::utc_stamp()).string());
  QDir().mkpath(QFileInfo(file).path());
  const bool saved = window_.grab().save(file, "PNG");
  notify_((saved ? words("Screenshot saved: ") : words("The screenshot can't be written: ")) + file, !saved);
}

void RunControl::repeat_when_ended(const LiveStatus& status, double now_s) {
  if (!status.finished || run_.paused()) {
    ended_s_.reset();
    return;
  }
  if (!ended_s_) ended_s_ = now_s;
  if (now_s - *ended_s_ < kRepeatPause_s) return;
  ended_s_.reset();
  run_.restart();
}

}  // namespace pellucida
