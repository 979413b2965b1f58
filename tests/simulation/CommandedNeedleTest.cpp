#include "pellucida/simulation/CommandedNeedle.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "simulation/SectionChecks.h"
#include "simulation/TestScenes.h"

namespace pellucida {
namespace {

using test::scenario_of;

const char* const kInjection = R"({"puncture": {"enabled": true}, "debris": {"count": 0}, "seed": 11})";

using test::bytes_of;

// A free hand's way as corners: second, offset and depth, um, and what was expelled by then, pL.
struct Corner {
  double time_s, offset_um, depth_um, expelled_pL;
};
const std::vector<Corner> kFreeHand{{0, 0, -15, 0},    {0.4, 6, -1, 0},  {0.8, 5, 15, 0},  {1.0, 7, 14, 0},
                                    {1.3, 2, -4, 0},   {1.6, -8, 10, 0}, {1.9, -7, -3, 0}, {2.2, 1, 5, 0},
                                    {3.0, 1, 48, 0},   {3.4, 0, 55, 0},  {3.9, 0, 55, 4},  {4.4, 2, 20, 4},
                                    {4.8, 2, -10, 4.0}};

Corner at(double time_s) {
  for (std::size_t k = 1; k < kFreeHand.size(); ++k) {
    const Corner &a = kFreeHand[k - 1], &b = kFreeHand[k];
    if (time_s > b.time_s) continue;
    const double part = (time_s - a.time_s) / (b.time_s - a.time_s);
    return {time_s, a.offset_um + part * (b.offset_um - a.offset_um), a.depth_um + part * (b.depth_um - a.depth_um),
            a.expelled_pL + part * (b.expelled_pL - a.expelled_pL)};
  }
  return kFreeHand.back();
}

// 1 kHz between the frames; `visit` sees each frame and its truth.
template <class Visit>
void move_by_hand(const Scenario& scenario, Visit visit) {
  auto needle = std::make_shared<CommandedNeedle>(scenario);
  VirtualMicroscope microscope(scenario, needle);
  const double interval_s = 1 / scenario.image.frame_rate_hz;
  double frame_s = 0;
  for (int k = 0; k <= 4800; ++k) {
    const Corner now = at(1e-3 * k);
    const auto& felt =
        needle->move(now.time_s, needle->force().tip_at(now.offset_um, now.depth_um), {}, now.expelled_pL);
    if (now.time_s + 1e-9 < frame_s) continue;
    frame_s += interval_s;
    const auto frame = microscope.next();
    ASSERT_TRUE(frame.has_value());
    visit(*frame, microscope.truth(), felt);
  }
}

TEST(CommandedNeedle, FreeHandTouchesTwicePuncturesDepositsAndLeaves) {
  std::vector<CellState> states;
  double peak = 0, deposited = 0;
  move_by_hand(scenario_of(kInjection), [&](const Frame&, const Truth& truth, const SpecimenMoment& felt) {
    const Observation& seen = truth.observation;
    if (states.empty() || states.back() != seen.state) states.push_back(seen.state);
    peak = std::max(peak, truth.contact_force_uN);
    deposited = truth.deposited_pL;
    // The picture's truth is what the hand felt.
    EXPECT_EQ(truth.contact_force_uN, felt.reply.axial_force_uN);
    EXPECT_EQ(truth.lateral_force_uN, felt.reply.lateral_force_uN);
    EXPECT_LE((truth.tip_um.eigen() - felt.tip_um.eigen()).norm(), 1e-9);
    EXPECT_TRUE(truth.in_range);

    // The membrane stays a whole line, and the tip sits on it while it is whole.
    const Contour_um& outer = seen.outer->points_um;
    EXPECT_EQ(test::crossing_count(outer), 0) << seen.time_s;
    const bool tip_is_inside = test::inside(outer, seen.needle->tip_um);
    if (seen.state == CellState::kContact) {
      EXPECT_LE(test::distance_to(outer, seen.needle->tip_um), 3e-4) << seen.time_s;
    }
    if (seen.state == CellState::kFree) {
      EXPECT_FALSE(tip_is_inside) << seen.time_s;
    }
    if (seen.time_s > 3.4 && seen.time_s < 3.9) {
      EXPECT_TRUE(tip_is_inside) << seen.time_s;
    }
  });
  const std::vector<CellState> expected{CellState::kFree,      CellState::kContact, CellState::kFree,
                                        CellState::kContact,   CellState::kFree,    CellState::kContact,
                                        CellState::kPunctured, CellState::kFree};
  EXPECT_EQ(states, expected);
  EXPECT_GT(peak, 6.5);
  EXPECT_LE(peak, 7.5 + 0.05);
  EXPECT_NEAR(deposited, 4.0, 1e-9);
}

TEST(CommandedNeedle, TheSameHandOnTheSameCellGivesTheSameBytes) {
  Scenario scenario = scenario_of(kInjection);
  scenario.image.frame_rate_hz = 3;
  const auto frames = [](const Scenario& of) {
    std::vector<std::vector<std::uint8_t>> all;
    move_by_hand(of, [&](const Frame& frame, const Truth&, const SpecimenMoment&) { all.push_back(bytes_of(frame)); });
    return all;
  };
  const auto first = frames(scenario);
  EXPECT_GE(first.size(), 14u);
  EXPECT_EQ(first, frames(scenario));
  scenario.seed = 12;
  EXPECT_NE(first, frames(scenario));
}

TEST(CommandedNeedle, DropletIsSeenWhereTheTipLeftIt) {
  const Scenario scenario =
      scenario_of(R"({"puncture": {"enabled": true}, "optics": {"noise": false}, "debris": {"count": 0}})");
  const auto last_frame = [&](double expelled_pL) {
    auto needle = std::make_shared<CommandedNeedle>(scenario);
    VirtualMicroscope microscope(scenario, needle);
    double time_s = 0;
    for (double depth = -5; depth < 60; depth += 0.05) needle->move(time_s += 1e-3, needle->force().tip_at(0, depth));
    needle->move(time_s += 1e-3, needle->force().tip_at(0, 60), {}, expelled_pL);
    for (double depth = 60; depth > -15; depth -= 0.05)
      needle->move(time_s += 1e-3, needle->force().tip_at(0, depth), {}, expelled_pL);
    const auto frame = microscope.next();
    return std::pair(bytes_of(*frame), microscope.truth());
  };
  const auto [plain, none] = last_frame(0);
  const auto [marked, truth] = last_frame(4);
  ASSERT_EQ(truth.droplets.size(), 1u);
  EXPECT_TRUE(none.droplets.empty());
  const double pixel_um = scenario.image.pixel_size_um, radius_um = truth.droplets[0].radius_um();
  double rim = 0, middle = 0;
  int rim_count = 0, middle_count = 0, elsewhere = 0;
  for (int y = 0; y < scenario.image.height_px; ++y)
    for (int x = 0; x < scenario.image.width_px; ++x) {
      const auto i = static_cast<std::size_t>(y * scenario.image.width_px + x);
      const double change = static_cast<double>(marked[i]) - plain[i];
      const double from_um =
          std::hypot(x * pixel_um - truth.droplets[0].center_um.x, y * pixel_um - truth.droplets[0].center_um.y) -
          radius_um;
      if (std::abs(from_um) < 0.5) rim += change, ++rim_count;
      if (from_um < -4) middle += change, ++middle_count;
      if (from_um > 9.1 && change != 0) ++elsewhere;
    }
  EXPECT_LT(rim / rim_count, -10);
  EXPECT_GT(middle / middle_count, 5);
  EXPECT_EQ(elsewhere, 0);
}

TEST(CommandedNeedle, WaitsBeforeTheCellAndIgnoresWhatIsNoPlace) {
  const Scenario scenario = scenario_of(kInjection);
  CommandedNeedle needle(scenario);
  EXPECT_EQ(needle.at(0).moment->state, CellState::kFree);
  EXPECT_NEAR(needle.at(0).moment->reply.depth_um, -scenario.motion.gap_um, 1e-9);
  const auto felt = needle.move(0.1, needle.force().tip_at(0, 20));
  EXPECT_GT(felt.reply.axial_force_uN, 2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(needle.move(0.2, {nan, 0, 0}).reply.axial_force_uN, felt.reply.axial_force_uN);
  EXPECT_EQ(needle.move(nan, needle.start_um()).reply.axial_force_uN, felt.reply.axial_force_uN);
  EXPECT_EQ(needle.at(0.2).moment->reply.axial_force_uN, felt.reply.axial_force_uN);
  // A new cell.
  needle.move(0.3, needle.force().tip_at(0, 50));
  EXPECT_EQ(needle.at(0.3).moment->state, CellState::kPunctured);
  needle.renew();
  EXPECT_EQ(needle.move(0.4, needle.force().tip_at(0, 20)).state, CellState::kContact);
}

TEST(CommandedNeedle, ScriptedNeedleAndCommandsAlongItGiveTheSamePicture) {
  Scenario scenario = scenario_of(R"({"image": {"frame_rate_hz": 3}})");
  VirtualMicroscope scripted(scenario);
  auto needle = std::make_shared<CommandedNeedle>(scenario);
  VirtualMicroscope commanded(scenario, needle);
  const VirtualSpecimen specimen(scenario);
  ScriptedNeedle script(scenario, specimen);
  int count = 0;
  while (const auto one = scripted.next()) {
    const auto told = script.at(one->time_s);
    needle->move(one->time_s, told.tip_um, told.velocity_um_per_s);
    const auto two = commanded.next();
    ASSERT_TRUE(two.has_value());
    EXPECT_NEAR(scripted.truth().contact_force_uN, commanded.truth().contact_force_uN, 1e-9);
    EXPECT_NEAR(scripted.truth().pressure_Pa, commanded.truth().pressure_Pa, 1e-6);
    const auto a = bytes_of(*one), b = bytes_of(*two);
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(int{a[i]} - int{b[i]}));
    EXPECT_LE(largest, 1);
    ++count;
  }
  EXPECT_GT(count, 10);
}

TEST(CommandedNeedle, LiveMicroscopeFollowsAHandInAnotherThread) {
  const Scenario scenario = scenario_of(
      R"({"image": {"width_px": 128, "height_px": 128, "frame_rate_hz": 50, "duration_s": 0.6},
          "cell": {"center_x_um": 50, "center_y_um": 50}})");
  auto needle = std::make_shared<CommandedNeedle>(scenario);
  VirtualMicroscope microscope(scenario, needle, Pace::kWallClock);
  EXPECT_TRUE(microscope.info().live);
  EXPECT_FALSE(microscope.restart());
  std::jthread hand([&](std::stop_token stop) {
    double depth = -12, time_s = 0;
    while (!stop.stop_requested()) {
      depth = std::min(depth + 0.1, 40.0);
      needle->move(time_s += 1e-3, needle->force().tip_at(0, depth));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  long before = -1, frames = 0, lost = 0;
  double depth = -100;
  while (const auto frame = microscope.next()) {
    EXPECT_EQ(frame->frame_index, before + 1 + frame->gap_count);
    EXPECT_NEAR(frame->time_s, static_cast<double>(frame->frame_index) / 50, 1e-12);
    EXPECT_GE(microscope.truth().tip_depth_um, depth);
    depth = microscope.truth().tip_depth_um;
    before = frame->frame_index;
    lost += frame->gap_count;
    ++frames;
  }
  // However busy the machine: every frame was given or counted, up to those lost after the last one given.
  EXPECT_GE(frames, 1);
  EXPECT_LE(frames + lost, 30);
}

}  // namespace
}  // namespace pellucida
