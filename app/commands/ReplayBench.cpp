#include "commands/ReplayBench.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "commands/MeasureSession.h"
#include "commands/ReplayVariants.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/pipeline/AnySource.h"
#include "pellucida/pipeline/Counterfactual.h"
#include "pellucida/pipeline/LiveRun.h"
#include "pellucida/pipeline/RunProvenance.h"

namespace pellucida {
namespace {

constexpr double kSpeeds[] = {0.5, 1.0, 2.0};
constexpr std::chrono::milliseconds kLookEvery{20};

PaceFigures play(const std::string& session, const PipelineOptions& pipeline, double speed_ratio, double seconds) {
  PlaybackOptions playback;
  playback.loop_count = 0;
  LiveRun run(std::make_unique<SessionSource>(session, playback), pipeline, speed_ratio);
  run.start();
  LiveStatus status;
  do {
    std::this_thread::sleep_for(kLookEvery);
    status = run.status();
  } while (status.pace.wall_s() < seconds && !status.finished && !status.fault);
  run.stop();
  status = run.status();
  if (status.fault) throw InputError(session + ": " + *status.fault);
  return status.pace;
}

}  // namespace

ReplayFigures measure_replay(const std::string& source, const PipelineOptions& pipeline, double seconds) {
  const TemporaryFolder folder;
  std::string session = source;
  PipelineOptions options = pipeline;
  if (is_session(source)) {
    options = recorded_options(SessionReader(source).info());
  } else {
    session = (folder.path() / "session").string();
    const auto frames = open_any_source(source, {});
    require_measured(measure_session(*frames, pipeline, 2, session, {}, ""), source);
  }

  ReplayFigures figures;
  for (const double speed_ratio : kSpeeds) figures.paces.push_back(play(session, options, speed_ratio, seconds));

  const SessionReader reader(session);
  figures.recorded_s = reader.steps().back().time_s - reader.steps().front().time_s;
  const CellProfile profile = profile_of(options);
  CounterfactualOptions again;
  again.rerun = has_observations(reader) ? Rerun::kMechanics : Rerun::kTracking;
  again.pipeline = options;
  again.job_count = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const auto same = make_variants(profile, {}, {}, folder.path() / "same");
  figures.equal_row_count = run_counterfactual(session, again, same).variants.front().changes.equal_row_count;
  const auto five = make_variants(profile, {}, {"young_modulus_kPa=100,120,140,160,180"}, folder.path() / "five");
  const CounterfactualResult result = run_counterfactual(session, again, five);
  figures.variant_count = static_cast<int>(five.size());
  figures.frame_count = result.variants.front().changes.frame_count;
  figures.counterfactual_s = result.elapsed_s;
  return figures;
}

}  // namespace pellucida
