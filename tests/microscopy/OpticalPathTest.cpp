#include "OpticalPath.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "CellPath.h"

namespace pellucida {
namespace {

constexpr double kGrid_um = 0.5;

OpticalPath empty_path(int width, int height) {
  OpticalPath path;
  path.clear({width, height});
  return path;
}

// A cell whose zona lies between two circles, needle along +x of the picture.
MicroscopeCell round_cell(double outer_um, double inner_um, double center_um) {
  constexpr int kPoints = 400;
  MicroscopeCell cell;
  cell.outer_um.resize(2, kPoints);
  cell.angle_rad.resize(kPoints);
  for (int k = 0; k < kPoints; ++k) {
    const double angle = -std::numbers::pi + 2 * std::numbers::pi * k / kPoints;
    cell.angle_rad(k) = angle;
    cell.outer_um.col(k) = Eigen::Vector2d(std::sin(angle), std::cos(angle));
  }
  cell.inner_um = inner_um * cell.outer_um;
  cell.ooplasm_um = cell.inner_um;
  cell.outer_um *= outer_um;
  cell.center_um = {center_um, center_um};
  return cell;
}

TEST(SoftRoot, IsTheRootFarFromZeroAndFadesBelow) {
  const SoftRoot root;
  EXPECT_NEAR(root(100, 1), 10, 1e-3);
  EXPECT_NEAR(root(8, 1), std::sqrt(8), 0.01);
  EXPECT_EQ(root(-10, 1), 0);
  float before = 0;
  for (float u = -5; u < 20; u += 0.01f) {
    EXPECT_GE(root(u, 1), before);
    before = root(u, 1);
  }
}

TEST(OpticalPath, BallIsItsChord) {
  OpticalPath path = empty_path(200, 200);
  add_ball(path, {{50, 50}, 20, 0.02, 0.01}, kGrid_um);
  for (const double r : {0.0, 6.0, 12.0, 18.0}) {
    const double chord_um = 2 * std::sqrt(400 - r * r);
    const int x = static_cast<int>(std::lround((50 + r) / kGrid_um));
    EXPECT_NEAR(path.phase_rad(100, x), 0.02 * kPhase_rad_per_um * chord_um, 0.02) << r;
    EXPECT_NEAR(path.absorbance(100, x), 0.01 * chord_um, 2e-3) << r;
  }
  EXPECT_EQ(path.phase_rad(100, 145), 0);
}

TEST(OpticalPath, NeedleIsGlassLessLumen) {
  MicroscopeScene scene;
  scene.needle_shape = {3.0, 2.0, 6.0, {}};
  scene.needle_shape.look.end = "open";
  scene.needle_shape.look.lumen_ratio = 0.5;
  scene.needle_shape.look.liquid_index = 0.05;
  scene.needle = {{20, 50}, {1, 0}};
  OpticalPath path = empty_path(300, 200);
  add_needle(path, scene, kGrid_um);
  for (const double back : {20.0, 60.0, 100.0}) {
    const double outer = scene.needle_shape.outer_radius_um(back), lumen = scene.needle_shape.lumen_radius_um(back);
    const int x = static_cast<int>(std::lround((20 + back) / kGrid_um));
    const double middle = kPhase_rad_per_um * 2 * (0.14 * (outer - lumen) + 0.05 * lumen);
    EXPECT_NEAR(path.needle_phase_rad(100, x), middle, 0.03 * middle) << back;
    const double side = 0.5 * (outer + lumen),
                 wall = kPhase_rad_per_um * 2 * 0.14 * std::sqrt(outer * outer - side * side);
    EXPECT_NEAR(path.needle_phase_rad(static_cast<int>(std::lround((50 + side) / kGrid_um)), x), wall, 0.25 * wall);
  }
  EXPECT_EQ(path.needle_phase_rad(100, 30), 0);
}

TEST(OpticalPath, BevelledNeedleEndsAtItsTip) {
  NeedleShape shape{3.0, 2.0, 6.0, {}};
  shape.look.end = "bevelled";
  shape.look.spike_um = 2.0;
  EXPECT_EQ(shape.span_um(0).first, shape.span_um(0).second);
  double width = 0;
  for (double back = 0.1; back < 30; back += 0.1) {
    const auto [low, high] = shape.span_um(back);
    EXPECT_GE(high - low + 1e-9, width) << back;
    width = high - low;
  }
  EXPECT_NEAR(width, 2 * shape.outer_radius_um(30), 0.05);
}

TEST(CellPath, RoundCellIsItsChords) {
  Look::Cell look;
  look.zona_index = 0.01;
  look.ooplasm_index = 0.03;
  CellPath cells(look, kGrid_um);
  OpticalPath path = empty_path(300, 300);
  const MicroscopeCell cell = round_cell(50, 40, 75);
  cells.add(path, cell);
  for (const double angle : {0.0, 0.7, 2.0, 4.0})
    for (const double r : {0.0, 20.0, 38.0, 42.0, 48.0}) {
      const double outer = std::sqrt(2500 - r * r), inner = r < 40 ? std::sqrt(1600 - r * r) : 0;
      const double expected = kPhase_rad_per_um * 2 * (0.01 * (outer - inner) + 0.03 * inner);
      const double x = (75 + r * std::cos(angle)) / kGrid_um, y = (75 + r * std::sin(angle)) / kGrid_um;
      EXPECT_NEAR(path.phase_rad(static_cast<int>(std::lround(y)), static_cast<int>(std::lround(x))), expected,
                  0.06 * expected + 0.05)
          << angle << ' ' << r;
    }
  EXPECT_EQ(path.phase_rad(150, 255), 0);
}

// Thickness summed over the picture is the volume, also of a dimpled cell, however it is turned.
TEST(CellPath, KeepsTheVolumeOfADimple) {
  Look::Cell look;
  look.zona_index = look.ooplasm_index = 0.02;
  look.zona_absorption_per_mm = look.ooplasm_absorption_per_mm = 1.0;
  MicroscopeCell cell = round_cell(50, 45, 75);
  for (Contour_um* contour : {&cell.outer_um, &cell.inner_um, &cell.ooplasm_um})
    for (Eigen::Index k = 0; k < contour->cols(); ++k)
      if ((*contour)(1, k) > 0) (*contour)(1, k) -= 40 * std::exp(-std::pow((*contour)(0, k) / 12, 2));
  double volume = 0;  // Pappus, both halves
  const Contour_um& outer = cell.outer_um;
  for (Eigen::Index i = 0, j = outer.cols() - 1; i < outer.cols(); j = i++) {
    const double x = 0.5 * (outer(0, i) + outer(0, j));
    volume += 0.5 * std::numbers::pi * x * std::abs(x) * (outer(1, j) - outer(1, i));
  }
  volume = std::abs(volume);
  for (const double turn : {0.0, 0.4, 2.2}) {
    cell.axis = {std::cos(turn), std::sin(turn)};
    cell.across = {-cell.axis.y(), cell.axis.x()};
    CellPath cells(look, kGrid_um);
    OpticalPath path = empty_path(300, 300);
    cells.add(path, cell);
    const double sum_um3 = cv::sum(path.absorbance)[0] / 1e-3 * kGrid_um * kGrid_um;
    EXPECT_NEAR(sum_um3 / volume, 1, 0.02) << turn;
  }
}

}  // namespace
}  // namespace pellucida
