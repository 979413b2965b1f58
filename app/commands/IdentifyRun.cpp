#include "commands/IdentifyRun.h"

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <vector>

#include "commands/CommandLine.h"
#include "commands/IdentifyPicture.h"
#include "commands/IdentifyReport.h"
#include "commands/ReplaceOption.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Progress.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/Version.h"
#include "pellucida/identification/GeometrySurvey.h"
#include "pellucida/identification/Identification.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

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
  cell.name = arguments.name.empty() ? fs::path(arguments.output).stem().string() : arguments.name;
  if (!arguments.description.empty()) {
    cell.description = arguments.description;
  } else if (arguments.base.empty()) {
    cell.description = "Cell with a zona, identified";
  }

  // The numbers, and where each comes from.
  const FieldList fields = fields_of(cell);
  for (const auto& [key, given] : arguments.numbers) {
    const FieldPlace& field = *fields.find(key);
    const bool puncture = field.name().starts_with("puncture");
    if (arguments.keep_constants && given && !puncture) {
      throw UsageError("identify: --keep-constants keeps geometry and modulus of --from too; leave one of them out");
    }
    if (given) {
      *std::get<double*>(field.value) = *given;
      set_source(cell, field.name(), arguments.source);
    } else if (arguments.base.empty()) {
      set_source(cell, field.name(),
                 field.group() == "material"
                     ? "Table I of the paper (from a planar, clamped, point-load membrane formula)"
                     : "the finite-element reference's specimen");
    }
  }
  if (arguments.base.empty()) {
    set_source(cell, "inner_radius_um", "middle radius less half the thickness");
    set_source(cell, "tip_bond_per_um, holder_bond_per_um",
               "the finite-element reference's: 0.2 and 0.1 uN/um^3 at 17.9 kPa");
    set_source(cell, "volume_stiffness_ratio", "2 uN/um^2 at 17.9 kPa: the volume changes by one part in ten thousand");
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

FittedArms fit_arms(const std::string& file) {
  FittedArms fitted;
  fitted.record = read_relaxation_record(file);
  fitted.two = fit_relaxation(fitted.record, 2);
  fitted.one = fit_relaxation(fitted.record, 1);
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

/// Whether the files can be written, before a minute is spent on what goes into them, and are none that is read.
void check_outputs(const IdentifyArguments& arguments, const fs::path& picture) {
  std::vector<fs::path> outputs{arguments.output};
  if (!arguments.no_picture) outputs.push_back(picture);
  for (const fs::path& output : outputs) {
    for (const std::string& input : {arguments.base, arguments.measured_curve, arguments.relaxation}) {
      require_apart(output, input, "--output");
    }
  }
  require_apart(picture, arguments.output, "--output");
  if (!arguments.replace) require_new(outputs);
  { OutputFile probe(arguments.output); }
}

/// How the force differs at other geometries.
void survey(const IdentifyArguments& arguments, CellProfile& profile) {
  Progress progress("other geometries: %");
  survey_geometry(profile, {arguments.geometry_cells, arguments.threads},
                  [&](double share) { progress.update(static_cast<long>(100.0 * share), 100); });
  set_source(profile, "geometry_terms",
             "least squares to the solid of revolution (modules/fem) on " + std::to_string(arguments.geometry_cells) +
                 " geometries, over the springs there");
  set_source(profile, "geometry_terms of the depth alone",
             "least squares to the same solid at the profile's own geometry, over the springs there; 1 at the "
             "puncture's depth");
  const GeometryRange& range = profile.geometry_range;
  std::printf(
      "other geometries: %d cells; force and pressure of those left out of the fit within %.1f and %.1f %% (RMS)\n",
      range.cell_count, 100.0 * range.spread_ratio, 100.0 * range.pressure_spread_ratio);
}

/// Takes the profile's curve through what was measured.
void set_scale(const IdentificationRequest& request, Identification& result) {
  CellProfile& profile = result.profile;
  result.scale = request.measured ? scale_to_curve(profile, *request.measured)
                                  : scale_to_point(profile, profile.puncture_force_uN, profile.puncture_indentation_um,
                                                   request.assumed_scale_sigma_ratio);
  apply(result.scale, profile);
}

void write_profile(const CellProfile& profile, const fs::path& file) {
  OutputFile output(file);
  output.add(to_json(profile));
  output.finish();
}

}  // namespace

void run_identify(const IdentifyArguments& arguments) {
  const fs::path output(arguments.output);
  fs::path picture = output;
  picture.replace_extension(".png");
  check_outputs(arguments, picture);
  IdentificationRequest request;
  request.cell = cell_of(arguments);
  if (!arguments.measured_curve.empty()) request.measured = read_measured_curve(arguments.measured_curve);
  if (request.measured && !arguments.has("material.puncture_force_uN")) {
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
  std::optional<FittedArms> arms;
  if (!arguments.relaxation.empty()) {
    arms = fit_arms(arguments.relaxation);
    print_relaxation(fs::path(arguments.relaxation).filename().string(), *arms);
  }

  Identification result;
  if (arguments.keep_constants) {
    result.profile = request.cell;
    set_scale(request, result);
  } else {
    Progress progress("identify: %");
    result = identify(request, [&](std::string_view stage, double share) {
      // The finite elements take about a third of the time.
      const double all = stage == "finite elements" ? 0.35 * share : stage == "fit" ? 0.35 + 0.6 * share : 0.95;
      progress.update(static_cast<long>(100.0 * all), 100);
    });
  }
  set_relaxation(arguments, arms, result.profile);
  if (arguments.geometry_cells > 0) {
    survey(arguments, result.profile);
    set_scale(request, result);  // by the curve that is measured by
  }
  name_sources(arguments, result.profile);
  write_profile(result.profile, output);

  print_identification(result, request.measured.has_value());

  if (!arguments.no_picture) {
    MeasuredCurve shown;
    if (request.measured) {
      shown = *request.measured;
    } else {
      shown.indentation_um = Eigen::VectorXd::Constant(1, result.profile.puncture_indentation_um);
      shown.force_uN = Eigen::VectorXd::Constant(1, result.profile.puncture_force_uN);
    }
    std::optional<RelaxationPicture> relaxation;
    if (arms) relaxation = RelaxationPicture{&arms->record, &arms->two, &arms->one};
    draw_identification(result, shown, relaxation, picture);
    std::cout << output.string() << ", " << picture.string() << '\n';
  } else {
    std::cout << output.string() << '\n';
  }
}

}  // namespace pellucida
