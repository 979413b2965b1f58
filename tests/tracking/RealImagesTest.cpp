// Real pictures, where they are at hand beside the checkout; skipped where they are not. What is asserted is honesty
// first, accuracy as far as the masks allow. The figures are printed.
#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida {
namespace {

const std::filesystem::path kReal = std::filesystem::path(PELLUCIDA_SOURCE_DIR) / ".." / "shared" / "real";
constexpr double kPixelSize_um = 0.5;  // not stated with the pictures; the tracker works in pixels

Observation track(MembraneTracker& tracker, const cv::Mat& grey, long frame) {
  ImageView view;
  view.data = grey.data;
  view.format = grey.depth() == CV_16U ? PixelFormat::kGray16 : PixelFormat::kGray8;
  view.width_px = grey.cols;
  view.height_px = grey.rows;
  view.row_bytes = static_cast<std::ptrdiff_t>(grey.step);
  view.pixel_size_um = kPixelSize_um;
  return tracker.process(view, static_cast<double>(frame) / 30.0, frame);
}

cv::Mat filled(const MembraneContour& contour, const cv::Size& size) {
  std::vector<cv::Point> points;
  for (Eigen::Index i = 0; i < contour.points_um.cols(); ++i)
    points.emplace_back(static_cast<int>(std::lround(contour.points_um(0, i) / kPixelSize_um)),
                        static_cast<int>(std::lround(contour.points_um(1, i) / kPixelSize_um)));
  cv::Mat mask = cv::Mat::zeros(size, CV_8U);
  cv::fillPoly(mask, std::vector<std::vector<cv::Point>>{points}, cv::Scalar(255));
  return mask;
}

double dice(const cv::Mat& a, const cv::Mat& b) {
  const double both = cv::countNonZero(a & b);
  return 2.0 * both / std::max(1, cv::countNonZero(a) + cv::countNonZero(b));
}

class OocyteStill : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kReal / "oocyte_stills")) GTEST_SKIP() << "the real pictures are not at hand";
  }
};

TEST_P(OocyteStill, TheInnermostMembraneEnclosesTheOoplasm) {
  const std::string name = GetParam();
  const cv::Mat grey = cv::imread((kReal / "oocyte_stills" / (name + "_image.png")).string(), cv::IMREAD_GRAYSCALE);
  cv::Mat mask = cv::imread((kReal / "oocyte_stills" / (name + "_mask.png")).string(), cv::IMREAD_GRAYSCALE);
  ASSERT_FALSE(grey.empty() || mask.empty());
  mask = mask > 127;
  MembraneTracker tracker;
  const Observation seen = track(tracker, grey, 0);
  ASSERT_TRUE(seen.outer.has_value());
  const MembraneContour& innermost = seen.inner ? *seen.inner : *seen.outer;
  const cv::Mat ooplasm = filled(innermost, grey.size());
  if (name.rfind("ooplasm", 0) == 0) {
    const double agreement = dice(ooplasm, mask);
    std::printf("%s: ooplasm Dice %.3f, confidence %.2f\n", name.c_str(), agreement, seen.confidence);
    EXPECT_GT(agreement, 0.93);
  } else {
    // The zona's mask is a ring. What is followed is the strong dark line of the oolemma, a little inside the ring's
    // hole where a perivitelline gap parts the two; hence the wider limits.
    cv::Mat outside = mask.clone(), hole;
    cv::floodFill(outside,
                  cv::Point(static_cast<int>(seen.center_um.x() / kPixelSize_um),
                            static_cast<int>(seen.center_um.y() / kPixelSize_um)),
                  cv::Scalar(128));
    hole = outside == 128;
    std::printf("%s: zona's hole Dice %.3f", name.c_str(), dice(ooplasm, hole));
    EXPECT_GT(dice(ooplasm, hole), 0.85);
    if (seen.inner) {
      const cv::Mat zona = filled(*seen.outer, grey.size()) & ~ooplasm;
      std::printf(", zona Dice %.3f", dice(zona, mask));
      EXPECT_GT(dice(zona, mask), 0.6);
    } else {
      std::printf(", zona's outer edge not seen");
    }
    std::printf(", confidence %.2f\n", seen.confidence);
  }
}

INSTANTIATE_TEST_SUITE_P(Real, OocyteStill,
                         testing::Values("ooplasm0", "ooplasm1", "ooplasm2", "zona0", "zona1", "zona2"));

TEST(RealImages, TheInjectedOocyteIsFoundWithModestConfidence) {
  const cv::Mat grey = cv::imread((kReal / "oocyte_stills" / "icsi_needle_inside.jpg").string(), cv::IMREAD_GRAYSCALE);
  if (grey.empty()) GTEST_SKIP() << "the real pictures are not at hand";
  MembraneTracker tracker;
  const Observation seen = track(tracker, grey, 0);
  ASSERT_TRUE(seen.outer.has_value());
  std::printf("outer %s, inner %s, needle %s, state %s, confidence %.2f\n", "seen", seen.inner ? "seen" : "not seen",
              seen.needle ? "seen" : "not seen", std::string(to_string(seen.state)).c_str(), seen.confidence);
  EXPECT_LT(seen.confidence, 0.6);
  // The needle comes from the right and its tip lies in the cell's left half.
  ASSERT_TRUE(seen.needle.has_value());
  EXPECT_LT(seen.needle->direction.x(), -0.98);
  EXPECT_LT(seen.needle->tip_um.x() / kPixelSize_um, 200.0);
  // The cell's middle, as an eye would set it.
  EXPECT_NEAR(seen.center_um.x() / kPixelSize_um, 215.0, 15.0);
  EXPECT_NEAR(seen.center_um.y() / kPixelSize_um, 290.0, 15.0);
}

TEST(RealImages, ALarvaIsNoRoundCell) {
  cv::VideoCapture video((kReal / "needle" / "zebrafish_larva_poke.mkv").string());
  if (!video.isOpened()) GTEST_SKIP() << "the real video is not at hand";
  MembraneTracker tracker;
  cv::Mat colour, grey;
  long frames = 0, claimed = 0;
  for (; video.read(colour); ++frames) {
    cv::cvtColor(colour, grey, cv::COLOR_BGR2GRAY);
    const Observation seen = track(tracker, grey, frames);
    claimed += seen.outer ? 1 : 0;
    EXPECT_LT(seen.confidence, 0.5) << "frame " << frames;
  }
  ASSERT_GT(frames, 100);
  EXPECT_LT(claimed, frames / 10);
}

TEST(RealImages, ARedCellSuckedInIsLostNotInvented) {
  cv::VideoCapture video((kReal / "aspiration" / "red_cell_aspiration.mp4").string());
  if (!video.isOpened()) GTEST_SKIP() << "the real video is not at hand";
  MembraneTracker tracker;
  cv::Mat colour, grey;
  for (long frame = 0; frame < 420 && video.read(colour); ++frame) {
    cv::cvtColor(colour, grey, cv::COLOR_BGR2GRAY);
    const Observation seen = track(tracker, grey, frame);
    // Before it arrives there is none; from frame 300 on it is inside the pipette.
    if (frame < 60 || frame > 330) {
      EXPECT_LT(seen.confidence, 0.5) << "frame " << frame;
    }
  }
}

}  // namespace
}  // namespace pellucida
