#include "pellucida/pipeline/Distribution.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

TEST(Distribution, OrderStatistics) {
  Distribution d;
  for (int i = 100; i >= 1; --i) d.add(i);
  EXPECT_DOUBLE_EQ(d.quantile(0.5), 50.0);
  EXPECT_DOUBLE_EQ(d.quantile(0.99), 99.0);
  EXPECT_DOUBLE_EQ(d.quantile(0.0), 1.0);
  EXPECT_DOUBLE_EQ(d.max(), 100.0);
  EXPECT_DOUBLE_EQ(d.mean(), 50.5);
  Distribution both;
  both.add(d);
  both.add(1000.0);
  EXPECT_EQ(both.count(), 101U);
  EXPECT_DOUBLE_EQ(both.max(), 1000.0);
}

TEST(Distribution, NothingMeasuredIsZero) {
  EXPECT_DOUBLE_EQ(Distribution().quantile(0.5), 0.0);
  EXPECT_DOUBLE_EQ(Distribution().mean(), 0.0);
}

}  // namespace
}  // namespace pellucida
