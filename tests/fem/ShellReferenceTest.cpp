#include "pellucida/fem/ShellReference.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

const ShellOptions kCoarse{.edge_length_ratio = 1.5};

/// Solved once for all cases of one program.
class EveryConfiguration : public ::testing::TestWithParam<int> {
 protected:
  struct Solved {
    explicit Solved(int configuration) : reference({}, contact_for_configuration(configuration), kCoarse) {}
    ShellReference reference;
    ShellCurve curve = reference.run(20.0, 1.0);
  };
  static const Solved& solved() {
    static std::map<int, Solved> all;
    return all.try_emplace(GetParam(), GetParam()).first->second;
  }
  const ShellReference& reference_ = solved().reference;
  const ShellCurve& curve_ = solved().curve;
};

TEST_P(EveryConfiguration, ConvergesAndStartsAtRest) {
  ASSERT_EQ(curve_.outcome, CurveOutcome::kComplete);
  ASSERT_EQ(curve_.steps.size(), 21u);
  EXPECT_EQ(curve_.steps[0].indentation_um, 0.0);
  EXPECT_EQ(curve_.steps[0].axial_force_uN, 0.0);
  EXPECT_LT((curve_.steps[0].nodes_um - reference_.rest().points_um).cwiseAbs().maxCoeff(), 1e-12);
  for (std::size_t k = 1; k < curve_.steps.size(); ++k) {
    const ShellStep& step = curve_.steps[k];
    EXPECT_EQ(step.indentation_um, static_cast<double>(k));
    EXPECT_EQ(step.report.status, SolveStatus::kConverged);
    EXPECT_LE(step.report.residual_uN, 1e-5 * 0.0179 * 5.0);
    EXPECT_GT(step.axial_force_uN, curve_.steps[k - 1].axial_force_uN);
    EXPECT_GT(step.pressure_kPa, curve_.steps[k - 1].pressure_kPa);
    EXPECT_LT(std::abs(step.volume_change_ratio), 8e-5);
    EXPECT_NEAR(curve_.total_force_uN(k), std::hypot(step.axial_force_uN, step.lateral_force_uN), 1e-9);
  }
}

TEST_P(EveryConfiguration, TipAndHolderAreInBalance) {
  // Nothing else acts from outside: forces cancel. Residual forces on a thousand nodes are the rest.
  for (const ShellStep& step : curve_.steps) {
    EXPECT_LT((step.tip_force_uN + step.holder_force_uN).norm(), 1e-9);
    EXPECT_NEAR(step.tip_force_uN.y(), 0.0, 1e-6);  // the mirror
  }
}

TEST_P(EveryConfiguration, ForceIsTheSlopeOfTheEnergy) {
  // Central differences over 2 um of a curve whose third derivative is small.
  for (std::size_t k = 3; k + 1 < curve_.steps.size(); ++k) {
    const double slope = 0.5 * (curve_.steps[k + 1].energy_uN_um - curve_.steps[k - 1].energy_uN_um);
    EXPECT_NEAR(curve_.steps[k].axial_force_uN, slope, 0.01 * slope) << k;
  }
}

TEST_P(EveryConfiguration, SectionRunsRoundTheShell) {
  const ShellSection section = reference_.section(curve_.steps.back());
  const Eigen::Index count = section.rest_angle_rad.size();
  ASSERT_GT(count, 40);
  for (Eigen::Index k = 1; k < count; ++k) EXPECT_GT(section.rest_angle_rad[k], section.rest_angle_rad[k - 1]);
  EXPECT_GE(section.rest_angle_rad[0], -std::numbers::pi);
  EXPECT_LT(section.rest_angle_rad[count - 1], std::numbers::pi);
  for (Eigen::Index k = 0; k < count; ++k) {
    EXPECT_NEAR((section.outer_um.col(k) - section.inner_um.col(k)).norm(), 5.0, 1e-9);
  }
  // The outer surface lies outside: more area by the shoelace formula.
  const auto area = [count](const Eigen::Matrix2Xd& c) {
    double twice = 0.0;
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::Index next = (k + 1) % count;
      twice += c(1, k) * c(0, next) - c(1, next) * c(0, k);
    }
    return 0.5 * twice;
  };
  EXPECT_GT(area(section.outer_um), area(section.mid_um));
  EXPECT_GT(area(section.mid_um), area(section.inner_um));
}

INSTANTIATE_TEST_SUITE_P(Configurations, EveryConfiguration, ::testing::Values(1, 2, 3, 4));

TEST(ShellReference, ForceGoesWithTheModulus) {
  ShellSpecimen stiff;
  stiff.young_modulus_kPa = 42.2;
  const ShellCurve soft_curve = ShellReference({}, contact_for_configuration(2), kCoarse).run(12.0, 12.0);
  const ShellCurve stiff_curve = ShellReference(stiff, contact_for_configuration(2), kCoarse).run(12.0, 12.0);
  EXPECT_NEAR(stiff_curve.steps[1].axial_force_uN / soft_curve.steps[1].axial_force_uN, 42.2 / 17.9, 1e-9);
  EXPECT_LT((stiff_curve.steps[1].nodes_um - soft_curve.steps[1].nodes_um).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(ShellReference, ForceGoesWithTheSquareOfTheSize) {
  // All lengths times 1.4, the bonds' densities over it.
  ShellSpecimen large;
  large.mid_radius_um *= 1.4;
  large.thickness_um *= 1.4;
  ShellContact wide = contact_for_configuration(4);
  for (double* length :
       {&wide.tip_radius_um, &wide.holder_ring_um, &wide.holder_half_width_um, &wide.lateral_offset_um}) {
    *length *= 1.4;
  }
  wide.tip_bond_per_um /= 1.4;
  wide.holder_bond_per_um /= 1.4;
  const ShellCurve curve = ShellReference({}, contact_for_configuration(4), kCoarse).run(12.0, 12.0);
  const ShellCurve large_curve = ShellReference(large, wide, kCoarse).run(1.4 * 12.0, 1.4 * 12.0);
  EXPECT_NEAR(large_curve.steps[1].axial_force_uN / curve.steps[1].axial_force_uN, 1.4 * 1.4, 1e-9);
  EXPECT_NEAR(large_curve.steps[1].pressure_kPa / curve.steps[1].pressure_kPa, 1.0, 1e-8);
}

TEST(ShellReference, StepsDoNotChangeTheCurve) {
  ShellReference reference({}, contact_for_configuration(3), kCoarse);
  const double fine = reference.run(15.0, 0.5).steps.back().axial_force_uN;
  const ShellCurve coarse = reference.run(15.0, 15.0);  // and a second run starts from rest again
  ASSERT_EQ(coarse.steps.size(), 2u);
  EXPECT_NEAR(coarse.steps.back().axial_force_uN, fine, 6e-6 * fine);
}

TEST(ShellReference, OffsetToEitherSideIsTheMirrorImage) {
  const ShellCurve right = ShellReference({}, contact_for_configuration(4, 10.0), kCoarse).run(10.0, 10.0);
  const ShellCurve left = ShellReference({}, contact_for_configuration(4, -10.0), kCoarse).run(10.0, 10.0);
  // Two meshes, one the other's mirror image.
  EXPECT_NEAR(left.steps[1].axial_force_uN, right.steps[1].axial_force_uN, 1e-9 * right.steps[1].axial_force_uN);
  EXPECT_NEAR(left.steps[1].lateral_force_uN, -right.steps[1].lateral_force_uN, 1e-9 * right.steps[1].axial_force_uN);
}

TEST(ShellReference, FinerMeshesConverge) {
  // Each refinement changes the force less than the one before; constant-strain triangles are stiff, so it falls.
  const ShellContact contact = contact_for_configuration(1);
  std::vector<double> force;
  for (const double ratio : {2.4, 1.7, 1.2}) {
    force.push_back(
        ShellReference({}, contact, {.edge_length_ratio = ratio}).run(24.0, 2.0).steps.back().axial_force_uN);
  }
  EXPECT_GT(force[0], force[1]);
  EXPECT_GT(force[1], force[2]);
  EXPECT_GT(force[0] - force[1], force[1] - force[2]);
}

TEST(ShellReference, SofterBelowHalfPoisson) {
  // Bending and stretching both go with E / (1 - nu^2): a smaller ratio is softer against a tip.
  ShellSpecimen specimen;
  const double incompressible = ShellReference(specimen, {}, kCoarse).run(4.0, 4.0).steps.back().axial_force_uN;
  specimen.poisson_ratio = 0.3;
  const ShellCurve curve = ShellReference(specimen, {}, kCoarse).run(4.0, 4.0);
  EXPECT_LT(curve.steps.back().axial_force_uN, incompressible);
  // Reissner's stiffness goes with (1 - nu^2)^-1/2.
  EXPECT_NEAR(curve.steps.back().axial_force_uN / incompressible, std::sqrt(0.75 / 0.91), 0.05);
}

TEST(ShellReference, OtherGeometriesConvergeToo) {
  const ShellOptions quick{.edge_length_ratio = 1.8};
  const auto expect_complete = [&](const ShellSpecimen& specimen, const ShellContact& contact, double deepest_um) {
    const ShellCurve curve = ShellReference(specimen, contact, quick).run(deepest_um, 0.1 * deepest_um);
    EXPECT_EQ(curve.outcome, CurveOutcome::kComplete) << "stopped before " << curve.failed_indentation_um;
    EXPECT_GT(curve.steps.back().axial_force_uN, 0.0);
  };
  ShellContact turned = contact_for_configuration(2);
  turned.lateral_offset_um = -20.0;
  turned.tip_radius_um = 8.0;
  expect_complete({}, turned, 40.0);
  ShellContact narrow = contact_for_configuration(3);
  narrow.holder_ring_um = 8.0;
  narrow.tip_radius_um = 2.0;
  expect_complete({}, narrow, 30.0);
  expect_complete({.mid_radius_um = 50.0, .thickness_um = 1.5}, {}, 25.0);
  expect_complete({.mid_radius_um = 30.0, .thickness_um = 6.0, .poisson_ratio = 0.4}, {}, 35.0);
  expect_complete({.mid_radius_um = 100.0, .thickness_um = 8.0}, contact_for_configuration(4, 30.0), 80.0);
}

TEST(ShellReference, ACancelledRunKeepsWhatItHas) {
  ShellReference reference({}, contact_for_configuration(1), kCoarse);
  std::stop_source stop;
  std::vector<double> shares;
  const ShellCurve curve = reference.run(
      20.0, 1.0,
      [&](const ShellStep& step, double share) {
        shares.push_back(share);
        if (step.indentation_um >= 5.0) stop.request_stop();
      },
      stop.get_token());
  EXPECT_EQ(curve.outcome, CurveOutcome::kCancelled);
  ASSERT_EQ(curve.steps.size(), 6u);
  EXPECT_GT(curve.steps.back().axial_force_uN, 0.0);
  ASSERT_EQ(shares.size(), 6u);
  EXPECT_EQ(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 0.25);
}

TEST(ShellReference, ARunThatDoesNotConvergeSaysSo) {
  // So thin that it wrinkles: one iteration doesn't follow that in the shortest of steps.
  ShellSpecimen thin;
  thin.thickness_um = 0.5;
  ShellReference reference(thin, contact_for_configuration(1), {.edge_length_ratio = 2.5, .max_iterations = 1});
  const ShellCurve curve = reference.run(20.0, 5.0);
  EXPECT_EQ(curve.outcome, CurveOutcome::kNotConverged);
  EXPECT_EQ(curve.failure.status, SolveStatus::kIterationBudget);
  ASSERT_LT(curve.steps.size(), 5u);
  EXPECT_EQ(curve.failed_indentation_um, 5.0 * static_cast<double>(curve.steps.size()));
  EXPECT_EQ(curve.steps.back().report.status, SolveStatus::kConverged);
}

TEST(ShellReference, OutOfRangeIsRefused) {
  const auto refused = [](auto change) {
    ShellSpecimen specimen;
    ShellContact contact;
    change(specimen, contact);
    EXPECT_THROW(ShellReference(specimen, contact, kCoarse), UsageError);
  };
  refused([](ShellSpecimen& s, ShellContact&) { s.mid_radius_um = 0.0; });
  refused([](ShellSpecimen& s, ShellContact&) { s.thickness_um = 30.0; });
  refused([](ShellSpecimen& s, ShellContact&) { s.young_modulus_kPa = -1.0; });
  refused([](ShellSpecimen& s, ShellContact&) { s.poisson_ratio = 0.6; });
  refused([](ShellSpecimen&, ShellContact& c) { c.tip_radius_um = 0.0; });
  refused([](ShellSpecimen&, ShellContact& c) { c.holder_ring_um = 50.0; });
  refused([](ShellSpecimen&, ShellContact& c) { c.lateral_offset_um = 60.0; });
  refused([](ShellSpecimen&, ShellContact& c) {  // the needle on the holder's mouth
    c.holder_angle_rad = 0.5 * std::numbers::pi;
    c.lateral_offset_um = 41.0;
    c.holder_ring_um = 35.0;
  });
  EXPECT_THROW(contact_for_configuration(5), UsageError);
  ShellReference reference({}, {}, kCoarse);
  EXPECT_THROW(reference.run(20.0, 0.0), UsageError);
  EXPECT_THROW(reference.run(20.0, 21.0), UsageError);
  EXPECT_THROW(reference.run(71.0, 1.0), UsageError);
}

}  // namespace
}  // namespace pellucida
