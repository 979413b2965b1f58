#include "pellucida/haptics/ForceGuards.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pellucida/haptics/LimitLog.h"
#include "pellucida/haptics/TipHistory.h"

namespace pellucida {
namespace {

using Vector = Eigen::Vector3d;

TEST(ForceGuards, OneNumberThatIsNotFiniteIsEnough) {
  EXPECT_TRUE(is_finite(Vector(1.0, -2.0, 0.0)));
  EXPECT_FALSE(is_finite(Vector(1.0, std::numeric_limits<double>::quiet_NaN(), 0.0)));
  EXPECT_FALSE(is_finite(Vector(std::numeric_limits<double>::infinity(), 0.0, 0.0)));
}

TEST(ForceGuards, LowPassHasTheDelayItPromises) {
  // On a ramp a first-order low-pass lags by its time constant.
  constexpr double kCutoff_Hz = 50.0, kDt_s = 1e-3;
  Vector filtered = Vector::Zero();
  double time_s = 0.0;
  for (int k = 0; k < 500; ++k) {
    time_s += kDt_s;
    filtered = low_pass(filtered, Vector(time_s, 0.0, 0.0), kCutoff_Hz, kDt_s);
  }
  EXPECT_NEAR(time_s - filtered.x(), 1.0 / (2.0 * M_PI * kCutoff_Hz), 1e-6);
}

TEST(ForceGuards, ChangeAndLengthAreLimitedWithoutTurning) {
  const Vector from(1.0, 0.0, 0.0), to(1.0, 3.0, 4.0);
  EXPECT_EQ(limit_change(from, to, 10.0), to);
  EXPECT_LT((limit_change(from, to, 1.0) - Vector(1.0, 0.6, 0.8)).norm(), 1e-12);
  EXPECT_LT((saturate(Vector(3.0, 4.0, 0.0), 1.0) - Vector(0.6, 0.8, 0.0)).norm(), 1e-12);
  EXPECT_EQ(saturate(Vector(3.0, 4.0, 0.0), 0.0), Vector(0.0, 0.0, 0.0));
}

TEST(ForceGuards, RampsTakeTheirTime) {
  Ramp ramp(1.0);
  for (int k = 0; k < 4; ++k) ramp.step(0.0, 0.005, 1e-3);
  EXPECT_NEAR(ramp.value(), 0.2, 1e-12);
  ramp.step(0.0, 0.005, 1e-3);
  EXPECT_NEAR(ramp.value(), 0.0, 1e-12);
  EXPECT_EQ(ramp.step(1.0, 0.0, 1e-3), 1.0);
}

TEST(TipHistory, InterpolatesAndKeepsTheLastSecond) {
  TipHistory history;
  EXPECT_EQ(history.at(1.0), Vector(0.0, 0.0, 0.0));
  for (int k = 0; k <= 5000; ++k) history.add(1e-3 * k, Vector(k, -2.0 * k, 0.0));
  EXPECT_LT((history.at(4.5005) - Vector(4500.5, -9001.0, 0.0)).norm(), 1e-6);
  EXPECT_EQ(history.at(9.0).x(), 5000.0);
  EXPECT_NEAR(history.at(0.0).x(), 5000.0 - 1023.0, 1e-9) << "the oldest kept";
  history.add(4.0, Vector::Zero());
  EXPECT_EQ(history.at(9.0).x(), 5000.0) << "a place before the newest is ignored";
}

TEST(LimitLog, FlickeringIsOneEventAndItsEnd) {
  LimitLog log;
  int begun = 0, ended = 0;
  for (int k = 0; k < 1000; ++k) {
    const bool acts = k < 400 && k % 2 == 0;
    log.note(LimitKind::kForce, 21.0, 20.0);
    const auto changes = log.update(1e-3 * k, acts ? limit_bit(LimitKind::kForce) : 0);
    for (std::size_t i = 0; i < changes.count; ++i) {
      EXPECT_EQ(changes.events[i].kind, LimitKind::kForce);
      EXPECT_EQ(changes.events[i].value, 21.0);
      ++(changes.events[i].begun ? begun : ended);
    }
  }
  EXPECT_EQ(begun, 1);
  EXPECT_EQ(ended, 1);
}

TEST(LimitLog, EveryKindHasAWordOfItsOwn) {
  for (std::size_t a = 0; a < LimitLog::kKindCount; ++a) {
    EXPECT_NE(to_string(static_cast<LimitKind>(a)), "unknown");
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_NE(to_string(static_cast<LimitKind>(a)), to_string(static_cast<LimitKind>(b)));
    }
  }
}

}  // namespace
}  // namespace pellucida
