// Where the network that reads tips has the end of a needle drawn here, from wherever it looks.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace pellucida
