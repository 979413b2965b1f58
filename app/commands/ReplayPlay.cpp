#include "commands/ReplayPlay.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>
#include <thread>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/core/Progress.h"
#include "pellucida/pipeline/BatchRun.h"
#include "pellucida/pipeline/ChangeFigures.h"
#include "pellucida/pipeline/LiveRun.h"

namespace pellucida {
namespace {

constexpr std::chrono::milliseconds kLook{20};

std::string printed(const char* pattern, auto... numbers) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, numbers...);
  return text;
}

/// The recorded row of a frame; null where the session has none.
const Measurement* recorded_row(const SessionReader& session, long frame) {
  const auto& rows = session.measurements();
  const auto row = std::lower_bound(rows.begin(), rows.end(), frame,
                                    [](const Measurement& one, long index) { return one.frame < index; });
  return row != rows.end() && row->frame == frame ? &*row : nullptr;
}

void print_missing(const SessionSource& source) {
  if (source.absent_count() > 0) {
    std::cout << printed("missing  %ld frames have no image: skipped, all others at their own time\n",
                         source.absent_count());
  }
  if (source.damaged_count() > 0) {
    std::cout << printed("damaged  %ld frames can't be read: skipped; the first: ", source.damaged_count())
              << source.first_damage() << '\n';
  }
}

std::string state_of(const Measurement& row) {
  return row.state ? std::string(to_string(*row.state)) : "not measured";
}

std::string step_line(const Measurement& row, const Measurement* recorded) {
  std::string line = printed("frame %ld  %.3f s  %s", row.frame, row.time_s, state_of(row).c_str());
  if (!std::isnan(row.indentation_um)) line += printed("  depth %.2f um", row.indentation_um);
  if (!std::isnan(row.contact_force_uN)) {
    line += printed("  force %.3f uN (95 %%: %.3f to %.3f)", row.contact_force_uN, row.contact_force_lower_uN,
                    row.contact_force_upper_uN);
  }
  if (!recorded) return line;
  if (equal_as_written(*recorded, row)) return line + "  as recorded";
  return line + printed("  recorded: %s, %.3f uN", state_of(*recorded).c_str(), recorded->contact_force_uN);
}

/// Asks before each frame; frames already measured can be looked at again.
class AskingSource final : public FrameSource {
 public:
  AskingSource(FrameSource& source, const std::vector<std::string>& lines) : source_(source), lines_(lines) {}

  const SourceInfo& info() const noexcept override { return source_.info(); }

  std::optional<Frame> next() override {
    std::string word;
    while (ask(word)) {
      if (word.empty() || word == "n") {
        if (shown_ + 1 >= lines_.size()) return source_.next();
        std::cout << lines_[++shown_] << std::endl;
      } else if (word == "b" && shown_ > 0 && !lines_.empty()) {
        std::cout << lines_[--shown_] << std::endl;
      } else if (word == "b") {
        std::cout << "the first frame" << std::endl;
      } else if (word == "q") {
        return std::nullopt;
      } else {
        std::cout << word << ": Enter or n for the next frame, b for the one before, q to end" << std::endl;
      }
    }
    return std::nullopt;
  }

  /// A frame was measured, and its line was shown.
  void measured() { shown_ = lines_.size() - 1; }

 private:
  static bool ask(std::string& word) {
    if (isatty(STDIN_FILENO) == 1) std::cerr << "> " << std::flush;
    return static_cast<bool>(std::getline(std::cin, word));
  }

  FrameSource& source_;
  const std::vector<std::string>& lines_;
  std::size_t shown_ = 0;
};

void print_pace(const PaceFigures& pace) {
  std::cout << printed("pace     %.3f s of the recording in %.3f s at %g x: %+.3f %% of the wall clock, ",
                       pace.recorded_s(), pace.wall_s(), pace.speed_ratio, 100.0 * pace.error_ratio())
            << printed("no frame more than %.1f ms late\n", 1e3 * pace.largest_lateness_s);
}

}  // namespace

void play_session(const std::string& session, const PipelineOptions& pipeline, const PlaybackOptions& playback,
                  double speed_ratio) {
  auto opened = std::make_unique<SessionSource>(session, playback);
  // Owned by the run, which goes on living until all is printed.
  const SessionSource& source = *opened;
  LiveRun run(std::move(opened), pipeline, speed_ratio);
  LiveStatus status;
  {
    Progress progress("replay, frame");
    run.start();
    do {
      std::this_thread::sleep_for(kLook);
      status = run.status();
      progress.update(static_cast<long>(status.frame_count), source.info().frame_count);
    } while (!status.finished && !status.fault);
    run.stop();
    status = run.status();
  }
  if (status.fault) throw InputError(session + ": " + *status.fault);

  const auto rows = run.measurements_since(0);
  std::cout << printed("replay   %llu frames shown, %llu measured, %llu overtaken by a newer one\n",
                       static_cast<unsigned long long>(status.frame_count),
                       static_cast<unsigned long long>(status.measured_count),
                       static_cast<unsigned long long>(status.skipped_count));
  print_pace(status.pace);
  const auto peak = std::max_element(rows.begin(), rows.end(), [](const Measurement& a, const Measurement& b) {
    return !(b.contact_force_uN <= a.contact_force_uN) && !std::isnan(b.contact_force_uN);
  });
  if (peak != rows.end() && peak->contact_force_uN > 0.0) {
    std::cout << printed("force    %.2f uN (95 %%: %.2f to %.2f) at %.1f um, %.2f s\n", peak->contact_force_uN,
                         peak->contact_force_lower_uN, peak->contact_force_upper_uN, peak->indentation_um,
                         peak->time_s);
  }
  if (!playback.backwards && playback.loop_count == 1) {
    const auto equal_count = std::count_if(rows.begin(), rows.end(), [&](const Measurement& row) {
      const Measurement* recorded = recorded_row(source.session(), row.frame);
      return recorded && equal_as_written(*recorded, row);
    });
    std::cout << printed("equal    %ld of %zu measured rows are the recorded ones to the last digit\n",
                         static_cast<long>(equal_count), rows.size());
  }
  print_missing(source);
}

void step_through_session(const std::string& session, const PipelineOptions& pipeline,
                          const PlaybackOptions& playback) {
  SessionSource source(session, playback);
  std::vector<std::string> lines;
  AskingSource asking(source, lines);
  const bool comparable = !playback.backwards && playback.loop_count == 1;
  const BatchResult result = run_batch(asking, {.pipeline = pipeline}, [&](const Scene& scene) {
    const Measurement& row = scene.measurement;
    lines.push_back(step_line(row, comparable ? recorded_row(source.session(), row.frame) : nullptr));
    asking.measured();
    std::cout << lines.back() << std::endl;
  });
  if (result.input_fault) std::rethrow_exception(result.input_fault);
  print_missing(source);
}

}  // namespace pellucida
