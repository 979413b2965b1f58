#include "RunControl.h"

#include <QDir>
#include <QFileInfo>
#include <QInputDialog>
#include <QPixmap>

#include "pellucida/core/Error.h"
#include "pellucida/pipeline/LiveRun.h"

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
    notify_(error.what(), true);
  }
}

void RunControl::toggle_pause() {
  run_.set_paused(!run_.paused());
}

void RunControl::restart() {
  run_.set_paused(false);
  run_.restart();
}

void RunControl::ask_for_note() {
  bool given = false;
  const QString text =
      QInputDialog::getText(&window_, "Note", "Remark for the session's events:", QLineEdit::Normal, {}, &given);
  if (!given || text.trimmed().isEmpty()) return;
  const bool written = run_.note(text.trimmed().toStdString());
  notify_(written ? "Note written into the recording" : "Nothing is recording: the note goes into the next recording",
          false);
}

void RunControl::save_picture() {
  const QString file = QString::fromStdString(recordings_.picture_file(RecordingPresenter::utc_stamp()).string());
  QDir().mkpath(QFileInfo(file).path());
  const bool saved = window_.grab().save(file, "PNG");
  notify_((saved ? "Screenshot saved: " : "The screenshot can't be written: ") + file, !saved);
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
