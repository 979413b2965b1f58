#include "pellucida/batch/BatchRow.h"

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldCsv.h"

namespace pellucida {
namespace {

using R = BatchRow;
constexpr FieldRange kAnyValue;
constexpr Field<R> kHeadColumns[] = {
    {"name", "", &R::name, kAnyValue, "the recording's name: of its folder in the output"},
    {"group", "", &R::group, kAnyValue, "its group with `--group-by`; else the folder that holds it"},
    {"input", "", &R::input, kAnyValue, "what was analysed"},
    {"result", "", &R::result, kAnyValue,
     "`measured` to its end; `damaged`: broken off, the session holds everything before the damage; `nothing`: read to "
     "its end, no cell in any frame; `failed`: no session; `waiting`: not analysed yet, or changed since"},
    {"session", "", &R::session, kAnyValue, "the session's folder, relative to this file; empty for none"},
    {"exit_code", "", &R::exit_code, kAnyValue,
     "of `pellucida analyze` for this recording; 128 and the signal's number where a signal ended it; empty while it "
     "is waiting"},
    {"error", "", &R::error, kAnyValue, "what went wrong, where, and what helps, in one line"},
};
constexpr Field<R> kTailColumns[] = {
    {"wall_time_s", "s", &R::wall_time_s, kAnyValue, "time the analysis took"},
    {"speed_ratio", "", &R::speed_ratio, kAnyValue,
     "recorded time over that time: 2 is twice as fast as it was recorded"},
};

std::string result_of(const RecordingRecord& record, bool has_session) {
  if (!has_session) return batch_result::kFailed;
  switch (static_cast<ExitCode>(record.exit_code)) {
    case ExitCode::kDone:
      return batch_result::kMeasured;
    case ExitCode::kNothingMeasured:
      return batch_result::kNothing;
    default:
      return batch_result::kDamaged;
  }
}

}  // namespace

std::span<const Field<BatchRow>> batch_row_head_columns() noexcept {
  return kHeadColumns;
}

std::span<const Field<BatchRow>> batch_row_tail_columns() noexcept {
  return kTailColumns;
}

BatchRow make_row(const Recording& recording, const std::optional<RecordingRecord>& record,
                  const std::filesystem::path& output) {
  BatchRow row;
  row.name = recording.name;
  row.group = recording.group;
  row.input = recording.input;
  if (!record) return row;
  row.exit_code = record->exit_code;
  row.error = record->error;
  row.wall_time_s = record->wall_time_s;
  const bool has_session = !record->session_sha256.empty();
  row.result = result_of(*record, has_session);
  if (!has_session) return row;
  row.session = recording.name;
  row.numbers = summarize_recording(output / recording.name);
  row.speed_ratio = row.numbers.duration_s / row.wall_time_s;
  return row;
}

std::string summary_csv(std::span<const BatchRow> rows) {
  std::string text = csv_header(batch_row_head_columns()) + ',' + csv_header(recording_summary_columns()) + ',' +
                     csv_header(batch_row_tail_columns()) + '\n';
  for (const BatchRow& row : rows) {
    text += csv_row(batch_row_head_columns(), row) + ',' + csv_row(recording_summary_columns(), row.numbers) + ',' +
            csv_row(batch_row_tail_columns(), row) + '\n';
  }
  return text;
}

}  // namespace pellucida
