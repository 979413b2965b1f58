#include "pellucida/simulation/SpecimenForce.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pellucida/core/Resources.h"
#include "pellucida/core/Table.h"
#include "pellucida/simulation/CellReference.h"
#include "pellucida/simulation/Scenario.h"
#include "pellucida/simulation/VirtualSpecimen.h"
#include "simulation/TestScenes.h"

namespace pellucida {
namespace {

using test::ReferenceCase;

// A turned frame, so that no component is hidden by a zero.
SpecimenForce::Frame turned(double scale = 1.0) {
  const double angle = 0.7;
  return {{270, 200, 0}, {std::cos(angle), std::sin(angle), 0}, {std::sin(angle), -std::cos(angle), 0}, scale};
}

class ForceField : public testing::TestWithParam<ReferenceCase> {
 protected:
  SpecimenForce field_ = SpecimenForce::load(GetParam().cell, GetParam().configuration, turned());
  double offset_um_ = GetParam().configuration == 4 ? 10.0 : 0.0;
};

TEST_P(ForceField, AlongTheConfigurationsLineItIsTheReferenceCurve) {
  const auto reference = CellReference::load(GetParam().cell, GetParam().configuration);
  for (double depth = -5; depth <= reference.max_indentation_um(); depth += 0.37) {
    const auto reply = field_.at(field_.tip_at(offset_um_, depth));
    EXPECT_NEAR(reply.depth_um, depth, 1e-9);
    EXPECT_NEAR(reply.offset_um, offset_um_, 1e-9);
    // The tables by offset have six digits.
    EXPECT_NEAR(reply.axial_force_uN, reference.force_uN(depth), 1.2e-5) << depth;
    EXPECT_TRUE(reply.in_range) << depth;
  }
}

TEST_P(ForceField, BesideItIsTheTableThere) {
  const int family = GetParam().configuration == 4 ? 1 : GetParam().configuration;
  const Table table = Table::read(resource_folder() / "reference" /
                                  (std::string(GetParam().cell) + "-" + std::to_string(family) + "-field.csv"));
  const auto offset = table.column("offset_um"), depth = table.column("indentation_um"),
             force = table.column("force_uN");
  ASSERT_GT(offset.size(), 40);
  for (Eigen::Index i = 0; i < offset.size(); ++i)
    EXPECT_NEAR(field_.at(field_.tip_at(offset(i), depth(i))).axial_force_uN, force(i), 1e-9) << offset(i);
}

TEST_P(ForceField, ForceIsMinusTheEnergysGradient) {
  const double step = 1e-4;
  for (double offset : {-43.0, -31.0, -20.5, -13.0, -4.0, 0.3, 8.0, 17.0, 26.0, 40.0})
    for (double depth : {0.4, 3.3, 11.0, 27.5, 41.0, 60.0})
      for (double out : {0.0, 6.0, -15.0}) {
        PlainVector3 tip = field_.tip_at(offset, depth);
        tip.z += out;
        const auto reply = field_.at(tip);
        Eigen::Vector3d gradient;
        for (int k = 0; k < 3; ++k) {
          const Eigen::Vector3d way = step * Eigen::Vector3d::Unit(k);
          gradient(k) = (field_.at(Eigen::Vector3d(tip.eigen() + way)).energy_uN_um -
                         field_.at(Eigen::Vector3d(tip.eigen() - way)).energy_uN_um) /
                        (2 * step);
        }
        // Where a small step leaves the cell the difference is none.
        if (std::abs(reply.depth_um) < 0.01) continue;
        EXPECT_LE((reply.force_uN.eigen() + gradient).norm(), 3e-7 * (1 + gradient.norm())) << offset << ' ' << depth;
      }
}

TEST_P(ForceField, NothingIsFeltOutsideAndNothingJumps) {
  // From all directions on the needle's side, along straight lines: the force changes by no more than a stiff cell
  // allows.
  for (int k = -8; k <= 8; ++k) {
    const double angle = 0.7 + k * std::numbers::pi / 18;
    const Eigen::Vector3d way(std::cos(angle), std::sin(angle), 0), start(270, 200, 0);
    SpecimenReply before;
    bool first = true;
    for (double s = 80; s >= 12; s -= 0.02) {
      const auto reply = field_.at(Eigen::Vector3d(start + s * way));
      if (s > 52.6) {
        EXPECT_EQ(reply.force_uN.eigen().norm(), 0.0);
      }
      if (!first) {
        EXPECT_LE((reply.force_uN.eigen() - before.force_uN.eigen()).norm(), 0.06) << angle << ' ' << s;
      }
      EXPECT_GE(reply.axial_force_uN, 0.0);
      before = reply;
      first = false;
    }
  }
}

TEST_P(ForceField, SizeScalesLengthsAndForces) {
  const auto large = SpecimenForce::load(GetParam().cell, GetParam().configuration, turned(1.5));
  const auto a = field_.at(field_.tip_at(7, 20)), b = large.at(large.tip_at(10.5, 30));
  EXPECT_NEAR(b.axial_force_uN, 2.25 * a.axial_force_uN, 1e-9);
  EXPECT_NEAR(b.lateral_force_uN, 2.25 * a.lateral_force_uN, 1e-9);
  EXPECT_NEAR(b.stiffness_uN_per_um, 1.5 * a.stiffness_uN_per_um, 1e-9);
  EXPECT_NEAR(b.energy_uN_um, 3.375 * a.energy_uN_um, 1e-8);
  EXPECT_NEAR(b.indentation_um, 30, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Cells, ForceField,
                         testing::Values(ReferenceCase{"mouse-oocyte", 1}, ReferenceCase{"mouse-oocyte", 2},
                                         ReferenceCase{"mouse-oocyte", 3}, ReferenceCase{"mouse-oocyte", 4},
                                         ReferenceCase{"mouse-embryo", 1}, ReferenceCase{"mouse-embryo", 2},
                                         ReferenceCase{"mouse-embryo", 3}, ReferenceCase{"mouse-embryo", 4}),
                         [](const auto& which) {
                           return std::string(which.param.cell).substr(6) + std::to_string(which.param.configuration);
                         });

TEST(SpecimenForce, RangeIsSaid) {
  const auto field = SpecimenForce::load("mouse-oocyte", 1, turned());
  EXPECT_TRUE(field.at(field.tip_at(19.9, 10)).in_range);
  EXPECT_FALSE(field.at(field.tip_at(20.1, 10)).in_range);
  EXPECT_FALSE(field.at(field.tip_at(0, 44.5)).in_range);
  EXPECT_EQ(field.at(field.tip_at(50, 10)).axial_force_uN, 0.0);
}

TEST(SpecimenForce, OpposedHolderMakesItASurfaceOfRevolution) {
  const auto field = SpecimenForce::load("mouse-oocyte", 1, turned());
  const auto plane = field.at(field.tip_at(12, 25));
  PlainVector3 tip = field.tip_at(0, 0);
  const double back_um = 52.5 - (std::sqrt(52.5 * 52.5 - 144) - 25);
  const auto out =
      field.at(Eigen::Vector3d(tip.eigen() - back_um * field.frame().axis.eigen() + Eigen::Vector3d(0, 0, 12)));
  EXPECT_NEAR(out.axial_force_uN, plane.axial_force_uN, 1e-9);
  EXPECT_NEAR(out.force_uN.z, -plane.lateral_force_uN, 1e-9);
  // The cell pushes a needle beside the middle outwards.
  EXPECT_GT(out.force_uN.z, 0.1);
}

TEST(StifferCell, TakesMoreForceForTheSameDepth) {
  const VirtualSpecimen usual(load_scenario("default"));
  VirtualSpecimen stiff(load_scenario("default,cell.stiffness_ratio=2"));
  VirtualSpecimen same(load_scenario("default"));
  for (const double depth_um : {4.0, 20.0, 40.0}) {
    const SpecimenState twice = stiff.advance(depth_um, 0.1 * depth_um);
    const SpecimenState once = same.advance(depth_um, 0.1 * depth_um);
    ASSERT_GT(once.contact_force_uN, 0.0);
    EXPECT_NEAR(twice.contact_force_uN, 2.0 * once.contact_force_uN, 1e-9);
    EXPECT_NEAR(twice.pressure_Pa, 2.0 * once.pressure_Pa, 1e-9);
    EXPECT_TRUE(twice.section.outer_um.isApprox(once.section.outer_um));
    const auto tip = usual.force().tip_at(0.0, depth_um);
    EXPECT_NEAR(stiff.force().at(tip).energy_uN_um, 2.0 * usual.force().at(tip).energy_uN_um, 1e-9);
    EXPECT_NEAR(stiff.force().at(tip).stiffness_uN_per_um, 2.0 * usual.force().at(tip).stiffness_uN_per_um, 1e-9);
  }
}

}  // namespace
}  // namespace pellucida
