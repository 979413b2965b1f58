// The equilibria read off a path are those that are solved one by one.
#include "pellucida/membrane/EquilibriumPath.h"

#include <gtest/gtest.h>

#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/membrane/MembraneGeometry.h"
#include "pellucida/membrane/MembraneModel.h"

namespace pellucida {
namespace {

class EquilibriumPathTest : public ::testing::TestWithParam<int> {
 protected:
  CellProfile profile_ = load_profile("mouse-oocyte");
  MembraneSetup setup_ = setup_for_configuration(profile_, GetParam());
  MembraneGeometry geometry_ = geometry_of(profile_);
};

double largest_column_um(const Eigen::Matrix3Xd& m) {
  return m.colwise().norm().maxCoeff();
}

// At most found, over the four configurations: force 8e-5, stiffness 3.1e-3, a node 1.6e-3 um, a residual 2.1e-4 um.
TEST_P(EquilibriumPathTest, ReadsWhatIsSolvedOneByOne) {
  EquilibriumPath path(profile_, geometry_, setup_.push, setup_.holder);
  Indenter reader(profile_, geometry_, setup_.push, setup_.holder);
  Indenter solver(profile_, geometry_, setup_.push, setup_.holder);
  const IndentationState deepest = Indenter(profile_, geometry_, setup_.push, setup_.holder).advance_to(56.0);
  Eigen::Matrix3Xd residual_uN;
  for (double depth_um = 0.15; depth_um < 56.0; depth_um += 0.77) {
    const IndentationState solved = solver.advance_to(depth_um);
    const auto shape = path.at(depth_um);
    ASSERT_TRUE(shape) << depth_um;
    const IndentationState read = reader.adopt(*shape);
    EXPECT_EQ(read.depth_um, depth_um);
    EXPECT_NEAR(read.push_force_uN / solved.push_force_uN, 1.0, 2e-4) << depth_um;
    EXPECT_NEAR(read.stiffness_uN_per_um / solved.stiffness_uN_per_um, 1.0, 6e-3) << depth_um;
    EXPECT_LT((read.tip_force_uN - solved.tip_force_uN).norm() / solved.push_force_uN, 1e-3) << depth_um;
    EXPECT_NEAR(read.pressure_Pa, solved.pressure_Pa, 2e-3 * deepest.pressure_Pa) << depth_um;
    EXPECT_LT(largest_column_um(reader.positions_um() - solver.positions_um()), 3e-3) << depth_um;
    residual_uN.setZero(3, reader.positions_um().cols());
    reader.model().energy().add(reader.positions_um(), &residual_uN, nullptr);
    EXPECT_LT(largest_column_um(residual_uN) / reader.model().force_scale_uN_per_um(), 5e-4) << depth_um;
  }
}
INSTANTIATE_TEST_SUITE_P(Configurations, EquilibriumPathTest, ::testing::Values(1, 2, 3, 4));

// A thick, small cell's dimple gives way on the far side of its centre.
TEST(EquilibriumPathEnd, IsTheDeepestShapeAndSaysWhy) {
  const CellProfile profile = load_profile("mouse-embryo");
  const MembraneGeometry geometry{
      .mid_radius_um = 39.0, .thickness_um = 4.0, .tip_radius_um = 2.6, .holder_radius_um = 22.5};
  const Eigen::Vector3d along = -Eigen::Vector3d::UnitZ();
  EquilibriumPath path(profile, geometry, along, along);
  double depth_um = 0.0;
  while (path.at(depth_um)) depth_um += EquilibriumPath::kStep_um;
  EXPECT_LT(depth_um, 1.4 * geometry.mid_radius_um);
  const auto end = path.end();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->report.status, SolveStatus::kUnstable);
  EXPECT_NEAR(end->depth_um, depth_um, EquilibriumPath::kStep_um);
  Indenter reader(profile, geometry, along, along);
  EXPECT_EQ(reader.adopt(*end).depth_um, end->depth_um);
  EXPECT_EQ(reader.advance_to(end->depth_um).report.status, SolveStatus::kConverged);
}

// The modulus scales the forces on the nodes, which come with the shape.
TEST(AdoptedShapeTest, AnotherModulusBringsTheForcesOnTheNodes) {
  CellProfile profile = load_profile("mouse-oocyte");
  const MembraneGeometry geometry = geometry_of(profile);
  const Eigen::Vector3d along = -Eigen::Vector3d::UnitZ();
  Indenter solver(profile, geometry, along, along);
  const SolvedShape shape = solver.shape(solver.advance_to(15.0).report);
  profile.effective_young_modulus_kPa *= 1.7;
  Indenter reader(profile, geometry, along, along);
  reader.adopt(shape);
  const double largest_uN = largest_column_um(solver.elastic_force_uN());
  EXPECT_GT(largest_uN, 0.01);
  EXPECT_LT(largest_column_um(reader.elastic_force_uN() - 1.7 * solver.elastic_force_uN()), 1e-12 * largest_uN);
  EXPECT_LT(largest_column_um(reader.elastic_force_uN() - reader.model().elastic_force_uN(reader.positions_um())),
            1e-9 * largest_uN);
}

TEST(AdoptedShapeTest, AShapeThatIsNoEquilibriumIsSolved) {
  const CellProfile profile = load_profile("mouse-oocyte");
  const MembraneGeometry geometry = geometry_of(profile);
  const Eigen::Vector3d along = -Eigen::Vector3d::UnitZ();
  EquilibriumPath path(profile, geometry, along, along);
  auto shape = path.at(12.3);
  ASSERT_TRUE(shape);
  Indenter reader(profile, geometry, along, along), solver(profile, geometry, along, along);
  const IndentationState solved = solver.advance_to(12.3);
  EXPECT_EQ(reader.adopt_checked(*shape, 1e-3).report.iterations, 0);
  shape->positions_um *= 1.001;
  const IndentationState mended = reader.adopt_checked(*shape, 1e-3);
  EXPECT_GT(mended.report.iterations, 0);
  EXPECT_NEAR(mended.push_force_uN / solved.push_force_uN, 1.0, 1e-6);
}

}  // namespace
}  // namespace pellucida
