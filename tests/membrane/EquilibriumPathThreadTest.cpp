// The thread that follows a path: what is read doesn't depend on its pace, and it doesn't run away.
#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <thread>

#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/EquilibriumPath.h"
#include "pellucida/membrane/MembraneGeometry.h"

namespace pellucida {
namespace {

CellProfile coarse_cell() {
  CellProfile profile = load_profile("mouse-oocyte");
  profile.mesh_frequency = 4;
  return profile;
}

class PathOfOneCellTest : public ::testing::Test {
 protected:
  CellProfile profile_ = coarse_cell();
  MembraneGeometry geometry_ = geometry_of(profile_);
  Eigen::Vector3d along_ = -Eigen::Vector3d::UnitZ();
};

TEST_F(PathOfOneCellTest, SameBitsWhateverThePace) {
  EquilibriumPath waited_for(profile_, geometry_, along_, along_), hurried(profile_, geometry_, along_, along_);
  while (waited_for.solved_to_um() < EquilibriumPath::kAhead_um) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  // One reads deep first and the rest afterwards, the other on the way in.
  const std::optional<SolvedShape> deep = hurried.at(21.3);
  ASSERT_TRUE(deep);
  for (const double depth_um : {0.0, 2.0, 3.7, 12.9, 21.3}) {
    const auto a = waited_for.at(depth_um), b = hurried.at(depth_um);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->positions_um, b->positions_um) << depth_um;
    EXPECT_EQ(a->depth_tangent, b->depth_tangent) << depth_um;
    EXPECT_EQ(a->forces.push_uN, b->forces.push_uN) << depth_um;
    EXPECT_EQ(a->stiffness_uN_per_um, b->stiffness_uN_per_um) << depth_um;
  }
}

TEST_F(PathOfOneCellTest, SolvesOnlyALittleAhead) {
  EquilibriumPath path(profile_, geometry_, along_, along_);
  ASSERT_TRUE(path.at(3.0));
  // It stops where it was asked to, or has not got there yet.
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_LE(path.solved_to_um(), 3.0 + EquilibriumPath::kAhead_um + EquilibriumPath::kStep_um);
}

}  // namespace
}  // namespace pellucida
