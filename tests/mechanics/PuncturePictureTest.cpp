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

// Validation film 55134, frame by frame: its contact looks pierced from a depth of 3 um on, while the tip goes on and
// the contour with it; flanks read poorly at first go deeper.
TEST(PuncturePicture, APictureThatComesToMisleadIsNoPuncture) {
  struct Seen {
    double tip_um, membrane_um, flank_um, side_um, pierced;
  };
  PunctureVerdict verdict;
  for (const Seen& seen :
       {Seen{1.84, 1.82, 1.29, 0.22, 0.29}, Seen{2.57, 2.55, 0.42, 0.25, 0.33}, Seen{3.35, 3.30, -0.42, 0.27, 0.73},
        Seen{4.14, 4.09, -1.91, 0.31, 0.96}, Seen{4.91, 4.85, -0.53, 0.32, 0.75}, Seen{5.62, 5.55, 1.05, 0.38, 0.96},
        Seen{6.43, 6.34, 1.15, 0.42, 0.98}, Seen{7.19, 7.11, 2.22, 0.42, 0.97}, Seen{7.93, 7.89, 2.05, 0.42, 0.89},
        Seen{8.70, 8.66, 2.09, 0.44, 0.87}}) {
    Sight sight = picture_seen(seen.tip_um, seen.membrane_um, seen.pierced);
    sight.tip_sigma_um = 0.2;
    sight.membrane_sigma_um = 0.3;
    sight.confidence = 0.7;
    sight.flank_um = seen.flank_um;
    sight.side_um = seen.side_um;
    sight.shape_sigma_um = 0.3;  // flanks that leap as these do tell little
    EXPECT_FALSE(verdict.judge(sight)) << seen.tip_um;
    verdict.add(seen.tip_um, 0.1 * seen.tip_um);
  }
}

}  // namespace
}  // namespace pellucida
