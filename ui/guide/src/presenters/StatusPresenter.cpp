#include "presenters/StatusPresenter.h"

#include <cmath>

#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/ReadoutPresenter.h"

namespace pellucida {
namespace {

constexpr double kRateWindow_s = 2.0;
// A force older than this no longer describes the present.
constexpr double kOldForce_ms = 150.0;

std::string frames(std::uint64_t count, const std::string& what) {
  return std::to_string(count) + (count == 1 ? say(" frame ") : say(" frames ")) + what;
}

Phrase lost_phrase(const LiveStatus& status) {
  if (status.recorder_dropped_count > 0) {
    return {frames(status.recorder_dropped_count, say("recorded without their image")), current_theme().record};
  }
  if (status.recorder_thinned_count > 0) {
    return {frames(status.recorder_thinned_count, say("recorded without their surface")), current_theme().warning};
  }
  if (status.gap_count > 0) return {frames(status.gap_count, say("lost by the source")), current_theme().warning};
  return {frames(status.skipped_count, say("not measured")), current_theme().text_dim};
}

std::string notes_waiting(std::size_t count) {
  if (count == 0) return {};
  return ", " + std::to_string(count) + (count == 1 ? say(" note waits") : say(" notes wait")) +
         say(" for the next recording");
}

Phrase recording_phrase(const LiveStatus& status, bool paused) {
  if (status.recording) {
    const std::string doing = paused ? say("Recording paused, ") : say("Recording to ");
    return {doing + status.recording_folder + ", " + std::to_string(status.recorded_count) + say(" frames"),
            current_theme().record};
  }
  const std::string notes = notes_waiting(status.waiting_note_count);
  if (!status.recording_folder.empty())
    return {say("Recorded in ") + status.recording_folder + notes, current_theme().text_dim};
  return {say("Not recording") + notes, current_theme().text_dim};
}

Phrase notice_phrase(const LiveStatus& status, const Scene* scene, bool paused) {
  if (status.fault) return {say_message(*status.fault), current_theme().record};
  if (status.finished) return {say("The source has ended"), current_theme().warning};
  if (paused) return {say("Paused"), current_theme().warning};
  if (status.frame_count == 0) return {say("Waiting for the first frame"), current_theme().text_dim};
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
  texts.frame_rate = {say("Frames/s: ") + rate(measured) + say(" measured, ") + rate(drawn) + say(" drawn"),
                      current_theme().text_dim};
  const bool aging = !still && status.frame_age_ms > kOldForce_ms;
  texts.frame_age = {
      scene ? say("Frame age ") + readout::milliseconds(scene->measurement.frame_age_ms) : say("Frame age \u2013"),
      aging ? current_theme().warning : current_theme().text_dim};
  texts.lost = lost_phrase(status);
  texts.recording = recording_phrase(status, paused);
  texts.notice = notice_phrase(status, scene, paused);
  return texts;
}

}  // namespace pellucida
