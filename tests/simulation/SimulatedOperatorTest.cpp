#include "pellucida/simulation/SimulatedOperator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/simulation/CommandedNeedle.h"
#include "pellucida/simulation/SimulatedHand.h"
#include "pellucida/simulation/VirtualSpecimen.h"

namespace pellucida {
namespace {

constexpr double kStep_s = SimulatedOperator::kStep_s;

OperatorPlan plan_along_x() {
  OperatorPlan plan;
  plan.approach_um = {100, 0, 0};
  plan.entry_um = {90, 0, 0};
  plan.target_um = {40, 0, 0};
  plan.removal_um = {150, 0, 0};
  return plan;
}

OperatorOptions exact() {
  OperatorOptions options;
  options.tremor_rms_m = 0;
  options.lateral_noise_um = options.flat_depth_noise_um = options.space_depth_noise_um = 0;
  options.motor_noise_ratio = 0;
  return options;
}

// A tip that follows the hand at once: position control without a manipulator. `force_N` of the tip's place.
struct Bench {
  SimulatedHand hand;
  PlainVector3 start_um;
  double scale_um_per_m;
  double time_s = 0;
  HandSample sample;
  PlainVector3 tip_um;

  Bench(const OperatorOptions& options, const OperatorPlan& plan, const PlainVector3& start, std::uint64_t seed = 1)
      : hand(options, plan, ArmOptions{}, seed), start_um(start), scale_um_per_m(plan.scale_um_per_m), tip_um(start) {
    hand.read(0, sample);
  }
  void tick(const PlainVector3& force_N = {}, bool closed = false) {
    // A picture each 33 ms.
    if (std::lround(time_s / kStep_s) % 33 == 0) hand.see({time_s, tip_um, true, closed});
    hand.write(force_N);
    time_s += kStep_s;
    ASSERT_TRUE(hand.read(time_s, sample));
    tip_um = Eigen::Vector3d(start_um.eigen() + scale_um_per_m * world_from_hand(sample.position_m).eigen());
  }
};

TEST(SimulatedOperator, AimedMoveHasABellShapedSpeed) {
  Bench bench(exact(), plan_along_x(), {300, 0, 0});
  std::vector<double> speed;
  while (bench.time_s < 1.6) {
    bench.tick();
    speed.push_back(bench.sample.velocity_m_per_s.eigen().norm());
  }
  // One peak, in the middle of the move; its height is 15/8 of the mean (Flash and Hogan).
  const auto peak = static_cast<std::size_t>(std::max_element(speed.begin(), speed.end()) - speed.begin());
  const double top = speed[peak];
  std::size_t first = peak, last = peak;
  while (first > 0 && speed[first] > 0.005 * top) --first;
  while (last + 1 < speed.size() && speed[last] > 0.005 * top) ++last;
  const double duration_s = static_cast<double>(last - first) * kStep_s;
  EXPECT_NEAR(static_cast<double>(peak - first) / static_cast<double>(last - first), 0.5, 0.01);
  EXPECT_NEAR(top * duration_s / 0.02, 1.875, 0.15);  // 200 um of the tip are 20 mm of the hand
  for (std::size_t k = first + 1; k < last; ++k) {
    EXPECT_GE((k <= peak ? 1.0 : -1.0) * (speed[k] - speed[k - 1]), -0.01 * top) << k;
  }
  EXPECT_NEAR(bench.tip_um.x, 100, 2e-4);
}

TEST(SimulatedOperator, NothingMovesBeforeTheReactionTime) {
  for (double delay_s : {0.15, 0.2, 0.4}) {
    OperatorOptions options = exact();
    options.visual_delay_s = delay_s;
    Bench bench(options, plan_along_x(), {300, 0, 0});
    double moved_s = -1;
    while (bench.time_s < 1.0 && moved_s < 0) {
      bench.tick();
      if (bench.sample.position_m.eigen().norm() > 1e-6) moved_s = bench.time_s;
    }
    EXPECT_GE(moved_s, delay_s);
    EXPECT_LE(moved_s, delay_s + 0.12);
  }
}

TEST(SimulatedOperator, CorrectionsReachAPointInSpiteOfNoise) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    OperatorOptions options;
    options.motor_noise_ratio = 0.15;
    Bench bench(options, plan_along_x(), {400, 80, -30}, seed);
    while (bench.time_s < 10 && bench.hand.simulated_operator().phase() < OperatorPhase::kInsert) bench.tick();
    EXPECT_EQ(bench.hand.simulated_operator().phase(), OperatorPhase::kInsert) << seed;
    EXPECT_GE(bench.hand.simulated_operator().submovement_count(), 2) << seed;
    EXPECT_LE((bench.tip_um.eigen() - Eigen::Vector3d(100, 0, 0)).norm(), 10) << seed;
  }
}

TEST(SimulatedOperator, DepthIsWorstWithAFlatImage) {
  const auto depth_rms_um = [](Modality modality) {
    double squares = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      OperatorOptions options;
      options.modality = modality;
      Bench bench(options, plan_along_x(), {300, 0, 25}, seed);
      while (bench.time_s < 10 && bench.hand.simulated_operator().phase() < OperatorPhase::kInsert) bench.tick();
      squares += bench.tip_um.z * bench.tip_um.z / 60;
    }
    return std::sqrt(squares);
  };
  const double flat = depth_rms_um(Modality::kFlatImage), space = depth_rms_um(Modality::kSpace);
  EXPECT_GT(flat, 1.5 * space);
  EXPECT_LT(flat, 15);
}

TEST(SimulatedOperator, TremorIsAtTenHertzAndAsStrongAsAsked) {
  for (double rms_m : {50e-6, 100e-6, 200e-6}) {
    OperatorOptions options = exact();
    options.tremor_rms_m = rms_m;
    Bench bench(options, plan_along_x(), {100, 0, 0}, 3);
    std::vector<Eigen::Vector3d> place;
    // Nobody is shown anything: only the tremor moves the hand.
    SimulatedHand& hand = bench.hand;
    for (int k = 1; k <= 32768; ++k) {
      hand.read(k * kStep_s, bench.sample);
      place.push_back(bench.sample.position_m.eigen());
    }
    double power = 0;
    for (const auto& at : place) power += at.squaredNorm();
    EXPECT_NEAR(std::sqrt(power / static_cast<double>(place.size())), rms_m, 0.15 * rms_m);

    // Periodogram, 0.5 Hz wide, of the x axis.
    double best = 0, best_Hz = 0, inside = 0, all = 0;
    for (double hertz = 1; hertz <= 40; hertz += 0.5) {
      double sum = 0;
      for (int block = 0; block < 16; ++block) {
        std::complex<double> fourier = 0;
        for (int k = 0; k < 2048; ++k)
          fourier += place[static_cast<std::size_t>(2048 * block + k)].x() *
                     std::polar(1.0, -2 * std::numbers::pi * hertz * k * kStep_s);
        sum += std::norm(fourier);
      }
      all += sum;
      if (hertz >= 8 && hertz <= 12) inside += sum;
      if (sum > best) best = sum, best_Hz = hertz;
    }
    EXPECT_GE(best_Hz, 8);
    EXPECT_LE(best_Hz, 12);
    EXPECT_GT(inside, 0.65 * all);
  }
}

TEST(SimulatedOperator, SameSeedSameHand) {
  const auto path = [](std::uint64_t seed) {
    Bench bench(OperatorOptions{}, plan_along_x(), {300, 40, 10}, seed);
    std::vector<double> places;
    while (bench.time_s < 3) {
      bench.tick({0.1, 0, 0});
      places.push_back(bench.sample.position_m.x);
      places.push_back(bench.sample.position_m.z);
    }
    return places;
  };
  const auto one = path(5);
  EXPECT_EQ(one, path(5));
  EXPECT_NE(one, path(6));
}

TEST(SimulatedOperator, FeltDropEndsThePushSoonerThanSeeingIt) {
  const auto overshoot_um = [](Modality modality) {
    OperatorOptions options = exact();
    options.modality = modality;
    OperatorPlan plan = plan_along_x();
    Bench bench(options, plan, {110, 0, 0});
    bool broken = false;
    double broken_s = -1, deepest_um = 0;
    while (bench.time_s < 20 && !bench.hand.simulated_operator().done()) {
      const double push_um = plan.entry_um.x - bench.tip_um.x;
      if (!broken && push_um >= 44) {
        broken = true;
        broken_s = bench.time_s;
      }
      deepest_um = std::max(deepest_um, push_um);
      // 0.3 N when the membrane breaks.
      bench.tick({broken || push_um < 0 ? 0.0 : 0.3 * push_um / 44, 0, 0}, broken);
    }
    EXPECT_TRUE(bench.hand.simulated_operator().done());
    EXPECT_TRUE(broken);
    EXPECT_GE(bench.hand.simulated_operator().noticed_puncture_s(),
              broken_s + (modality == Modality::kSpace ? 0.2 : 0.12));
    EXPECT_LE(bench.hand.simulated_operator().noticed_puncture_s(), broken_s + 0.3);
    EXPECT_NEAR(bench.tip_um.x, plan.removal_um.x, 1e-4);
    return deepest_um;
  };
  EXPECT_LT(overshoot_um(Modality::kSpaceAndHaptics), overshoot_um(Modality::kSpace));
}

// A force at the operator's skin, felt but not resisted: the model alone, no arm.
double intended_speed_um_per_s(double slowing_N, const PlainVector3& force_N) {
  OperatorOptions options = exact();
  options.modality = Modality::kSpaceAndHaptics;
  options.slowing_N = slowing_N;
  SimulatedOperator simulated(options, plan_along_x(), 1);
  const PlainVector3 start_um{120, 0, 0};
  double speed = 0;
  for (int k = 0; k < 8000 && simulated.phase() != OperatorPhase::kDone; ++k) {
    const bool pushes = simulated.phase() == OperatorPhase::kInsert;
    const OperatorIntent& intent = simulated.tick(pushes ? force_N : PlainVector3{});
    const Eigen::Vector3d tip_um = start_um.eigen() + 1e4 * world_from_hand(intent.position_m).eigen();
    if (k % 33 == 0) simulated.see({simulated.time_s(), PlainVector3(tip_um), true, false});
    if (tip_um.x() < 60) return speed;
    if (pushes && tip_um.x() < 80) speed = std::max(speed, -1e4 * intent.velocity_m_per_s.x);
  }
  return 0;
}

TEST(SimulatedOperator, SlowsAgainstAResistanceButNotForAGuidesPush) {
  const double free = intended_speed_um_per_s(0.4, {});
  EXPECT_NEAR(free, plan_along_x().insertion_speed_um_per_s, 4);
  EXPECT_NEAR(intended_speed_um_per_s(0.4, {0.4, 0, 0}), 0.5 * free, 1e-9);
  EXPECT_EQ(intended_speed_um_per_s(0.4, {0, 0.4, 0}), free);
  EXPECT_EQ(intended_speed_um_per_s(0, {0.4, 0, 0}), free);
}

// A picture that comes 0.15 s late: who knows of it aims once, who does not goes to and fro.
TEST(SimulatedOperator, KnowsTheLagOfWhatItIsShown) {
  const auto turns = [](double known_lag_s) {
    OperatorPlan plan = plan_along_x();
    plan.lag_s = known_lag_s;
    SimulatedOperator simulated(exact(), plan, 1);
    std::vector<double> x_um;
    int count = 0;
    for (int k = 0; k < 3000 && simulated.phase() != OperatorPhase::kInsert; ++k) {
      x_um.push_back(300 + 1e4 * simulated.tick({}).position_m.x);
      const auto late = static_cast<std::size_t>(std::max(0, k - 150));
      if (k % 33 == 0) simulated.see({simulated.time_s(), {x_um[late], 0, 0}, true, false});
      if (x_um.size() > 2 && (x_um[x_um.size() - 1] - x_um[x_um.size() - 2]) > 1e-6) ++count;
    }
    return count;  // milliseconds on the way back
  };
  EXPECT_EQ(turns(0.15), 0);
  EXPECT_GT(turns(0.0), 100);
}

TEST(SimulatedOperator, DepositsAtTheTargetAndPressesTheButtonOnlyThere) {
  OperatorPlan plan = plan_along_x();
  plan.inject_s = 0.7;
  Bench bench(OperatorOptions{}, plan, {150, 5, 3}, 9);
  int pressed = 0;
  bool broken = false;
  while (bench.time_s < 30 && !bench.hand.simulated_operator().done()) {
    broken = broken || bench.tip_um.x < 60;
    bench.tick({}, broken);
    if (!(bench.sample.buttons & kInject)) continue;
    ++pressed;
    EXPECT_LE((bench.tip_um.eigen() - plan.target_um.eigen()).norm(), 9);
  }
  EXPECT_TRUE(bench.hand.simulated_operator().done());
  EXPECT_NEAR(pressed * kStep_s, 0.7, 0.002);
}

TEST(SimulatedHand, InjectsTheVirtualCell) {
  // Position control, 10 um of the tip for 1 mm of the hand; the hand feels 0.02 N for each uN.
  const Scenario scenario = parse_scenario(R"({"puncture": {"enabled": true, "spread_ratio": 0.2}})", "test");
  int injected = 0, count = 0;
  for (const Modality modality : {Modality::kFlatImage, Modality::kSpace, Modality::kSpaceAndHaptics})
    for (std::uint64_t seed = 1; seed <= 8; ++seed, ++count) {
      CommandedNeedle needle(scenario);
      OperatorPlan plan;
      plan.approach_um = needle.force().tip_at(0, -15);
      plan.entry_um = needle.force().tip_at(0, 0);
      plan.target_um = needle.force().tip_at(0, 30);
      plan.removal_um = needle.force().tip_at(0, -60);
      OperatorOptions options;
      options.modality = modality;
      const PlainVector3 start_um = needle.force().tip_at(25, -80);
      SimulatedHand hand(options, plan, ArmOptions{}, seed);
      HandSample sample;
      hand.read(0, sample);
      for (int k = 1; k < 40000 && !hand.simulated_operator().done(); ++k) {
        const double time_s = k * kStep_s;
        hand.read(time_s, sample);
        const Eigen::Vector3d tip_um =
            start_um.eigen() + plan.scale_um_per_m * world_from_hand(sample.position_m).eigen();
        const SpecimenMoment& felt =
            needle.move(time_s, tip_um, {}, needle.at(time_s).expelled_pL + (sample.buttons & kInject ? 5e-3 : 0.0));
        const bool feels = modality == Modality::kSpaceAndHaptics;
        hand.write(feels ? hand_from_world(Eigen::Vector3d(0.02 * felt.reply.force_uN.eigen())) : PlainVector3{});
        if (k % 33 == 0) hand.see({time_s, tip_um, true, felt.state == CellState::kPunctured});
      }
      EXPECT_TRUE(hand.simulated_operator().done()) << seed;
      const SpecimenMoment after = *needle.at(0).moment;
      EXPECT_EQ(after.state, CellState::kFree) << seed;
      if (after.deposited_pL > 4.9 && after.puncture_count == 1) ++injected;
    }
  EXPECT_GE(injected, count - 2);
}

TEST(SimulatedHand, HoldsAStiffWallStill) {
  // The approach point lies 10 mm of the hand behind a wall of 2000 N/m, without any damping of its own.
  OperatorOptions options = exact();
  OperatorPlan plan = plan_along_x();
  plan.approach_um = {-100, 0, 0};
  SimulatedHand hand(options, plan, ArmOptions{}, 1);
  HandSample sample;
  hand.read(0, sample);
  double largest_N = 0, late_speed = 0;
  for (int k = 1; k <= 4000; ++k) {
    const double time_s = k * kStep_s;
    const PlainVector3 tip_um(1e4 * sample.position_m.x, 0, 0);
    if (k % 33 == 1 && k < 200) hand.see({time_s, tip_um, true, false});
    const double force_N = sample.position_m.x < 0 ? -2000 * sample.position_m.x : 0.0;
    ASSERT_TRUE(hand.write({force_N, 0, 0}));
    ASSERT_TRUE(hand.read(time_s, sample));
    largest_N = std::max(largest_N, force_N);
    if (k > 3000) late_speed = std::max(late_speed, sample.velocity_m_per_s.eigen().norm());
  }
  EXPECT_GT(largest_N, 1.0);
  EXPECT_LT(largest_N, 8.0);
  EXPECT_LT(late_speed, 1e-9);
  // At rest the arm's spring and the wall balance.
  EXPECT_LT(std::abs(sample.position_m.x), 0.0026);
}

TEST(SimulatedHand, ArmYieldsAsItsStiffnessSays) {
  SimulatedHand hand(exact(), plan_along_x(), ArmOptions{}, 1);
  HandSample sample;
  for (int k = 0; k <= 2000; ++k) {
    hand.write({0, 1.5, 0});
    hand.read(k * kStep_s, sample);
  }
  EXPECT_NEAR(sample.position_m.y, 1.5 / 300, 1e-9);
  EXPECT_EQ(sample.buttons, 0u);
}

TEST(SimulatedHand, LimitsAndBadNumbers) {
  SimulatedHand hand(exact(), plan_along_x(), ArmOptions{}, 1);
  HandSample sample;
  hand.read(0, sample);
  EXPECT_FALSE(hand.write({std::nan(""), 0, 0}));
  EXPECT_TRUE(hand.write({1000, 0, 0}));
  for (int k = 0; k <= 3000; ++k) hand.read(k * kStep_s, sample);
  EXPECT_NEAR(sample.position_m.x, hand.specification().max_force_N / 300, 1e-9);
  // A long pause is left out, not replayed.
  const double before_s = hand.simulated_operator().time_s();
  hand.read(1000, sample);
  EXPECT_LE(hand.simulated_operator().time_s(), before_s + 0.01);

  OperatorOptions options;
  options.tremor_Hz = 30;
  EXPECT_THROW(SimulatedOperator(options, plan_along_x(), 1), UsageError);
  ArmOptions arm;
  arm.mass_kg = 0;
  EXPECT_THROW(SimulatedHand(exact(), plan_along_x(), arm, 1), UsageError);
}

}  // namespace
}  // namespace pellucida
