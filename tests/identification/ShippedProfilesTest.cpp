// The shipped profiles against finite elements computed here and now: every claim in them is found again.
#include <gtest/gtest.h>

#include <numbers>

#include "TestCells.h"
#include "pellucida/core/Resources.h"
#include "pellucida/core/Table.h"
#include "pellucida/fem/SolidReference.h"

namespace pellucida {
namespace {

/// Factor on the forces of `curve` that takes it through the profile's puncture point, where configuration 1's does.
double anchor_ratio(const CellProfile& profile, const ReferenceCurve& first) {
  Eigen::Index at = 0;
  (first.depth_um.array() - profile.puncture_indentation_um).abs().minCoeff(&at);
  EXPECT_NEAR(first.depth_um[at], profile.puncture_indentation_um, 1e-6);
  return profile.puncture_force_uN / first.force_uN[at];
}

ReferenceOptions options_for(const CellProfile& profile) {
  ReferenceOptions options;
  options.max_indentation_um = profile.puncture_indentation_um;
  options.step_um = options.max_indentation_um / std::ceil(0.5 * options.max_indentation_um);
  return options;
}

double& unscaled_anchor_force_uN() {
  static double force_uN = 0.0;
  return force_uN;
}

/// The four reference curves of the oocyte, computed once, scaled to the puncture point.
const std::vector<ReferenceCurve>& oocyte_curves() {
  static const std::vector<ReferenceCurve> kCurves = [] {
    const CellProfile profile = load_profile("mouse-oocyte");
    auto curves = compute_reference_curves(profile, options_for(profile));
    const double ratio = anchor_ratio(profile, curves[0]);
    unscaled_anchor_force_uN() = curves[0].force_uN[curves[0].force_uN.size() - 1];
    for (ReferenceCurve& curve : curves) curve.force_uN *= ratio;
    return curves;
  }();
  return kCurves;
}

TEST(ShippedOocyte, MeetsTheFiniteElementsInAllFourConfigurations) {
  const CellProfile profile = load_profile("mouse-oocyte");
  for (const ReferenceCurve& curve : oocyte_curves()) {
    const CurveError error = compare_with_reference(profile, curve, 4.0, profile.puncture_indentation_um);
    EXPECT_TRUE(error.complete);
    EXPECT_LT(error.largest_ratio, 0.05) << "configuration " << curve.configuration;
    EXPECT_LT(error.largest_of_peak_ratio, 0.03) << "configuration " << curve.configuration;

    // What the profile says of itself.
    bool claimed = false;
    for (const ProfileError& claim : profile.errors) {
      if (claim.configuration != curve.configuration || claim.reference.find("shell") == std::string::npos) continue;
      claimed = true;
      EXPECT_NEAR(claim.largest_ratio, error.largest_ratio, 1e-5) << curve.configuration;
      EXPECT_NEAR(claim.largest_of_peak_ratio, error.largest_of_peak_ratio, 1e-5) << curve.configuration;
    }
    EXPECT_TRUE(claimed) << "configuration " << curve.configuration;
  }
}

// The record gives a modulus by way of the solid (docs/method.md, 3.7), and the solid the force that anchors the
// profile.
TEST(ShippedAfmOocyte, CarriesTheForceOfTheSolidOfItsModulus) {
  const CellProfile profile = load_profile("oocyte-afm");
  const SolidCurve curve =
      SolidReference({.young_modulus_kPa = profile.young_modulus_kPa}, {}).run(profile.puncture_indentation_um, 2.0);
  ASSERT_EQ(curve.outcome, CurveOutcome::kComplete);
  EXPECT_NEAR(profile.puncture_force_uN, curve.steps.back().force_uN, 0.01 * profile.puncture_force_uN);
}

// An independent thin shell's.
TEST(ThinShellCurves, AreThoseOfOurFiniteElements) {
  for (int c = 1; c <= 3; ++c) {
    const Table table =
        Table::read(resource_folder() / "reference" / ("thin-shell-oocyte-" + std::to_string(c) + "-force.csv"));
    const Eigen::VectorXd depth_um = table.column("indentation_um"), force_uN = table.column("force_uN");
    const ReferenceCurve& ours = oocyte_curves()[static_cast<std::size_t>(c) - 1];
    for (Eigen::Index k = 0; k < ours.depth_um.size(); ++k) {
      for (Eigen::Index row = 0; row < table.rows(); ++row) {
        if (depth_um[row] < 4.0 || std::abs(depth_um[row] - ours.depth_um[k]) > 1e-6) continue;
        EXPECT_NEAR(ours.force_uN[k], force_uN[row], 0.02 * force_uN[row]) << c << " at " << depth_um[row];
      }
    }
  }
}

TEST(Transfer, ConstantsCarryOverToOtherAnglesAndOffsets) {
  const CellProfile profile = load_profile("mouse-oocyte");
  ReferenceOptions options = options_for(profile);
  options.step_um = 4.0;
  // The aligned curve, which carries the scale, is at the anchor already; the others are of the profile's own modulus.
  const ReferenceCurve& aligned = oocyte_curves()[0];
  const double own_uN = unscaled_anchor_force_uN(), scale = aligned.force_uN[aligned.force_uN.size() - 1] / own_uN;
  for (const auto& [angle_deg, offset_um] : {std::pair{67.5, 0.0}, {0.0, 20.0}}) {
    ReferenceCurve curve = compute_reference_curve(profile, angle_deg * std::numbers::pi / 180.0, offset_um, options);
    curve.force_uN *= scale;
    const CurveError error = compare_with_reference(profile, curve, 4.0, 44.0);
    std::printf("%.1f degrees, offset %.0f um: %.2f %% pointwise, %.2f %% of peak\n", angle_deg, offset_um,
                100.0 * error.largest_ratio, 100.0 * error.largest_of_peak_ratio);
    EXPECT_LT(error.largest_ratio, 0.037);
    EXPECT_LT(error.largest_of_peak_ratio, 0.03);
  }
}

TEST(Transfer, ConstantsCarryOverToOtherSizesAndBlunterTips) {
  // Constants of h = 5, a = 5 at another thickness, tip and radius: the table in the module's README.
  const CellProfile profile = load_profile("mouse-oocyte");
  ReferenceOptions options = options_for(profile);
  options.step_um = 4.0;
  const ReferenceCurve& aligned = oocyte_curves()[0];
  const double scale = aligned.force_uN[aligned.force_uN.size() - 1] / unscaled_anchor_force_uN();
  for (const auto& [radius_um, thickness_um, tip_um] :
       {std::tuple{50.0, 4.0, 5.0}, {50.0, 7.0, 5.0}, {50.0, 5.0, 8.0}, {45.0, 5.0, 5.0}, {55.0, 5.0, 5.0}}) {
    CellProfile other = profile;
    other.mid_radius_um = radius_um;
    other.thickness_um = thickness_um;
    other.inner_radius_um = radius_um - 0.5 * thickness_um;
    other.tip_radius_um = tip_um;
    options.max_indentation_um = std::min(44.0, 0.95 * radius_um);
    ReferenceCurve curve = compute_reference_curve(other, 0.0, 0.0, options);
    curve.force_uN *= scale;
    const CurveError error = compare_with_reference(other, curve, 4.0, options.max_indentation_um);
    std::printf("R %.0f um, h %.0f um, a %.0f um: %.2f %% pointwise, %.2f %% of peak\n", radius_um, thickness_um,
                tip_um, 100.0 * error.largest_ratio, 100.0 * error.largest_of_peak_ratio);
    EXPECT_LT(error.largest_ratio, 0.06);
    EXPECT_LT(error.largest_of_peak_ratio, 0.04);
  }
}

}  // namespace
}  // namespace pellucida
