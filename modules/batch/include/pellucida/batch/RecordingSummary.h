#pragma once
#include <filesystem>
#include <limits>
#include <span>
#include <string>

#include "pellucida/core/FieldTable.h"

namespace pellucida {

/// One recording in a few numbers, as in `summary.csv`. NaN: not measured.
struct RecordingSummary {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  int frame_count = 0;
  double duration_s = kNone;
  double measured_share = kNone;
  double peak_force_uN = kNone;
  double peak_force_lower_uN = kNone;
  double peak_force_upper_uN = kNone;
  double peak_depth_um = kNone;
  double peak_stiffness_uN_per_um = kNone;
  double puncture_time_s = kNone;
  double puncture_force_uN = kNone;
  double puncture_depth_um = kNone;
  double peak_picture_sigma_percent = kNone;
  double peak_scale_sigma_percent = kNone;
  int warning_count = 0;
  std::string warnings;  ///< "mismatch 2; slip 1"
};

/// The columns, with unit and meaning.
std::span<const Field<RecordingSummary>> recording_summary_columns() noexcept;

/// From a session's measurements and events. Throws InputError when it can't be read.
RecordingSummary summarize_recording(const std::filesystem::path& session);

}  // namespace pellucida
