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
  std::optional<ReferenceCurve> solid = solid_curve(profile, to_um, step_um, cancel);
  if (!solid) return;
  solid->force_uN *= profile.puncture_force_uN / solid->force_uN[solid->force_uN.size() - 1];
  const MembraneSetup setup = setup_for_configuration(profile, 1);
  Indenter indenter(profile, geometry_of(profile), setup.push, setup.holder);
  const CurveError found = compare_with_reference(indenter, *solid, kCompareFrom_um, to_um);
  if (!found.complete) return;
  std::erase_if(profile.errors, [](const ProfileError& old) { return old.reference == kSolidReference; });
  profile.errors.push_back(
      {1, kSolidReference, found.largest_ratio, found.largest_of_peak_ratio, found.from_um, found.to_um});
}

}  // namespace pellucida
