#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pellucida/batch/RecordingList.h"
#include "pellucida/batch/RecordingRecord.h"
#include "pellucida/batch/RecordingSummary.h"

namespace pellucida {

/// What became of a recording; the words are those of the column `result`.
namespace batch_result {
inline constexpr const char* kMeasured = "measured";  ///< to its end
inline constexpr const char* kDamaged = "damaged";    ///< a session holds everything before the damage
inline constexpr const char* kNothing = "nothing";    ///< read to its end, and no cell in any frame
inline constexpr const char* kFailed = "failed";      ///< no session
inline constexpr const char* kWaiting = "waiting";    ///< not analysed, or changed since
}  // namespace batch_result

/// A row of `summary.csv`: the recording, what became of it, its numbers, what it took.
struct BatchRow {
  std::string name;
  std::string group;
  std::string input;
  std::string result = batch_result::kWaiting;
  std::string session;                         ///< folder, relative to the batch's output; empty for none
  double exit_code = RecordingSummary::kNone;  ///< a whole number; NaN while it is waiting
  std::string error;
  RecordingSummary numbers;
  double wall_time_s = RecordingSummary::kNone;
  double speed_ratio = RecordingSummary::kNone;
};

/// The columns before and after those of `RecordingSummary`, with unit and meaning.
std::span<const Field<BatchRow>> batch_row_head_columns() noexcept;
std::span<const Field<BatchRow>> batch_row_tail_columns() noexcept;

/// The row of a recording; without a record it is waiting. `output`: the batch's folder.
BatchRow make_row(const Recording& recording, const std::optional<RecordingRecord>& record,
                  const std::filesystem::path& output);

/// `summary.csv`, header and all rows.
std::string summary_csv(std::span<const BatchRow> rows);

}  // namespace pellucida
