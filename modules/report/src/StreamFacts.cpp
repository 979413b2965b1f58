#include "StreamFacts.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "pellucida/core/Html.h"
#include "pellucida/session/SessionClocks.h"

namespace pellucida {
namespace {

using Clocks = nlohmann::ordered_json;

// Frames that are not as the source showed them.
struct IncompleteFrames {
  std::uint64_t lost = 0;     ///< by the source
  std::uint64_t damaged = 0;  ///< not decoded as recorded
  bool damaged_to_end = false;
  std::uint64_t without_image = 0;
  std::uint64_t without_surface = 0;
  std::uint64_t unmeasured = 0;
};

// The number that a detail holds at `start`; 1 where it holds none.
std::uint64_t number_at(std::string_view detail, std::string_view start) {
  std::uint64_t number = 1;
  if (detail.starts_with(start)) std::from_chars(detail.data() + start.size(), detail.data() + detail.size(), number);
  return number;
}

// Rows from a time on: of a damage that has no end.
std::uint64_t rows_from(const SessionReader& session, double time_s) {
  std::uint64_t count = 0;
  for (const Measurement& row : session.measurements()) count += row.time_s >= time_s ? 1U : 0U;
  return count;
}

IncompleteFrames incomplete_frames(const SessionReader& session) {
  IncompleteFrames frames;
  std::optional<double> damaged_since_s;
  for (const Event& event : session.events()) {
    if (event.kind == event_kind::kGap) frames.lost += number_at(event.detail, "");
    if (event.kind == event_kind::kDropped) frames.without_image += number_at(event.detail, "");
    if (event.kind == event_kind::kThinned) frames.without_surface += number_at(event.detail, "");
    if (event.kind != event_kind::kDamaged) continue;
    if (event.detail.starts_with("over")) {
      frames.damaged += number_at(event.detail, "over, after ");
      damaged_since_s.reset();
    } else {
      damaged_since_s = event.time_s;
    }
  }
  if (damaged_since_s) {
    frames.damaged += rows_from(session, *damaged_since_s);
    frames.damaged_to_end = true;
  }
  for (const Measurement& row : session.measurements()) frames.unmeasured += row.state ? 0U : 1U;
  // What was damaged was not measured either.
  frames.unmeasured -= std::min(frames.unmeasured, frames.damaged);
  return frames;
}

// "frames and hand": the streams that are stamped on a clock.
std::string streams_on(const Clocks& clocks, const char* clock, bool is_hand_recorded) {
  std::string text;
  for (const auto& [key, value] : clocks.items()) {
    if (!value.is_string() || value.get_ref<const std::string&>() != clock) continue;
    if (key == "hand" && !is_hand_recorded) continue;
    text += (text.empty() ? "" : " and ") + (key == "session" ? std::string("frames") : key);
  }
  return text;
}

}  // namespace

std::string clock_words(const SessionReader& session) {
  const SessionInfo& info = session.info();
  const auto clocks = Clocks::parse(info.clocks_json, nullptr, false);
  if (!clocks.is_object()) {
    return info.source.live ? "not recorded" : "one: the source's own times, on which everything else is counted";
  }
  const bool has_hand = session.hand_block_count() > 0;
  std::string text = streams_on(clocks, "source", has_hand);
  if (text.empty()) return "not recorded";
  text += " on the source's";
  const std::string others = streams_on(clocks, "run", has_hand);
  if (!others.empty()) text += ", " + others + " on the computer's";
  const auto fit = clock_fit_of(info);
  if (!fit || !std::isfinite(fit->offset_s + fit->drift_ppm + fit->drift_sigma_ppm + fit->scatter_s)) {
    return text + "; the recording was too short to tell a drift between the two";
  }
  return text + "; the computer's is " + fixed_number(1e3 * std::abs(fit->offset_s), 1) + " ms " +
         (fit->offset_s < 0.0 ? "behind" : "ahead") + " at 0 s and gains " + fixed_number(fit->drift_ppm, 1) + " ± " +
         fixed_number(fit->drift_sigma_ppm, 1) + " ppm, with " + fixed_number(1e3 * fit->scatter_s, 2) +
         " ms of scatter (" + std::to_string(fit->pair_count) + " pairs of stamps)";
}

std::string incomplete_frame_words(const SessionReader& session) {
  const IncompleteFrames frames = incomplete_frames(session);
  std::string text;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + what;
  };
  add(frames.lost, "lost by the source");
  add(frames.damaged, frames.damaged_to_end ? "damaged (to the end)" : "damaged");
  add(frames.without_image, "without image for want of time");
  add(frames.without_surface, "without surface for want of time");
  add(frames.unmeasured, "not measured");
  return text.empty() ? "none" : text;
}

std::vector<std::string> frame_doubts(const SessionReader& session) {
  const IncompleteFrames frames = incomplete_frames(session);
  std::vector<std::string> doubts;
  if (frames.damaged > 0) {
    doubts.push_back(std::to_string(frames.damaged) + (frames.damaged == 1 ? " frame" : " frames") +
                     " of the source could not be decoded as recorded" +
                     (frames.damaged_to_end ? ", to the end of the recording" : "") + ": not measured");
  }
  return doubts;
}

}  // namespace pellucida
