#include "commands/ForceCommand.h"

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/mechanics/CellProfile.h"
#include "pellucida/mechanics/Indenter.h"

namespace pellucida {
namespace {

struct ForceArguments {
  std::string profile;
  int configuration = 1;
  double max_indentation_um = 0.0;  // 0: the profile's puncture
  double step_um = 1.0;
  std::string output;
};

void write_force_curve(const ForceArguments& arguments) {
  const CellProfile profile = load_profile(arguments.profile);
  const double deepest_um =
      arguments.max_indentation_um != 0.0 ? arguments.max_indentation_um : profile.puncture_indentation_um;
  const auto curve = force_curve(profile, arguments.configuration, deepest_um, arguments.step_um);

  // The file, as far as the model goes.
  std::ofstream file(arguments.output);
  file << "indentation_um,force_uN,pressure_Pa,stiffness_uN_per_um\n";
  const IndentationState* last = nullptr;
  for (const auto& state : curve) {
    if (state.report.status != SolveStatus::kConverged) break;
    file << csv_number(state.depth_um) << ',' << csv_number(state.push_force_uN) << ',' << csv_number(state.pressure_Pa)
         << ',' << csv_number(state.stiffness_uN_per_um) << '\n';
    last = &state;
  }
  file.close();
  if (!file) throw OutputError(arguments.output + ": can't be written; check the folder and its permissions");
  if (last != &curve.back()) {
    throw Error(ExitCode::kOurFault, arguments.output + ": the model found no equilibrium beyond " +
                                         csv_number(last ? last->depth_um : 0.0) +
                                         " um; give a smaller --max-indentation-um");
  }
  std::cout << profile.name << ", configuration " << arguments.configuration << ": " << csv_number(last->push_force_uN)
            << " uN at " << csv_number(last->depth_um) << " um; " << curve.size() << " rows in " << arguments.output
            << '\n';
}

}  // namespace

void add_force_command(CLI::App& app) {
  auto arguments = std::make_shared<ForceArguments>();
  CLI::App* command = app.add_subcommand("force", "the model's force-indentation curve, no video");
  command->add_option("profile", arguments->profile, "cell profile, by name or file")->required();
  command
      ->add_option(
          "--configuration", arguments->configuration,
          "1: needle opposite the holder; 2: at 45 degrees; 3: at 90 degrees; 4: parallel, 10 um beside the axis")
      ->check(CLI::Range(1, 4))
      ->capture_default_str();
  command
      ->add_option("--max-indentation-um", arguments->max_indentation_um,
                   "deepest point, um (default: the profile's puncture)")
      ->check(CLI::PositiveNumber);
  command->add_option("--step-um", arguments->step_um, "distance of the rows, um")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--output", arguments->output, "CSV file: indentation_um,force_uN,pressure_Pa,stiffness_uN_per_um")
      ->required();
  command->callback([arguments] { write_force_curve(*arguments); });
}

}  // namespace pellucida
