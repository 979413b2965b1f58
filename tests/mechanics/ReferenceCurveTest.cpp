// The model against the finite-element reference, with the effective scale.
#include <gtest/gtest.h>

#include <filesystem>

#include "pellucida/core/Resources.h"
#include "pellucida/core/Table.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

struct Errors {
  double largest_ratio = 0.0;          ///< from 4 um
  double largest_of_peak_ratio = 0.0;  ///< everywhere
};

/// The model's forces, by depth, against a table's. `indenter` at rest.
Errors compare(Indenter indenter, const std::filesystem::path& file, const char* force_column) {
  const Table table = Table::read(file);
  const Eigen::VectorXd depth = table.column("indentation_um"), force = table.column(force_column);
  Errors errors;
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    const IndentationState state = indenter.advance_to(depth[row]);
    EXPECT_EQ(state.report.status, SolveStatus::kConverged) << depth[row];
    const double error = std::abs(state.push_force_uN - force[row]);
    errors.largest_of_peak_ratio = std::max(errors.largest_of_peak_ratio, error / force[table.rows() - 1]);
    if (depth[row] >= 4.0) errors.largest_ratio = std::max(errors.largest_ratio, error / force[row]);
  }
  std::printf("%s: %.2f %% pointwise from 4 um, %.2f %% of the last\n", file.filename().c_str(),
              100.0 * errors.largest_ratio, 100.0 * errors.largest_of_peak_ratio);
  return errors;
}

Indenter springs_alone(const CellProfile& profile, int configuration) {
  return {profile, setup_for_configuration(profile, configuration)};
}

Indenter as_measured(const CellProfile& profile, int configuration) {
  const MembraneSetup setup = setup_for_configuration(profile, configuration);
  return {profile, geometry_of(profile), setup.push, setup.holder};
}

class OocyteInConfiguration : public ::testing::TestWithParam<int> {
 protected:
  CellProfile profile_ = load_profile("mouse-oocyte");
  std::filesystem::path file(const std::string& cell) const {
    return resource_folder() / "reference" / (cell + "-" + std::to_string(GetParam()) + "-force.csv");
  }
};

// The springs' constants are the thin shell's, in all configurations.
TEST_P(OocyteInConfiguration, TheSpringsMeetTheThinShellWithinFivePercent) {
  const Errors errors = compare(springs_alone(profile_, GetParam()), file("thin-shell-oocyte"), "force_uN");
  EXPECT_LT(errors.largest_ratio, 0.05);
  EXPECT_LT(errors.largest_of_peak_ratio, 0.03);
}

// What is measured by is the solid, from the first micrometres on.
TEST_P(OocyteInConfiguration, TheForceMeetsTheVirtualSpecimenWithinFivePercent) {
  const Errors errors = compare(as_measured(profile_, GetParam()), file("mouse-oocyte"), "force_uN");
  EXPECT_LT(errors.largest_ratio, 0.05);
  EXPECT_LT(errors.largest_of_peak_ratio, 0.03);
  if (GetParam() == 1) {
    const Errors without = compare(springs_alone(profile_, 1), file("mouse-oocyte"), "force_uN");
    EXPECT_GT(without.largest_ratio, 3.0 * errors.largest_ratio);
  }
}

INSTANTIATE_TEST_SUITE_P(Configurations, OocyteInConfiguration, ::testing::Values(1, 2, 3, 4));

TEST(EmbryoReference, IsMetWithinFivePercent) {
  const Errors errors = compare(as_measured(load_profile("mouse-embryo"), 1),
                                resource_folder() / "reference/mouse-embryo-1-force.csv", "force_uN");
  EXPECT_LT(errors.largest_ratio, 0.05);
  EXPECT_LT(errors.largest_of_peak_ratio, 0.02);
}

TEST(PuncturePoint, IsPassedByBothCells) {
  for (const char* name : {"mouse-oocyte", "mouse-embryo"}) {
    const CellProfile profile = load_profile(name);
    const auto curve = force_curve(profile, 1, profile.puncture_indentation_um, 2.0);
    EXPECT_NEAR(curve.back().push_force_uN, profile.puncture_force_uN, 1e-9 * profile.puncture_force_uN) << name;
    // It rises all the way.
    for (std::size_t k = 1; k < curve.size(); ++k) EXPECT_GT(curve[k].push_force_uN, curve[k - 1].push_force_uN);
  }
}

TEST(TableOneModulus, CarriesOnlyAnEighthOfTheMeasuredForce) {
  // Why an effective modulus is needed: with the published one the shell passes far below the published force.
  CellProfile profile = load_profile("mouse-oocyte");
  profile.effective_young_modulus_kPa = profile.young_modulus_kPa;
  const double force = force_curve(profile, 1, 44.0, 2.0).back().push_force_uN;
  EXPECT_NEAR(force, 0.92, 0.05);
}

TEST(ProfileErrors, AreGivenForAllConfigurationsAndTheSolid) {
  // That the figures are true is tested where the finite elements are run: tests/identification.
  for (const char* name : {"mouse-oocyte", "mouse-embryo"}) {
    const CellProfile profile = load_profile(name);
    for (int configuration = 1; configuration <= 4; ++configuration) {
      int shells = 0, solids = 0;
      for (const auto& claim : profile.errors) {
        if (claim.configuration != configuration) continue;
        (claim.reference.find("thin-shell") != std::string::npos ? shells : solids) += 1;
        EXPECT_GT(claim.largest_of_peak_ratio, 0.0);
        EXPECT_DOUBLE_EQ(claim.to_um, profile.puncture_indentation_um);
      }
      EXPECT_EQ(shells, 1) << name << configuration;
      EXPECT_EQ(solids, configuration == 1 ? 1 : 0) << name << configuration;
    }
    EXPECT_EQ(profile.references.size(), 4U);
  }
}

TEST(ThinShellReference, TheEmbryoStaysWithinFourPercentPointwise) {
  const std::filesystem::path file =
      std::filesystem::path(PELLUCIDA_SOURCE_DIR) / "../shared/mechanics/reference/force_config1_embryo.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the embryo's thin-shell reference isn't beside this checkout";
  const Errors errors = compare(springs_alone(load_profile("mouse-embryo"), 1), file, "force_scaled_to_TableI_uN");
  EXPECT_LT(errors.largest_ratio, 0.033);
  EXPECT_LT(errors.largest_of_peak_ratio, 0.013);
}

TEST(SolidReference, ConfigurationOneStaysWithinFivePercentOfPeak) {
  const std::filesystem::path file =
      std::filesystem::path(PELLUCIDA_SOURCE_DIR) / "../shared/mechanics/reference/force_config1_oocyte_solidFE.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the solid reference isn't beside this checkout";
  const Errors errors = compare(as_measured(load_profile("mouse-oocyte"), 1), file, "force_scaled_to_TableI_uN");
  EXPECT_LT(errors.largest_of_peak_ratio, 0.05);
}

}  // namespace
}  // namespace pellucida
