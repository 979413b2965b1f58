#include "pellucida/operation/LimitDigest.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

TEST(LimitDigest, ALimitThatActsOnceHasABeginningAndAnEnd) {
  LimitDigest digest;
  digest.add({.time_s = 2.0, .kind = LimitKind::kDepth, .begun = true, .value = 46.1, .limit = 46.0});
  auto rows = digest.take(2.0, 0.5);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_DOUBLE_EQ(rows[0].time_s, 1.5);
  EXPECT_EQ(rows[0].kind, "limit");
  EXPECT_EQ(rows[0].detail, "depth: 46.1 um, limit 46 um");
  EXPECT_TRUE(digest.take(9.0, 0.5).empty()) << "it acts still";
  digest.add({.time_s = 9.0, .kind = LimitKind::kDepth});
  EXPECT_TRUE(digest.take(9.5, 0.5).empty()) << "it may come back";
  rows = digest.take(10.0, 0.5);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_DOUBLE_EQ(rows[0].time_s, 8.5);
  EXPECT_EQ(rows[0].detail, "depth: over");
}

// A hand that trembles at a limit makes two rows, not a thousand.
TEST(LimitDigest, ALimitThatComesAndGoesIsOneStretch) {
  LimitDigest digest;
  std::vector<Event> rows;
  const auto take = [&](double now_s) {
    for (Event& event : digest.take(now_s, 0.0)) rows.push_back(std::move(event));
  };
  for (int i = 0; i < 500; ++i) {
    const double time_s = 0.01 * i;
    digest.add({.time_s = time_s, .kind = LimitKind::kSpeed, .begun = true, .value = 200.0 + i, .limit = 200.0});
    digest.add({.time_s = time_s + 0.004, .kind = LimitKind::kSpeed});
    take(time_s + 0.004);
  }
  take(10.0);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].detail, "speed: 200 um/s, limit 200 um/s");
  EXPECT_EQ(rows[1].detail, "speed: over, acted 500 times in 4.99 s, at most 699 um/s");
  EXPECT_NEAR(rows[1].time_s, 4.994, 1e-9);
}

TEST(LimitDigest, KindsDoNotMixAndTheEndIsReported) {
  LimitDigest digest;
  digest.add({.time_s = 1.0, .kind = LimitKind::kPassivity, .begun = true});
  digest.add({.time_s = 1.1, .kind = LimitKind::kPuncture, .begun = true});
  digest.add({.time_s = 1.2, .kind = LimitKind::kPuncture});
  EXPECT_EQ(digest.take(1.2, 0.0).size(), 2U);
  const auto rows = digest.finish(0.0);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].detail, "puncture: over");
}

}  // namespace
}  // namespace pellucida
