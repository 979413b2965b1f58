#include "WarningNews.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

TEST(WarningNews, AWarningThatLastsIsReportedOnce) {
  WarningNews news;
  EXPECT_EQ(news.add(kShapeMismatch, 0.0), kShapeMismatch);
  for (int i = 1; i < 600; ++i) EXPECT_EQ(news.add(kShapeMismatch, i / 30.0), kNoForceWarning);
  EXPECT_EQ(news.add(kShapeMismatch | kNeedleSlip, 20.0), kNeedleSlip);
}

// As at the first touch, where contact comes and goes and the shape with it.
TEST(WarningNews, AWarningThatComesAndGoesIsReportedOnce) {
  WarningNews news;
  int reported_count = 0;
  for (int i = 0; i < 600; ++i) reported_count += news.add(i % 3 == 0 ? kShapeMismatch : 0U, i / 30.0) != 0U ? 1 : 0;
  EXPECT_EQ(reported_count, 1);
}

TEST(WarningNews, AfterAQuietTimeItIsNewsAgain) {
  WarningNews news;
  news.add(kNotOfRevolution, 1.0);
  news.add(0U, 3.0);
  EXPECT_EQ(news.add(kNotOfRevolution, 1.1 + WarningNews::kQuiet_s), kNotOfRevolution);
  news.clear();
  EXPECT_EQ(news.add(kNotOfRevolution, 1.2 + WarningNews::kQuiet_s), kNotOfRevolution);
}

}  // namespace
}  // namespace pellucida
