#include "pellucida/identification/ReferenceCurves.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

#include "ProfileSpecimen.h"
#include "Workers.h"
#include "pellucida/fem/ShellReference.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

constexpr int kConfigurations = 4;
/// Configuration 4's offset, less on a small cell.
constexpr double kOffset_um = 10.0, kMostOffset = 0.4;

}  // namespace

ReferenceCurve compute_reference_curve(const CellProfile& profile, double holder_angle_rad, double offset_um,
                                       const ReferenceOptions& options,
                                       const std::function<void(double share)>& progress,
                                       const std::stop_token& cancel) {
  ShellReference shell(specimen_of(profile), contact_of(profile, holder_angle_rad, offset_um),
                       {.edge_length_ratio = options.edge_length_ratio});
  const auto on_step = [&](const ShellStep&, double share) {
    if (progress) progress(share);
  };
  const ShellCurve curve = shell.run(options.max_indentation_um, options.step_um, on_step, cancel);
  ReferenceCurve reference;
  reference.holder_angle_rad = holder_angle_rad;
  reference.offset_um = offset_um;
  reference.node_count = static_cast<int>(shell.rest().points_um.cols());
  reference.outcome = curve.outcome;
  const auto count = static_cast<Eigen::Index>(curve.steps.size());
  reference.depth_um.resize(count);
  reference.force_uN.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    reference.depth_um[k] = curve.steps[static_cast<std::size_t>(k)].indentation_um;
    reference.force_uN[k] = curve.steps[static_cast<std::size_t>(k)].axial_force_uN;
    reference.largest_stretch =
        std::max(reference.largest_stretch, curve.steps[static_cast<std::size_t>(k)].largest_stretch);
  }
  return reference;
}

std::vector<ReferenceCurve> compute_reference_curves(const CellProfile& profile, const ReferenceOptions& options,
                                                     const std::function<void(double share)>& progress,
                                                     const std::stop_token& cancel) {
  std::vector<ReferenceCurve> curves(kConfigurations);
  std::vector<double> shares(kConfigurations, 0.0);
  std::mutex progress_mutex;
  run_jobs(kConfigurations, options.threads, [&](int k) {
    const ShellContact contact =
        contact_for_configuration(k + 1, std::min(kOffset_um, kMostOffset * profile.mid_radius_um));
    const auto report = [&](double share) {
      if (!progress) return;
      const std::lock_guard lock(progress_mutex);
      shares[static_cast<std::size_t>(k)] = share;
      progress(std::accumulate(shares.begin(), shares.end(), 0.0) / kConfigurations);
    };
    auto& curve = curves[static_cast<std::size_t>(k)];
    curve =
        compute_reference_curve(profile, contact.holder_angle_rad, contact.lateral_offset_um, options, report, cancel);
    curve.configuration = k + 1;
  });
  return curves;
}

CurveError compare_with_reference(const CellProfile& profile, const ReferenceCurve& reference, double from_um,
                                  double to_um, Eigen::VectorXd* force_uN) {
  Indenter indenter(profile, setup_for_needle(profile, reference.holder_angle_rad, reference.offset_um));
  return compare_with_reference(indenter, reference, from_um, to_um, force_uN);
}

CurveError compare_with_reference(Indenter& indenter, const ReferenceCurve& reference, double from_um, double to_um,
                                  Eigen::VectorXd* force_uN) {
  CurveError error;
  error.from_um = from_um;
  error.complete = true;
  Eigen::Index count = 0;
  while (count < reference.depth_um.size() && reference.depth_um[count] <= to_um + 1e-9) ++count;
  if (force_uN) force_uN->resize(count);
  if (count == 0) return error;
  const double peak_uN = reference.force_uN[count - 1];

  double square_sum = 0.0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const IndentationState state = indenter.advance_to(reference.depth_um[k]);
    if (state.report.status != SolveStatus::kConverged) {
      error.complete = false;
      if (force_uN) force_uN->conservativeResize(k);
      count = k;
      break;
    }
    if (force_uN) (*force_uN)[k] = state.push_force_uN;
    const double off_uN = std::abs(state.push_force_uN - reference.force_uN[k]);
    error.to_um = reference.depth_um[k];
    error.largest_of_peak_ratio = std::max(error.largest_of_peak_ratio, off_uN / peak_uN);
    square_sum += off_uN * off_uN / (peak_uN * peak_uN);
    if (reference.depth_um[k] >= from_um) {
      error.largest_ratio = std::max(error.largest_ratio, off_uN / reference.force_uN[k]);
    }
  }
  if (count > 0) error.rms_of_peak_ratio = std::sqrt(square_sum / static_cast<double>(count));
  return error;
}

}  // namespace pellucida
