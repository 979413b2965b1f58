#include "RunControl.h"

#include <QDir>
#include <QFileInfo>
#include <QPixmap>

#include "GuideMemory.h"
#include "Words.h"
#include "pellucida/core/Error.h"
#include "pellucida/pipeline/LiveRun.h"
#include "presenters/ScalePresenter.h"
#include "widgets/ScaleDialog.h"

namespace pellucida {
namespace {

constexpr double kRepeatPause_s = 2.0;

}  // namespace

RunControl::RunControl(LiveRun& run, QWidget& window, const std::string& session_folder, std::function<void()> begun,
                       Notify notify)
    : run_(run),
      window_(window),
      recordings_(session_folder, QDir::homePath().toStdString()),
      begun_(std::move(begun)),
      notify_(std::move(notify)) {
  if (const auto chosen = remembered_recordings(); session_folder.empty() && !chosen.empty()) set_place(chosen);
}

void RunControl::toggle_recording() {
  if (run_.status().recording) {
    end_recording();
    return;
  }
  try {
    run_.start_recording(recordings_.next_folder(RecordingPresenter::utc_stamp()));
    begun_();
  } catch (const Error& error) {
    notify_(words_of(error) + words("\nChoose another folder: Cells (E), Change."), true);
  }
}

void RunControl::end_recording() {
  try {
    run_.stop_recording();
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

void RunControl::note(const QString& text) {
  const bool written = run_.note(text.toStdString());
  notify_(written ? words("Note written into the recording")
                  : words("Nothing is recording: the note goes into the next recording"),
          false);
}

void RunControl::remark(const std::string& text) {
  run_.add_event({run_.clock().now_s() - run_.session_lag_s(), event_kind::kNote, text});
}

std::filesystem::path RunControl::cells_file() const {
  return recordings_.cells_file(RecordingPresenter::utc_stamp());
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
  // Not modal: the cell lives on, and the stop is in reach.
  auto* dialog = new ScaleDialog(run_.profile(), seen_for_scale(scene), has_own_scale, std::move(actions), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

void RunControl::give_hint(const PersonHint& hint) {
  run_.add_hint(hint);
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
