// The shell against the project's reference curves and shapes, and against its own figures.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <map>

#include "pellucida/core/Resources.h"
#include "pellucida/core/Table.h"
#include "pellucida/fem/ShellReference.h"
#include "support/SharedFolder.h"

namespace pellucida {
namespace {

/// On Table I's 17.9 kPa: with it the reference's thin shell passes 7.5 uN at 44 um (thin-shell-oocyte-1).
constexpr double kScale = 7.5 / 0.920359;

const ShellStep& at(const ShellCurve& curve, double depth_um) {
  for (const ShellStep& step : curve.steps) {
    if (std::abs(step.indentation_um - depth_um) < 1e-9) return step;
  }
  throw std::out_of_range("no step at that depth");
}

/// Solved once, looked at by all cases of one program.
class Configuration : public ::testing::TestWithParam<int> {
 protected:
  struct Solved {
    std::unique_ptr<ShellReference> reference;
    ShellCurve curve;
  };
  const Solved& solved() const {
    static std::map<int, Solved> all;
    Solved& one = all[GetParam()];
    if (!one.reference) {
      one.reference = std::make_unique<ShellReference>(ShellSpecimen{}, contact_for_configuration(GetParam()));
      one.curve = one.reference->run(44.0, 1.0);
      EXPECT_EQ(one.curve.outcome, CurveOutcome::kComplete);
    }
    return one;
  }
};
class ShippedConfiguration : public Configuration {};

TEST_P(ShippedConfiguration, ForceIsMetWithinTwoPercent) {
  const std::string stem = "thin-shell-oocyte-" + std::to_string(GetParam());
  const Table table = Table::read(resource_folder() / "reference" / (stem + "-force.csv"));
  const Eigen::VectorXd depth = table.column("indentation_um"), force = table.column("force_uN");
  const Eigen::VectorXd pressure = table.column("pressure_kPa");
  double largest = 0.0;
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    if (depth[row] < 4.0) continue;
    const ShellStep& step = at(solved().curve, depth[row]);
    const double error = kScale * step.axial_force_uN / force[row] - 1.0;
    EXPECT_LT(std::abs(error), 0.02) << depth[row];
    EXPECT_NEAR(kScale * step.pressure_kPa, pressure[row], 0.016 * pressure[row]) << depth[row];
    largest = std::max(largest, std::abs(error));
  }
  std::printf("configuration %d: largest error of the force from 4 um %.2f %%\n", GetParam(), 100.0 * largest);
}

TEST_P(ShippedConfiguration, SectionIsMetWithinAThirdOfAMicrometre) {
  // The shapes of configurations 2 and 3 are the virtual oocyte's.
  const std::string stem = (GetParam() == 1 ? "thin-shell-oocyte-" : "mouse-oocyte-") + std::to_string(GetParam());
  const Table table = Table::read(resource_folder() / "reference" / (stem + "-profile.csv"));
  const Eigen::VectorXd depth = table.column("indentation_um"), x = table.column("x_mid_um"),
                        z = table.column("z_mid_um");
  double largest = 0.0, sum = 0.0;
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    // To the nearest place on the polygon.
    const ShellSection section = solved().reference->section(at(solved().curve, depth[row]));
    const Eigen::Index count = section.mid_um.cols();
    const Eigen::Vector2d p(x[row], z[row]);
    double nearest = 1e9;
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::Vector2d a = section.mid_um.col(k), b = section.mid_um.col((k + 1) % count);
      const double along = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (p - a - along * (b - a)).norm());
    }
    largest = std::max(largest, nearest);
    sum += nearest * nearest;
  }
  std::printf("configuration %d: section off by %.2f um at most, %.2f um RMS\n", GetParam(), largest,
              std::sqrt(sum / static_cast<double>(table.rows())));
  EXPECT_LT(largest, 0.35);
  EXPECT_LT(std::sqrt(sum / static_cast<double>(table.rows())), 0.12);
}

TEST_P(ShippedConfiguration, LateralForceIsMet) {
  const auto file =
      test::shared_folder() / "mechanics" / "reference" / ("force_config" + std::to_string(GetParam()) + "_oocyte.csv");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const Table table = Table::read(file);
  const Eigen::VectorXd depth = table.column("indentation_um"), lateral = table.column("Fx_uN");
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    const ShellStep& step = at(solved().curve, depth[row]);
    EXPECT_NEAR(step.lateral_force_uN, lateral[row], 0.02 * step.tip_force_uN.norm() + 1e-5) << depth[row];
  }
}

INSTANTIATE_TEST_SUITE_P(OfThePaper, ShippedConfiguration, ::testing::Values(1, 2, 3));

// What this module found when it was made: 10, 20, 30, 44 um, axial and lateral, uN. A change of mesh moves them by a
// per cent or two; anything else should not move them at all.
TEST_P(Configuration, KeepsItsFigures) {
  const std::map<int, std::array<std::array<double, 2>, 4>> kept{
      {1, {{{0.1268, 0.0}, {0.2458, 0.0}, {0.4656, 0.0}, {0.9187, 0.0}}}},
      {2, {{{0.1228, 0.0500}, {0.2237, 0.0988}, {0.3904, 0.1944}, {0.6724, 0.4222}}}},
      {3, {{{0.1079, 0.0962}, {0.1672, 0.1573}, {0.2365, 0.2363}, {0.3191, 0.3290}}}},
      {4, {{{0.1285, -0.0075}, {0.2470, -0.0155}, {0.4630, -0.0405}, {0.9028, -0.1163}}}},
  };
  constexpr std::array<double, 4> kDepths_um{10.0, 20.0, 30.0, 44.0};
  for (std::size_t k = 0; k < kDepths_um.size(); ++k) {
    const ShellStep& step = at(solved().curve, kDepths_um[k]);
    std::printf("configuration %d, %.0f um: %.4f uN along, %.4f uN across\n", GetParam(), kDepths_um[k],
                step.axial_force_uN, step.lateral_force_uN);
    EXPECT_NEAR(step.axial_force_uN, kept.at(GetParam())[k][0], 7e-4 * kept.at(GetParam())[k][0]);
    EXPECT_NEAR(step.lateral_force_uN, kept.at(GetParam())[k][1], 0.002 * kept.at(GetParam())[k][0]);
  }
}

INSTANTIATE_TEST_SUITE_P(OfThePaper, Configuration, ::testing::Values(1, 2, 3, 4));

// The embryo differs from the oocyte by its modulus and goes deeper.
TEST(Embryo, ForceIsMetWithinTwoPercent) {
  const auto file = test::shared_folder() / "mechanics" / "reference" / "force_config1_embryo.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const Table table = Table::read(file);
  const Eigen::VectorXd depth = table.column("indentation_um"), force = table.column("force_uN");
  ShellSpecimen embryo;
  embryo.young_modulus_kPa = 42.2;
  const ShellCurve curve = ShellReference(embryo, contact_for_configuration(1)).run(53.0, 1.0);
  ASSERT_EQ(curve.outcome, CurveOutcome::kComplete);
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    if (depth[row] < 4.0) continue;
    EXPECT_NEAR(at(curve, depth[row]).axial_force_uN, force[row], 0.02 * force[row]) << depth[row];
  }
}

}  // namespace
}  // namespace pellucida
