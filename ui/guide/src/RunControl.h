#pragma once
#include <Eigen/Core>
#include <QString>
#include <functional>
#include <optional>

#include "pellucida/core/PersonHint.h"
#include "presenters/RecordingPresenter.h"

class QWidget;

namespace pellucida {

class LiveRun;
struct LiveStatus;
struct Scene;

/// What the window's buttons do to the run: recording, pause, restart, notes; and pictures of the window.
class RunControl {
 public:
  /// The text, and whether it is a problem.
  using Notify = std::function<void(const QString&, bool)>;

  /// `run` and `window` must outlive the control. `session_folder`: where the first recording goes; empty: a new folder
  /// each time.
  /// `begun`: a recording has begun.
  RunControl(LiveRun& run, QWidget& window, const std::string& session_folder, std::function<void()> begun,
             Notify notify);

  void toggle_recording();
  void end_recording();
  void toggle_pause();
  void restart();
  /// A person's words, for the session; kept for the next one while nothing records.
  void note(const QString& text);
  /// A note of the window's own, for the log and the recording that runs.
  void remark(const std::string& text);

  /// Where recordings, pictures and tables go.
  std::filesystem::path place() const { return recordings_.place(); }
  void set_place(const std::filesystem::path& folder) { recordings_.set_place(folder); }
  std::filesystem::path cells_file() const;

  /// Asks for a measurement of this cell's scale, beside the run. `scene`: the one on screen; nullptr: none yet.
  void ask_for_scale(const Scene* scene);
  /// A person's hint about the image, for the next frame; and the latest one taken back.
  void give_hint(const PersonHint& hint);
  void take_back_hint();
  void save_picture();

  /// A source that repeats begins anew after its end has been seen for a moment; `now_s` is any monotonic clock.
  void repeat_when_ended(const LiveStatus& status, double now_s);

 private:
  LiveRun& run_;
  QWidget& window_;
  RecordingPresenter recordings_;
  std::function<void()> begun_;
  Notify notify_;
  int hint_count_ = 0;             // in force
  std::optional<double> ended_s_;  // when the source was first seen at its end
};

}  // namespace pellucida
