#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "commands/FieldOption.h"
#include "commands/ReplaceOption.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Table.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/membrane/MembraneGeometry.h"

namespace pellucida {
namespace {

struct ForceArguments {
  std::string profile;
  int configuration = 1;
  double max_indentation_um = 0.0;  // 0: the profile's puncture
  double step_um = 1.0;
  std::optional<double> angle_deg, offset_um, radius_um, thickness_um, tip_radius_um, holder_radius_um;
  std::optional<double> speed_um_per_s, hold_s;
  std::string output;
  bool replace = false;
};

/// A row of the file. `time_s` counts from the contact, where a speed is given.
struct Row {
  double depth_um, force_uN, pressure_Pa, stiffness_uN_per_um, time_s;
};

constexpr int kHoldRows = 100;

/// A push of a given speed and a hold, in a membrane that relaxes: everything but the shape goes with what is left of
/// the elastic force.
std::vector<Row> relax(const std::vector<Row>& elastic, const CellProfile& profile, double speed_um_per_s,
                       double hold_s) {
  const double sudden = profile.relaxation_elastic_ratio;
  Relaxation relaxation(profile.relaxation_arms);
  relaxation.start(0.0);
  std::vector<Row> rows;
  const auto add = [&](Row row, double time_s) {
    const double force_uN = relaxation.advance(time_s, sudden * row.force_uN);
    const double left = row.force_uN > 0.0 ? force_uN / row.force_uN : 1.0;
    rows.push_back({row.depth_um, force_uN, left * row.pressure_Pa, sudden * row.stiffness_uN_per_um, time_s});
  };
  for (const Row& row : elastic) add(row, row.depth_um / speed_um_per_s);
  const double end_s = elastic.back().depth_um / speed_um_per_s;
  for (int k = 1; hold_s > 0.0 && k <= kHoldRows; ++k) add(elastic.back(), end_s + hold_s * k / kHoldRows);
  return rows;
}

/// The profile's geometry with what the command line says otherwise.
MembraneGeometry geometry_for(const ForceArguments& arguments, const CellProfile& profile) {
  MembraneGeometry geometry = geometry_of(profile);
  geometry.mid_radius_um = arguments.radius_um.value_or(geometry.mid_radius_um);
  geometry.thickness_um = arguments.thickness_um.value_or(geometry.thickness_um);
  geometry.tip_radius_um = arguments.tip_radius_um.value_or(geometry.tip_radius_um);
  geometry.holder_radius_um = arguments.holder_radius_um.value_or(geometry.holder_radius_um);
  const struct {
    const char* option;
    double value_um, most_ratio;
  } lengths[] = {{"--thickness-um", geometry.thickness_um, 0.5},
                 {"--tip-radius-um", geometry.tip_radius_um, 0.5},
                 {"--holder-radius-um", geometry.holder_radius_um, 0.95}};
  for (const auto& length : lengths) {
    if (length.value_um <= length.most_ratio * geometry.mid_radius_um) continue;
    throw UsageError(std::string(length.option) + ": " + csv_number(length.value_um) +
                     " um is too much for a cell of " + csv_number(geometry.mid_radius_um) + " um; give at most " +
                     csv_number(length.most_ratio * geometry.mid_radius_um) + " um");
  }
  const bool other =
      arguments.radius_um || arguments.thickness_um || arguments.tip_radius_um || arguments.holder_radius_um;
  if (other && profile.geometry_terms.empty()) {
    std::cerr << "warning: profile " << profile.name
              << " holds for its own geometry alone; make one with pellucida identify --geometry-cells\n";
  } else if (is_beyond_range(profile, geometry)) {
    std::cerr << "warning: this geometry is beyond those that profile " << profile.name << " was identified for\n";
  }
  return geometry;
}

void write_force_curve(const ForceArguments& arguments) {
  require_apart(arguments.output, arguments.profile, "--output");
  if (!arguments.replace) require_new({arguments.output});
  const CellProfile profile = load_profile(arguments.profile);
  const MembraneGeometry geometry = geometry_for(arguments, profile);
  if (arguments.speed_um_per_s && profile.relaxation_arms.empty()) {
    throw UsageError("--speed-um-per-s: profile " + profile.name +
                     " has no relaxation; give it one with pellucida identify --relaxation");
  }
  const CellProfile cell = adapted_to(profile, geometry);
  const bool own_setup = arguments.angle_deg || arguments.offset_um;
  const MembraneSetup setup = own_setup
                                  ? setup_for_needle(cell, arguments.angle_deg.value_or(0.0) * std::numbers::pi / 180.0,
                                                     arguments.offset_um.value_or(0.0))
                                  : setup_for_configuration(cell, arguments.configuration);
  const double deepest_um =
      arguments.max_indentation_um != 0.0 ? arguments.max_indentation_um : profile.puncture_indentation_um;
  const auto curve = force_curve(profile, geometry, setup, deepest_um, arguments.step_um);

  // As far as the model goes.
  std::vector<Row> rows;
  for (const auto& state : curve) {
    if (state.report.status != SolveStatus::kConverged) break;
    rows.push_back({state.depth_um, state.push_force_uN, state.pressure_Pa, state.stiffness_uN_per_um, 0.0});
  }
  const std::size_t reached = rows.size();
  const double reached_um = rows.empty() ? 0.0 : rows.back().depth_um;
  const bool relaxes = arguments.speed_um_per_s && !rows.empty();
  if (relaxes) rows = relax(rows, profile, *arguments.speed_um_per_s, arguments.hold_s.value_or(0.0));

  OutputFile file(arguments.output);
  file.add(std::string("indentation_um,force_uN,pressure_Pa,stiffness_uN_per_um") + (relaxes ? ",time_s" : ""));
  for (const Row& row : rows) {
    std::string line = csv_number(row.depth_um);
    for (const double value : {row.force_uN, row.pressure_Pa, row.stiffness_uN_per_um}) line += ',' + csv_number(value);
    if (relaxes) line += ',' + csv_number(row.time_s);
    file.add(line);
  }
  file.finish();
  if (reached < curve.size()) {
    throw Error(ExitCode::kOurFault, arguments.output + ": the model found no equilibrium beyond " +
                                         csv_number(reached_um) + " um; give a smaller --max-indentation-um");
  }
  const std::string where = own_setup ? "needle at " + csv_number(arguments.angle_deg.value_or(0.0)) + " degrees, " +
                                            csv_number(arguments.offset_um.value_or(0.0)) + " um beside the centre"
                                      : "configuration " + std::to_string(arguments.configuration);
  std::cout << profile.name << ", " << where << ": " << csv_number(rows.back().force_uN) << " uN at "
            << csv_number(rows.back().depth_um) << " um; " << rows.size() << " rows in " << arguments.output << '\n';
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
      ->add_option("--angle-deg", arguments->angle_deg,
                   "between the axes of needle and holder, 0 to 90 degrees, instead of a configuration")
      ->check(number_in({0.0, 90.0}))
      ->excludes("--configuration");
  command
      ->add_option("--offset-um", arguments->offset_um,
                   "of the needle's axis beside the cell's centre, um, towards the holder's side above 0, instead of a "
                   "configuration")
      ->check(number_in({-1e4, 1e4}))
      ->excludes("--configuration");
  const auto length = [&](const char* option, std::optional<double>& value, const char* help) {
    command->add_option(option, value, help)->check(number_in(above(0.0, 1e4)));
  };
  length("--radius-um", arguments->radius_um, "of the zona's middle surface, um (default: the profile's)");
  length("--thickness-um", arguments->thickness_um, "of the zona, um (default: the profile's)");
  length("--tip-radius-um", arguments->tip_radius_um, "of the needle, um (default: the profile's)");
  length("--holder-radius-um", arguments->holder_radius_um,
         "of the holding pipette, outer, um (default: the profile's)");
  command
      ->add_option("--max-indentation-um", arguments->max_indentation_um,
                   "deepest point, um (default: the profile's puncture)")
      ->check(number_in(above(0.0, 1e9)));
  command->add_option("--step-um", arguments->step_um, "step between rows, um")
      ->check(number_in(above(0.0, 1e9)))
      ->capture_default_str();
  CLI::Option* speed =
      command
          ->add_option("--speed-um-per-s", arguments->speed_um_per_s,
                       "push at this speed, for a profile with relaxation: forces decay meanwhile, and "
                       "a column time_s is added")
          ->check(number_in(above(0.0, 1e9)));
  command->add_option("--hold-s", arguments->hold_s, "then hold the needle there, s")
      ->check(number_in(above(0.0, 1e9)))
      ->needs(speed);
  command
      ->add_option("--output", arguments->output, "CSV file: indentation_um,force_uN,pressure_Pa,stiffness_uN_per_um")
      ->required();
  add_replace_option(*command, arguments->replace);
  command->callback([arguments] { write_force_curve(*arguments); });
}

}  // namespace pellucida
