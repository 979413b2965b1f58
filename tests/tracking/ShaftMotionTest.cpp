// Where a needle's tip is, by its shaft alone.
#include "ShaftMotion.h"

#include <gtest/gtest.h>

#include <optional>

#include "tracking/NeedleDrawing.h"

namespace pellucida {
namespace {

using Drawing = test::NeedleDrawing;

constexpr double kHalfWidth_px = 6.0, kReadSigma_px = 0.4;

// Its tip so far ahead of where the first one has it; each with noise of its own.
Drawing ahead(Drawing d, double ahead_px, unsigned seed) {
  d.tip += ahead_px * d.direction();
  d.seed = seed;
  return d;
}

NeedleAxis axis_of(const Drawing& d) {
  return {d.tip, d.direction()};
}

// Learnt from frames in which it comes 3 px nearer each, and the tip is read where it is.
ShaftMotion learnt(const Drawing& first, int frames) {
  ShaftMotion shaft;
  for (int k = 0; k < frames; ++k) {
    const Drawing d = ahead(first, 3.0 * k, static_cast<unsigned>(k));
    const test::NeedlePicture picture = draw(d);
    const FrameSampler image(picture.view());
    shaft.learn(image, axis_of(d), shaft.find(image, axis_of(d), 4.0), d.tip, kReadSigma_px, kHalfWidth_px);
  }
  return shaft;
}

// Of a needle so far ahead of the first one, due 3 px short and 1 px beside of where it is.
std::optional<ShaftMotion::Place> found(const ShaftMotion& shaft, const Drawing& first, double ahead_px,
                                        double covered_px) {
  const Drawing d = ahead(first, ahead_px, 99);
  const test::NeedlePicture picture = draw(d);
  NeedleAxis due = axis_of(d);
  due.tip += -3.0 * due.direction + due.across();
  return shaft.find(FrameSampler(picture.view()), due, covered_px);
}

TEST(ShaftMotion, AShaftThatWidensSaysWhereTheTipIs) {
  Drawing first;
  for (const double slope : {0.03, 0.06}) {
    for (const bool wedge : {false, true}) {
      first.slope = slope;
      first.wedge = wedge;
      SCOPED_TRACE(::testing::PrintToString(first) + ", slope " + std::to_string(slope));
      const ShaftMotion shaft = learnt(first, 6);
      ASSERT_TRUE(shaft.is_known());
      // The first pixels behind the tip are the cell's, and what is there does not matter.
      for (const double covered_px : {6.0, 30.0}) {
        const auto place = found(shaft, first, 30.0, covered_px);
        ASSERT_TRUE(place.has_value()) << covered_px;
        EXPECT_NEAR(place->ahead_px, 3.0, 0.5) << covered_px;
        EXPECT_NEAR(place->across_px, -1.0, 0.1) << covered_px;
        EXPECT_LT(std::abs(place->ahead_px - 3.0), 3.0 * place->sigma_px) << covered_px;
      }
    }
  }
}

TEST(ShaftMotion, OneThatIsTheSameAllAlongSaysNothing) {
  Drawing first;
  first.slope = 0.0;
  first.tip_radius = 5.0;
  const ShaftMotion shaft = learnt(first, 6);
  EXPECT_FALSE(found(shaft, first, 30.0, 6.0).has_value());
}

TEST(ShaftMotion, NothingIsSaidByLittleOrByAnother) {
  const Drawing first;
  EXPECT_FALSE(learnt(first, 2).is_known());
  const ShaftMotion shaft = learnt(first, 6);
  EXPECT_FALSE(found(shaft, first, 12.0, 95.0).has_value());
  Drawing other = first;
  other.depth = -0.3;
  EXPECT_FALSE(found(shaft, other, 12.0, 6.0).has_value());
}

// Light that stays where it is, seen while the needle comes nearer, is not the needle's: where the readings of its tip
// show that the shaft drifts against them, it is the less sure the farther the needle goes.
TEST(ShaftMotion, WhatDriftsAgainstTheReadingsIsLessSure) {
  const Drawing first;
  const auto drifting = [&](double per_px) {
    ShaftMotion shaft;
    for (int k = 0; k < 12; ++k) {
      const Drawing d = ahead(first, 2.0 * k, static_cast<unsigned>(k));
      const test::NeedlePicture picture = draw(d);
      const FrameSampler image(picture.view());
      const Eigen::Vector2d read = d.tip + per_px * 2.0 * k * d.direction();
      shaft.learn(image, axis_of(d), shaft.find(image, axis_of(d), 4.0), read, 0.1, kHalfWidth_px);
    }
    const auto place = found(shaft, first, 28.0, 6.0);
    return place ? place->sigma_px : 1e9;
  };
  EXPECT_LT(drifting(0.0), 0.5);
  EXPECT_GT(drifting(0.1), 1.0);
}

}  // namespace
}  // namespace pellucida
