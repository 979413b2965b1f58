// What the picture about the needle's tip says of a puncture, where nothing else tells.
#include <gtest/gtest.h>

#include <limits>

#include "PunctureVerdict.h"

namespace pellucida {
namespace {

using Sight = PunctureVerdict::Sight;

constexpr double kShallow_um = 5.0;  // a push in which neither flanks nor sides are seen

Sight picture_seen(double tip_um, double membrane_um, double pierced) {
  return {.tip_um = tip_um,
          .tip_sigma_um = 0.4,
          .membrane_um = membrane_um,
          .membrane_sigma_um = 0.4,
          .confidence = 0.75,
          .pierced_probability = pierced,
          .rest_radius_um = 50.0};
}

PunctureVerdict pushed(double pierced) {
  PunctureVerdict verdict;
  for (double depth = 0.5; depth <= kShallow_um; depth += 0.5) {
    EXPECT_FALSE(verdict.judge(picture_seen(depth, depth, pierced))) << depth;
    verdict.add(depth, 0.1 * depth);
  }
  return verdict;
}

int frames_until_through(double pierced, int most) {
  PunctureVerdict verdict = pushed(0.05);
  // The membrane springs back; its contour follows to within its noise of the tip.
  const double membrane_um[] = {4.6, 3.6, 3.0};
  for (int k = 0; k < most; ++k) {
    const double at_um = k < 3 ? membrane_um[k] : 2.8;
    if (verdict.judge(picture_seen(kShallow_um + 0.2 * k, at_um, pierced))) return k + 1;
    verdict.add(kShallow_um, 0.5);
  }
  return most + 1;
}

TEST(PuncturePicture, AShallowPunctureIsReportedSoonerByThePictureAboutTheTip) {
  const int by_depths = frames_until_through(std::numeric_limits<double>::quiet_NaN(), 12);
  const int by_picture = frames_until_through(0.98, 12);
  EXPECT_LE(by_picture, 4);
  EXPECT_LT(by_picture, by_depths);
}

TEST(PuncturePicture, AMembraneThatThePictureShowsOnTheTipIsNotThrough) {
  EXPECT_GT(frames_until_through(0.02, 12), 12);
}

// A look like none before may make every contact look pierced: a dimple whose flanks go with the needle is pushed.
TEST(PuncturePicture, APictureThatMisleadsThroughoutAContactIsNoPuncture) {
  PunctureVerdict verdict;
  for (double depth = 0.5; depth <= 20.0; depth += 0.5) {
    Sight seen = picture_seen(depth, depth, 0.97);
    seen.flank_um = 0.35 * depth;
    EXPECT_FALSE(verdict.judge(seen)) << depth;
    verdict.add(depth, 0.1 * depth);
  }
}

}  // namespace
}  // namespace pellucida
