#include "pellucida/charts/Curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

Curve hills(int count) {
  Curve curve;
  for (int i = 0; i < count; ++i) curve.add(i, i == 777 ? 50.0 : std::sin(0.01 * i), -2.0, 60.0);
  return curve;
}

double greatest(const Curve& curve) {
  double value = -1e9;
  for (const double y : curve.y) value = std::fmax(value, y);
  return value;
}

TEST(Curve, AShortOneStaysAsItIs) {
  const Curve curve = hills(100);
  EXPECT_EQ(thinned(curve, 100).y, curve.y);
}

TEST(Curve, AThinOneKeepsPeaksEndsAndOrder) {
  const Curve curve = hills(20000);
  const Curve thin = thinned(curve, 500);
  EXPECT_LE(thin.size(), 600U);
  EXPECT_GT(thin.size(), 100U);
  EXPECT_EQ(greatest(thin), 50.0);
  EXPECT_EQ(thin.x.front(), 0.0);
  EXPECT_GT(thin.x.back(), 19800.0);
  EXPECT_TRUE(is_ascending(thin));
  EXPECT_EQ(thin.lower.size(), thin.size());
}

TEST(Curve, AGapIsKeptOnceWherePointsAreJoinedOtherwise) {
  Curve curve;
  curve.add_gap();
  EXPECT_TRUE(curve.empty());
  for (int i = 0; i < 5000; ++i) {
    if (i == 2500) {
      curve.add_gap();
      curve.add_gap();
    }
    curve.add(i, 1.0);
  }
  const Curve thin = thinned(curve, 300);
  EXPECT_EQ(std::count_if(thin.y.begin(), thin.y.end(), [](double y) { return std::isnan(y); }), 1);
}

TEST(Curve, TheBandOfACurveThatTurnsBackIsThatOfTheWayIn) {
  Curve curve;
  for (int i = 0; i <= 100; ++i) curve.add(i, i, i - 1.0, i + 1.0);
  for (int i = 100; i >= 0; --i) curve.add(i, 0.5 * i, 0.5 * i - 1.0, 0.5 * i + 1.0);
  EXPECT_FALSE(is_ascending(curve));
  // A hold: it trembles, and goes on.
  for (const double x : {100.0, 99.8, 100.1, 99.9, 103.0}) curve.add(x, 90.0, 80.0, 95.0);
  curve.add_gap();
  const Curve band = band_of_way_in(curve);
  ASSERT_EQ(band.size(), 103U);
  EXPECT_TRUE(is_ascending(band));
  EXPECT_DOUBLE_EQ(band.lower[60], 59.0);
  EXPECT_DOUBLE_EQ(band.upper[60], 61.0);
  EXPECT_DOUBLE_EQ(band.x[101], 100.1);
  EXPECT_DOUBLE_EQ(band.lower[102], 80.0);
  const std::vector<double> depths{1.0, std::nan(""), 0.5, 2.0, 2.0};
  EXPECT_EQ(way_in(depths), (std::vector<std::size_t>{0, 3}));
}

TEST(Curve, AnIntervalThatIsUnknownIsTheCurveItself) {
  Curve curve;
  curve.add(1.0, 2.0, std::nan(""), 3.0);
  EXPECT_EQ(curve.lower[0], 2.0);
  EXPECT_EQ(curve.upper[0], 3.0);
}

}  // namespace
}  // namespace pellucida
