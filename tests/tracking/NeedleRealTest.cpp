// Needle and pipette on real pictures, where they are at hand beside the checkout; skipped where they are not. Places
// were read off enlarged pictures by eye.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "GrayImage.h"
#include "HolderFinder.h"
#include "NeedleTracker.h"
#include "support/MatView.h"
#include "support/SharedFolder.h"

namespace pellucida {
namespace {

TEST(RealNeedle, ALarvasNeedleIsFoundAndFollowedWithNoCellToGoBy) {
  cv::VideoCapture video((test::shared_folder() / "real" / "needle" / "zebrafish_larva_poke.mkv").string());
  if (!video.isOpened()) GTEST_SKIP() << "the real video is not at hand";
  // A point on the shaft's axis outside the head, and where the dark part of the needle ends. In frame 66 that is the
  // tip itself; later it is the end of what the glass holds, and clear glass goes on in front of it.
  struct Seen {
    int frame;
    Eigen::Vector2d on_axis, dark_end;
    double end_tolerance_px;
  };
  const std::vector<Seen> by_eye{{66, {397.0, 271.7}, {249.0, 256.0}, 45.0},
                                 {100, {380.0, 259.7}, {298.0, 251.0}, 20.0}};
  NeedleTracker needle;
  cv::Mat colour, grey;
  int followed = 0, frames = 0;
  for (int frame = 0; video.read(colour); ++frame) {
    if (frame < 66) continue;
    ++frames;
    cv::cvtColor(colour, grey, cv::COLOR_BGR2GRAY);
    const FrameSampler image(test::mat_view(grey, 1.0));
    const double noise = noise_level(image);
    if (!needle.valid()) {
      GrayImage gray;
      load(test::mat_view(grey, 1.0), gray);
      needle.start_anywhere(image, gray, noise);
      ASSERT_TRUE(needle.valid()) << "frame " << frame;
    } else {
      followed += needle.track(image, noise, {34.0, true, {}}) ? 1 : 0;
    }
    const NeedleEstimate& seen = needle.estimate();
    for (const Seen& truth : by_eye) {
      if (truth.frame != frame) continue;
      const Eigen::Vector2d across(-seen.direction.y(), seen.direction.x());
      const double beside = std::abs((truth.on_axis - seen.tip).dot(across));
      const double from_end = (truth.dark_end - seen.tip).norm();
      std::printf("frame %d: axis %.1f px, end %.1f px from where the eye sees them\n", frame, beside, from_end);
      EXPECT_LT(beside, 4.4);
      EXPECT_LT(from_end, truth.end_tolerance_px);
      EXPECT_LT(seen.direction.x(), -0.991);
    }
  }
  ASSERT_GT(frames, 50);
  EXPECT_GE(followed, frames - 3);
}

TEST(RealNeedle, AVesiclesPipetteEndsWhereItsGlassDoes) {
  const cv::Mat grey =
      cv::imread((test::shared_folder() / "real" / "oocyte_stills" / "vesicle_on_pipette_16bit.png").string(),
                 cv::IMREAD_GRAYSCALE | cv::IMREAD_ANYDEPTH);
  if (grey.empty()) GTEST_SKIP() << "the real picture is not at hand";
  const FrameSampler image(test::mat_view(grey, 1.0));
  GrayImage gray;
  load(test::mat_view(grey, 1.0), gray);
  const contour::Circle vesicle{{122.0, 230.0}, 102.0, 1.0, 0.0};
  const std::optional<HolderFit> holder = find_holder(image, find_tools(gray, vesicle), vesicle, noise_level(image));
  ASSERT_TRUE(holder.has_value());
  EXPECT_GT(holder->direction.x(), 0.9993);
  EXPECT_NEAR(holder->mouth.x(), 216.0, 3.3);
  EXPECT_NEAR(holder->mouth.y(), 228.0, 2.0);
  EXPECT_NEAR(holder->half_width, 42.0, 3.0);
}

}  // namespace
}  // namespace pellucida
