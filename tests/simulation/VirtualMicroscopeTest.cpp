#include "pellucida/simulation/VirtualMicroscope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "pellucida/core_vtk/SceneData.h"
#include "simulation/SectionChecks.h"
#include "simulation/TestScenes.h"

namespace pellucida {
namespace {

using test::scenario_of;

using test::bytes_of;

std::vector<std::vector<std::uint8_t>> all_frames(VirtualMicroscope& microscope) {
  std::vector<std::vector<std::uint8_t>> frames;
  while (const auto frame = microscope.next()) frames.push_back(bytes_of(*frame));
  return frames;
}

const char* const kShort = R"("image": {"frame_rate_hz": 2})";

TEST(VirtualMicroscope, SameSeedSameBytes) {
  VirtualMicroscope a(scenario_of(std::string("{\"seed\": 5, ") + kShort + "}"));
  VirtualMicroscope b(scenario_of(std::string("{\"seed\": 5, ") + kShort + "}"));
  VirtualMicroscope c(scenario_of(std::string("{\"seed\": 6, ") + kShort + "}"));
  const auto first = all_frames(a);
  EXPECT_GE(first.size(), 8u);
  EXPECT_EQ(first, all_frames(b));
  EXPECT_NE(first, all_frames(c));

  // Once more from the beginning.
  EXPECT_FALSE(a.next().has_value());
  EXPECT_TRUE(a.restart());
  EXPECT_EQ(first, all_frames(a));
}

TEST(VirtualMicroscope, FramesAreStampedAndCounted) {
  VirtualMicroscope microscope(scenario_of(R"({"image": {"duration_s": 0.5, "frame_rate_hz": 20, "bit_depth": 16}})"));
  EXPECT_EQ(*microscope.info().frame_count, 10);
  long index = 0;
  while (const auto frame = microscope.next()) {
    EXPECT_EQ(frame->frame_index, index);
    EXPECT_NEAR(frame->time_s, index / 20.0, 1e-12);
    EXPECT_EQ(frame->gap_count, 0);
    EXPECT_EQ(stamped_frame_index(frame->image.get()), index);
    const ImageView view = view_of(frame->image.get());
    EXPECT_EQ(view.format, PixelFormat::kGray16);
    EXPECT_EQ(view.width_px, 728);
    EXPECT_NEAR(view.pixel_size_um, 0.825, 1e-12);
    EXPECT_EQ(microscope.truth().observation.frame_index, index);
    ++index;
  }
  EXPECT_EQ(index, 10);
}

TEST(VirtualMicroscope, NoiseIsShotAndReadNoise) {
  // The same frame with and without noise: deviation as the electrons say, mean kept.
  const std::string head =
      R"({"image": {"duration_s": 0.05, "bit_depth": 16}, "optics": {"full_well_electrons": 4000, )";
  VirtualMicroscope noisy(scenario_of(head + R"("read_noise_electrons": 20}})"));
  VirtualMicroscope clean(scenario_of(head + R"("noise": false}})"));
  const auto a = *noisy.next(), b = *clean.next();
  const ImageView va = view_of(a.image.get()), vb = view_of(b.image.get());
  const auto *pa = static_cast<const std::uint16_t*>(va.data), *pb = static_cast<const std::uint16_t*>(vb.data);
  const long count = va.width_px * va.height_px;
  double sum = 0, normalised = 0;
  for (long i = 0; i < count; ++i) {
    const double electrons = pb[i] / 65535.0 * 4000, difference = (pa[i] - pb[i]) / 65535.0 * 4000;
    sum += difference;
    normalised += difference * difference / (electrons + 400);
  }
  EXPECT_NEAR(sum / static_cast<double>(count), 0.0, 0.25);
  EXPECT_NEAR(normalised / static_cast<double>(count), 1.0, 0.005);
}

// Grey value at a place in um, by cubic interpolation (Catmull and Rom's): bilinear values would draw the darkest place
// to the pixel grid.
double grey(const ImageView& view, const Eigen::Vector2d& point_um) {
  const double x = point_um.x() / view.pixel_size_um, y = point_um.y() / view.pixel_size_um;
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  auto weights = [](double t) {
    return std::array{(-t + 2 * t * t - t * t * t) / 2, (2 - 5 * t * t + 3 * t * t * t) / 2,
                      (t + 4 * t * t - 3 * t * t * t) / 2, (-t * t + t * t * t) / 2};
  };
  const auto wx = weights(x - i), wy = weights(y - j);
  double sum = 0;
  for (int b = 0; b < 4; ++b)
    for (int a = 0; a < 4; ++a) {
      const int column = std::clamp(i - 1 + a, 0, view.width_px - 1),
                row = std::clamp(j - 1 + b, 0, view.height_px - 1);
      sum += wx[static_cast<std::size_t>(a)] * wy[static_cast<std::size_t>(b)] *
             static_cast<const std::uint16_t*>(view.data)[static_cast<long>(row) * view.width_px + column];
    }
  return sum;
}

// How far the darkest place along the normal lies from the true contour, um; signed, positive outwards.
std::vector<double> line_offsets(const ImageView& view, const Contour_um& contour, const Observation& seen) {
  std::vector<double> offsets;
  const Eigen::Index n = contour.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d point = contour.col(i);
    // The tools' own lines cross here.
    if (std::abs(test::cross(point - seen.needle->tip_um, seen.needle->direction)) < 14 &&
        (point - seen.center_um).dot(seen.axis) > 0)
      continue;
    if ((point - seen.center_um).dot(seen.holder->direction) > 30) continue;
    const Eigen::Vector2d tangent = (contour.col((i + 1) % n) - contour.col((i + n - 1) % n)).normalized();
    const Eigen::Vector2d normal(tangent.y(), -tangent.x());

    double best = 0, darkest = 1e9;
    for (double s = -2.0; s <= 2.0; s += 0.02) {
      const double value = grey(view, point + s * normal);
      if (value < darkest) {
        darkest = value;
        best = s;
      }
    }
    offsets.push_back(best);
  }
  return offsets;
}

struct Scene {
  const char* name;
  const char* json;
};

void PrintTo(const Scene& scene, std::ostream* out) {
  *out << scene.name;
}

class ImageAndTruth : public testing::TestWithParam<Scene> {};

TEST_P(ImageAndTruth, DarkestLineLiesAtTheTrueContour) {
  VirtualMicroscope microscope(scenario_of(GetParam().json));
  int checked = 0;
  while (const auto frame = microscope.next()) {
    const ImageView view = view_of(frame->image.get());
    const Observation& seen = microscope.truth().observation;
    for (const auto* contour : {&seen.outer, &seen.inner}) {
      const auto offsets = line_offsets(view, (*contour)->points_um, seen);
      ASSERT_GT(offsets.size(), 50u);
      double sum = 0, square = 0, worst = 0;
      for (double offset : offsets) {
        sum += offset;
        square += offset * offset;
        worst = std::max(worst, std::abs(offset));
      }
      // 0.25 um are 0.3 px of the default camera.
      const double count = static_cast<double>(offsets.size());
      EXPECT_LE(std::abs(sum / count), 0.03) << "um, frame " << frame->frame_index;
      EXPECT_LE(std::sqrt(square / count), 0.08) << "um, frame " << frame->frame_index;
      EXPECT_LE(worst, 0.25) << "um, frame " << frame->frame_index;
      ++checked;
    }
  }
  EXPECT_GE(checked, 10);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, ImageAndTruth,
    testing::Values(
        Scene{
            "plain",
            R"({"image": {"frame_rate_hz": 2, "bit_depth": 16}, "optics": {"noise": false}, "debris": {"count": 0}})"},
        Scene{"turned",
              R"({"image": {"frame_rate_hz": 2, "bit_depth": 16}, "tools": {"holder_angle_deg": 37, "configuration": 2},
                            "drift": {"x_um_per_s": 3}, "optics": {"noise": false}, "debris": {"count": 0}})"},
        Scene{"rotating",
              R"({"image": {"frame_rate_hz": 2, "bit_depth": 16}, "tools": {"configuration": 3},
                            "drift": {"rotation_deg_per_s": 13, "x_um_per_s": -4, "jump_x_px": 17.3, "jump_y_px": -9, "jump_period_s": 1.1},
                            "lamp": {"step_ratio": 0.7}, "optics": {"noise": false}, "debris": {"count": 0}})"},
        Scene{"fine", R"({"image": {"frame_rate_hz": 2, "bit_depth": 16, "pixel_size_um": 0.3},
                          "cell": {"center_x_um": 110, "center_y_um": 62}, "tools": {"configuration": 3},
                          "optics": {"noise": false}, "debris": {"count": 0}})"}),
    [](const auto& which) { return which.param.name; });

TEST(VirtualMicroscope, TurnedImageIsTheTurnedImage) {
  // A quarter turn of the whole scene, without what stays fixed in the image (light, relief): pixel for pixel,
  // transposed.
  const std::string optics =
      R"("optics": {"noise": false, "gradient_ratio": 0, "vignette_ratio": 0, "relief": 0}, "debris": {"count": 0})";
  const std::string image =
      R"("image": {"width_px": 401, "height_px": 401, "pixel_size_um": 0.825, "bit_depth": 16, "frame_rate_hz": 1})";
  const std::string cell = R"("cell": {"center_x_um": 165, "center_y_um": 165})";
  VirtualMicroscope a(scenario_of("{" + image + "," + cell + "," + optics +
                                  R"(, "tools": {"holder_angle_deg": 0, "configuration": 3}})"));
  VirtualMicroscope b(scenario_of("{" + image + "," + cell + "," + optics +
                                  R"(, "tools": {"holder_angle_deg": 90, "configuration": 3}})"));
  while (const auto one = a.next()) {
    const auto two = b.next();
    ASSERT_TRUE(two.has_value());
    const ImageView va = view_of(one->image.get()), vb = view_of(two->image.get());
    const auto *pa = static_cast<const std::uint16_t*>(va.data), *pb = static_cast<const std::uint16_t*>(vb.data);
    // (x, y) about the centre goes to (-y, x).
    int largest = 0;
    for (int y = 0; y < 401; ++y)
      for (int x = 0; x < 401; ++x) largest = std::max(largest, std::abs(pa[y * 401 + x] - pb[x * 401 + (400 - y)]));
    EXPECT_LE(largest, 655) << "frame " << one->frame_index;  // 1 % of full scale
  }
}

TEST(VirtualMicroscope, KeysLeftOutDrawNothing) {
  // Every one of these changes the picture; none of them is in a scenario that does not name it.
  const auto first_frame = [](const std::string& json) {
    VirtualMicroscope microscope(scenario_of(json));
    for (int k = 0; k < 40; ++k) microscope.skip();
    return bytes_of(*microscope.next());
  };
  const auto plain = first_frame("{}");
  for (const char* changed :
       {R"({"drift": {"rotation_deg_per_s": 5}})", R"({"drift": {"jump_x_px": 10}})",
        R"({"lamp": {"step_ratio": 0.9}})", R"({"lamp": {"flicker_ratio": 0.1, "flicker_hz": 0.7}})",
        R"({"debris": {"touching_count": 3}})", R"({"debris": {"passing_count": 8}})",
        R"({"bystander": {"cell_radius_um": 40}})", R"({"bystander": {"bubble_radius_um": 30}})"})
    EXPECT_NE(plain, first_frame(changed)) << changed;
  EXPECT_EQ(plain, first_frame(R"({"drift": {"jump_period_s": 0.2}, "lamp": {"step_time_s": 0.1, "flicker_hz": 9},
      "debris": {"touching_radius_um": 5, "passing_speed_um_per_s": 10},
      "bystander": {"cell_x_um": 200, "bubble_y_um": 200}})"));
}

TEST(VirtualMicroscope, SkippedFramesAreThoseNotDrawn) {
  VirtualMicroscope all(scenario_of(std::string("{") + kShort + "}")),
      some(scenario_of(std::string("{") + kShort + "}"));
  const auto frames = all_frames(all);
  std::size_t k = 1;
  while (some.skip()) {
    const auto frame = some.next();
    if (!frame) break;
    EXPECT_EQ(frame->frame_index, static_cast<long>(k));
    EXPECT_EQ(bytes_of(*frame), frames.at(k));
    k += 2;
  }
  EXPECT_GE(k, frames.size() - 1);
}

TEST(VirtualMicroscope, ToolsAreDrawnWhereTruthSaysThem) {
  VirtualMicroscope microscope(scenario_of(
      R"({"image": {"frame_rate_hz": 4, "bit_depth": 16}, "optics": {"noise": false}, "debris": {"count": 0}})"));
  while (const auto frame = microscope.next()) {
    const ImageView view = view_of(frame->image.get());
    const auto& needle = *microscope.truth().observation.needle;
    // Along both flanks the outline is darker than the glass's core and the field outside.
    const Eigen::Vector2d across(-needle.direction.y(), needle.direction.x());
    for (Eigen::Index i = 1; i < needle.outline_um.cols(); ++i) {
      const Eigen::Vector2d point = needle.outline_um.col(i);
      const double back = (needle.tip_um - point).dot(needle.direction), side = (point - needle.tip_um).dot(across);
      if (back < 60 || back > 150) continue;
      const Eigen::Vector2d out = side > 0 ? across : Eigen::Vector2d(-across);
      EXPECT_LT(grey(view, point), 0.85 * grey(view, point + 5 * out));
      EXPECT_LT(grey(view, point), 0.85 * grey(view, point - 3 * out));
    }
  }
}

TEST(VirtualMicroscope, CellPartlyOutsideTheImageIsStillDrawn) {
  for (const char* center :
       {R"("center_x_um": 0)", R"("center_x_um": 600)", R"("center_y_um": -30)", R"("center_y_um": 5000)"}) {
    VirtualMicroscope microscope(
        scenario_of(std::string(R"({"image": {"frame_rate_hz": 1}, "cell": {)") + center + "}}"));
    EXPECT_EQ(all_frames(microscope).size(), static_cast<std::size_t>(*microscope.info().frame_count));
  }
}

}  // namespace
}  // namespace pellucida
