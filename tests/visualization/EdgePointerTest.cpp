#include "pellucida/visualization/EdgePointer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pellucida {
namespace {

TEST(EdgePointer, IsThereOnlyForWhatLiesOutside) {
  EXPECT_FALSE(edge_pointer({10.0, 10.0}, 200.0, 100.0, 14.0));
  EXPECT_FALSE(edge_pointer({200.0, 100.0}, 200.0, 100.0, 14.0));
  EXPECT_TRUE(edge_pointer({201.0, 50.0}, 200.0, 100.0, 14.0));
}

TEST(EdgePointer, PointsFromTheMiddleAndMeasuresFromTheEdge) {
  const auto right = edge_pointer({260.0, 50.0}, 200.0, 100.0, 14.0);
  ASSERT_TRUE(right);
  EXPECT_NEAR((right->direction - Eigen::Vector2d(1.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(right->at.x(), 186.0, 1e-9);
  EXPECT_NEAR(right->at.y(), 50.0, 1e-9);
  EXPECT_NEAR(right->beyond, 60.0, 1e-9);
  const auto below = edge_pointer({100.0, -30.0}, 200.0, 100.0, 14.0);
  ASSERT_TRUE(below);
  EXPECT_NEAR(below->at.y(), 14.0, 1e-9);
  EXPECT_NEAR(below->beyond, 30.0, 1e-9);
}

TEST(EdgePointer, StaysInsideInEveryDirection) {
  for (int k = 0; k < 72; ++k) {
    const double angle = k * 0.0873;
    const auto pointer = edge_pointer(Eigen::Vector2d(100.0 + 500.0 * std::cos(angle), 50.0 + 500.0 * std::sin(angle)),
                                      200.0, 100.0, 14.0);
    ASSERT_TRUE(pointer);
    EXPECT_GE(pointer->at.x(), 14.0 - 1e-9);
    EXPECT_LE(pointer->at.x(), 186.0 + 1e-9);
    EXPECT_GE(pointer->at.y(), 14.0 - 1e-9);
    EXPECT_LE(pointer->at.y(), 86.0 + 1e-9);
    EXPECT_GT(pointer->beyond, 0.0);
  }
}

}  // namespace
}  // namespace pellucida
