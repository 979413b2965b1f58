#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "commands/FieldOption.h"
#include "commands/IdentifyRun.h"
#include "commands/ReplaceOption.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/identification/Identification.h"

namespace pellucida {

void add_identify_command(CLI::App& app) {
  auto a = std::make_shared<IdentifyArguments>();
  CLI::App* command = app.add_subcommand(
      "identify", "a cell's profile: the model's constants from finite elements, its force scale from a measurement");
  command->add_option("--output", a->output, "profile to write, JSON; a picture is written beside it, as PNG")
      ->required();
  command->add_option("--from", a->base,
                      "profile, by name or file, whose numbers are taken where none is given "
                      "(default: Table I's mouse oocyte)");
  command->add_option("--name", a->name, "the profile's name (default: the file's)");
  command->add_option("--description", a->description, "one line on what the cell is");
  command->add_option("--source", a->source, "where the numbers given here come from, for the profile")
      ->capture_default_str();
  // The profile's own numbers.
  CellProfile defaults = table_one_oocyte();
  const FieldList fields = fields_of(defaults);
  const auto field = [&](const char* option, const char* key) {
    return add_field_option(*command, option, *fields.find(key), a->numbers[key]);
  };
  field("--young-modulus-kPa", "material.young_modulus_kPa");
  field("--radius-um", "geometry.mid_radius_um");
  field("--thickness-um", "geometry.thickness_um");
  field("--poisson-ratio", "material.poisson_ratio");
  field("--tip-radius-um", "contact.tip_radius_um");
  field("--holder-radius-um", "contact.holder_ring_um");
  field("--holder-half-width-um", "contact.holder_half_width_um");
  CLI::Option* force = field("--puncture-force-uN", "material.puncture_force_uN");
  CLI::Option* depth = field("--puncture-indentation-um", "material.puncture_indentation_um");
  force->needs(depth);
  depth->needs(force);
  const auto number = [&](const char* option, std::optional<double>& value, const char* help) {
    return command->add_option(option, value, help);
  };
  number("--scale-uncertainty-percent", a->scale_uncertainty_percent,
         "standard deviation of a scale anchored to one point, % (default: 5, an assumption)")
      ->check(number_in({0.0, 100.0}));
  command
      ->add_option("--measured-curve", a->measured_curve,
                   "CSV, indentation_um,force_uN, needle opposite the holder: anchors the scale by least squares, with "
                   "its standard error")
      ->excludes("--scale-uncertainty-percent");
  command->add_option(
      "--relaxation", a->relaxation,
      "CSV, segment,style,time_s,height_um,force_uN: a ramp-and-hold record to fit two relaxation arms to");
  number("--anchor-ramp-s", a->anchor_ramp_s,
         "how long the push took whose force anchors the scale, s; 0: sudden (default: as fast as the record's ramp)")
      ->check(number_in({0.0, 1e9}));
  command
      ->add_flag("--keep-constants", a->keep_constants,
                 "keep the constants of --from; only the force scale and the relaxation are found")
      ->needs("--from");
  number("--max-indentation-um", a->max_indentation_um,
         "deepest point fitted, um (default: the puncture's, 1.06 radii at least)")
      ->check(number_in(above(0.0, 2e4)));
  command
      ->add_option("--edge-length-ratio", a->edge_length_ratio,
                   "factor on the finite elements' size: 1.4 is quicker and 3 to 8 % stiffer")
      ->check(number_in({0.5, 2.0}))
      ->capture_default_str();
  command
      ->add_option(
          "--geometry-cells", a->geometry_cells,
          "cells of other geometries to compute, 60 or more (200: about two minutes on two cores), so that the "
          "profile also holds for another thickness, tip and holder; 0: for its own alone, or as --from has it "
          "with --keep-constants")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  command->add_option("--jobs", a->threads, "threads (default: one a core)")->check(CLI::Range(1, 256));
  command->add_flag("--no-picture", a->no_picture, "draw no picture");
  add_replace_option(*command, a->replace);
  command->callback([a] { run_identify(*a); });
}

}  // namespace pellucida
