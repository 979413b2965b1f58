#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "commands/FieldOption.h"
#include "commands/Interrupt.h"
#include "commands/ReplaceOption.h"
#include "commands/TrialPicture.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Progress.h"
#include "pellucida/evaluation/TrialSeries.h"
#include "pellucida/evaluation/TrialSummary.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

struct TrialArguments {
  bool simulated = false;
  bool no_slowing = false;
  bool no_picture = false;
  bool replace = false;
  int trials = 200, jobs = 0;
  std::uint64_t seed = 1;
  std::optional<double> force_scale_N_per_uN;
  std::string modality = "all", scenario = "injection";
  std::string output;
};

std::vector<Modality> modalities_of(const std::string& name) {
  if (const auto one = modality_of(name)) return {*one};
  return SeriesOptions{}.modalities;
}

void write_file(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  std::ostringstream text;
  write(text);
  OutputFile output(file);
  output.write(text.str());
  output.finish();
}

void run_trials(const TrialArguments& arguments) {
  if (!arguments.simulated) {
    throw UsageError("trial: this version has simulated operators only; add --simulated");
  }
  const fs::path folder(arguments.output);
  std::vector<fs::path> files{folder / "trials.csv", folder / "summary.csv"};
  if (!arguments.no_picture) files.push_back(folder / "trials.png");
  if (!arguments.replace) require_new(files);
  make_folder(folder);

  SeriesOptions options;
  options.modalities = modalities_of(arguments.modality);
  options.trials = arguments.trials;
  options.seed = arguments.seed;
  options.jobs = arguments.jobs;
  if (arguments.force_scale_N_per_uN) options.trial.force_scale_N_per_uN = *arguments.force_scale_N_per_uN;
  options.trial.slows_on_force = !arguments.no_slowing;
  const TrialScene scene(load_scenario(arguments.scenario));
  std::vector<TrialOutcome> outcomes;
  const InterruptScope interrupt;
  {
    Progress progress("simulated trials:");
    options.stopped = [] { return interrupted() != 0; };
    outcomes = run_series(scene, options, [&](long done, long all) { progress.update(done, all); });
  }
  if (outcomes.empty()) return;

  const auto summaries = summarize(outcomes);
  write_file(folder / "trials.csv", [&](std::ostream& stream) { write_trials_csv(stream, outcomes); });
  write_file(folder / "summary.csv", [&](std::ostream& stream) { write_summary_csv(stream, summaries); });
  std::cout << table_text(summaries) << effects_text(outcomes);
  std::cout << (folder / "trials.csv").string() << ", " << (folder / "summary.csv").string() << std::endl;
  if (arguments.no_picture) return;
  draw_trials(outcomes, folder / "trials.png");
  std::cout << (folder / "trials.png").string() << '\n';
}

}  // namespace

void add_trial_command(CLI::App& app) {
  auto a = std::make_shared<TrialArguments>();
  CLI::App* command = app.add_subcommand(
      "trial", "injections by a SIMULATED operator: 2-D image, 3-D view, 3-D and haptics, 3-D, haptics and a guide");
  command->add_flag("--simulated", a->simulated, "the operator is a model of a person (required: there is no other)");
  command->add_option("--trials", a->trials, "of each modality")->check(CLI::Range(1, 100000))->capture_default_str();
  command->add_option("--seed", a->seed, "of the first trial; incremented for the next ones")
      ->check(number_in({0.0, kMostSeed}))
      ->capture_default_str();
  command->add_option("--modality", a->modality, "what the operator sees and feels: all, 2d, 3d, haptics or guide")
      ->check(CLI::IsMember({"all", "2d", "3d", "haptics", "guide"}))
      ->capture_default_str();
  command->add_option("--scenario", a->scenario, "the cell, by name or file; one that can be punctured")
      ->capture_default_str();
  TrialOptions defaults;
  const FieldList fields = fields_of(defaults);
  add_field_option(*command, "--force-scale", *fields.find("trial.force_scale_N_per_uN"), a->force_scale_N_per_uN);
  command->add_flag("--no-slowing", a->no_slowing,
                    "a felt force moves the operator's arm, but does not make the operator slow down");
  command->add_option("--jobs", a->jobs, "threads (default: one per core)")->check(CLI::Range(1, 256));
  command->add_flag("--no-picture", a->no_picture, "draw no chart");
  command->add_option("--output", a->output, "folder for trials.csv, summary.csv, trials.png")->required();
  add_replace_option(*command, a->replace);
  command->callback([a] { run_trials(*a); });
}

}  // namespace pellucida
