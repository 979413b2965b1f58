#include "Meridian.h"

#include <gtest/gtest.h>

#include <limits>

#include "reconstruction/TestContours.h"

namespace pellucida {
namespace {

const Eigen::Vector2d kCutCenter_um(100.0, 80.0);
const Eigen::Vector2d kAxis(0.6, -0.8);

TEST(Meridian, FractionsRunFromZeroToOneAndAreDenserAtTheNeedle) {
  const auto s = graded_fractions(11, 0.4);
  EXPECT_DOUBLE_EQ(s[0], 0.0);
  EXPECT_DOUBLE_EQ(s[10], 1.0);
  for (int i = 1; i < 10; ++i) EXPECT_GT(s[i + 1] - s[i], s[i] - s[i - 1]);
}

TEST(Meridian, ACircleGivesTwoEqualHalfCircles) {
  const auto contour_um = test::ellipse(720, kCutCenter_um, kAxis, 50.0, 50.0);
  const auto pair = cut_meridians(contour_um, kCutCenter_um, kAxis, graded_fractions(33, 1.0));
  ASSERT_TRUE(pair);
  for (int j = 0; j < 33; ++j) {
    const double polar_rad = std::numbers::pi * j / 32;
    EXPECT_NEAR(pair->positive(0, j), 50.0 * std::cos(polar_rad), 9e-4);
    EXPECT_NEAR(pair->positive(1, j), 50.0 * std::sin(polar_rad), 9e-4);
    EXPECT_NEAR(pair->negative(1, j), 50.0 * std::sin(polar_rad), 9e-4);
  }
}

TEST(Meridian, StartPointAndSenseDoNotMatter) {
  const auto contour_um = test::ellipse(200, kCutCenter_um, kAxis, 40.0, 55.0);
  const auto fractions = graded_fractions(21, 0.4);
  const auto reference = cut_meridians(contour_um, kCutCenter_um, kAxis, fractions);
  ASSERT_TRUE(reference);
  for (const int shift : {1, 57, 133}) {
    Contour_um turned(2, 200);
    for (int i = 0; i < 200; ++i) turned.col(i) = contour_um.col((i + shift) % 200);
    const Contour_um reversed = turned.rowwise().reverse();
    for (const auto& variant : {turned, reversed}) {
      const auto pair = cut_meridians(variant, kCutCenter_um, kAxis, fractions);
      ASSERT_TRUE(pair);
      EXPECT_LT((pair->positive - reference->positive).cwiseAbs().maxCoeff(), 1e-9);
      EXPECT_LT((pair->negative - reference->negative).cwiseAbs().maxCoeff(), 1e-9);
    }
  }
}

TEST(Meridian, DegenerateContoursAreRefusedWithAReason) {
  const auto fractions = graded_fractions(9, 1.0);
  const auto contour_um = test::ellipse(100, kCutCenter_um, kAxis, 50.0, 50.0);
  EXPECT_FALSE(cut_meridians(contour_um, {500.0, 80.0}, kAxis, fractions));
  // On the axis, but beyond the contour: it holds no part of this cell.
  EXPECT_FALSE(cut_meridians(contour_um, kCutCenter_um + 60.0 * kAxis, kAxis, fractions));
  EXPECT_FALSE(cut_meridians(contour_um, kCutCenter_um - 60.0 * kAxis, kAxis, fractions));
  EXPECT_FALSE(cut_meridians(contour_um.leftCols(5), kCutCenter_um, kAxis, fractions));
  Contour_um broken = contour_um;
  broken(0, 3) = std::numeric_limits<double>::quiet_NaN();
  const auto result = cut_meridians(broken, kCutCenter_um, kAxis, fractions);
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().find("finite"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
