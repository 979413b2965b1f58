// Makes the tables that the virtual specimen is drawn from, for any geometry: fem_make_reference --help.
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <numbers>
#include <string>

#include "ReferenceTables.h"
#include "pellucida/core/Error.h"

namespace {

using namespace pellucida;

struct Arguments {
  ShellSpecimen specimen;
  int configuration = 1;
  double offset_um = 10.0;
  double holder_angle_deg = -1.0;  // below 0: the configuration's
  ShellContact tools;              // tip and holder; the rest follows from the configuration
  ShellOptions options;
  bool solid = false;
  double max_indentation_um = 44.0;
  double step_um = 2.0;
  std::string folder = ".";
  std::string name;
};

ShellContact contact_of(const Arguments& arguments) {
  ShellContact contact = contact_for_configuration(arguments.configuration, arguments.offset_um);
  if (arguments.holder_angle_deg >= 0.0) contact.holder_angle_rad = arguments.holder_angle_deg * std::numbers::pi / 180;
  contact.tip_radius_um = arguments.tools.tip_radius_um;
  contact.holder_ring_um = arguments.tools.holder_ring_um;
  contact.holder_half_width_um = arguments.tools.holder_half_width_um;
  contact.tip_bond_per_um = arguments.tools.tip_bond_per_um;
  contact.holder_bond_per_um = arguments.tools.holder_bond_per_um;
  return contact;
}

/// Keeps depths 0, half a step, one step, two, ...: the first bit of the curve bends most.
template <class Curve>
void thin_out(Curve& curve) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < curve.steps.size(); ++k) {
    if (k < 2 || k % 2 == 0 || k + 1 == curve.steps.size()) curve.steps[kept++] = curve.steps[k];
  }
  curve.steps.resize(kept);
}

template <class Reference, class Report>
int make(const Arguments& arguments, Reference reference, Report report) {
  const auto start = std::chrono::steady_clock::now();
  auto curve = reference.run(arguments.max_indentation_um, 0.5 * arguments.step_um, report);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  thin_out(curve);
  write_reference_tables(reference, curve, arguments.folder, arguments.name);
  std::cout << curve.steps.size() << " depths in " << seconds << " s: " << arguments.folder << '/' << arguments.name
            << "-{force,profile}.csv\n";
  if (curve.outcome == CurveOutcome::kComplete) return 0;
  std::cerr << "no equilibrium at " << curve.failed_indentation_um << " um (" << to_string(curve.failure.status)
            << "); the tables end before. Try a smaller step, or another --edge-length-ratio.\n";
  return static_cast<int>(ExitCode::kOurFault);
}

int make(const Arguments& arguments) {
  const ShellContact contact = contact_of(arguments);
  if (arguments.solid) {
    return make(arguments,
                SolidReference(arguments.specimen, contact, {.edge_length_ratio = arguments.options.edge_length_ratio}),
                [](const SolidStep& step, double) {
                  std::cout << step.indentation_um << " um: " << step.force_uN << " uN; " << step.pressure_kPa
                            << " kPa; " << step.report.iterations << " iterations" << std::endl;
                });
  }
  return make(arguments, ShellReference(arguments.specimen, contact, arguments.options),
              [](const ShellStep& step, double) {
                std::cout << step.indentation_um << " um: " << step.axial_force_uN << " uN along the push, "
                          << step.lateral_force_uN << " across; " << step.pressure_kPa << " kPa; "
                          << step.report.iterations << " iterations" << std::endl;
              });
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Finite-element force and shape of a cell under a needle, as tables for the virtual specimen");
  app.option_defaults()->always_capture_default();
  app.add_option("--name", arguments.name, "the files' stem, e.g. mouse-oocyte-4")->required();
  app.add_option("--folder", arguments.folder, "where they go");
  app.add_option("--configuration", arguments.configuration, "1 aligned, 2 at 45 degrees, 3 at 90, 4 beside the axis");
  app.add_option("--offset-um", arguments.offset_um, "of configuration 4");
  app.add_option("--holder-angle-deg", arguments.holder_angle_deg,
                 "0 opposite the needle to 90; instead of the configuration's");
  app.add_option("--radius-um", arguments.specimen.mid_radius_um, "of the middle surface");
  app.add_option("--thickness-um", arguments.specimen.thickness_um);
  app.add_option("--young-modulus-kpa", arguments.specimen.young_modulus_kPa,
                 "forces and pressures go with it; the shape does not");
  app.add_option("--poisson-ratio", arguments.specimen.poisson_ratio);
  app.add_option("--tip-radius-um", arguments.tools.tip_radius_um);
  app.add_option("--holder-ring-um", arguments.tools.holder_ring_um, "mean radius of the holder's mouth");
  app.add_option("--holder-half-width-um", arguments.tools.holder_half_width_um, "of the ring it bears on");
  app.add_option("--tip-bond-per-um", arguments.tools.tip_bond_per_um,
                 "peak density of the needle's bond, over the modulus");
  app.add_option("--holder-bond-per-um", arguments.tools.holder_bond_per_um, "the same of the holder's");
  app.add_option("--max-indentation-um", arguments.max_indentation_um);
  app.add_option("--step-um", arguments.step_um, "of the depths; the first step is halved");
  app.add_option("--edge-length-ratio", arguments.options.edge_length_ratio, "mesh: 1 reference, 1.4 coarse, 0.6 fine");
  app.add_flag("--solid", arguments.solid, "a solid of revolution instead of a shell; configuration 1 only");
  CLI11_PARSE(app, argc, argv);
  try {
    return make(arguments);
  } catch (const Error& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(error.code());
  }
}
