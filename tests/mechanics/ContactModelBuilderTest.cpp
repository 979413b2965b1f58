#include "pellucida/mechanics/ContactModelBuilder.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

Observation seen(CellState state) {
  Observation o;
  o.frame_index = 7;
  o.state = state;
  o.confidence = 0.9;
  o.outer.emplace();
  o.center_um = {200.0, 150.0};
  o.rest_outer_radius_um = 52.5;
  o.needle = NeedlePose{{230.0, 150.0}, {-1.0, 0.0}, 5.0, 1.0, {}};
  return o;
}

ForceEstimate measured() {
  ForceEstimate e;
  e.contact_force_uN = 2.0;
  e.contact_force_lower_uN = 1.902;
  e.contact_force_upper_uN = 2.098;
  e.tip_force_uN = {-2.0, 0.5, 0.0};
  e.stiffness_uN_per_um = 0.2;
  e.damping_uN_s_per_um = 0.01;
  e.depth_um = 22.5;
  return e;
}

TEST(ContactModelBuilder, TheHandFeelsTheReactionOfTheCell) {
  const ContactModel m = contact_model(seen(CellState::kContact), measured(), 3.5);
  ASSERT_TRUE(m.valid);
  EXPECT_DOUBLE_EQ(m.time_s, 3.5);
  EXPECT_EQ(m.frame_index, 7);
  EXPECT_DOUBLE_EQ(m.force_uN.x, 2.0);
  EXPECT_DOUBLE_EQ(m.force_uN.y, -0.5);
  EXPECT_LT(m.force_uN.eigen().dot(m.push.eigen()), 0.0);
  EXPECT_NEAR(m.force_sigma_uN, 0.05, 1e-12);
  EXPECT_DOUBLE_EQ(m.stiffness_uN_per_um, 0.2);
  EXPECT_DOUBLE_EQ(m.damping_uN_s_per_um, 0.01);
  EXPECT_DOUBLE_EQ(m.depth_um, 22.5);
  EXPECT_DOUBLE_EQ(m.outer_radius_um, 52.5);
  EXPECT_FALSE(m.holder_seen);
}

TEST(ContactModelBuilder, NothingPushesBackWhenFree) {
  ForceEstimate e = measured();
  e.contact_force_uN = 0.0;
  e.tip_force_uN.setZero();
  const ContactModel m = contact_model(seen(CellState::kFree), e, 0.0);
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(m.force_uN.eigen().norm(), 0.0);
  EXPECT_EQ(m.stiffness_uN_per_um, 0.0);
}

TEST(ContactModelBuilder, APunctureTheForceShowedFirstCounts) {
  ForceEstimate e = measured();
  e.punctured = true;
  const ContactModel m = contact_model(seen(CellState::kContact), e, 0.0);
  EXPECT_EQ(m.state, CellState::kPunctured);
  EXPECT_EQ(m.force_uN.eigen().norm(), 0.0);
}

TEST(ContactModelBuilder, WithoutAForceOrANeedleItIsNotValid) {
  ForceEstimate e = measured();
  e.contact_force_uN = ForceEstimate::kNotMeasured;
  EXPECT_FALSE(contact_model(seen(CellState::kContact), e, 0.0).valid);

  Observation blind = seen(CellState::kContact);
  blind.needle.reset();
  const ContactModel m = contact_model(blind, measured(), 0.0);
  EXPECT_FALSE(m.valid);
  EXPECT_TRUE(m.cell_seen);
}

TEST(ContactModelBuilder, NumbersThatWereNotHadAreZeroNotNaN) {
  ForceEstimate e = measured();
  e.stiffness_uN_per_um = e.damping_uN_s_per_um = e.depth_um = ForceEstimate::kNotMeasured;
  e.contact_force_lower_uN = ForceEstimate::kNotMeasured;
  const ContactModel m = contact_model(seen(CellState::kContact), e, 0.0);
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(m.stiffness_uN_per_um, 0.0);
  EXPECT_EQ(m.damping_uN_s_per_um, 0.0);
  EXPECT_EQ(m.force_sigma_uN, 0.0);
  EXPECT_EQ(m.depth_um, 0.0);
}

}  // namespace
}  // namespace pellucida
