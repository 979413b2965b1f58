// One contour, two read-outs: what the equilibrium makes of it, and what prescribing every node does. The numbers of
// the lesson "prescribed-contour".
#include "pellucida/teaching/ReadoutComparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pellucida/core/Error.h"
#include "pellucida/simulation/CellReference.h"

namespace pellucida {
namespace {

class ReadoutTest : public testing::Test {
 protected:
  ReadoutPair read(const ReadoutParameters& p, std::optional<int> node = {}) {
    if (!is_of_finite_elements(p)) return comparison_.read(p, comparison_.own_section(p.depth_um), node).value();
    const auto section = reference_.section(p.depth_um);
    return comparison_
        .read(p, {section.outer_um, section.inner_um, reference_.angle_rad(), reference_.force_uN(p.depth_um)}, node)
        .value();
  }
  static ReadoutParameters at(double depth_um, const std::string& laying, double noise_um = 0.0) {
    ReadoutParameters p;
    p.depth_um = depth_um;
    p.laying = laying;
    p.noise_um = noise_um;
    return p;
  }

  CellReference reference_ = CellReference::load("thin-shell-oocyte", 1);
  ReadoutComparison comparison_{9};
};

TEST_F(ReadoutTest, TheEquilibriumIsTrueAndThePrescribedContourIsNot) {
  struct Row {
    double depth_um, true_uN;
    double equal_uN, true_places_uN, nearest_uN;
  };
  for (const Row& row :
       {Row{10.0, 1.05, 0.45, 0.43, 0.87}, Row{20.0, 2.02, 0.29, 0.79, 1.31}, Row{44.0, 7.50, -0.22, 4.23, 5.03}}) {
    for (const auto& [laying, force_uN] :
         {std::pair("equal-distances", row.equal_uN), std::pair("true-places", row.true_places_uN),
          std::pair("nearest", row.nearest_uN)}) {
      const ReadoutPair pair = read(at(row.depth_um, laying));
      EXPECT_NEAR(pair.true_force_uN, row.true_uN, 0.01);
      EXPECT_NEAR(pair.equilibrium.force_uN / pair.true_force_uN, 1.0, 0.03) << row.depth_um;
      EXPECT_NEAR(pair.prescribed.force_uN, force_uN, 0.03) << row.depth_um << ' ' << laying;
      EXPECT_EQ(pair.seen_depth_um, row.depth_um);
    }
  }
  // "44 to 61 % too low", and 4.2 uN.
  EXPECT_NEAR(1.0 - 4.23 / 7.50, 0.44, 0.005);
  EXPECT_NEAR(1.0 - 0.79 / 2.02, 0.61, 0.005);
}

TEST_F(ReadoutTest, NoiseIsReadAsForceWherePrescribed) {
  double least[2] = {1e9, 1e9}, most[2] = {-1e9, -1e9};
  for (int draw = 1; draw <= 8; ++draw) {
    ReadoutParameters p = at(20.0, "equal-distances", 0.3);
    p.draw = draw;
    const ReadoutPair pair = read(p);
    const double forces_uN[2] = {pair.equilibrium.force_uN, pair.prescribed.force_uN};
    for (int k = 0; k < 2; ++k) {
      least[k] = std::min(least[k], forces_uN[k]);
      most[k] = std::max(most[k], forces_uN[k]);
    }
  }
  EXPECT_LT(most[0] - least[0], 0.05);
  EXPECT_GT(most[1] - least[1], 0.2);
  EXPECT_LT(most[1] - least[1], 1.0);
}

TEST_F(ReadoutTest, AFreeNodeIsInBalanceOnlyInEquilibrium) {
  // 45 degrees beside the needle's contact point: neither tool reaches it.
  const ReadoutPair first = read(at(20.0, "equal-distances"));
  int node = 0;
  double nearest = 1e9;
  for (int n = 0; n < first.equilibrium.shape.x_um.cols(); ++n) {
    const Eigen::Vector3d p = first.equilibrium.shape.x_um.col(n).normalized();
    const double off = (p - Eigen::Vector3d(1.0, 0.0, 1.0).normalized()).norm();
    if (off < nearest) node = n;
    nearest = std::min(nearest, off);
  }
  const ReadoutPair pair = read(at(20.0, "equal-distances"), node);
  ASSERT_TRUE(pair.equilibrium.shape.node_forces && pair.prescribed.shape.node_forces);
  EXPECT_EQ(pair.equilibrium.shape.node_forces->of(ForceTerm::kNeedle).norm(), 0.0);
  EXPECT_LT(pair.equilibrium.shape.node_forces->residual_uN().norm(), 1e-4);
  EXPECT_GT(pair.prescribed.shape.node_forces->residual_uN().norm(), 1e-2);
}

// "Connectors that pull in truth seem slack, or to push": meridians within 12 um of the needle's axis.
TEST_F(ReadoutTest, EqualDistancesSlackenWhatPullsUnderTheTip) {
  const ReadoutPair pair = read(at(44.0, "equal-distances"));
  double pulls_uN[2] = {0.0, 0.0}, least_uN = 0.0;
  int count = 0;
  const CellMesh& mesh = *pair.equilibrium.shape.mesh;
  for (std::size_t k = 0; k < mesh.pairs.size(); ++k) {
    if (mesh.directions[k] != SpringDirection::kMeridian) continue;
    const auto at_tip = [&](int n) {
      const Eigen::Vector3d x_um = pair.equilibrium.shape.x_um.col(n);
      return x_um.head<2>().norm() < 12.0 && x_um.z() > -10.0;
    };
    if (!at_tip(mesh.pairs[k][0]) || !at_tip(mesh.pairs[k][1])) continue;
    pulls_uN[0] += pair.equilibrium.shape.spring_pull_uN[static_cast<Eigen::Index>(k)];
    pulls_uN[1] += pair.prescribed.shape.spring_pull_uN[static_cast<Eigen::Index>(k)];
    least_uN = std::min(least_uN, pair.prescribed.shape.spring_pull_uN[static_cast<Eigen::Index>(k)]);
    ++count;
  }
  ASSERT_GT(count, 4);
  EXPECT_GT(pulls_uN[0] / count, 0.15);
  EXPECT_LT(pulls_uN[1] / count, 0.02);
  EXPECT_LT(least_uN, -0.02);
}

TEST_F(ReadoutTest, TheNetworksOwnContourNeedsTheTruePlacesToo) {
  ReadoutParameters p = at(20.0, "nearest");
  p.contour = "model";
  const ReadoutPair pair = read(p);
  EXPECT_NEAR(pair.equilibrium.force_uN, pair.true_force_uN, 1e-6);
  EXPECT_NEAR(pair.prescribed.force_uN, 1.73, 0.03);
}

TEST_F(ReadoutTest, UnknownNamesAreRefused) {
  ReadoutParameters p;
  p.laying = "anywhere";
  EXPECT_THROW(require_valid(p), UsageError);
  p = {};
  p.contour = "drawn";
  EXPECT_THROW(require_valid(p), UsageError);
  p = {};
  p.depth_um = 50.0;
  EXPECT_THROW(require_valid(p), UsageError);
}

}  // namespace
}  // namespace pellucida
