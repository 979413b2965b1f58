#include "pellucida/core/ManipulatorTrack.h"

#include <gtest/gtest.h>

#include <limits>

#include "pellucida/core/Measurement.h"

namespace pellucida {
namespace {

const Eigen::Vector2d kStill = Eigen::Vector2d::Zero();

TEST(ManipulatorTrack, LiesOnTheLineBetweenTwoReports) {
  ManipulatorTrack track;
  EXPECT_FALSE(track.at(0.0));
  track.add(1.0, {10.0, -4.0}, kStill);
  track.add(1.1, {12.0, -4.5}, kStill);
  const auto place = track.at(1.025);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x(), 10.5, 1e-9);
  EXPECT_NEAR(place->y(), -4.125, 1e-9);
  EXPECT_FALSE(track.at(0.99)) << "before the first report";
}

TEST(ManipulatorTrack, GoesOnByItsVelocityForAShortTimeOnly) {
  ManipulatorTrack track;
  track.add(2.0, {5.0, 5.0}, {100.0, 0.0});
  const auto place = track.at(2.03);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x(), 8.0, 1e-9);
  EXPECT_FALSE(track.at(2.06));
}

TEST(ManipulatorTrack, SaysNothingAcrossAGapOrOfNumbersThatAreNone) {
  ManipulatorTrack track;
  track.add(0.0, {0.0, 0.0}, kStill);
  track.add(1.0, {9.0, 0.0}, kStill);
  EXPECT_FALSE(track.at(0.5)) << "it was lost in between";
  track.add(1.1, {std::numeric_limits<double>::quiet_NaN(), 0.0}, kStill);
  track.add(0.9, {50.0, 0.0}, kStill);
  EXPECT_EQ(*track.at(1.0), Eigen::Vector2d(9.0, 0.0));
}

TEST(ManipulatorTrack, KeepsAsManyReportsAsItHasRoomFor) {
  ManipulatorTrack track;
  for (int k = 0; k <= 1000; ++k) track.add(0.01 * k, {0.1 * k, 0.0}, kStill);
  EXPECT_NEAR(track.at(9.005)->x(), 90.05, 1e-9);
  EXPECT_FALSE(track.at(5.0)) << "too long ago";
}

TEST(ManipulatorTrack, ARowKeepsItsPlacesToTheBit) {
  ManipulatorTrack track;
  track.add(0.0, {1234.56789, -0.0123456789}, {17.0 / 3.0, 1.0 / 7.0});
  Measurement row;
  const auto place = track.at(0.0123);
  ASSERT_TRUE(place);
  row.manipulator_x_um = place->x();
  row.manipulator_y_um = place->y();
  const Measurement read = measurement_from_csv(to_csv(row));
  EXPECT_EQ(read.manipulator_x_um, place->x());
  EXPECT_EQ(read.manipulator_y_um, place->y());
}

}  // namespace
}  // namespace pellucida
