// A tip that the large networks read every few frames and the small one in those between.
#include "TipFollower.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "TipNetwork.h"
#include "tracking/NeedleDrawing.h"

namespace pellucida {
namespace {

constexpr double kShaftHalfWidth_px = 6.0, kStep_px = 1.3;

/// A needle that goes on from frame to frame, its tip due where it is but for half a pixel.
struct Moving {
  test::NeedleDrawing drawing{.tip = {250.3, 171.6}, .tip_radius = 3.0};
  TipNetwork network;
  TipFollower follower;
  int frames = 0;

  struct Frame {
    TipReading followed, read;
    double off_px;
  };
  Frame step(double way_px, bool may_be_quick) {
    drawing.tip += way_px * drawing.direction();
    drawing.seed = static_cast<unsigned>(++frames);
    const test::NeedlePicture picture = draw(drawing);
    const FrameSampler image(picture.view());
    const NeedleAxis due{drawing.tip - (way_px - kStep_px) * drawing.direction() + Eigen::Vector2d(0.3, -0.4),
                         drawing.direction()};
    const TipReading followed = follower.read(network, image, due, kShaftHalfWidth_px, may_be_quick);
    return {followed, network.read(image, due, kShaftHalfWidth_px), (followed.tip - drawing.tip).norm()};
  }
};

TEST(TipFollower, MostFramesAreReadByTheSmallNetworkAndAsWell) {
  Moving needle;
  int quick = 0;
  double worst_px = 0.0, worst_read_px = 0.0;
  for (int frame = 0; frame < 24; ++frame) {
    const Moving::Frame seen = needle.step(kStep_px, true);
    quick += seen.followed.tip != seen.read.tip ? 1 : 0;
    worst_px = std::max(worst_px, seen.off_px);
    worst_read_px = std::max(worst_read_px, (seen.read.tip - needle.drawing.tip).norm());
  }
  EXPECT_GE(quick, 14);
  EXPECT_LE(quick, 18) << "every fourth is read by the large ones";
  EXPECT_LT(worst_px, worst_read_px + 0.5);
}

TEST(TipFollower, ALeapIsReadByTheLargeNetworks) {
  Moving needle;
  for (int frame = 0; frame < 8; ++frame) needle.step(kStep_px, true);
  const Moving::Frame leap = needle.step(kStep_px + 9.0, true);
  EXPECT_EQ(leap.followed.tip, leap.read.tip);
}

TEST(TipFollower, EachFrameIsReadWhereTimeDoesNotCount) {
  Moving needle;
  for (int frame = 0; frame < 8; ++frame) {
    const Moving::Frame seen = needle.step(kStep_px, false);
    EXPECT_EQ(seen.followed.tip, seen.read.tip) << frame;
  }
}

}  // namespace
}  // namespace pellucida
