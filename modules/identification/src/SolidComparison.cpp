#include "SolidComparison.h"

#include <algorithm>
#include <cmath>

#include "ProfileSpecimen.h"
#include "pellucida/fem/SolidReference.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

constexpr double kStep_um = 2.0;

}  // namespace

std::optional<ReferenceCurve> solid_curve(const CellProfile& profile, double to_um, double step_um,
                                          const std::stop_token& cancel) {
  SolidReference solid(specimen_of(profile), contact_of(profile));
  const SolidCurve curve = solid.run(to_um, std::min(step_um, to_um), {}, cancel);
  if (curve.outcome != CurveOutcome::kComplete) return std::nullopt;
  ReferenceCurve reference;
  reference.configuration = 1;
  const auto count = static_cast<Eigen::Index>(curve.steps.size());
  reference.depth_um.resize(count);
  reference.force_uN.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    reference.depth_um[k] = curve.steps[static_cast<std::size_t>(k)].indentation_um;
    reference.force_uN[k] = curve.steps[static_cast<std::size_t>(k)].force_uN;
  }
  return reference;
}

void record_solid_error(CellProfile& profile, const std::stop_token& cancel) {
  const double to_um = profile.puncture_indentation_um, step_um = to_um / std::ceil(to_um / kStep_um - 1e-9);
  const std::optional<ReferenceCurve> solid = solid_curve(profile, to_um, step_um, cancel);
  if (!solid) return;
  const MembraneSetup setup = setup_for_configuration(profile, 1);
  Indenter indenter(profile, geometry_of(profile), setup.push, setup.holder);
  const Eigen::Index count = solid->depth_um.size();
  Eigen::VectorXd model_uN(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const IndentationState state = indenter.advance_to(solid->depth_um[k]);
    if (state.report.status != SolveStatus::kConverged) return;
    model_uN[k] = state.push_force_uN;
  }
  const double peak_uN = model_uN[count - 1];
  const Eigen::VectorXd solid_uN = solid->force_uN * (peak_uN / solid->force_uN[count - 1]);
  ProfileError error{1, kSolidReference, 0.0, 0.0, kCompareFrom_um, to_um};
  for (Eigen::Index k = 0; k < count; ++k) {
    const double off_uN = std::abs(model_uN[k] - solid_uN[k]);
    error.largest_of_peak_ratio = std::max(error.largest_of_peak_ratio, off_uN / peak_uN);
    if (solid->depth_um[k] >= kCompareFrom_um)
      error.largest_ratio = std::max(error.largest_ratio, off_uN / solid_uN[k]);
  }
  std::erase_if(profile.errors, [](const ProfileError& old) { return old.reference == kSolidReference; });
  profile.errors.push_back(error);
}

}  // namespace pellucida
