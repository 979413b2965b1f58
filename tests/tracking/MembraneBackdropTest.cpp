// What a needle's tip is seen against: a membrane's line drawn here, of known place and look.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "MembraneBackdrop.h"
#include "NeedleTracker.h"
#include "tracking/NeedleDrawing.h"

namespace pellucida {
namespace {

using Drawing = test::NeedleDrawing;
using Picture = test::NeedlePicture;

constexpr double kRadius_px = 40.0, kSample_px = 0.5;
constexpr Eigen::Index kPoints = 120;

Eigen::Matrix2Xd unit_circle() {
  Eigen::Matrix2Xd points(2, kPoints);
  for (Eigen::Index i = 0; i < kPoints; ++i) {
    const double t = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(kPoints);
    points.col(i) << std::cos(t), std::sin(t);
  }
  return points;
}

// The drawings' membrane, learnt.
EdgeTemplate membrane_edge() {
  std::vector<float> profiles;
  for (Eigen::Index i = 0; i < kPoints; ++i)
    for (int k = -EdgeTemplate::kHalf; k <= EdgeTemplate::kHalf; ++k)
      profiles.push_back(static_cast<float>(Drawing::membrane_light(k * kSample_px)));
  EdgeTemplate edge;
  EXPECT_TRUE(edge.learn(profiles.data(), unit_circle(), Eigen::VectorXd::Ones(kPoints), {}, 1.0));
  return edge;
}

double along(const NeedleTracker& needle, const Drawing& d) {
  return (needle.estimate().tip - d.tip).dot(d.direction());
}

TEST(MembraneBackdrop, IsTheLineWhereTheOutlineIsAndGoesWithTheNeedleAboutItsTip) {
  const EdgeTemplate edge = membrane_edge();
  const Eigen::Vector2d shift(3.0, 1.0), tip = shift + Eigen::Vector2d(-kRadius_px, 0.0), inwards(1.0, 0.0);
  MembraneBackdrop membrane;
  EXPECT_TRUE(membrane.is_empty());
  EXPECT_EQ(membrane.at(tip), 1.0F);
  membrane.set(kRadius_px * unit_circle(), edge, kSample_px, tip, shift, 10.0);
  EXPECT_FALSE(membrane.is_empty());
  for (const double away : {0.0, 1.0, 2.0})
    EXPECT_NEAR(membrane.at(tip - away * inwards),
                Drawing::membrane_light(away) / Drawing::membrane_light(EdgeTemplate::kHalf * kSample_px), 0.01)
        << away;
  const float on_line = membrane.at(tip);
  const Eigen::Vector2d beside = shift + kRadius_px * Eigen::Vector2d(-std::cos(1.2), std::sin(1.2));
  const float on_line_beside = membrane.at(beside);
  const Eigen::Vector2d way = shift + 3.0 * inwards;
  membrane.push(way);
  EXPECT_NEAR(membrane.at(tip + 3.0 * inwards), on_line, 0.02);
  EXPECT_GT(membrane.at(tip), on_line + 0.2F);
  EXPECT_NEAR(membrane.at(beside), on_line_beside, 0.02);
  // The outline elsewhere says nothing about the tip.
  membrane.set(kRadius_px * unit_circle(), edge, kSample_px, tip + Eigen::Vector2d(200.0, 200.0), shift, 0.0);
  EXPECT_TRUE(membrane.is_empty());
}

// A cell's outline bends away from the tip that touches it, and its line hides the end's: taken for part of the end, it
// moves the tip; known where it is and what it looks like, it doesn't.
TEST(MembraneBackdrop, AgainstAMembraneThatIsKnownTheTipIsWhereItIsInPlainMedium) {
  const EdgeTemplate edge = membrane_edge();
  Drawing d;
  d.angle_rad = 0.4;
  NeedleTracker needle;
  const Picture before = draw(d);
  ASSERT_TRUE(needle.start(FrameSampler(before.view()), tool_of(d), 0.01));
  const double in_medium = along(needle, d);
  for (const double ahead : {1.0, 0.5, 0.0}) {
    d.membrane_ahead = ahead;
    d.membrane_radius = kRadius_px;
    const Picture picture = draw(d);
    const FrameSampler image(picture.view());
    const Eigen::Vector2d center = d.tip + (ahead + kRadius_px) * d.direction();
    const auto off_with = [&](MembraneBackdrop* membrane) {
      NeedleTracker tried = needle;
      NeedleCue cue;
      cue.membrane = membrane;
      EXPECT_TRUE(tried.track(image, 0.01, cue));
      return std::abs(along(tried, d) - in_medium);
    };
    MembraneBackdrop membrane;
    membrane.set((kRadius_px * unit_circle()).colwise() + center, edge, kSample_px, d.tip, Eigen::Vector2d::Zero(),
                 0.0);
    const double known = off_with(&membrane);
    EXPECT_LT(known, 0.06) << ahead;
    EXPECT_LT(known, off_with(nullptr)) << ahead;
  }
}

}  // namespace
}  // namespace pellucida
