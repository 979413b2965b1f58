#include "presenters/StatusPresenter.h"

#include <cmath>

#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr double kRateWindow_s = 2.0;
// A force older than this no longer describes the present.
constexpr double kOldForce_ms = 150.0;
constexpr double kWeakConfidence = 0.5;

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

Phrase notice_phrase(const LiveStatus& status, bool paused) {
  if (status.fault) return {*status.fault, palette::kRecord};
  if (status.finished) return {"The source has ended", palette::kWarning};
  if (paused) return {"Paused", palette::kWarning};
  if (status.frame_count == 0) return {"Waiting for the first frame", palette::kTextDim};
  return {};
}

}  // namespace

double StatusPresenter::frames_per_s(std::uint64_t measured_count, double now_s) {
  counts_.emplace_back(now_s, measured_count);
  while (counts_.size() > 2 && counts_.front().first < now_s - kRateWindow_s) counts_.pop_front();
  const double elapsed_s = now_s - counts_.front().first;
  return elapsed_s > 0.2 ? static_cast<double>(measured_count - counts_.front().second) / elapsed_s : std::nan("");
}

StatusTexts StatusPresenter::update(const LiveStatus& status, const std::optional<Measurement>& row, bool paused,
                                    double now_s) {
  const Measurement m = row.value_or(Measurement{});
  const auto value = [](std::string text, double number) {
    return Phrase{std::move(text), std::isfinite(number) ? palette::kText : palette::kTextDim};
  };

  StatusTexts texts;
  texts.state = {row ? readout::state(m.state) : "Waiting", state_color(m.state)};
  texts.indentation = value(readout::indentation(m), m.indentation_um);
  texts.force = value(readout::force(m), m.contact_force_uN);
  const std::string interval = readout::force_interval(m);
  if (std::isfinite(m.contact_force_uN)) texts.force_interval = interval.empty() ? "no interval" : "95 %: " + interval;
  texts.pressure = value(readout::pressure(m), m.pressure_Pa);
  texts.confidence =
      row ? Phrase{readout::confidence(m), m.confidence < kWeakConfidence ? palette::kWarning : palette::kText}
          : Phrase{"\u2013", palette::kTextDim};

  const double rate = frames_per_s(status.measured_count, now_s);
  const bool still = paused || status.finished;
  texts.frame_rate = {readout::number(still ? std::nan("") : rate, 1) + " frames/s", palette::kTextDim};
  const bool aging = !still && status.frame_age_ms > kOldForce_ms;
  texts.frame_age = {row ? "Frame age " + readout::milliseconds(m.frame_age_ms) : "Frame age \u2013",
                     aging ? palette::kWarning : palette::kTextDim};
  texts.lost = lost_phrase(status);
  texts.recording = recording_phrase(status, paused);
  texts.notice = notice_phrase(status, paused);
  return texts;
}

}  // namespace pellucida
