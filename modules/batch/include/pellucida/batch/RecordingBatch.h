#pragma once
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "pellucida/batch/BatchRow.h"

namespace pellucida {

/// How far a batch is.
struct BatchProgress {
  int done_count = 0;    ///< finished now or before
  int failed_count = 0;  ///< of these, not measured to their end
  int all_count = 0;
  double left_s = 0.0;  ///< estimated from the bytes done; NaN until something is
};

struct BatchSettings {
  std::filesystem::path program;     ///< that analyses one recording: `PROGRAM analyze INPUT --output FOLDER OPTIONS`
  std::filesystem::path output;      ///< of the batch
  Recipe recipe;                     ///< its options are passed on
  int job_count = 1;                 ///< child processes at once, >= 1
  bool again = false;                ///< also what is finished
  bool only_collect = false;         ///< analyse nothing
  std::function<int()> stop_signal;  ///< asked all the time: the number of a signal to stop by, 0 to go on
  std::function<void(const BatchProgress&)> progress;  ///< several times a second; may be empty
  /// After each recording, also one that was finished before: all rows so far, and its own. May be empty.
  std::function<void(std::span<const BatchRow>, const BatchRow&)> finished;
};

/// Analyses each recording in a child process of its own, so that a broken one, or a crash, is that one's row and
/// nothing else. Gives a row for each, in their order; `waiting` for what a stop, or `only_collect`, left undone.
///
/// A result is a session `output/NAME` and its record `records/NAME.json`; it is made below `.unfinished` and moved to
/// its place once it is whole, an older one staying until then. What is finished and made from the same input, by the
/// same recipe, is kept: only what is missing, failed without a session, or was made from something else is done.
///
/// On a stop, children get the same signal and are waited for; what they had is dropped. Should the caller be killed,
/// the system kills the children. Other batches may work in the same folder: a recording that one has begun is `failed`
/// in the other. A folder of that name which the batch didn't make is never touched: the recording fails.
///
/// Call from one thread, which must live until it returns. Throws OutputError when the output can't be written, also by
/// a child: what is finished stays.
std::vector<BatchRow> run_recordings(const std::vector<Recording>& recordings, const BatchSettings& settings);

/// Whether a recording's result is there, whole and made from what is there now.
bool is_finished(const Recording& recording, const BatchSettings& settings);

/// Seconds left after `elapsed_s` in which `done_bytes` of `all_bytes` were worked off; NaN before any were.
double estimate_left_s(double elapsed_s, double done_bytes, double all_bytes) noexcept;

}  // namespace pellucida
