#include "commands/IdentifyCommand.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>

#include "commands/CommandLine.h"
#include "commands/IdentifyPicture.h"
#include "commands/Progress.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/Version.h"
#include "pellucida/identification/Identification.h"
#include "pellucida/identification/RelaxationFit.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

struct IdentifyArguments {
  std::string output;
  std::string base;  ///< a profile to start from
  std::string name, description, source = "given on the command line";
  std::optional<double> young_modulus_kPa, radius_um, thickness_um, poisson_ratio;
  std::optional<double> tip_radius_um, holder_radius_um, holder_half_width_um;
  std::optional<double> puncture_force_uN, puncture_indentation_um, scale_uncertainty_percent;
  std::optional<double> max_indentation_um, anchor_ramp_s;
  std::string measured_curve, relaxation;
  double edge_length_ratio = 1.0;
  int threads = 0;
  bool keep_constants = false;
  bool no_picture = false;
};

void set_if(std::optional<double> given, double& value) {
  if (given) value = *given;
}

void set_source(CellProfile& cell, const std::string& what, const std::string& where) {
  for (auto& [key, text] : cell.sources) {
    if (key == what) {
      text = where;
      return;
    }
  }
  cell.sources.push_back({what, where});
}

/// A cell from Table I's or a profile's numbers and what the command line says otherwise.
CellProfile cell_of(const IdentifyArguments& arguments) {
  CellProfile cell = arguments.base.empty() ? table_one_oocyte() : load_profile(arguments.base);
  const bool as_it_was = !arguments.radius_um && !arguments.thickness_um && !arguments.poisson_ratio &&
                         !arguments.tip_radius_um && !arguments.holder_radius_um && !arguments.holder_half_width_um &&
                         !arguments.young_modulus_kPa;
  if (arguments.keep_constants && !as_it_was) {
    throw UsageError("identify: --keep-constants keeps geometry and modulus of --from too; leave one of them out");
  }
  cell.name = arguments.name.empty() ? fs::path(arguments.output).stem().string() : arguments.name;
  if (!arguments.description.empty()) {
    cell.description = arguments.description;
  } else if (arguments.base.empty()) {
    cell.description = "Cell with a zona, identified";
  }
  set_if(arguments.young_modulus_kPa, cell.young_modulus_kPa);
  set_if(arguments.radius_um, cell.mid_radius_um);
  set_if(arguments.thickness_um, cell.thickness_um);
  set_if(arguments.poisson_ratio, cell.poisson_ratio);
  set_if(arguments.tip_radius_um, cell.tip_radius_um);
  set_if(arguments.holder_radius_um, cell.holder_ring_um);
  set_if(arguments.holder_half_width_um, cell.holder_half_width_um);
  set_if(arguments.puncture_force_uN, cell.puncture_force_uN);
  set_if(arguments.puncture_indentation_um, cell.puncture_indentation_um);

  // Where each number comes from.
  const auto from = [&](bool given, const char* otherwise) {
    return given ? arguments.source : std::string(otherwise);
  };
  const char* table = "Table I of the paper (from a planar, clamped, point-load membrane formula)";
  const char* specimen = "the finite-element reference's specimen";
  if (arguments.base.empty()) {
    set_source(cell, "mid_radius_um", from(arguments.radius_um.has_value(), specimen));
    set_source(cell, "thickness_um", from(arguments.thickness_um.has_value(), specimen));
    set_source(cell, "inner_radius_um", "middle radius less half the thickness");
    set_source(cell, "young_modulus_kPa", from(arguments.young_modulus_kPa.has_value(), table));
    set_source(cell, "poisson_ratio", from(arguments.poisson_ratio.has_value(), table));
    set_source(cell, "puncture_force_uN", from(arguments.puncture_force_uN.has_value(), table));
    set_source(cell, "puncture_indentation_um", from(arguments.puncture_indentation_um.has_value(), table));
    set_source(cell, "tip_radius_um", from(arguments.tip_radius_um.has_value(), specimen));
    set_source(cell, "holder_ring_um", from(arguments.holder_radius_um.has_value(), specimen));
    set_source(cell, "holder_half_width_um", from(arguments.holder_half_width_um.has_value(), specimen));
    set_source(cell, "tip_bond_per_um, holder_bond_per_um",
               "the finite-element reference's: 0.2 and 0.1 uN/um^3 at 17.9 kPa");
    set_source(cell, "volume_stiffness_ratio", "2 uN/um^2 at 17.9 kPa: the volume changes by one part in ten thousand");
  } else {
    for (const auto& [given, key] : {std::pair{arguments.radius_um.has_value(), "mid_radius_um"},
                                     {arguments.thickness_um.has_value(), "thickness_um"},
                                     {arguments.young_modulus_kPa.has_value(), "young_modulus_kPa"},
                                     {arguments.poisson_ratio.has_value(), "poisson_ratio"},
                                     {arguments.puncture_force_uN.has_value(), "puncture_force_uN"},
                                     {arguments.puncture_indentation_um.has_value(), "puncture_indentation_um"},
                                     {arguments.tip_radius_um.has_value(), "tip_radius_um"},
                                     {arguments.holder_radius_um.has_value(), "holder_ring_um"},
                                     {arguments.holder_half_width_um.has_value(), "holder_half_width_um"}}) {
      if (given) set_source(cell, key, arguments.source);
    }
  }
  return cell;
}

void name_sources(const IdentifyArguments& arguments, CellProfile& cell) {
  if (!arguments.keep_constants) {
    set_source(cell, "msd.tip, msd.body, msd.holder",
               "fitted to the curves under references (thin-shell finite elements, edge length ratio " +
                   csv_number(arguments.edge_length_ratio) + ") on the mesh under mesh");
    set_source(cell, "msd.tip_angle_rad, msd.holder_angle_rad",
               "the tool's reach on the cell and about a bending length, sqrt(R h), beyond");
    set_source(cell, "msd.node_mass_kg", "the cell at the density of water in equal parts on the nodes; not fitted");
    set_source(cell, "msd.damping_uN_s_per_um", "the quickest connector is damped critically; not fitted");
    set_source(cell, "mesh", "as many nodes as the time of a frame allows; evenly spread, or finer at a sharp needle");
  }
  const bool curve = !arguments.measured_curve.empty();
  set_source(cell, "effective_young_modulus_kPa",
             curve ? "least squares of the model, configuration 1, to the measured curve " +
                         fs::path(arguments.measured_curve).filename().string()
                   : std::string("the model, configuration 1, passes the puncture point; Table I's modulus does not "
                                 "(docs/method.md, 3.7)"));
  set_source(
      cell, "force_scale_relative_sigma",
      curve ? "standard error of that least squares"
            : (arguments.scale_uncertainty_percent ? "given on the command line" : "assumed: one point has no spread"));
  if (!arguments.relaxation.empty()) {
    set_source(cell, "relaxation_arms",
               "spring and two Maxwell arms fitted to the ramp-and-hold record " +
                   fs::path(arguments.relaxation).filename().string());
  }
  set_source(cell, "made with", command_line() + ", version " + kVersion);
}

void print_errors(const Identification& result) {
  std::printf("%-34s %7s %16s %12s %12s %10s\n", "against finite elements", "nodes", "depths", "pointwise", "of peak",
              "rms");
  const auto row = [](const IdentifiedCurve& curve, const char* what) {
    char depths[32];
    std::snprintf(depths, sizeof depths, "%g to %g um", curve.error.from_um, curve.error.to_um);
    std::printf("configuration %d, %-17s %7d %16s %10.2f %% %10.2f %% %8.2f %%\n", curve.reference.configuration, what,
                curve.reference.node_count, depths, 100.0 * curve.error.largest_ratio,
                100.0 * curve.error.largest_of_peak_ratio, 100.0 * curve.error.rms_of_peak_ratio);
  };
  for (const IdentifiedCurve& curve : result.curves) row(curve, "thin shell");
  if (result.solid) row(*result.solid, "solid");
  std::printf(
      "pointwise: largest difference over the force there; of peak, rms: over the force at the deepest point\n");
}

void print_constants(const CellProfile& p) {
  std::printf("%-10s %12s %10s %10s\n", "region", "K2/(E h)", "K1/K2", "g");
  for (const auto& [name, r] : {std::pair{"tip", p.tip}, {"body", p.body}, {"holder", p.holder}}) {
    std::printf("%-10s %12.4f %10.4f %10.4f\n", name, r.k2_ratio, r.k1_over_k2, r.hinge_ratio);
  }
}

/// A record and what was fitted to it.
struct FittedArms {
  RelaxationRecord record;
  RelaxationFit two, one;
};

FittedArms fit_arms(const std::string& file) {
  FittedArms fitted;
  fitted.record = read_relaxation_record(file);
  fitted.two = fit_relaxation(fitted.record, 2);
  fitted.one = fit_relaxation(fitted.record, 1);
  std::printf("relaxation, %s: sensor noise %.2f nN\n", fs::path(file).filename().c_str(),
              1e3 * fitted.record.baseline_sigma_uN);
  std::printf("%-28s %12s %12s %18s\n", "residual RMS, nN", "hold", "ramp", "ramp and hold");
  for (const auto& [name, fit] : {std::pair{"spring and two arms", &fitted.two}, {"spring and one arm", &fitted.one}}) {
    std::printf("%-28s %12.2f %12.2f %18.2f\n", name, 1e3 * fit->hold_rms_uN, 1e3 * fit->ramp_rms_uN,
                1e3 * fit->ramp_and_hold_rms_uN);
  }
  for (const RelaxationArm& arm : fitted.two.arms) {
    std::printf("arm: %.1f %% of the sudden force, gone with %.3g s\n", 100.0 * arm.fraction, arm.time_s);
  }
  return fitted;
}

/// Gives the anchored profile its relaxation: new arms, or those that it had.
void set_relaxation(const IdentifyArguments& arguments, const std::optional<FittedArms>& fitted, CellProfile& cell) {
  const std::vector<RelaxationArm> arms = fitted ? fitted->two.arms : cell.relaxation_arms;
  if (arms.empty()) return;
  double ramp_s = cell.relaxation_anchor_ramp_s;
  if (arguments.anchor_ramp_s) {
    ramp_s = *arguments.anchor_ramp_s;
    set_source(cell, "relaxation_anchor_ramp_s", arguments.source);
  } else if (fitted) {
    const double speed_um_per_s = ramp_speed_um_per_s(fitted->record);
    ramp_s = cell.puncture_indentation_um / speed_um_per_s;
    set_source(cell, "relaxation_anchor_ramp_s",
               "assumed: the measured force was pushed as fast as the ramp-and-hold record, " +
                   csv_number(speed_um_per_s) + " um/s");
  }
  apply_relaxation(arms, ramp_s, cell);
  set_source(cell, "relaxation_elastic_ratio",
             "the model's curve through the arms in relaxation_anchor_ramp_s: a sudden push over one of that time");
  std::printf("a sudden push takes %.3f times the force of one of %.3g s%s, for which the scale is anchored\n",
              cell.relaxation_elastic_ratio, ramp_s, arguments.anchor_ramp_s ? "" : " (assumed)");
}

void write_profile(const CellProfile& profile, const fs::path& file) {
  std::ofstream stream(file);
  stream << to_json(profile) << '\n';
  stream.close();
  if (!stream) throw OutputError(file.string() + ": can't be written; check the folder and its permissions");
}

/// Whether the file can be written, before a minute is spent on what goes into it.
void check_writable(const fs::path& file) {
  std::error_code ignored;
  const bool existed = fs::exists(file, ignored);
  std::ofstream probe(file, std::ios::app);
  if (!probe) throw OutputError(file.string() + ": can't be written; check the folder and its permissions");
  probe.close();
  if (!existed) fs::remove(file, ignored);
}

void run_identify(const IdentifyArguments& arguments) {
  const fs::path output(arguments.output);
  IdentificationRequest request;
  request.cell = cell_of(arguments);
  if (!arguments.measured_curve.empty()) request.measured = read_measured_curve(arguments.measured_curve);
  if (request.measured && !arguments.puncture_force_uN && !arguments.puncture_indentation_um) {
    // The deepest point of a measured curve is the best guess of where it ends.
    const auto last = request.measured->force_uN.size() - 1;
    request.cell.puncture_force_uN = request.measured->force_uN[last];
    request.cell.puncture_indentation_um = request.measured->indentation_um[last];
    set_source(request.cell, "puncture_force_uN", "the measured curve's deepest point");
    set_source(request.cell, "puncture_indentation_um", "the measured curve's deepest point");
  }
  if (arguments.scale_uncertainty_percent)
    request.assumed_scale_sigma_ratio = 0.01 * *arguments.scale_uncertainty_percent;
  if (arguments.max_indentation_um) request.max_indentation_um = *arguments.max_indentation_um;
  request.edge_length_ratio = arguments.edge_length_ratio;
  request.threads = arguments.threads;
  check_writable(output);
  std::optional<FittedArms> arms;
  if (!arguments.relaxation.empty()) arms = fit_arms(arguments.relaxation);

  Identification result;
  if (arguments.keep_constants) {
    result.profile = request.cell;
    result.scale = request.measured
                       ? scale_to_curve(request.cell, *request.measured)
                       : scale_to_point(request.cell, request.cell.puncture_force_uN,
                                        request.cell.puncture_indentation_um, request.assumed_scale_sigma_ratio);
    apply(result.scale, result.profile);
  } else {
    Progress progress("identify: %");
    result = identify(request, [&](std::string_view stage, double share) {
      // The finite elements take about a third of the time.
      const double all = stage == "finite elements" ? 0.35 * share : stage == "fit" ? 0.35 + 0.6 * share : 0.95;
      progress.update(static_cast<long>(100.0 * all), 100);
    });
  }
  set_relaxation(arguments, arms, result.profile);
  name_sources(arguments, result.profile);
  write_profile(result.profile, output);

  // What came out.
  const CellProfile& p = result.profile;
  if (!arguments.keep_constants) {
    print_errors(result);
    std::printf("finite elements %.1f s; fit %.1f s, %d times all four curves\n", result.reference_s, result.fit_s,
                result.fit.evaluations);
    print_constants(p);
  }
  std::printf("force scale: effective modulus %.2f kPa, %.3f times the %.4g kPa given, +- %.2g %%%s\n",
              p.effective_young_modulus_kPa, p.effective_young_modulus_kPa / p.young_modulus_kPa, p.young_modulus_kPa,
              100.0 * p.force_scale_relative_sigma, request.measured ? "" : " (assumed)");
  if (request.measured) {
    std::printf("measured curve: %d points, %.3g uN RMS off the model\n", result.scale.point_count,
                result.scale.residual_rms_uN);
  }
  std::fflush(stdout);

  if (!arguments.no_picture) {
    MeasuredCurve shown;
    if (request.measured) {
      shown = *request.measured;
    } else {
      shown.indentation_um = Eigen::VectorXd::Constant(1, p.puncture_indentation_um);
      shown.force_uN = Eigen::VectorXd::Constant(1, p.puncture_force_uN);
    }
    fs::path picture = output;
    picture.replace_extension(".png");
    std::optional<RelaxationPicture> relaxation;
    if (arms) relaxation = RelaxationPicture{&arms->record, &arms->two, &arms->one};
    draw_identification(result, shown, relaxation, picture);
    std::cout << output.string() << ", " << picture.string() << '\n';
  } else {
    std::cout << output.string() << '\n';
  }
}

}  // namespace

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
  const auto number = [&](const char* option, std::optional<double>& value, const char* help) {
    return command->add_option(option, value, help);
  };
  number("--young-modulus-kPa", a->young_modulus_kPa, "published modulus of the zona, kPa (default: 17.9)")
      ->check(CLI::PositiveNumber);
  number("--radius-um", a->radius_um, "radius of the zona's middle surface, um (default: 50)")
      ->check(CLI::PositiveNumber);
  number("--thickness-um", a->thickness_um, "of the zona, um (default: 5)")->check(CLI::PositiveNumber);
  number("--poisson-ratio", a->poisson_ratio, "above 0, up to 0.5 (default: 0.5)")->check(CLI::Range(0.0, 0.5));
  number("--tip-radius-um", a->tip_radius_um, "of the needle's contact, um (default: 5)")->check(CLI::PositiveNumber);
  number("--holder-radius-um", a->holder_radius_um, "mean radius of the holder's mouth, um (default: 17.5)")
      ->check(CLI::PositiveNumber);
  number("--holder-half-width-um", a->holder_half_width_um, "half the width of its ring of contact, um (default: 5)")
      ->check(CLI::PositiveNumber);
  CLI::Option* force = number("--puncture-force-uN", a->puncture_force_uN,
                              "measured force that anchors the force scale, uN (default: 7.5)")
                           ->check(CLI::PositiveNumber);
  CLI::Option* depth = number("--puncture-indentation-um", a->puncture_indentation_um,
                              "indentation it was measured at, um (default: 44)")
                           ->check(CLI::PositiveNumber);
  force->needs(depth);
  depth->needs(force);
  number("--scale-uncertainty-percent", a->scale_uncertainty_percent,
         "standard deviation of a scale anchored to one point, % (default: 5, an assumption)")
      ->check(CLI::Range(0.0, 100.0));
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
      ->check(CLI::NonNegativeNumber);
  command
      ->add_flag("--keep-constants", a->keep_constants,
                 "keep the constants of --from; only the force scale and the relaxation are found")
      ->needs("--from");
  number("--max-indentation-um", a->max_indentation_um,
         "deepest point fitted, um (default: the puncture's, 1.06 radii at least)")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--edge-length-ratio", a->edge_length_ratio,
                   "factor on the finite elements' size: 1.4 is quicker and 3 to 8 % stiffer")
      ->check(CLI::Range(0.5, 2.0))
      ->capture_default_str();
  command->add_option("--jobs", a->threads, "threads (default: one a core)")->check(CLI::Range(1, 256));
  command->add_flag("--no-picture", a->no_picture, "draw no picture");
  command->callback([a] { run_identify(*a); });
}

}  // namespace pellucida
