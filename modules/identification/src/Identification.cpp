#include "pellucida/identification/Identification.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "CurveSensitivity.h"
#include "MotionConstants.h"
#include "SolidComparison.h"
#include "Workers.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core/Error.h"
#include "pellucida/fem/ShellSpecimen.h"
#include "pellucida/membrane/MembraneGeometry.h"

namespace pellucida {
namespace {

/// Curves reach at least this share of the radius, so that constants hold somewhat beyond the puncture.
constexpr double kLeastReach = 1.06;
/// Connectors must bear strains beyond the largest of the reference's middle surface, and never less than these.
constexpr double kStrainReserve = 1.2, kLeastStrain = 0.5;

/// The force at the point nearest to a depth.
double force_near_uN(const ReferenceCurve& curve, double depth_um) {
  Eigen::Index nearest = 0;
  (curve.depth_um.array() - depth_um).abs().minCoeff(&nearest);
  return curve.force_uN[nearest];
}

void check(const IdentificationRequest& request) {
  const CellProfile& cell = request.cell;
  const auto positive = [](double value, const char* what) {
    if (!(value > 0.0 && std::isfinite(value))) throw UsageError(std::string("identify: ") + what + " must be above 0");
  };
  positive(cell.mid_radius_um, "the radius");
  positive(cell.thickness_um, "the thickness");
  positive(cell.young_modulus_kPa, "Young's modulus");
  positive(cell.puncture_force_uN, "the puncture force");
  positive(cell.puncture_indentation_um, "the puncture indentation");
  positive(request.step_um, "the step");
  if (!(request.assumed_scale_sigma_ratio >= 0.0 && request.assumed_scale_sigma_ratio <= 1.0)) {
    throw UsageError("identify: the scale's uncertainty must be between 0 and 100 %");
  }
  if (!(cell.puncture_indentation_um <= 1.4 * cell.mid_radius_um)) {
    throw UsageError("identify: the puncture indentation must be at most 1.4 radii; check the unit");
  }
}

double reach_um(const IdentificationRequest& request) {
  if (request.max_indentation_um > 0.0) return request.max_indentation_um;
  return std::max(request.cell.puncture_indentation_um, kLeastReach * request.cell.mid_radius_um);
}

[[noreturn]] void cancelled() {
  throw Error(ExitCode::kOurFault, "identify: cancelled; nothing was written");
}

void record_error(CellProfile& profile, const IdentifiedCurve& curve, const char* what) {
  profile.errors.push_back({curve.reference.configuration, what, curve.error.largest_ratio,
                            curve.error.largest_of_peak_ratio, curve.error.from_um, curve.error.to_um});
}

}  // namespace

CellProfile table_one_oocyte() {
  CellProfile cell;
  cell.name = "mouse-oocyte";
  cell.description = "Mouse oocyte, zona pellucida";
  cell.mid_radius_um = 50.0;
  cell.thickness_um = 5.0;
  cell.inner_radius_um = 47.5;
  cell.young_modulus_kPa = 17.9;
  cell.poisson_ratio = 0.5;
  cell.puncture_force_uN = 7.5;
  cell.puncture_indentation_um = 44.0;
  const ShellContact contact;
  cell.tip_radius_um = contact.tip_radius_um;
  cell.tip_bond_per_um = contact.tip_bond_per_um;
  cell.holder_ring_um = contact.holder_ring_um;
  cell.holder_half_width_um = contact.holder_half_width_um;
  cell.holder_bond_per_um = contact.holder_bond_per_um;
  cell.volume_stiffness_ratio = ShellSpecimen{}.bulk_modulus_ratio;
  cell.mesh_frequency = 9;
  cell.mesh_grading = 1.0;
  return cell;
}

Identification identify(const IdentificationRequest& request,
                        const std::function<void(std::string_view stage, double share)>& progress,
                        const std::stop_token& cancel) {
  check(request);
  const SteadyClock clock;
  Identification result;
  CellProfile& profile = result.profile;
  profile = request.cell;
  profile.inner_radius_um = profile.mid_radius_um - 0.5 * profile.thickness_um;
  profile.effective_young_modulus_kPa = profile.young_modulus_kPa;
  profile.references.clear();
  profile.errors.clear();
  profile.geometry_terms.clear();  // they belong to the constants
  profile.geometry_pressure_terms.clear();
  profile.geometry_range = {};
  set_regions(profile);
  if (!(profile.body.k2_ratio > 0.0)) set_starting_constants(profile);

  // The reference.
  const double deepest_um = reach_um(request);
  const double anchor_um = std::min(profile.puncture_indentation_um, deepest_um);
  const double step_um = anchor_um / std::ceil(anchor_um / request.step_um - 1e-9);  // one point at the anchor
  const ReferenceOptions options{deepest_um, step_um, request.edge_length_ratio, request.threads};
  const auto report = [&](std::string_view stage, double share) {
    if (progress) progress(stage, share);
  };
  auto references = compute_reference_curves(
      profile, options, [&](double share) { report("finite elements", share); }, cancel);
  if (cancel.stop_requested()) cancelled();
  double largest_stretch = 1.0;
  for (const ReferenceCurve& curve : references) {
    const double reached_um = curve.depth_um[curve.depth_um.size() - 1];
    if (reached_um < anchor_um - 1e-6) {
      throw NothingMeasuredError("identify: the finite elements find no equilibrium beyond " +
                                 std::to_string(reached_um) + " um in configuration " +
                                 std::to_string(curve.configuration) + "; give a smaller --puncture-indentation-um");
    }
    profile.references.push_back({curve.configuration, curve.holder_angle_rad * 180.0 / std::numbers::pi,
                                  curve.offset_um, curve.node_count, reached_um});
    largest_stretch = std::max(largest_stretch, curve.largest_stretch);
  }
  result.reference_s = clock.now_s();

  // The constants.
  FitOptions fit;
  fit.from_um = kCompareFrom_um;
  fit.largest_strain = std::max(kLeastStrain, kStrainReserve * (largest_stretch - 1.0));
  fit.threads = request.threads;
  fit.anchor_um = anchor_um;
  result.fit = fit_constants(
      profile, references, fit, [&](int evaluations, double) { report("fit", 1.0 - std::exp(-evaluations / 16.0)); },
      cancel);
  if (cancel.stop_requested()) cancelled();
  if (!result.fit.complete) {
    throw NothingMeasuredError("identify: no constants meet the finite elements; give a cell nearer to a thin shell");
  }
  result.fit_s = clock.now_s() - result.reference_s;

  // The scale. The references are scaled to the same anchor.
  result.scale = request.measured ? scale_to_curve(profile, *request.measured)
                                  : scale_to_point(profile, profile.puncture_force_uN, profile.puncture_indentation_um,
                                                   request.assumed_scale_sigma_ratio);
  const CellProfile unscaled = profile;
  apply(result.scale, profile);
  const Eigen::VectorXd anchor = Eigen::VectorXd::Constant(1, anchor_um);
  const CurveSensitivity first(profile, setup_for_configuration(profile, 1));
  const double anchor_force_uN = first.solve(constants_of(profile), anchor).force_uN[0];

  // What they err by.
  const double shell_ratio = anchor_force_uN / force_near_uN(references[0], anchor_um);
  result.curves.resize(references.size());
  report("errors", 0.0);
  std::optional<ReferenceCurve> solid;
  run_jobs(static_cast<int>(references.size()) + 1, request.threads, [&](int k) {
    if (k == static_cast<int>(references.size())) {
      solid = solid_curve(unscaled, anchor_um, options.step_um, cancel);
      return;
    }
    IdentifiedCurve& curve = result.curves[static_cast<std::size_t>(k)];
    curve.reference = references[static_cast<std::size_t>(k)];
    curve.reference.force_uN *= shell_ratio;
    curve.error = compare_with_reference(profile, curve.reference, kCompareFrom_um, anchor_um);
    compare_with_reference(profile, curve.reference, kCompareFrom_um, deepest_um, &curve.model_force_uN);
  });
  if (cancel.stop_requested()) cancelled();
  for (const IdentifiedCurve& curve : result.curves)
    record_error(profile, curve, "thin-shell finite elements, scaled to the anchor");
  if (solid) {
    solid->force_uN *= anchor_force_uN / solid->force_uN[solid->force_uN.size() - 1];
    result.solid.emplace();
    result.solid->reference = *solid;
    result.solid->error =
        compare_with_reference(profile, *solid, kCompareFrom_um, anchor_um, &result.solid->model_force_uN);
    record_error(profile, *result.solid, kSolidReference);
  }

  const MotionConstants motion = motion_constants(profile);
  profile.node_mass_kg = motion.node_mass_kg;
  profile.damping_uN_s_per_um = motion.damping_uN_s_per_um;
  report("done", 1.0);
  return result;
}

IdentificationTimes measure_identification() {
  const SteadyClock clock;
  const std::clock_t begin = std::clock();
  const Identification result = identify({});
  IdentificationTimes times;
  times.wall_s = clock.now_s();
  times.processor_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  times.reference_s = result.reference_s;
  times.fit_s = result.fit_s;
  times.fit_evaluations = result.fit.evaluations;
  return times;
}

}  // namespace pellucida
