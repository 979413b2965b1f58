// The needle's parts on pictures drawn here: a cone with a round tip or one cut off straight, as two dark lines or as a
// dark wedge, of known place, direction and blur.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "GrayImage.h"
#include "HolderFinder.h"
#include "NeedleTracker.h"
#include "SceneVerdict.h"
#include "ToolFinder.h"
#include "tracking/NeedleDrawing.h"

namespace pellucida {
namespace {

using Drawing = test::NeedleDrawing;
using Picture = test::NeedlePicture;
using test::tool_of;

struct NeedleError {
  double along = 0.0, across = 0.0;
};
NeedleError error_of(const NeedleTracker& needle, const Drawing& d) {
  const Eigen::Vector2d off = needle.estimate().tip - d.tip, u = d.direction();
  return {off.dot(u), off.dot(Eigen::Vector2d(-u.y(), u.x()))};
}

class AnyNeedle : public testing::TestWithParam<Drawing> {};

TEST_P(AnyNeedle, TipAndAxisAreFoundToAFractionOfAPixel) {
  const Drawing d = GetParam();
  const Picture picture = draw(d);
  const FrameSampler image(picture.view());
  NeedleTracker needle;
  ASSERT_TRUE(needle.start(image, tool_of(d), noise_level(image)));
  const NeedleError error = error_of(needle, d);
  EXPECT_NEAR(error.along, 0.0, 0.35 * std::max(1.0, d.blur));
  EXPECT_NEAR(error.across, 0.0, 0.08 * std::max(1.0, d.blur));
  EXPECT_GT(needle.estimate().direction.dot(d.direction()), std::cos(0.002));
}

Drawing with(double angle_rad, double blur, bool wedge, double noise) {
  Drawing d;
  d.angle_rad = angle_rad;
  d.blur = blur;
  d.wedge = wedge;
  d.noise = noise;
  return d;
}
INSTANTIATE_TEST_SUITE_P(Looks, AnyNeedle,
                         testing::Values(with(0.0, 1.0, false, 0.01), with(0.7, 1.0, false, 0.01),
                                         with(1.6, 1.0, false, 0.01), with(2.9, 1.3, false, 0.01),
                                         with(4.0, 1.0, false, 0.01), with(5.2, 0.8, false, 0.01),
                                         with(0.3, 1.0, false, 0.04), with(0.3, 2.5, false, 0.01),
                                         with(0.2, 1.0, true, 0.01), with(3.6, 1.5, true, 0.01)),
                         [](const testing::TestParamInfo<Drawing>& chosen) {
                           return "case" + std::to_string(chosen.index);
                         });

// A pipette is mostly cut off: as a half ball its end would lie a fifth of its half width further ahead.
TEST(NeedleTracker, AnEndCutOffStraightIsWhereItIsAndAsWideAsItIs) {
  for (const bool wedge : {false, true}) {
    Drawing d = with(0.4, 1.0, wedge, 0.01);
    d.straight = true;
    d.tip_radius = 9.0;
    const Picture picture = draw(d);
    const FrameSampler image(picture.view());
    NeedleTracker needle;
    ASSERT_TRUE(needle.start(image, tool_of(d), noise_level(image)));
    EXPECT_NEAR(error_of(needle, d).along, 0.0, 0.3) << wedge;
    EXPECT_NEAR(needle.estimate().tip_half_width, 9.0, 0.2) << wedge;
  }
}

// Two lines blurred into each other are read nearer together than they are; that is undone. Even lines are believed
// against a network, which reads such tips too wide.
TEST(NeedleTracker, ATipNarrowerThanItsLinesIsAsWideAsItIs) {
  TipWidthNetwork network;
  for (const double tip_radius_px : {0.45, 0.7, 1.0, 1.5, 2.5}) {
    Drawing d = with(0.4, 0.9, false, 0.01);
    d.tip_radius = tip_radius_px;
    const Picture picture = draw(d);
    const FrameSampler image(picture.view());
    NeedleTracker needle;
    ASSERT_TRUE(needle.start(image, tool_of(d), noise_level(image)));
    EXPECT_NEAR(needle.estimate().tip_radius / tip_radius_px, 1.0, 0.1) << tip_radius_px;
    const double by_lines_px = needle.estimate().tip_radius;
    needle.read_width(network, image);
    ASSERT_TRUE(needle.is_width_read());
    EXPECT_EQ(needle.estimate().tip_radius, by_lines_px) << tip_radius_px;
  }
}

TEST(NeedleLook, LinesAreEvenWhereBothTheirSidesAndBothSidesOfTheNeedleAreAlike) {
  // Of a line's value at a distance from the outline, as the needle's sides have it.
  const auto unevenness = [](const auto& left, const auto& right) {
    NeedleLook look;
    look.resize(0.25, 4.0, 5.0);
    for (double d = -4.0; d <= 5.0; d += 0.25) {
      look.add_sample(0, d, static_cast<float>(left(d)), 1.0F);
      look.add_sample(1, d, static_cast<float>(right(d)), 1.0F);
    }
    look.finish(0.0);
    return look.unevenness();
  };
  const auto line = [](double d) { return -0.4 * std::exp(-0.5 * d * d); };
  const auto weak = [&](double d) { return 0.5 * line(d); };
  const auto darker_inside = [&](double d) { return d < 0.0 ? std::min(line(d), -0.2) : line(d); };
  EXPECT_LT(unevenness(line, line), 0.02);
  EXPECT_NEAR(unevenness(line, weak), 1.0 / 3.0, 0.02);
  EXPECT_GT(unevenness(darker_inside, darker_inside), 0.15);
  NeedleLook wedge;
  wedge.set_line(false);
  EXPECT_EQ(wedge.unevenness(), 1.0);
}

// Follows a needle that goes forward by `step` px a frame, `clear` frames in the clear, then up to a membrane that it
// pushes before it.
std::vector<NeedleError> push(Drawing d, double step, int clear_frames, int contact_frames, NeedleTracker& needle,
                              int* within_sigma = nullptr) {
  std::vector<NeedleError> errors;
  Picture picture = draw(d);
  if (!needle.start(FrameSampler(picture.view()), tool_of(d), 0.01)) return errors;
  for (int k = 0; k < clear_frames + contact_frames; ++k) {
    const bool clear = k < clear_frames;
    d.tip += step * d.direction();
    d.membrane_ahead = clear ? -1.0 : 0.0;
    d.seed = static_cast<unsigned>(10 + k);
    picture = draw(d);
    const FrameSampler image(picture.view());
    NeedleCue cue;
    cue.in_the_clear = clear;
    if (!needle.track(image, noise_level(image), cue)) return {};
    errors.push_back(error_of(needle, d));
    if (within_sigma && std::abs(errors.back().along) <= needle.estimate().tip_sigma) ++*within_sigma;
  }
  return errors;
}

TEST(NeedleTracker, FollowsIntoAMembraneThatHidesItsEnd) {
  NeedleTracker needle;
  int within_sigma = 0;
  const std::vector<NeedleError> errors = push({}, 1.3, 12, 12, needle, &within_sigma);
  ASSERT_EQ(errors.size(), 24U);
  for (const NeedleError& error : errors) {
    EXPECT_NEAR(error.along, 0.0, 0.44);
    EXPECT_NEAR(error.across, 0.0, 0.032);
  }
  EXPECT_TRUE(needle.estimate().evidence & kKnownCone);
  EXPECT_GE(within_sigma, 12);
}

// Frame `k` of a needle that touches something from the seventh on: followed, to a pixel.
constexpr int kClearFrames = 6;
void follow(NeedleTracker& needle, const Drawing& d, int k) {
  const Picture picture = draw(d);
  const FrameSampler image(picture.view());
  ASSERT_TRUE(k > 0 || needle.start(image, tool_of(d), noise_level(image)));
  NeedleCue cue;
  cue.in_the_clear = k < kClearFrames;
  ASSERT_TRUE(needle.track(image, noise_level(image), cue));
  EXPECT_NEAR(error_of(needle, d).along, 0.0, 1.0) << "frame " << k;
}

// What comes into view behind the part that was seen in the clear says nothing about where the tip is.
TEST(NeedleTracker, AShaftThatTapersNoFurtherDoesNotHoldTheTipBack) {
  Drawing d = with(0.0, 1.0, false, 0.01);
  d.tip.x() = 370.0;
  d.tapered_px = 50.0;
  NeedleTracker needle;
  for (int k = 0; k < 28; ++k, d.tip.x() -= 4.0) {
    d.membrane_ahead = k < kClearFrames ? -1.0 : 0.5;
    follow(needle, d, k);
  }
}

// Blur makes its lines fainter and seem further apart: it is no nearer for that.
TEST(NeedleTracker, LiftedOutOfFocusItStaysWhereItIs) {
  Drawing d = with(0.3, 1.0, false, 0.005);
  d.slope = 0.015;
  NeedleTracker needle;
  for (int k = 0; k < 16; ++k) {
    if (k > kClearFrames) {
      d.blur *= 1.1;
      d.depth /= 1.1;
    }
    follow(needle, d, k);
  }
}

// A membrane that goes slowly under a needle that fades has not given way; under one that was faint all along it may
// have.
TEST(NeedleTracker, AFaintOneIsClearUntilItFades) {
  Drawing d = with(0.2, 1.0, false, 0.02);
  d.depth = 0.08;
  Picture picture = draw(d);
  const FrameSampler first(picture.view());
  NeedleTracker needle;
  ASSERT_TRUE(needle.start(first, tool_of(d), noise_level(first)));
  const auto follow = [&] {
    ++d.seed;
    picture = draw(d);
    const FrameSampler image(picture.view());
    return needle.track(image, noise_level(image), {.in_the_clear = true});
  };
  for (int frame = 0; frame < 10; ++frame) {
    ASSERT_TRUE(follow());
    EXPECT_LT(needle.estimate().confidence, 0.5);
    EXPECT_TRUE(needle.is_clear()) << frame;
  }
  d.depth = 0.04;
  follow();
  EXPECT_FALSE(needle.is_clear()) << needle.estimate().confidence;
}

TEST(NeedleTracker, AStopIsNotSmeared) {
  NeedleTracker needle;
  Drawing d;
  ASSERT_EQ(push(d, 3.0, 8, 0, needle).size(), 8U);
  d.tip += 24.0 * d.direction();
  d.seed = 99;
  const Picture picture = draw(d);
  const FrameSampler image(picture.view());
  ASSERT_TRUE(needle.track(image, noise_level(image), {34.0, true, {}}));
  EXPECT_NEAR(error_of(needle, d).along, 0.0, 0.15);
}

TEST(NeedleTracker, AJumpAsideIsFoundAgain) {
  NeedleTracker needle;
  Drawing d;
  ASSERT_EQ(push(d, 1.0, 6, 0, needle).size(), 6U);
  d.tip += 6.0 * d.direction() + Eigen::Vector2d(18.0, -24.0);
  const Picture picture = draw(d);
  const FrameSampler image(picture.view());
  ASSERT_TRUE(needle.track(image, noise_level(image), {34.0, true, {}}));
  EXPECT_NEAR(error_of(needle, d).along, 0.0, 0.21);
  EXPECT_NEAR(error_of(needle, d).across, 0.0, 0.013);
}

TEST(NeedleTracker, TheCommandedMotionSaysSoAndHelps) {
  NeedleTracker needle;
  Drawing d;
  ASSERT_EQ(push(d, 1.0, 6, 0, needle).size(), 6U);
  d.tip += 6.0 * d.direction() + 9.0 * d.direction();
  const Picture picture = draw(d);
  const FrameSampler image(picture.view());
  // A manipulator whose commands it has followed so far, and now leaps by.
  const NeedleEstimate before = needle.estimate();
  CommandedMotion command;
  for (int k = 10; k >= 0; --k) {
    command.begin(Eigen::Vector2d(1.0 * d.direction()));
    command.learn(before.tip - 1.0 * k * before.direction, before.direction, 0.1, k == 10);
  }
  command.begin(Eigen::Vector2d(9.0 * d.direction()));
  ASSERT_TRUE(needle.track(image, noise_level(image), {34.0, true, &command}));
  EXPECT_NEAR(error_of(needle, d).along, 0.0, 0.2);
  EXPECT_TRUE(needle.estimate().evidence & kCommandedMotion);
}

TEST(NeedleTracker, HeldItIsWhereItWasSent) {
  NeedleTracker needle;
  ASSERT_FALSE(push({}, 1.0, 6, 0, needle).empty());
  const NeedleEstimate before = needle.estimate();
  needle.hold({.ahead_px = 4.0, .sigma_px = 0.7});
  EXPECT_NEAR((needle.estimate().tip - before.tip - 4.0 * before.direction).norm(), 0.0, 1e-9);
  EXPECT_EQ(needle.estimate().tip_sigma, 0.7);
  EXPECT_TRUE(needle.estimate().evidence & kCommandedMotion);
}

TEST(NeedleTracker, TheDimpleIsWeighedByItsSigmaAndRefusedWhenFarOff) {
  NeedleTracker needle;
  ASSERT_FALSE(push({}, 1.0, 6, 4, needle).empty());
  const NeedleEstimate before = needle.estimate();
  needle.take_dimple(before.tip + 20.0 * before.direction, 0.3);
  EXPECT_EQ(needle.estimate().tip, before.tip);
  EXPECT_FALSE(needle.estimate().evidence & kDimple);
  needle.take_dimple(before.tip + 0.2 * before.direction, before.tip_sigma);
  EXPECT_NEAR((needle.estimate().tip - before.tip).dot(before.direction), 0.1, 1e-6);
  EXPECT_LT(needle.estimate().tip_sigma, before.tip_sigma);
  EXPECT_TRUE(needle.estimate().evidence & kDimple);
}

TEST(NeedleTracker, WhatItBeginsToPushTellsWhereItEnds) {
  NeedleTracker needle;
  ASSERT_FALSE(push({}, 1.0, 6, 0, needle).empty());
  const NeedleEstimate before = needle.estimate();
  // However far off: only the place along the needle is taken.
  needle.rest_on(
      before.tip + 9.0 * before.direction + 2.0 * Eigen::Vector2d(-before.direction.y(), before.direction.x()), 0.2);
  EXPECT_NEAR((needle.estimate().tip - before.tip - 9.0 * before.direction).norm(), 0.0, 1e-6);
  EXPECT_DOUBLE_EQ(needle.estimate().tip_sigma, 0.2);
  EXPECT_TRUE(needle.estimate().evidence & kDimple);
}

TEST(NeedleTracker, ABodyRightAheadOfABlurredTipSilencesTheEnd) {
  NeedleTracker needle;
  const Drawing d = with(0.4, 3.0, false, 0.01);
  const Picture picture = draw(d);
  const FrameSampler image(picture.view());
  ASSERT_TRUE(needle.start(image, tool_of(d), 0.01));
  NeedleCue cue{.in_the_clear = true};
  ASSERT_TRUE(needle.track(image, noise_level(image), cue));
  EXPECT_TRUE(needle.estimate().evidence & kTipEnd);
  cue.body = contour::Circle{d.tip + 44.0 * d.direction(), 40.0, 1.0, 0.0};
  ASSERT_TRUE(needle.track(image, noise_level(image), cue));
  EXPECT_FALSE(needle.estimate().evidence & kTipEnd);
  EXPECT_TRUE(needle.estimate().evidence & kKnownCone);
}

TEST(NeedleTracker, AnEmptyPictureIsNoNeedle) {
  Picture picture;
  std::mt19937 random(5);
  std::normal_distribution<double> noise(140.0, 3.0);
  for (std::uint8_t& p : picture.pixels) p = static_cast<std::uint8_t>(noise(random));
  const FrameSampler image(picture.view());
  NeedleTracker needle;
  EXPECT_FALSE(needle.start(image, tool_of({}), noise_level(image)));
  GrayImage gray;
  load(picture.view(), gray);
  EXPECT_FALSE(needle.start_anywhere(image, gray, noise_level(image)));
}

TEST(NeedleTracker, IsFoundWithNoCellToGoBy) {
  for (const bool wedge : {false, true}) {
    const Drawing d = with(0.4, 1.2, wedge, 0.01);
    const Picture picture = draw(d);
    const FrameSampler image(picture.view());
    GrayImage gray;
    load(picture.view(), gray);
    NeedleTracker needle;
    ASSERT_TRUE(needle.start_anywhere(image, gray, noise_level(image))) << (wedge ? "wedge" : "lines");
    EXPECT_NEAR(error_of(needle, d).along, 0.0, 0.33) << (wedge ? "wedge" : "lines");
    EXPECT_NEAR(error_of(needle, d).across, 0.0, 0.09) << (wedge ? "wedge" : "lines");
  }
}

// A pipette of two thick walls with rounded rims that ends beside a round cell.
TEST(HolderFinder, AxisWidthAndMouthAreThoseDrawn) {
  Picture picture;
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.01);
  const Eigen::Vector2d center(250.0, 170.0);
  const double radius = 60.0, mouth = 56.0, middle_of_wall = 25.0, wall = 5.0;
  for (int y = 0; y < Picture::kHeight_px; ++y) {
    for (int x = 0; x < Picture::kWidth_px; ++x) {
      const double along = center.x() - x, aside = std::abs(y - center.y());
      const double ring = std::hypot(along, aside) - radius;
      const double side = std::abs(aside - middle_of_wall), back = along - (mouth + wall);
      const double distance = (back >= 0.0 ? side : std::hypot(back, side)) - wall;
      double light =
          0.55 * (1.0 - 0.4 * std::exp(-0.5 * ring * ring)) * (1.0 - 0.5 * std::exp(-0.5 * distance * distance / 1.7));
      light += noise(random);
      picture.pixels[static_cast<std::size_t>(y * Picture::kWidth_px + x)] =
          static_cast<std::uint8_t>(255.0 * light + 0.5);
    }
  }
  const FrameSampler image(picture.view());
  GrayImage gray;
  load(picture.view(), gray);
  const contour::Circle cell{center, radius, 1.0, 0.0};
  const std::optional<HolderFit> holder = find_holder(image, find_tools(gray, cell), cell, noise_level(image));
  ASSERT_TRUE(holder.has_value());
  EXPECT_LT(holder->direction.x(), -0.99999);
  EXPECT_NEAR(holder->offset, 0.0, 0.54);
  EXPECT_NEAR(holder->half_width, middle_of_wall + wall, 0.09);
  EXPECT_LT(holder->unevenness, 1.0);
  EXPECT_TRUE(holder->mouth_seen);
  EXPECT_NEAR(holder->mouth.x(), center.x() - mouth, 2.0);
  EXPECT_GT(holder->confidence, 0.5);
}

// The scene's width is the mean over its length: a needle that tapers is as wide half-way along.
TEST(Needle, OneOfItsWallsIsFarThinnerThanItself) {
  SceneTool seen;
  seen.length_px = 200.0;
  seen.half_width_px = 14.0;
  NeedleEstimate lines;
  lines.tip_half_width = 0.6;
  lines.widening = 0.01;
  EXPECT_TRUE(is_one_wall(lines, seen));
  lines.tip_half_width = 4.0;
  lines.widening = 0.1;
  EXPECT_FALSE(is_one_wall(lines, seen));
}

}  // namespace
}  // namespace pellucida
