#include "SteadyDrift.h"

#include <gtest/gtest.h>

#include <random>

namespace pellucida {
namespace {

const Eigen::Vector2d kStart(300.0, 200.0), kVelocity(0.3, -0.2);

// After `frames` frames of a drift, each place off by `noise_px`.
SteadyDrift learnt(int frames, double noise_px, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise;
  SteadyDrift drift;
  for (int k = 0; k < frames; ++k) {
    drift.advance(Eigen::Vector2d::Zero());
    drift.learn(kStart + k * kVelocity + noise_px * Eigen::Vector2d(noise(random), noise(random)));
  }
  return drift;
}

TEST(SteadyDrift, GoesOnAlongTheLineAndTakesAJumpWithIt) {
  SteadyDrift drift = learnt(10, 0.0);
  const Eigen::Vector2d jump(5.0, 7.0);
  for (int k = 0; k < 30; ++k) drift.advance(k == 4 ? jump : Eigen::Vector2d::Zero());
  EXPECT_LT((drift.place() - kStart - 39.0 * kVelocity - jump).norm(), 1e-9);
}

TEST(SteadyDrift, SaysHowFarItsPlaceIsOff) {
  for (const int frames : {4, 10, 40}) {
    double squares = 0.0, sigma_px = 0.0;
    constexpr int kRuns = 200, kAhead = 20;
    for (unsigned seed = 1; seed <= kRuns; ++seed) {
      SteadyDrift drift = learnt(frames, 0.15, seed);
      for (int k = 0; k < kAhead; ++k) drift.advance(Eigen::Vector2d::Zero());
      squares += (drift.place() - kStart - (frames - 1 + kAhead) * kVelocity).squaredNorm() / (2.0 * kRuns);
      sigma_px = drift.sigma_px();
    }
    EXPECT_LT(std::sqrt(squares), 1.2 * sigma_px) << frames;
    EXPECT_GT(std::sqrt(squares), 0.1 * sigma_px) << frames;
  }
}

TEST(SteadyDrift, OfNoFrameKnowsNothing) {
  EXPECT_GT(SteadyDrift().sigma_px(), 100.0);
  EXPECT_LT(learnt(1, 0.0).sigma_px(), 1.0);
}

}  // namespace
}  // namespace pellucida
