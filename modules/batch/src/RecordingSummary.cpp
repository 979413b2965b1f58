#include "pellucida/batch/RecordingSummary.h"

#include <cmath>
#include <map>
#include <sstream>

#include "pellucida/core/Event.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {
namespace {

using S = RecordingSummary;
constexpr FieldRange kAnyNumber;
constexpr Field<S> kSummaryColumns[] = {
    {"frames", "", &S::frame_count, kAnyNumber, "frames in the session"},
    {"duration_s", "s", &S::duration_s, kAnyNumber, "from the first frame to the last"},
    {"measured_share", "0..1", &S::measured_share, kAnyNumber,
     "share of the frames with a contact force, 0 uN included"},
    {"peak_force_uN", "uN", &S::peak_force_uN, kAnyNumber, "largest contact force"},
    {"peak_force_lower_uN", "uN", &S::peak_force_lower_uN, kAnyNumber, "lower end of its 95 % interval, the whole"},
    {"peak_force_upper_uN", "uN", &S::peak_force_upper_uN, kAnyNumber, "upper end of it"},
    {"peak_depth_um", "um", &S::peak_depth_um, kAnyNumber, "indentation in that frame"},
    {"peak_stiffness_uN_per_um", "uN/um", &S::peak_stiffness_uN_per_um, kAnyNumber, "tangent stiffness in that frame"},
    {"peak_picture_sigma_percent", "%", &S::peak_picture_sigma_percent, kAnyNumber,
     "what the picture leaves open of that force (depth, sizes, model): standard deviation over the force; independent "
     "from recording to recording, but for the model's part"},
    {"peak_scale_sigma_percent", "%", &S::peak_scale_sigma_percent, kAnyNumber,
     "what the scale leaves open: how single cells of the kind differ, or what is left of it once this cell's scale "
     "was "
     "measured"},
    {"puncture_time_s", "s", &S::puncture_time_s, kAnyNumber, "time of the first event `puncture`"},
    {"puncture_force_uN", "uN", &S::puncture_force_uN, kAnyNumber, "largest contact force up to then"},
    {"puncture_depth_um", "um", &S::puncture_depth_um, kAnyNumber, "indentation in the frame of that force"},
    {"warning_count", "", &S::warning_count, kAnyNumber, "events `warning`"},
    {"warnings", "", &S::warnings, kAnyNumber, "how many of each kind: `mismatch 2; slip 1`"},
};

// The frame of the largest force up to `until_s`; null without a force above 0.
const Measurement* peak_until(const std::vector<Measurement>& rows, double until_s) {
  const Measurement* peak = nullptr;
  for (const Measurement& row : rows) {
    if (row.time_s > until_s || !(row.contact_force_uN > (peak ? peak->contact_force_uN : 0.0))) continue;
    peak = &row;
  }
  return peak;
}

// "mismatch+slip: contour 3.1 um from the model ..." is of the kinds "mismatch" and "slip".
std::vector<std::string> kinds_of(const std::string& detail) {
  std::vector<std::string> kinds;
  std::istringstream words(detail.substr(0, detail.find(':')));
  for (std::string word; std::getline(words, word, '+');) kinds.push_back(word);
  return kinds;
}

}  // namespace

std::span<const Field<RecordingSummary>> recording_summary_columns() noexcept {
  return kSummaryColumns;
}

RecordingSummary summarize_recording(const std::filesystem::path& session) {
  const SessionReader reader(session);
  const std::vector<Measurement>& rows = reader.measurements();
  RecordingSummary summary;
  summary.frame_count = static_cast<int>(rows.size());
  if (!rows.empty()) {
    summary.duration_s = rows.back().time_s - rows.front().time_s;
    double measured = 0.0;
    for (const Measurement& row : rows) measured += std::isnan(row.contact_force_uN) ? 0.0 : 1.0;
    summary.measured_share = measured / static_cast<double>(rows.size());
  }
  if (const Measurement* peak = peak_until(rows, std::numeric_limits<double>::infinity())) {
    summary.peak_force_uN = peak->contact_force_uN;
    summary.peak_force_lower_uN = peak->contact_force_lower_uN;
    summary.peak_force_upper_uN = peak->contact_force_upper_uN;
    const ForceSpread spread = force_spread(*peak);
    summary.peak_picture_sigma_percent = 100.0 * spread.picture_ratio;
    summary.peak_scale_sigma_percent = 100.0 * spread.scale_ratio;
    summary.peak_depth_um = peak->indentation_um;
    summary.peak_stiffness_uN_per_um = peak->stiffness_uN_per_um;
  }

  std::map<std::string, int> warnings;
  const std::vector<Event> events = reader.events();
  for (std::size_t i = 0; i < events.size(); ++i) {
    const Event& event = events[i];
    if (event.kind == event_kind::kWarning) {
      ++summary.warning_count;
      for (const std::string& kind : kinds_of(event.detail)) ++warnings[kind];
    }
    if (event.kind != event_kind::kPuncture || !std::isnan(summary.puncture_time_s) || is_revoked(events, i)) continue;
    summary.puncture_time_s = event.time_s;
    const Measurement* before = peak_until(rows, event.time_s);
    if (!before) continue;
    summary.puncture_force_uN = before->contact_force_uN;
    summary.puncture_depth_um = before->indentation_um;
  }
  for (const auto& [kind, count] : warnings) {
    summary.warnings += (summary.warnings.empty() ? "" : "; ") + kind + ' ' + std::to_string(count);
  }
  return summary;
}

}  // namespace pellucida
