#include "ReferenceTables.h"

#include <gtest/gtest.h>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/TemporaryFolder.h"

namespace pellucida {
namespace {

TEST(ReferenceTables, HoldTheCurveAndTheSections) {
  const TemporaryFolder folder;
  ShellReference reference({}, contact_for_configuration(4), {.edge_length_ratio = 2.5});
  const ShellCurve curve = reference.run(4.0, 2.0);
  write_reference_tables(reference, curve, folder.path() / "new", "cell-4");

  const Table force = Table::read(folder.path() / "new" / "cell-4-force.csv");
  ASSERT_EQ(force.rows(), 3);
  EXPECT_EQ(force.column("indentation_um")[2], 4.0);
  EXPECT_NEAR(force.column("force_uN")[2], curve.steps[2].axial_force_uN, 1e-6);
  EXPECT_NEAR(force.column("lateral_force_uN")[2], curve.steps[2].lateral_force_uN, 1e-6);
  EXPECT_NEAR(force.column("pressure_kPa")[2], curve.steps[2].pressure_kPa, 1e-8);

  const ShellSection last = reference.section(curve.steps[2]);
  const Table profile = Table::read(folder.path() / "new" / "cell-4-profile.csv");
  const Eigen::Index count = last.mid_um.cols();
  ASSERT_EQ(profile.rows(), 3 * count);
  EXPECT_NEAR(profile.column("theta0_rad")[2 * count + 5], last.rest_angle_rad[5], 1e-6);
  EXPECT_NEAR(profile.column("x_mid_um")[2 * count + 5], last.mid_um(0, 5), 1e-4);
  EXPECT_NEAR(profile.column("z_mid_um")[2 * count + 5], last.mid_um(1, 5), 1e-4);
}

TEST(ReferenceTables, HoldTheSolidsHalfSections) {
  const TemporaryFolder folder;
  SolidReference reference({}, {}, {.edge_length_ratio = 2.0, .across = 1});
  const SolidCurve curve = reference.run(2.0, 2.0);
  write_reference_tables(reference, curve, folder.path(), "cell-1");
  EXPECT_EQ(Table::read(folder.path() / "cell-1-force.csv").rows(), 2);
  const Table profile = Table::read(folder.path() / "cell-1-profile.csv");
  EXPECT_EQ(profile.rows(), 2 * reference.rest_angle_rad().size());
  EXPECT_EQ(profile.column("outer_r_um")[0], 0.0);
  EXPECT_NEAR(profile.column("inner_z_um")[0], 47.5, 1e-9);
}

TEST(ReferenceTables, AFolderThatCannotBeIsAnError) {
  SolidReference reference({}, {}, {.edge_length_ratio = 2.0, .across = 1});
  EXPECT_THROW(write_reference_tables(reference, SolidCurve{}, "/dev/null/folder", "cell"), OutputError);
}

}  // namespace
}  // namespace pellucida
