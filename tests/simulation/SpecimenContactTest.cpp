#include "pellucida/simulation/SpecimenContact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "pellucida/simulation/VirtualSpecimen.h"
#include "simulation/TestScenes.h"

namespace pellucida {
namespace {

using test::scenario_of;

const char* const kPuncturing = R"({"puncture": {"enabled": true}})";

// Moves a tip along straight legs at 1 kHz.
class Hand {
 public:
  explicit Hand(SpecimenContact contact) : contact_(std::move(contact)) { go(0, -15, 0.001); }

  // To an offset and a depth at a steady speed; `visit` sees each moment.
  template <class Visit>
  void go(double offset_um, double depth_um, double duration_s, Visit visit) {
    const int count = std::max(1, static_cast<int>(std::lround(1000 * duration_s)));
    const double from_offset = offset_um_, from_depth = depth_um_;
    for (int k = 1; k <= count; ++k) {
      const double part = static_cast<double>(k) / count;
      offset_um_ = from_offset + part * (offset_um - from_offset);
      depth_um_ = from_depth + part * (depth_um - from_depth);
      visit(step(0.0));
    }
  }
  void go(double offset_um, double depth_um, double duration_s) {
    go(offset_um, depth_um, duration_s, [](const SpecimenMoment&) {});
  }
  const SpecimenMoment& step(double expel_pL) {
    expelled_pL_ += expel_pL;
    return contact_.advance(contact_.force().tip_at(offset_um_, depth_um_), time_s_ += 1e-3, expelled_pL_);
  }
  const SpecimenMoment& moment() const { return contact_.moment(); }
  SpecimenContact contact_;

 private:
  double offset_um_ = 0, depth_um_ = -15, time_s_ = 0, expelled_pL_ = 0;
};

TEST(SpecimenContact, TouchTwiceAtTwoPlaces) {
  Hand hand(VirtualSpecimen(scenario_of(kPuncturing)).contact());
  EXPECT_EQ(hand.moment().state, CellState::kFree);
  hand.go(3, -2, 0.5);
  EXPECT_EQ(hand.moment().state, CellState::kFree);
  hand.go(3, 12, 0.6);
  EXPECT_EQ(hand.moment().state, CellState::kContact);
  EXPECT_GT(hand.moment().reply.axial_force_uN, 0.9);
  EXPECT_NEAR(hand.moment().reply.indentation_um, 12, 1e-9);
  hand.go(-9, -4, 0.6);
  EXPECT_EQ(hand.moment().state, CellState::kFree);
  EXPECT_EQ(hand.moment().reply.axial_force_uN, 0.0);
  hand.go(-9, 20, 0.6);
  EXPECT_EQ(hand.moment().state, CellState::kContact);
  // Pushed outwards, away from the middle: the needle pushes the cell towards it.
  EXPECT_GT(hand.moment().reply.lateral_force_uN, 0.1);
  EXPECT_EQ(hand.moment().puncture_count, 0);
}

TEST(SpecimenContact, WhatIsPutInByPushingComesBackByRetracting) {
  Hand hand(VirtualSpecimen(scenario_of("{}")).contact());
  double work = 0;
  Eigen::Vector3d before = hand.moment().tip_um.eigen(), force_before = Eigen::Vector3d::Zero();
  auto add = [&](const SpecimenMoment& now) {
    const Eigen::Vector3d tip = now.tip_um.eigen(), force = now.reply.force_uN.eigen();
    work -= 0.5 * (force + force_before).dot(tip - before);
    before = tip;
    force_before = force;
  };
  hand.go(4, 30, 1.0, add);
  EXPECT_NEAR(work, hand.moment().reply.energy_uN_um, 1e-4);
  EXPECT_GT(work, 30);
  hand.go(-13, 22, 1.0, add);
  hand.go(-13, -1, 1.0, add);
  EXPECT_NEAR(work, 0, 8e-5);
}

TEST(SpecimenContact, PunctureDepositAndRemoval) {
  Hand hand(VirtualSpecimen(scenario_of(kPuncturing)).contact());
  EXPECT_NEAR(hand.contact_.puncture_force_uN(), 7.5, 1e-9);
  double peak = 0;
  hand.go(0, 43.5, 2.0, [&](const SpecimenMoment& now) { peak = std::max(peak, now.reply.axial_force_uN); });
  EXPECT_EQ(hand.moment().state, CellState::kContact);
  hand.go(0, 50, 0.3, [&](const SpecimenMoment& now) { peak = std::max(peak, now.reply.axial_force_uN); });
  EXPECT_EQ(hand.moment().state, CellState::kPunctured);
  EXPECT_NEAR(peak, 7.5, 1e-3);
  EXPECT_NEAR(hand.moment().puncture_force_uN, 7.5, 1e-9);
  EXPECT_NEAR(hand.moment().puncture_depth_um, 44, 1e-9);
  EXPECT_EQ(hand.moment().reply.force_uN.eigen().norm(), 0.0);

  // The membrane closes round the shaft while the tip goes on.
  hand.go(0, 55, 0.5);
  EXPECT_NEAR(hand.moment().reply.indentation_um, 2.0, 2e-4);
  EXPECT_NEAR(hand.moment().reply.depth_um, 55, 1e-9);

  // Five picolitres where the tip is, then two more elsewhere.
  for (int k = 0; k < 500; ++k) hand.step(0.01);
  EXPECT_EQ(hand.moment().droplet_count, 1);
  EXPECT_NEAR(hand.moment().droplets[0].volume_pL, 5, 1e-9);
  EXPECT_NEAR(hand.moment().droplets[0].radius_um(), std::cbrt(3 * 5000 / (4 * std::numbers::pi)), 1e-9);
  EXPECT_LE((hand.moment().droplets[0].center_um.eigen() - hand.moment().tip_um.eigen()).norm(), 1e-12);
  hand.go(0, 35, 0.5);
  for (int k = 0; k < 200; ++k) hand.step(0.01);
  EXPECT_EQ(hand.moment().droplet_count, 2);
  EXPECT_NEAR(hand.moment().deposited_pL, 7, 1e-9);

  // Out: free and whole, the droplets stay; what is expelled now is lost.
  hand.go(0, -5, 1.0);
  EXPECT_EQ(hand.moment().state, CellState::kFree);
  hand.step(3);
  EXPECT_NEAR(hand.moment().deposited_pL, 7, 1e-9);
  EXPECT_NEAR(hand.moment().lost_pL, 3, 1e-9);
  hand.go(0, 10, 0.3);
  EXPECT_EQ(hand.moment().state, CellState::kContact);
  EXPECT_EQ(hand.moment().puncture_count, 1);

  hand.contact_.reset();
  hand.step(0);
  EXPECT_EQ(hand.moment().droplet_count, 0);
  EXPECT_EQ(hand.moment().puncture_count, 0);
}

TEST(SpecimenContact, WithoutPuncturesTheForceGoesOn) {
  Hand hand(VirtualSpecimen(scenario_of("{}")).contact());
  hand.go(0, 50, 2.0);
  EXPECT_EQ(hand.moment().state, CellState::kContact);
  EXPECT_GT(hand.moment().reply.axial_force_uN, 9.0);
  EXPECT_FALSE(hand.moment().reply.in_range);
  EXPECT_NEAR(hand.moment().reply.indentation_um, 44, 1e-9);
}

TEST(SpecimenContact, CellsBearDifferentForcesWhereAskedAndTheSeedSaysWhich) {
  const auto bears = [](int seed, double spread) {
    Scenario scenario = scenario_of(kPuncturing);
    scenario.seed = static_cast<std::uint64_t>(seed);
    scenario.puncture.spread_ratio = spread;
    return VirtualSpecimen(scenario).contact().puncture_force_uN();
  };
  std::set<double> forces;
  for (int seed = 0; seed < 20; ++seed) {
    EXPECT_NEAR(bears(seed, 0.0), 7.5, 1e-9);
    const double force = bears(seed, 0.2);
    EXPECT_EQ(force, bears(seed, 0.2));
    EXPECT_GE(force, 6.0);
    EXPECT_LE(force, 7.5);
    forces.insert(force);
  }
  EXPECT_EQ(forces.size(), 20u);

  // A weaker cell gives way at its own force.
  Scenario scenario = scenario_of(R"({"puncture": {"enabled": true, "spread_ratio": 0.4}, "seed": 3})");
  Hand hand(VirtualSpecimen(scenario).contact());
  hand.go(0, 44, 2.0);
  EXPECT_EQ(hand.moment().state, CellState::kPunctured);
  EXPECT_NEAR(hand.moment().puncture_force_uN, hand.contact_.puncture_force_uN(), 1e-9);
  EXPECT_NEAR(hand.contact_.force().at(hand.contact_.force().tip_at(0, hand.moment().puncture_depth_um)).axial_force_uN,
              hand.contact_.puncture_force_uN(), 2e-6);
}

}  // namespace
}  // namespace pellucida
