#include "presenters/StatusPresenter.h"

#include <cmath>

#include "pellucida/visualization/Readout.h"
#include "presenters/ReadoutPresenter.h"

namespace pellucida {
namespace {

constexpr double kRateWindow_s = 2.0;
// A force older than this no longer describes the present.
constexpr double kOldForce_ms = 150.0;

std::string frames(std::uint64_t count, const char* what) {
  return std::to_string(count) + (count == 1 ? " frame " : " frames ") + what;
}

Phrase lost_phrase(const LiveStatus& status) {
  if (status.recorder_dropped_count > 0) {
    return {frames(status.recorder_dropped_count, "recorded without their image"), palette::kRecord};
  }
  if (status.gap_count > 0) return {frames(status.gap_count, "lost by the source"), palette::kWarning};
  return {frames(status.skipped_count, "not measured"), palette::kTextDim};
}

std::string notes_waiting(std::size_t count) {
  if (count == 0) return {};
  return ", " + std::to_string(count) + (count == 1 ? " note waits" : " notes wait") + " for the next recording";
}

Phrase recording_phrase(const LiveStatus& status, bool paused) {
  if (status.recording) {
    const char* doing = paused ? "Recording paused, " : "Recording to ";
    return {doing + status.recording_folder + ", " + std::to_string(status.recorded_count) + " frames",
            palette::kRecord};
  }
  const std::string notes = notes_waiting(status.waiting_note_count);
  if (!status.recording_folder.empty()) return {"Recorded in " + status.recording_folder + notes, palette::kTextDim};
  return {"Not recording" + notes, palette::kTextDim};
}

Phrase notice_phrase(const LiveStatus& status, const Scene* scene, bool paused) {
  if (status.fault) return {*status.fault, palette::kRecord};
  if (status.finished) return {"The source has ended", palette::kWarning};
  if (paused) return {"Paused", palette::kWarning};
  if (status.frame_count == 0) return {"Waiting for the first frame", palette::kTextDim};
  return scene ? force_notice(*scene) : Phrase{};
}

}  // namespace

double StatusPresenter::Rate::update(std::uint64_t count, double now_s) {
  counts_.emplace_back(now_s, count);
  while (counts_.size() > 2 && counts_.front().first < now_s - kRateWindow_s) counts_.pop_front();
  const double elapsed_s = now_s - counts_.front().first;
  return elapsed_s > 0.2 ? static_cast<double>(count - counts_.front().second) / elapsed_s : std::nan("");
}

StatusTexts StatusPresenter::update(const LiveStatus& status, const Scene* scene, bool paused,
                                    std::uint64_t drawn_count, double now_s) {
  StatusTexts texts;
  const double measured = measured_.update(status.measured_count, now_s);
  const double drawn = drawn_.update(drawn_count, now_s);
  const bool still = paused || status.finished;
  const auto rate = [&](double per_s) { return readout::number(still ? std::nan("") : per_s, 1); };
  texts.frame_rate = {"Frames/s: " + rate(measured) + " measured, " + rate(drawn) + " drawn", palette::kTextDim};
  const bool aging = !still && status.frame_age_ms > kOldForce_ms;
  texts.frame_age = {scene ? "Frame age " + readout::milliseconds(scene->measurement.frame_age_ms) : "Frame age \u2013",
                     aging ? palette::kWarning : palette::kTextDim};
  texts.lost = lost_phrase(status);
  texts.recording = recording_phrase(status, paused);
  texts.notice = notice_phrase(status, scene, paused);
  return texts;
}

}  // namespace pellucida
