// Real pictures, where they are at hand beside the checkout; skipped where they are not. What is asserted is honesty
// first, accuracy as far as the masks allow. The figures are printed.
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "ContourMath.h"
#include "pellucida/tracking/MembraneTracker.h"
#include "support/MatView.h"
#include "support/SharedFolder.h"

namespace pellucida {
namespace {

constexpr double kPixelSize_um = 0.5;  // not stated with the pictures; the tracker works in pixels

Observation track(MembraneTracker& tracker, const cv::Mat& grey, long frame) {
  return tracker.process(test::mat_view(grey, kPixelSize_um), static_cast<double>(frame) / 30.0, frame);
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

// Mean distance of the contour's points from the mask's edge, px. Points outside the image, or nearest to where the
// picture's border cuts the mask off, say nothing.
double mean_distance_px(const MembraneContour& contour, const cv::Mat& mask) {
  std::vector<std::vector<cv::Point>> edges;
  cv::findContours(mask, edges, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::Mat from_edge(mask.size(), CV_8U, cv::Scalar(255)), from_cut = from_edge.clone();
  const cv::Rect inner(2, 2, mask.cols - 4, mask.rows - 4);
  for (const auto& edge : edges)
    for (const cv::Point& p : edge) (inner.contains(p) ? from_edge : from_cut).at<uchar>(p) = 0;
  cv::Mat to_edge, to_cut;
  cv::distanceTransform(from_edge, to_edge, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::distanceTransform(from_cut, to_cut, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  double sum = 0.0;
  int count = 0;
  for (Eigen::Index i = 0; i < contour.points_um.cols(); ++i) {
    const cv::Point p(static_cast<int>(std::lround(contour.points_um(0, i) / kPixelSize_um)),
                      static_cast<int>(std::lround(contour.points_um(1, i) / kPixelSize_um)));
    if (!inner.contains(p) || to_cut.at<float>(p) < to_edge.at<float>(p)) continue;
    sum += to_edge.at<float>(p);
    ++count;
  }
  return count > 0 ? sum / count : std::numeric_limits<double>::infinity();
}

// A still is one frame, seen once.
struct Still {
  cv::Mat grey, mask;
  Observation seen;
};

std::optional<Still> look_at(const std::string& name) {
  Still still;
  still.grey = cv::imread((test::shared_folder() / "real" / "oocyte_stills" / (name + "_image.png")).string(),
                          cv::IMREAD_GRAYSCALE);
  still.mask = cv::imread((test::shared_folder() / "real" / "oocyte_stills" / (name + "_mask.png")).string(),
                          cv::IMREAD_GRAYSCALE);
  if (still.grey.empty() || still.mask.empty()) return std::nullopt;
  still.mask = still.mask > 127;
  MembraneTracker tracker;
  still.seen = track(tracker, still.grey, 0);
  return still;
}

class OoplasmStill : public testing::TestWithParam<const char*> {};

TEST_P(OoplasmStill, TheInnermostMembraneEnclosesTheOoplasm) {
  const std::optional<Still> still = look_at(GetParam());
  if (!still) GTEST_SKIP() << "the real pictures are not at hand";
  const Observation& seen = still->seen;
  ASSERT_TRUE(seen.outer.has_value());
  const MembraneContour& ooplasm = seen.oolemma ? *seen.oolemma : seen.inner ? *seen.inner : *seen.outer;
  const double agreement = dice(filled(ooplasm, still->grey.size()), still->mask);
  const double distance = mean_distance_px(ooplasm, still->mask);
  std::printf("%s: ooplasm Dice %.3f, mean distance %.2f px, confidence %.2f\n", GetParam(), agreement, distance,
              seen.confidence);
  EXPECT_GT(agreement, 0.97);
  EXPECT_LT(distance, 2.0);
}

INSTANTIATE_TEST_SUITE_P(Real, OoplasmStill, testing::Values("ooplasm0", "ooplasm1", "ooplasm2"));

// The zona's mask is a ring, drawn by hand as polygons and cut off by the picture's border. `least` is what is reached,
// less a margin; docs/method.md, 1.7, says where the rest is lost.
struct ZonaGoal {
  const char* name;
  double least_ring, least_outer, least_hole;
};

class ZonaStill : public testing::TestWithParam<ZonaGoal> {};

TEST_P(ZonaStill, BothEdgesOfTheZonaAreFound) {
  const std::optional<Still> still = look_at(GetParam().name);
  if (!still) GTEST_SKIP() << "the real pictures are not at hand";
  const Observation& seen = still->seen;
  ASSERT_TRUE(seen.outer && seen.inner);
  cv::Mat outside = still->mask.clone();
  cv::floodFill(outside,
                cv::Point(static_cast<int>(seen.center_um.x() / kPixelSize_um),
                          static_cast<int>(seen.center_um.y() / kPixelSize_um)),
                cv::Scalar(128));
  const cv::Mat hole = outside == 128, disc = outside > 0;
  const cv::Mat outer = filled(*seen.outer, still->grey.size()), inner = filled(*seen.inner, still->grey.size());
  const double ring = dice(outer & ~inner, still->mask), outer_dice = dice(outer, disc), hole_dice = dice(inner, hole);
  std::printf(
      "%s: zona Dice %.3f (outer edge's disc %.3f, %.2f px; inner edge's disc %.3f, %.2f px), confidence %.2f\n",
      GetParam().name, ring, outer_dice, mean_distance_px(*seen.outer, disc), hole_dice,
      mean_distance_px(*seen.inner, hole), seen.confidence);
  EXPECT_GT(ring, GetParam().least_ring);
  EXPECT_GT(outer_dice, GetParam().least_outer);
  EXPECT_GT(hole_dice, GetParam().least_hole);
  EXPECT_TRUE(seen.oolemma.has_value()) << "all three show a perivitelline gap";
}

INSTANTIATE_TEST_SUITE_P(Real, ZonaStill,
                         testing::Values(ZonaGoal{"zona0", 0.79, 0.93, 0.93}, ZonaGoal{"zona1", 0.83, 0.97, 0.92},
                                         ZonaGoal{"zona2", 0.83, 0.96, 0.94}));

TEST(RealImages, TheInjectedOocyteIsFoundWithModestConfidence) {
  const cv::Mat grey = cv::imread(
      (test::shared_folder() / "real" / "oocyte_stills" / "icsi_needle_inside.jpg").string(), cv::IMREAD_GRAYSCALE);
  if (grey.empty()) GTEST_SKIP() << "the real pictures are not at hand";
  MembraneTracker tracker;
  const Observation seen = track(tracker, grey, 0);
  ASSERT_TRUE(seen.outer.has_value());
  std::printf("outer %s, inner %s, needle %s, state %s, confidence %.2f\n", "seen", seen.inner ? "seen" : "not seen",
              seen.needle ? "seen" : "not seen", std::string(to_string(seen.state)).c_str(), seen.confidence);
  EXPECT_LT(seen.confidence, 0.6);
  // The needle comes from the right and its tip lies in the cell's left half.
  ASSERT_TRUE(seen.needle.has_value());
  EXPECT_LT(seen.needle->direction.x(), -0.9999);
  EXPECT_LT(seen.needle->tip_um.x() / kPixelSize_um, 200.0);
  // The cell's middle, as an eye would set it.
  EXPECT_NEAR(seen.center_um.x() / kPixelSize_um, 215.0, 5.0);
  EXPECT_NEAR(seen.center_um.y() / kPixelSize_um, 290.0, 7.2);
}

// What an eye draws in the still, px: where pipette and debris hide the membranes, nothing is drawn.
using Polyline = std::vector<cv::Point2d>;
const std::vector<Polyline> kZonaByEye = {
    {{200, 84}, {240, 79}, {285, 85}, {330, 104}, {372, 142}, {402, 186}, {420, 236}, {425, 278}},
    {{421, 322}, {406, 372}, {380, 415}, {342, 450}, {298, 476}, {250, 489}, {203, 488}, {156, 475}, {115, 452}}};
const std::vector<Polyline> kOolemmaByEye = {
    {{190, 147}, {225, 137}, {262, 141}, {296, 157}, {324, 186}, {341, 222}, {348, 262}, {349, 284}},
    {{347, 326}, {336, 367}, {310, 402}, {272, 426}, {225, 435}, {180, 428}, {140, 406}, {106, 370}, {83, 330}},
    {{86, 262}, {110, 224}, {148, 180}}};

// Mean and largest distance of drawn points, a few px apart, from a contour.
std::pair<double, double> distance_px(const std::vector<Polyline>& drawn, const MembraneContour& contour) {
  double sum = 0.0, largest = 0.0;
  int count = 0;
  for (const Polyline& line : drawn) {
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      for (int part = 0; part < 8; ++part) {
        const cv::Point2d p = line[k] + (line[k + 1] - line[k]) * (part / 8.0);
        const double off =
            contour::distance_to(contour.points_um, kPixelSize_um * Eigen::Vector2d(p.x, p.y)) / kPixelSize_um;
        sum += off;
        largest = std::max(largest, off);
        ++count;
      }
    }
  }
  return {sum / count, largest};
}

TEST(RealImages, TheInjectedOocytesMembranesLieWhereAnEyeDrawsThem) {
  const cv::Mat grey = cv::imread(
      (test::shared_folder() / "real" / "oocyte_stills" / "icsi_needle_inside.jpg").string(), cv::IMREAD_GRAYSCALE);
  if (grey.empty()) GTEST_SKIP() << "the real pictures are not at hand";
  MembraneTracker tracker;
  const Observation seen = track(tracker, grey, 0);
  ASSERT_TRUE(seen.outer && seen.inner);
  const MembraneContour& oolemma = seen.oolemma ? *seen.oolemma : *seen.inner;
  const auto [outer_mean, outer_largest] = distance_px(kZonaByEye, *seen.outer);
  const auto [inner_mean, inner_largest] = distance_px(kOolemmaByEye, oolemma);
  std::printf("zona's outer edge %.1f px (largest %.1f), oolemma %.1f px (largest %.1f) from the drawn lines\n",
              outer_mean, outer_largest, inner_mean, inner_largest);
  EXPECT_LT(outer_mean, 5.0);
  EXPECT_LT(inner_mean, 5.0);
}

TEST(RealImages, AVesicleOnAPipetteIsFound) {
  const cv::Mat grey =
      cv::imread((test::shared_folder() / "real" / "oocyte_stills" / "vesicle_on_pipette_16bit.png").string(),
                 cv::IMREAD_ANYDEPTH | cv::IMREAD_GRAYSCALE);
  if (grey.empty()) GTEST_SKIP() << "the real pictures are not at hand";
  MembraneTracker tracker;
  const Observation seen = track(tracker, grey, 0);
  ASSERT_TRUE(seen.outer.has_value());
  EXPECT_FALSE(seen.oolemma.has_value()) << "a vesicle has no zona";
  const Eigen::Vector2d center_px = contour::centroid(seen.outer->points_um) / kPixelSize_um;
  const double radius_px = contour::arc_length(seen.outer->points_um) / (2.0 * M_PI * kPixelSize_um);
  std::printf("vesicle at %.1f %.1f px, radius %.1f px, confidence %.2f\n", center_px.x(), center_px.y(), radius_px,
              seen.confidence);
  EXPECT_NEAR(center_px.x(), 122.0, 4.0);
  EXPECT_NEAR(center_px.y(), 231.0, 1.0);
  // The picture and its three mirrored versions gave 98.0 to 99.1.
  EXPECT_NEAR(radius_px, 98.0, 1.5);
}

TEST(RealImages, ALarvaIsNoRoundCell) {
  cv::VideoCapture video((test::shared_folder() / "real" / "needle" / "zebrafish_larva_poke.mkv").string());
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

TEST(RealImages, ARedCellIsFollowedWhileRoundAndLostNotInvented) {
  int followed = 0;
  cv::VideoCapture video((test::shared_folder() / "real" / "aspiration" / "red_cell_aspiration.mp4").string());
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
    // Round and held at the mouth, until half of it is inside; the mouth is taken in, so that it is never quite sure.
    if (frame >= 135 && frame <= 150) followed += seen.outer && seen.confidence > 0.3 ? 1 : 0;
  }
  EXPECT_GE(followed, 14);
}

}  // namespace
}  // namespace pellucida
