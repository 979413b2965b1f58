// Where the network that reads tips has the end of a needle drawn here, from wherever it looks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "NeedleTracker.h"
#include "TipNetwork.h"
#include "tracking/NeedleDrawing.h"

namespace pellucida {
namespace {

using Drawing = test::NeedleDrawing;
using Picture = test::NeedlePicture;

constexpr double kShaftHalfWidth_px = 3.0;
// A needle as specimens have them.
Drawing fine_needle() {
  Drawing d;
  d.tip = {60.4, 171.6};
  d.slope = 0.02;
  return d;
}

NeedleTracker followed(const Picture& picture, const Drawing& d) {
  const FrameSampler image(picture.view());
  NeedleTracker needle;
  needle.start(image, test::tool_of(d), noise_level(image));
  return needle;
}

// The first `width_px` columns of another picture.
void show_left(const Picture& other, int width_px, Picture& picture) {
  for (int y = 0; y < Picture::kHeight_px; ++y)
    std::copy_n(other.pixels.begin() + y * Picture::kWidth_px, width_px,
                picture.pixels.begin() + y * Picture::kWidth_px);
}

double off_px(const TipReading& reading, const Drawing& d) {
  return (reading.tip - d.tip).norm();
}

TEST(TipReading, ATipBeyondWhatIsLookedAtIsWalkedTo) {
  const Drawing d = fine_needle();
  const Picture picture = draw(d);
  TipNetwork network;
  for (const double behind_px : {0.0, 40.0, 90.0, 200.0}) {
    const TipReading seen = network.read(FrameSampler(picture.view()),
                                         {d.tip - behind_px * d.direction(), d.direction()}, kShaftHalfWidth_px);
    EXPECT_GT(seen.share, 0.5) << behind_px;
    EXPECT_LT(off_px(seen, d), 2.0) << behind_px;
  }
}

TEST(TipReading, WhereNoEndComesIntoViewThereIsNone) {
  Drawing d = fine_needle();
  d.tip = {-200.0, 171.6};  // the shaft goes right through
  const Picture picture = draw(d);
  TipNetwork network;
  const TipReading seen =
      network.read(FrameSampler(picture.view()), {{300.0, 171.6}, d.direction()}, kShaftHalfWidth_px);
  EXPECT_LT(seen.share, 0.5);
}

// Where a faint needle passes over a dark body, a look there alone has its end.
TEST(TipReading, ABodyOnTheShaftIsNotItsEnd) {
  TipNetwork network;
  for (const double radius_px : {3.0, 5.0, 8.0}) {
    Drawing d = fine_needle();
    d.depth = 0.08;
    d.disc_behind_px = 60.0;
    d.disc_radius_px = radius_px;
    const Picture picture = draw(d);
    const FrameSampler image(picture.view());
    const NeedleAxis at_disc{d.tip - d.disc_behind_px * d.direction(), d.direction()};
    EXPECT_GT(off_px(network.read(image, at_disc, kShaftHalfWidth_px), d), 50.0) << radius_px;
    const TipReading seen = network.find(image, at_disc, kShaftHalfWidth_px, {20.0, 171.6});
    EXPECT_GT(seen.share, 0.5) << radius_px;
    EXPECT_LT(off_px(seen, d), 2.0) << radius_px;
  }
}

TEST(TipReading, AnEndWithNothingAheadStaysTheEnd) {
  for (const double membrane_ahead : {-1.0, 4.0, 30.0}) {
    Drawing d = fine_needle();
    d.tip = {200.3, 171.6};
    d.membrane_ahead = membrane_ahead;
    const Picture picture = draw(d);
    TipNetwork network;
    const TipReading seen =
        network.find(FrameSampler(picture.view()), {d.tip, d.direction()}, kShaftHalfWidth_px, {20.0, 171.6});
    EXPECT_LT(off_px(seen, d), 2.0) << membrane_ahead;
  }
}

// The last 30 px of a needle, moved aside by 10 px: as if another corner of it were taken for its tip.
TEST(TipReading, InContactATipDoesNotLeapAcrossItsNeedle) {
  Drawing d = fine_needle();
  d.tip = {200.3, 171.6};
  Picture picture = draw(d);
  TipNetwork network;
  const double noise = noise_level(FrameSampler(picture.view()));
  NeedleTracker needle = followed(picture, d);
  ASSERT_TRUE(needle.valid());
  Drawing aside = d;
  aside.tip.y() += 10.0;
  show_left(draw(aside), 230, picture);
  const FrameSampler image(picture.view());
  ASSERT_TRUE(needle.track(image, noise, {}));
  const auto across_px = [&](const NeedleTracker& n) { return std::abs(n.estimate().tip.y() - d.tip.y()); };
  const std::optional<Eigen::Vector2d> read = needle.tip_read(network, image);
  ASSERT_TRUE(read);
  ASSERT_GT(std::abs(read->y() - d.tip.y()), 6.0) << "the network does not take it for the tip";
  NeedleTracker free = needle;
  EXPECT_TRUE(free.read_tip(network, image, 1.0));
  EXPECT_GT(across_px(free), 6.0);
  EXPECT_TRUE(needle.read_tip_in_contact(network, image, {}, nullptr));
  EXPECT_LT(across_px(needle), 1.0);
}

// What was followed has run 90 px ahead, to a piece of glass that ends as a needle does; the needle is where it was.
TEST(TipReading, WhereLinesRanAwayTheTipIsReadWhereItWasBefore) {
  Drawing d = fine_needle();
  d.tip = {240.3, 171.6};
  Picture picture = draw(d);
  TipNetwork network;
  const double noise = noise_level(FrameSampler(picture.view()));
  NeedleTracker needle = followed(picture, d);
  ASSERT_TRUE(needle.valid());
  ASSERT_TRUE(needle.track(FrameSampler(picture.view()), noise, {}));
  Drawing piece = d;
  piece.tip.x() -= 90.0;
  show_left(draw(piece), 190, picture);
  const FrameSampler image(picture.view());
  EXPECT_GT(network.read(image, {piece.tip, piece.direction()}, kShaftHalfWidth_px).share, 0.5)
      << "the network does not take it for a tip";
  needle.hold({90.0, 0.5});
  EXPECT_TRUE(needle.read_tip_in_contact(network, image, {}, nullptr));
  EXPECT_LT((needle.estimate().tip - d.tip).norm(), 2.0);
}

// Known by its tip alone, which then seems to go back by 14 px within a frame. Of a needle in the clear, or one that
// was drawn back already, that says that it is not seen well.
TEST(TipReading, InADimpleATipThatLeapsBackLeavesTheNeedleClear) {
  TipNetwork network;
  Drawing d = fine_needle();
  d.tip = {200.3, 171.6};
  const auto kept = [&](double depth_px, double drawn_back_px) {
    NeedleTracker needle;
    NeedleCue cue;
    cue.depth_px = depth_px;
    Drawing now = d;
    const Picture first = draw(now);
    EXPECT_TRUE(needle.start_read(network, FrameSampler(first.view()), {d.tip, d.direction()}, kShaftHalfWidth_px));
    for (int frame = 0; frame < 6; ++frame) {
      now.tip -= drawn_back_px * d.direction();
      const Picture picture = draw(now);
      EXPECT_TRUE(needle.follow_read(network, FrameSampler(picture.view()), cue));
    }
    const NeedleEstimate before = needle.estimate();
    now.tip -= 14.0 * d.direction();
    const Picture after = draw(now);
    EXPECT_TRUE(needle.follow_read(network, FrameSampler(after.view()), cue));
    EXPECT_LT((needle.estimate().tip - before.tip).norm(), 4.0) << "one frame is not believed";
    const double ratio = needle.estimate().confidence / before.confidence;
    EXPECT_TRUE(needle.follow_read(network, FrameSampler(after.view()), cue));
    EXPECT_LT((needle.estimate().tip - now.tip).norm(), 3.0) << "the second one is";
    return ratio;
  };
  EXPECT_EQ(kept(25.0, 0.0), 1.0);
  EXPECT_EQ(kept(0.0, 0.0), 0.5);
  EXPECT_EQ(kept(25.0, 2.0), 0.5);
}

}  // namespace
}  // namespace pellucida
