#include "presenters/PlanEdit.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

// A cell of 50 um at (100, 100) um, the needle from the right.
InjectionPlan plan() {
  CellGeometry cell;
  cell.center_um = {100.0, 100.0, 0.0};
  cell.outer_radius_um = 50.0;
  cell.inner_radius_um = 42.0;
  cell.needle_direction = {-1.0, 0.0, 0.0};
  return plan_injection(cell).value();
}

TEST(PlanEdit, AHandleIsTakenWithinReach) {
  const PlanMarks marks = plan_marks(plan(), 60.0, true);
  EXPECT_EQ(handle_at(marks, {100.0, 103.0}, 5.0), PlanHandle::kTarget);
  EXPECT_EQ(handle_at(marks, {151.0, 100.0}, 5.0), PlanHandle::kEntry);
  EXPECT_EQ(handle_at(marks, {90.0, 98.0}, 5.0), PlanHandle::kDepthStop);
  EXPECT_EQ(handle_at(marks, {94.0, 100.0}, 9.0), PlanHandle::kDepthStop) << "the nearer of two";
  EXPECT_EQ(handle_at(marks, {100.0, 110.0}, 5.0), PlanHandle::kNone);
}

TEST(PlanEdit, DragsKeepThePlanPossible) {
  const InjectionPlan before = plan();
  const PlanChoice from = choice_of(before, 60.0);
  const PlanChoice target = drag_handle(before, from, PlanHandle::kTarget, {105.0, 92.0});
  EXPECT_EQ(target.target_um, Eigen::Vector2d(105.0, 92.0));
  EXPECT_EQ(target.depth_stop_um, 60.0);
  // Along the line the entry can't go: it is where the line meets the membrane.
  const PlanChoice entry = drag_handle(before, from, PlanHandle::kEntry, {170.0, 108.0});
  EXPECT_LT((entry.target_um - Eigen::Vector2d(100.0, 108.0)).norm(), 1e-9);
  const PlanChoice stop = drag_handle(before, from, PlanHandle::kDepthStop, {80.0, 130.0});
  EXPECT_NEAR(stop.depth_stop_um, 70.0, 1e-9);
  EXPECT_EQ(stop.target_um, from.target_um);
  EXPECT_EQ(drag_handle(before, from, PlanHandle::kDepthStop, {200.0, 100.0}).depth_stop_um, 1.0);
  EXPECT_EQ(drag_handle(before, from, PlanHandle::kNone, {0.0, 0.0}), from);
}

TEST(PlanEdit, WordsSayDepthOrReason) {
  const InjectionPlan before = plan();
  const PlanChoice from = choice_of(before, 61.4);
  EXPECT_EQ(handle_words(before, from, PlanHandle::kDepthStop), "Depth stop 61 µm beyond the entry");
  EXPECT_EQ(handle_words(before, from, PlanHandle::kTarget), "Target 50 µm beyond the entry");
  const PlanChoice outside = drag_handle(before, from, PlanHandle::kTarget, {100.0, 160.0});
  EXPECT_FALSE(plan_with(before, outside));
  EXPECT_NE(handle_words(before, outside, PlanHandle::kTarget).find("outside"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
