#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "commands/FieldOption.h"
#include "commands/ReplaceOption.h"
#include "commands/ReplayBench.h"
#include "pellucida/bench/DisplayBench.h"
#include "pellucida/bench/HapticsBench.h"
#include "pellucida/bench/LiveBench.h"
#include "pellucida/bench/MechanicsBench.h"
#include "pellucida/bench/TrackingBench.h"
#include "pellucida/bench/WindowBench.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/core/NewFiles.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Progress.h"
#include "pellucida/identification/Identification.h"
#include "pellucida/pipeline/AnySource.h"
#include "pellucida/pipeline/BatchRun.h"
#include "pellucida/pipeline/SessionBench.h"

namespace pellucida {
namespace {

using Json = nlohmann::ordered_json;

struct BenchArguments {
  std::string part = "all";
  std::string json;
  bool replace = false;
  std::string source = "virtual";
  double seconds = 10.0;
  bool window = false;
  WindowBenchOptions window_options;
  PipelineOptions pipeline;
};

Json to_json(const Distribution& distribution) {
  return {{"p50", distribution.quantile(0.5)},
          {"p99", distribution.quantile(0.99)},
          {"p99_9", distribution.quantile(0.999)},
          {"max", distribution.max()},
          {"count", distribution.count()}};
}

void print_row(const char* name, const Distribution& us) {
  std::printf("%-28s %9.2f ms median %9.2f ms p99 %9.2f ms max %8zu\n", name, 1e-3 * us.quantile(0.5),
              1e-3 * us.quantile(0.99), 1e-3 * us.max(), us.count());
}

// The source as often as it takes to fill the time; the figures of all rounds together.
struct Rounds {
  std::map<std::string, Distribution> step_us;
  long frame_count = 0;
  double elapsed_s = 0.0;     ///< in the chain alone: reading, or drawing, the frames comes before
  std::vector<Scene> scenes;  ///< of the first round
};

Rounds run_rounds(const BenchArguments& arguments) {
  Rounds rounds;
  Progress progress("bench: frame");
  do {
    const auto source = open_any_source(arguments.source, {});
    const bool first_round = rounds.frame_count == 0;
    long count = 0;
    const auto keep = [&](const Scene& scene) {
      if (first_round) rounds.scenes.push_back(scene);
      progress.update(rounds.frame_count + ++count, std::nullopt);
    };
    BatchResult result = run_batch(*source, {.pipeline = arguments.pipeline}, keep);
    if (result.input_fault) std::rethrow_exception(result.input_fault);
    for (const auto& [step, us] : result.step_us) {
      rounds.step_us[step].add(us);
      if (step != "writing") rounds.elapsed_s += 1e-6 * us.mean() * static_cast<double>(us.count());
    }
    rounds.frame_count += count;
  } while (rounds.elapsed_s < arguments.seconds && rounds.frame_count > 0);
  return rounds;
}

Json bench_tracking(const BenchArguments& arguments) {
  const auto source = open_any_source(arguments.source, {});
  const TrackingFigures figures = measure_tracking(*source, arguments.seconds);
  print_row("tracking, per frame", figures.frame_us);
  Json parts = Json::object();
  for (const auto& [name, us] : figures.parts_us) {
    print_row(("  " + name).c_str(), us);
    parts[name] = to_json(us);
  }
  print_row("detection, per frame", figures.detect_us);
  std::printf("%-28s %9.1f frames/s, one thread\n", "tracking", figures.frames_per_s);
  return {{"frame_us", to_json(figures.frame_us)},
          {"detect_us", to_json(figures.detect_us)},
          {"parts_us", parts},
          {"frames_per_s", figures.frames_per_s}};
}

Json bench_mechanics(const Rounds& rounds, const std::string& profile_name) {
  print_row("mechanics, per frame", rounds.step_us.at("mechanics"));
  print_row("surface, per frame", rounds.step_us.at("surface"));
  const Scene* modelled = nullptr;
  for (const Scene& scene : rounds.scenes) {
    if (scene.model) modelled = &scene;
  }
  const auto nodes = modelled ? const_cast<vtkPolyData*>(modelled->model.get())->GetNumberOfPoints() : 0;
  const CellProfile profile = load_profile(profile_name);
  const ExplicitTimes explicit_steps = measure_explicit_steps(profile, profile.mesh_frequency);
  std::printf("%-28s %9.2f ns per spring and step, %d springs\n", "explicit time steps",
              explicit_steps.ns_per_spring_step, explicit_steps.spring_count);
  // The same by the size of the mesh, beside plain code that takes one connector at a time.
  Json sweep = Json::array();
  for (const int frequency : {7, 14, 32, 50, 71}) {
    const ExplicitTimes times = measure_explicit_steps(profile, frequency, 0.1);
    std::printf("  %7d nodes              %9.2f ns per spring and step, %.2f without AVX2, %.2f one at a time\n",
                times.node_count, times.ns_per_spring_step, times.plain_ns_per_spring_step,
                times.naive_ns_per_spring_step);
    sweep.push_back({{"nodes", times.node_count},
                     {"springs", times.spring_count},
                     {"ns_per_spring_step", times.ns_per_spring_step},
                     {"plain_ns_per_spring_step", times.plain_ns_per_spring_step},
                     {"naive_ns_per_spring_step", times.naive_ns_per_spring_step}});
  }
  return {{"nodes", nodes},
          {"springs", explicit_steps.spring_count},
          {"step_us", to_json(rounds.step_us.at("mechanics"))},
          {"surface_us", to_json(rounds.step_us.at("surface"))},
          {"ns_per_spring_step", explicit_steps.ns_per_spring_step},
          {"explicit_sweep", sweep}};
}

Json to_json(const LatencySummary& us) {
  return {{"p50", us.p50_us},       {"p99", us.p99_us}, {"p99_9", us.p99_9_us},
          {"p99_99", us.p99_99_us}, {"max", us.max_us}, {"count", us.count}};
}

void print_row(const char* name, const LatencySummary& us) {
  std::printf("%-28s %7.1f us median %7.1f us p99 %8.1f us p99.9 %8.1f us p99.99 %8.1f us max %8llu\n", name, us.p50_us,
              us.p99_us, us.p99_9_us, us.p99_99_us, us.max_us, static_cast<unsigned long long>(us.count));
}

Json bench_haptics(const BenchArguments& arguments) {
  const HapticsFigures figures = measure_haptics(arguments.seconds);
  print_row("haptic tick, lateness", figures.lateness_us);
  print_row("haptic tick, compute", figures.compute_us);
  std::printf("%-28s %llu missed; %s\n", "", static_cast<unsigned long long>(figures.missed_count),
              figures.policy.c_str());
  std::printf("%-28s %9.1f frames/s measured, %.1f frames/s drawn\n", "beside it", figures.pipeline_frames_per_s,
              figures.display_frames_per_s);
  Json report{{"lateness_us", to_json(figures.lateness_us)},
              {"compute_us", to_json(figures.compute_us)},
              {"missed", figures.missed_count},
              {"policy", figures.policy},
              {"pipeline_frames_per_s", figures.pipeline_frames_per_s},
              {"display_frames_per_s", figures.display_frames_per_s}};
  if (!figures.cyclictest) {
    std::printf("%-28s not installed (Debian's rt-tests): nothing to compare the lateness with\n", "cyclictest");
    return report;
  }
  const LatencySummary& floor = figures.cyclictest->lateness_us;
  print_row("cyclictest, lateness", floor);
  const auto ratio = [](double ours, double theirs) { return theirs > 0.0 ? ours / theirs : 0.0; };
  const double p50 = ratio(figures.lateness_us.p50_us, floor.p50_us);
  const double p99 = ratio(figures.lateness_us.p99_us, floor.p99_us);
  const double p99_9 = ratio(figures.lateness_us.p99_9_us, floor.p99_9_us);
  std::printf("%-28s %7.2f x median %9.2f x p99 %9.2f x p99.9; cyclictest with %s\n", "ours over cyclictest's", p50,
              p99, p99_9, figures.cyclictest->policy.c_str());
  report["cyclictest"] = {{"lateness_us", to_json(floor)},
                          {"policy", figures.cyclictest->policy},
                          {"ratio", {{"p50", p50}, {"p99", p99}, {"p99_9", p99_9}}}};
  return report;
}

/// A whole identification with the defaults: half a minute, so that only who asks for the mechanics gets it.
Json bench_identification() {
  const IdentificationTimes times = measure_identification();
  std::printf("%-28s %9.1f s, %.1f s of processor; finite elements %.1f s, fit %.1f s, %d evaluations\n",
              "identification", times.wall_s, times.processor_s, times.reference_s, times.fit_s, times.fit_evaluations);
  return {{"wall_s", times.wall_s},
          {"processor_s", times.processor_s},
          {"finite_elements_s", times.reference_s},
          {"fit_s", times.fit_s},
          {"fit_evaluations", times.fit_evaluations}};
}

Json bench_pipeline(const Rounds& rounds, const BenchArguments& arguments) {
  const LiveFigures live = measure_live(*open_any_source(arguments.source, {}), arguments.pipeline, arguments.seconds);
  print_row("frame arrival to force, live", live.frame_to_force_us);
  print_row("  while a cell is searched", live.search_us);
  if (live.skipped_count > 0) std::printf("  %ld frames skipped, overtaken by newer ones\n", live.skipped_count);
  const double frames_per_s = static_cast<double>(rounds.frame_count) / rounds.elapsed_s;
  std::printf("%-28s %9.1f frames/s, one thread\n", "chain", frames_per_s);
  const double display_frames_per_s = measure_display_frames_per_s(rounds.scenes);
  std::printf("%-28s %9.1f frames/s, off screen\n", "feed, 3-D view, charts", display_frames_per_s);
  return {{"frame_to_force_us", to_json(live.frame_to_force_us)},
          {"search_us", to_json(live.search_us)},
          {"skipped", live.skipped_count},
          {"frames_per_s", frames_per_s},
          {"display_frames_per_s", display_frames_per_s}};
}

Json bench_session(const Rounds& rounds, const SourceInfo& source, double seconds) {
  const SessionBenchReport measured = measure_sessions(rounds.scenes, source, seconds);
  std::cout << measured.text;
  return Json::parse(measured.json);
}

Json bench_window(WindowBenchOptions options, const BenchArguments& arguments) {
  options.program = std::filesystem::canonical("/proc/self/exe");
  options.source = arguments.source;
  const WindowBenchReport measured = measure_window(options);
  std::cout << measured.text;
  return Json::parse(measured.json);
}

Json bench_replay(const BenchArguments& arguments) {
  const ReplayFigures figures = measure_replay(arguments.source, arguments.pipeline, arguments.seconds);
  Json paces = Json::array();
  for (const PaceFigures& pace : figures.paces) {
    std::printf("replay at %-18g %+9.4f %% of the wall clock over %.1f s, no frame more than %.1f ms late\n",
                pace.speed_ratio, 100.0 * pace.error_ratio(), pace.wall_s(), 1e3 * pace.largest_lateness_s);
    paces.push_back({{"speed_ratio", pace.speed_ratio},
                     {"wall_s", pace.wall_s()},
                     {"recorded_s", pace.recorded_s()},
                     {"error_ratio", pace.error_ratio()},
                     {"largest_lateness_s", pace.largest_lateness_s}});
  }
  std::printf("%-28s %9d of %d rows equal\n", "replay without changes", figures.equal_row_count, figures.frame_count);
  std::printf("%-28s %9.1f s for %d moduli on %.1f s of %d frames\n", "counterfactual", figures.counterfactual_s,
              figures.variant_count, figures.recorded_s, figures.frame_count);
  return {{"pace", paces},
          {"frames", figures.frame_count},
          {"equal_rows", figures.equal_row_count},
          {"recorded_s", figures.recorded_s},
          {"variants", figures.variant_count},
          {"counterfactual_s", figures.counterfactual_s}};
}

void write_report(const BenchArguments& arguments, const Json& report) {
  if (arguments.json.empty()) return;
  OutputFile file(arguments.json);
  file.add(report.dump(2));
  file.finish();
}

void bench(const BenchArguments& arguments) {
  const auto wanted = [&](const char* part) { return arguments.part == "all" || arguments.part == part; };
  // Thrice the time of the others: only who asks for it gets it.
  const bool replays = arguments.part == "replay";
  if (!(replays || wanted("tracking") || wanted("mechanics") || wanted("haptics") || wanted("pipeline") ||
        wanted("session"))) {
    throw UsageError("bench " + arguments.part +
                     ": give tracking, mechanics, haptics, pipeline, session, replay or all");
  }
  if (!arguments.json.empty()) {
    require_apart(arguments.json, arguments.source, "--json");
    if (!arguments.replace) require_new({arguments.json});
  }
  Json report;
  if (arguments.window) {
    report["pipeline"]["window"] = bench_window(arguments.window_options, arguments);
    write_report(arguments, report);
    return;
  }
  if (replays) report["replay"] = bench_replay(arguments);
  if (wanted("tracking")) report["tracking"] = bench_tracking(arguments);
  if (wanted("haptics")) report["haptics"] = bench_haptics(arguments);
  if (arguments.part != "tracking" && arguments.part != "haptics" && !replays) {
    const SourceInfo source = open_any_source(arguments.source, {})->info();
    const Rounds rounds = run_rounds(arguments);
    if (rounds.frame_count == 0) throw NothingMeasuredError(arguments.source + ": it has no frames");
    if (wanted("mechanics")) report["mechanics"] = bench_mechanics(rounds, arguments.pipeline.profile);
    if (arguments.part == "mechanics") report["mechanics"]["identification"] = bench_identification();
    if (wanted("pipeline")) report["pipeline"] = bench_pipeline(rounds, arguments);
    if (wanted("session")) report["session"] = bench_session(rounds, source, arguments.seconds);
  }
  write_report(arguments, report);
}

}  // namespace

void add_bench_command(CLI::App& app) {
  auto arguments = std::make_shared<BenchArguments>();
  CLI::App* command = app.add_subcommand("bench", "measure the program's own speed");
  command->add_option("part", arguments->part, "tracking, mechanics, haptics, pipeline, session, replay or all")
      ->capture_default_str();
  command->add_option("--json", arguments->json, "also write the figures to this file (microseconds unless named)");
  add_replace_option(*command, arguments->replace);
  command->add_option("--seconds", arguments->seconds, "measure for at least this long, s")
      ->check(number_in(above(0.0, 3600.0)))
      ->capture_default_str();
  command->add_option("--source", arguments->source, "virtual[:SCENARIO], a file or a session")->capture_default_str();
  command->add_option("--profile", arguments->pipeline.profile, "cell profile, by name or file")->capture_default_str();
  command->add_flag("--window", arguments->window,
                    "pipeline: the real window, 1400 x 900, with the hand: frames drawn, blocks, start, memory");
  command->add_option("--against", arguments->window_options.against,
                      "--window: another pellucida, such as an older one, in turns with this one");
  command
      ->add_option("--minutes", arguments->window_options.minutes,
                   "--window: one more turn of this length, for the memory, min")
      ->check(number_in({0.0, 600.0}));
  command->callback([command, arguments] {
    if (arguments->window && arguments->part != "pipeline") throw UsageError("--window belongs to bench pipeline");
    for (const char* option : {"--against", "--minutes"}) {
      if (command->count(option) > 0 && !arguments->window)
        throw UsageError(std::string(option) + " belongs to --window");
    }
    // Long enough for a demonstration to touch the cell.
    if (command->count("--seconds") > 0) arguments->window_options.seconds = arguments->seconds;
    bench(*arguments);
  });
}

}  // namespace pellucida
