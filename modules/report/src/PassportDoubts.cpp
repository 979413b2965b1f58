#include "PassportDoubts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "StreamFacts.h"
#include "pellucida/core/CellNameNote.h"
#include "pellucida/core/NewCellNote.h"
#include "pellucida/core/Table.h"
#include "pellucida/mechanics/ForceEstimate.h"

namespace pellucida {
namespace {

/// The window shows a confidence below this in amber.
constexpr double kLowConfidence = 0.5;
/// Half an interval's width over the force, from which on it is named.
constexpr double kWide_ratio = 0.4;
/// How the mechanics' own notes begin: reasons, not an operator's words.

template <class... Numbers>
std::string sentence(const char* pattern, Numbers... numbers) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, numbers...);
  return text;
}

// The words of the warnings named before the colon of an event's detail ("slip+profile: contour 1.2 um from ...").
std::string warning_words(const Event& event, const std::string& profile) {
  const std::string names = '+' + event.detail.substr(0, event.detail.find(':')) + '+';
  unsigned known = 0;
  for (const ForceWarning warning : {kShapeMismatch, kNeedleSlip, kNotOfRevolution, kSeldomBorne}) {
    if (names.find('+' + to_string(warning) + '+') != std::string::npos) known |= warning;
  }
  return known == 0 ? event.detail : describe(static_cast<ForceWarning>(known), profile);
}

void add_events(const PassportInput& input, double begin_s, double end_s, std::vector<std::string>& doubts) {
  for (const Event& event : input.events) {
    if (event.time_s < begin_s || event.time_s > end_s) continue;
    if (event.kind == event_kind::kWarning) {
      doubts.push_back(sentence("at %.2f s: ", event.time_s) + warning_words(event, input.profile));
    } else if (event.kind == event_kind::kGap) {
      doubts.push_back(sentence("at %.2f s the source lost frames: ", event.time_s) + event.detail);
    } else if (event.kind == event_kind::kRevoked) {
      doubts.push_back(
          sentence("at %.2f s the puncture reported before was revoked; until then the force is 0: ", event.time_s) +
          event.detail);
    } else if (event.kind == event_kind::kNote && event.detail.starts_with(kNoForceNote)) {
      doubts.push_back(sentence("at %.2f s ", event.time_s) + event.detail);
    }
  }
}

void add_rows(const PassportInput& input, const ContactPassport& contact, std::vector<std::string>& doubts) {
  int forceless = 0, force_count = 0;
  auto punctures = -std::count_if(input.events.begin(), input.events.end(), [&](const Event& event) {
    return event.kind == event_kind::kRevoked && event.time_s >= contact.touch_s &&
           event.time_s <= input.rows[contact.rows.end - 1].time_s;
  });
  bool is_through = false;
  double lost_s = 0.0;
  const Measurement* before = nullptr;
  for (std::size_t i = contact.rows.begin; i < contact.rows.end; ++i) {
    const Measurement& row = input.rows[i];
    if (before && before->state == CellState::kLost) lost_s += row.time_s - before->time_s;
    if (row.state == CellState::kContact) ++(std::isfinite(row.contact_force_uN) ? force_count : forceless);
    if (row.state == CellState::kPunctured && !is_through) ++punctures;
    if (row.state) is_through = row.state == CellState::kPunctured;
    before = &row;
  }
  if (contact.unmeasured_frames > 0) {
    doubts.push_back(sentence("%d of %d frames were recorded but not measured: the largest values may lie between",
                              contact.unmeasured_frames, contact.frames));
  }
  if (forceless > 0) doubts.push_back(sentence("%d frames in contact have no force", forceless));
  if (force_count > 0 && force_count < 5)
    doubts.push_back(sentence("only %d frames in contact have a force", force_count));
  if (lost_s > 0.0) doubts.push_back(sentence("the cell was lost for %.2f s of the contact", lost_s));
  if (punctures > 1)
    doubts.push_back(
        sentence("%d punctures in one contact; the numbers are the first one's", static_cast<int>(punctures)));
}

}  // namespace

std::vector<std::string> contact_doubts(const PassportInput& input, const ContactSpan& span,
                                        const ContactPassport& contact) {
  std::vector<std::string> doubts;
  if (!span.is_touch_seen) doubts.emplace_back("first seen in contact: the touch itself is not in the recording");
  const double end_s = input.rows[contact.rows.end - 1].time_s;
  add_events(input, contact.touch_s, end_s, doubts);
  add_rows(input, contact, doubts);
  if (contact.confidence < kLowConfidence) {
    doubts.push_back(sentence("low confidence: %.0f %% in the median", 100.0 * contact.confidence));
  }
  // How single cells differ is no fault of this recording; earlier versions' intervals did not contain it.
  const bool has_parts = std::isfinite(contact.picture_sigma_percent);
  const double half_percent =
      has_parts ? 1.96 * contact.picture_sigma_percent
                : 50.0 * (contact.peak_force_upper_uN - contact.peak_force_lower_uN) / contact.peak_force_uN;
  if (half_percent > 100.0 * kWide_ratio) {
    doubts.push_back(sentence("a wide interval: the picture shows the peak force to +- %.0f %% only", half_percent));
  }
  if (contact.outcome == "punctured" && std::isnan(contact.puncture_force_uN)) {
    doubts.emplace_back("the puncture was seen, but no force just before it");
  }
  if (contact.outcome == "lost") doubts.emplace_back("the cell was lost in contact: what followed is not known");
  if (contact.outcome == "unfinished") doubts.emplace_back("the recording of this cell ends in contact");
  return doubts;
}

std::vector<std::string> cell_doubts(const CellSpan& span, const CellPassport& cell) {
  std::vector<std::string> doubts;
  if (span.away_s > 0.0) {
    doubts.push_back(
        sentence("found after %.1f s without a cell, and counted as another one than before", span.away_s));
  }
  if (span.lost_s > 0.0) {
    doubts.push_back(sentence("out of sight for %.1f s in all, and counted as the same cell after it", span.lost_s));
  }
  const auto punctures = std::count_if(cell.contact_list.begin(), cell.contact_list.end(),
                                       [](const auto& contact) { return contact.outcome == "punctured"; });
  if (punctures > 1) {
    doubts.push_back(
        sentence("punctured in %d contacts: these may be several cells at one place; a note that begins "
                 "with \"new cell\" keeps them apart",
                 static_cast<int>(punctures)));
  }
  return doubts;
}

std::vector<std::string> notes_between(const PassportInput& input, double begin_s, double end_s) {
  std::vector<std::string> notes;
  for (const Event& event : input.events) {
    if (event.kind != event_kind::kNote || event.detail.starts_with(kNoForceNote) || event.time_s < begin_s ||
        event.time_s > end_s || begins_new_cell(event) || named_cell(event)) {
      continue;
    }
    notes.push_back(sentence("%.2f s: ", event.time_s) + event.detail);
  }
  return notes;
}

std::vector<std::string> session_doubts(const SessionReader& session, const PassportInput& input) {
  std::vector<std::string> doubts = input.unread;
  if (!session.complete()) doubts.emplace_back("the recording was cut off, or is still being written");
  if (session.head_changed()) {
    doubts.emplace_back("session.json was changed after it was written: check calibration and profile");
  }
  if (session.skipped_row_count() > 0) {
    doubts.push_back(std::to_string(session.skipped_row_count()) +
                     " row(s) can't be read or were changed, and are left out; run pellucida check on the session");
  }
  for (std::string& one : frame_doubts(session)) doubts.push_back(std::move(one));
  return doubts;
}

std::string in_one_line(const std::vector<std::string>& sentences) {
  std::string line;
  for (const std::string& one : sentences) line += (line.empty() ? "" : "; ") + one;
  return line;
}

}  // namespace pellucida
