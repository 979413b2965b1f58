#include "pellucida/planning/InjectionPlan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/haptics/DeviceCatalog.h"

namespace pellucida {
namespace {

using Vector = Eigen::Vector3d;

// Needle from the left, holder on the right.
CellGeometry oocyte() {
  CellGeometry cell;
  cell.center_um = PlainVector3(300.0, 200.0, 0.0);
  cell.outer_radius_um = 42.0;
  cell.inner_radius_um = 36.0;
  cell.needle_direction = PlainVector3(1.0, 0.0, 0.0);
  cell.holder_known = true;
  cell.holder_mouth_um = PlainVector3(342.0, 200.0, 0.0);
  cell.holder_direction = PlainVector3(1.0, 0.0, 0.0);
  return cell;
}

TEST(InjectionPlan, ToTheCentreByDefault) {
  const auto plan = plan_injection(oocyte());
  ASSERT_TRUE(plan) << to_string(plan.error());
  EXPECT_NEAR(plan->depth_um, 42.0, 1e-9);
  EXPECT_LT((plan->entry_um.eigen() - Vector(258.0, 200.0, 0.0)).norm(), 1e-9);
  EXPECT_LT((plan->approach_um.eigen() - Vector(228.0, 200.0, 0.0)).norm(), 1e-9);
}

TEST(InjectionPlan, ForAnyTargetInsideTheEntryIsOnTheMembraneTowardsTheNeedle) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> radius(0.0, 25.0);
  for (int k = 0; k < 500; ++k) {
    CellGeometry cell = oocyte();
    cell.holder_known = false;
    const Vector direction = Vector(normal(random), normal(random), normal(random)).normalized();
    cell.needle_direction = direction;
    const Vector offset = Vector(normal(random), normal(random), normal(random)).normalized() * radius(random);
    const auto plan = plan_injection(cell, PlainVector3(cell.center_um.eigen() + offset));
    ASSERT_TRUE(plan) << to_string(plan.error());
    EXPECT_NEAR((plan->entry_um.eigen() - cell.center_um.eigen()).norm(), 42.0, 1e-9);
    EXPECT_NEAR((plan->entry_um.eigen() + plan->depth_um * direction - plan->target_um.eigen()).norm(), 0.0, 1e-9);
    EXPECT_GT(plan->depth_um, 0.0);
    EXPECT_GT((plan->approach_um.eigen() - cell.center_um.eigen()).norm(), 42.0);
  }
}

TEST(InjectionPlan, FaultsAreDistinguished) {
  const auto fault = [](const CellGeometry& cell, std::optional<PlainVector3> target = {}, PlanOptions options = {}) {
    const auto plan = plan_injection(cell, target, options);
    EXPECT_FALSE(plan);
    EXPECT_GT(to_string(plan.error()).size(), 20U);
    return plan.error();
  };
  CellGeometry cell = oocyte();
  cell.outer_radius_um = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault(cell), PlanFault::kNotFinite);
  cell = oocyte();
  cell.needle_direction = PlainVector3();
  EXPECT_EQ(fault(cell), PlanFault::kNoDirection);
  EXPECT_EQ(fault(oocyte(), PlainVector3(300.0, 238.0, 0.0)), PlanFault::kTargetOutside) << "in the zona";
  PlanOptions far;
  far.overshoot_um = 50.0;
  EXPECT_EQ(fault(oocyte(), {}, far), PlanFault::kOvershootTooFar);
  cell = oocyte();
  cell.needle_direction = PlainVector3(-1.0, 0.0, 0.0);
  EXPECT_EQ(fault(cell), PlanFault::kThroughHolder);
  PlanOptions slow;
  slow.insertion_speed_um_per_s = 0.0;
  EXPECT_EQ(fault(oocyte(), {}, slow), PlanFault::kNotFinite);
}

TEST(InjectionPlan, FromAFrame) {
  ContactModel model;
  EXPECT_FALSE(geometry_of(model));
  model.cell_seen = true;
  model.outer_radius_um = 42.0;
  model.push = PlainVector3(0.0, 1.0, 0.0);
  const auto cell = geometry_of(model);
  ASSERT_TRUE(cell);
  EXPECT_EQ(cell->needle_direction, model.push);
  EXPECT_FALSE(cell->holder_known);
}

TEST(InjectionPlan, ItsFixturesLeaveThePathFreeAndTheDeviceHoldsThem) {
  for (const DeviceSpecification& device : shipped_devices()) {
    const auto plan = plan_injection(oocyte(), PlainVector3(305.0, 190.0, 3.0));
    ASSERT_TRUE(plan);
    const HapticSettings settings = with_plan(default_settings(device, 2000.0), *plan);
    EXPECT_FALSE(fault_of(settings, device, 2000.0)) << device.name;
    // Along the path nothing is felt, from the approach to the target and back; beyond the overshoot the stop is.
    for (double way_um = -plan->options.approach_distance_um; way_um <= plan->depth_um; way_um += 0.5) {
      const Vector tip = plan->entry_um.eigen() + way_um * plan->axis.eigen();
      EXPECT_EQ(apply(settings.fixtures, tip, Vector::Zero(), 2000.0, 1.0).acting, 0U) << way_um;
    }
    const Vector deep = plan->target_um.eigen() + 15.0 * plan->axis.eigen();
    EXPECT_TRUE(apply(settings.fixtures, deep, Vector::Zero(), 2000.0, 1.0).acting & kStopBit);
    EXPECT_EQ(settings.limits.max_contact_speed_um_per_s, plan->options.insertion_speed_um_per_s);
  }
}

TEST(InjectionPlan, SavedAndReadItIsTheSame) {
  PlanOptions options;
  options.approach_distance_um = 41.0;
  const auto plan = plan_injection(oocyte(), PlainVector3(305.0, 190.0, 3.0), options);
  ASSERT_TRUE(plan);
  const TemporaryFolder folder;
  write_plan(*plan, folder.path() / "plan.json");
  const InjectionPlan read = read_plan(folder.path() / "plan.json");
  EXPECT_EQ(to_json(read), to_json(*plan));
  EXPECT_THROW(write_plan(*plan, folder.path() / "missing" / "plan.json"), OutputError);
  EXPECT_THROW(read_plan(folder.path() / "none.json"), InputError);
}

TEST(InjectionPlan, ABadFileSaysWhere) {
  const auto text_of_error = [](const std::string& json) {
    try {
      plan_from_json(json, "plan.json");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(text_of_error("[").find("plan.json is no JSON"), std::string::npos);
  EXPECT_NE(text_of_error("{\"depth_um\": 1e999}").find("too large"), std::string::npos);
  EXPECT_NE(text_of_error("{}").find("\"schema\" is missing"), std::string::npos);
  std::string good = to_json(*plan_injection(oocyte()));
  EXPECT_EQ(text_of_error(good), "");
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return text_of_error(text);
  };
  EXPECT_NE(replaced("\"outer_radius_um\": 42.0", "\"outer_radius_um\": \"wide\"").find("cell: \"outer_radius_um\""),
            std::string::npos);
  EXPECT_NE(replaced("\"outer_radius_um\": 42.0", "\"outer_radius_um\": 30.0").find("out of range"), std::string::npos);
  EXPECT_NE(replaced("\"path_radius_um\"", "\"path_radus_um\"").find("path_radius_um"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
