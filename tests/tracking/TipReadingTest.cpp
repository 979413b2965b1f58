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

// A needle that its lines are followed by, in a picture that a test may change.
struct Followed {
  explicit Followed(const Drawing& d) : drawing(d), picture(draw(d)), noise(noise_level(image())) {
    needle.start(image(), test::tool_of(d), noise);
  }
  FrameSampler image() const { return FrameSampler(picture.view()); }

  Drawing drawing;
  Picture picture;
  double noise;
  NeedleTracker needle;
  TipNetwork network;
};

Drawing fine_needle_at(double x_px) {
  Drawing d = fine_needle();
  d.tip.x() = x_px;
  return d;
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
  Followed f(fine_needle_at(200.3));
  ASSERT_TRUE(f.needle.valid());
  const Eigen::Vector2d tip = f.drawing.tip;
  f.drawing.tip.y() += 10.0;
  show_left(draw(f.drawing), 230, f.picture);
  ASSERT_TRUE(f.needle.track(f.image(), f.noise, {}));
  const auto across_px = [&](const NeedleTracker& n) { return std::abs(n.estimate().tip.y() - tip.y()); };
  const std::optional<Eigen::Vector2d> read = f.needle.tip_read(f.network, f.image());
  ASSERT_TRUE(read);
  ASSERT_GT(std::abs(read->y() - tip.y()), 6.0) << "the network does not take it for the tip";
  NeedleTracker free = f.needle;
  EXPECT_TRUE(free.read_tip(f.network, f.image(), 1.0));
  EXPECT_GT(across_px(free), 6.0);
  EXPECT_TRUE(f.needle.read_tip_in_contact(f.network, f.image(), {}, nullptr));
  EXPECT_LT(across_px(f.needle), 1.0);
}

// What was followed has run 90 px ahead, to a piece of glass that ends as a needle does; the needle is where it was.
TEST(TipReading, WhereLinesRanAwayTheTipIsReadWhereItWasBefore) {
  Followed f(fine_needle_at(240.3));
  ASSERT_TRUE(f.needle.valid());
  ASSERT_TRUE(f.needle.track(f.image(), f.noise, {}));
  const Drawing piece = fine_needle_at(150.3);
  show_left(draw(piece), 190, f.picture);
  EXPECT_GT(f.network.read(f.image(), {piece.tip, piece.direction()}, kShaftHalfWidth_px).share, 0.5)
      << "the network does not take it for a tip";
  f.needle.hold({90.0, 0.5});
  EXPECT_TRUE(f.needle.read_tip_in_contact(f.network, f.image(), {}, nullptr));
  EXPECT_LT((f.needle.estimate().tip - f.drawing.tip).norm(), 2.0);
}

// Its last 16 px are hidden from then on, and the network reads its end where they begin.
TEST(TipReading, InContactTheShaftKeepsATipThatIsHidden) {
  Followed f(Drawing{.tip = {220.3, 171.6}});
  ASSERT_TRUE(f.needle.valid());
  NeedleCue cue{.is_free = true, .covered_px = 6.0};
  const auto advance = [&](bool is_hidden) {
    f.drawing.tip.x() -= 3.0;
    ++f.drawing.seed;
    f.picture = draw(f.drawing);
    Drawing nothing = f.drawing;
    nothing.depth = 0.0;
    if (is_hidden) show_left(draw(nothing), static_cast<int>(f.drawing.tip.x() + 16.0), f.picture);
    return f.needle.track(f.image(), f.noise, cue);
  };
  for (int frame = 0; frame < 6; ++frame) {
    ASSERT_TRUE(advance(false));
    ASSERT_TRUE(f.needle.read_tip(f.network, f.image(), 1.0, &cue));
  }
  cue = {.covered_px = 24.0};
  const auto short_px = [&](const NeedleTracker& n) { return n.estimate().tip.x() - f.drawing.tip.x(); };
  for (int frame = 0; frame < 6; ++frame) {
    advance(true);
    NeedleTracker alone = f.needle;
    ASSERT_TRUE(alone.read_tip(f.network, f.image(), 1.0));
    EXPECT_GT(short_px(alone), 8.0) << "the network does not take that for its end";
    EXPECT_TRUE(f.needle.read_tip_in_contact(f.network, f.image(), cue, nullptr));
    EXPECT_LT(std::abs(short_px(f.needle)), 2.0) << frame;
    EXPECT_NE(f.needle.estimate().evidence & kKnownCone, 0U);
  }
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
