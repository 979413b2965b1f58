// The classic snake: its forces are its energies' gradients, it finds a ring, and fails as theory says.
#include "pellucida/teaching/KassSnake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// A dark ring of 40 px round (80, 75), 3 px wide.
std::shared_ptr<const SnakeField> ring() {
  Eigen::ArrayXXd energy(150, 160);
  for (Eigen::Index y = 0; y < energy.rows(); ++y) {
    for (Eigen::Index x = 0; x < energy.cols(); ++x) {
      const double off = std::hypot(static_cast<double>(x) - 80.0, static_cast<double>(y) - 75.0) - 40.0;
      energy(y, x) = -std::exp(-off * off / 18.0);
    }
  }
  return std::make_shared<SnakeField>(energy);
}

double mean_radius_px(const KassSnake& snake) {
  return (snake.points_px().colwise() - Eigen::Vector2d(80.0, 75.0)).colwise().norm().mean();
}

void run(KassSnake& snake, int most = 3000) {
  while (snake.state() == SnakeState::kMoving && snake.iteration() < most && snake.step()) {
  }
}

TEST(KassSnake, FindsARingFromOutside) {
  SnakeParameters p;
  p.balloon = 0.0;
  KassSnake snake(p);
  snake.set_field(ring());
  snake.start({83.0, 73.0}, 48.0);
  EXPECT_NEAR(mean_radius_px(snake), 48.0, 0.2);
  run(snake);
  EXPECT_EQ(snake.state(), SnakeState::kConverged);
  EXPECT_GT(snake.iteration(), 10);
  // Stretching draws it a little inside the ring.
  EXPECT_NEAR(mean_radius_px(snake), 40.0, 0.5);
  EXPECT_LT(mean_radius_px(snake), 40.0);
}

TEST(KassSnake, EnergyFallsAndForcesBalance) {
  SnakeParameters p;
  p.gamma = 1.0;
  KassSnake snake(p);
  snake.set_field(ring());
  snake.start({80.0, 75.0}, 30.0);
  double before = snake.energy().total();
  while (snake.state() == SnakeState::kMoving && snake.step()) {
    EXPECT_LE(snake.energy().total(), before + 1e-6) << snake.iteration();
    before = snake.energy().total();
  }
  ASSERT_EQ(snake.state(), SnakeState::kConverged);
  // What is left is the way of the last step times gamma.
  const double left = (snake.internal_force() + snake.external_force()).colwise().norm().maxCoeff();
  EXPECT_LT(left, 1.5 * KassSnake::kStill_px * p.gamma);
}

// Central differences of the energies, on a shape that is no circle.
TEST(KassSnake, ForcesAreMinusTheGradients) {
  SnakeParameters p;
  p.alpha = 0.7;
  p.beta = 1.3;
  p.balloon = 0.2;
  KassSnake snake(p);
  snake.set_field(std::make_shared<SnakeField>(Eigen::ArrayXXd::Zero(150, 160)));
  snake.start({80.0, 75.0}, 50.0);
  EXPECT_EQ(snake.energy().balloon, 0.0);
  const double start_px = std::sqrt(enclosed_area_px2(snake.points_px()) / std::numbers::pi);
  for (int k = 0; k < 3; ++k) snake.step();
  const auto total_at = [&](const Eigen::Matrix2Xd& points) {
    double stretching = 0.0, bending = 0.0;
    const Eigen::Index n = points.cols();
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Vector2d a = points.col(i), b = points.col((i + 1) % n), c = points.col((i + 2) % n);
      stretching += 0.5 * p.alpha * (b - a).squaredNorm();
      bending += 0.5 * p.beta * (a - 2.0 * b + c).squaredNorm();
    }
    const double radius_px = std::sqrt(enclosed_area_px2(points) / std::numbers::pi);
    return stretching + bending - p.balloon * static_cast<double>(n) * (radius_px - start_px);
  };
  EXPECT_NEAR(total_at(snake.points_px()), snake.energy().total(), 1e-9);
  const Eigen::Matrix2Xd force = snake.internal_force() + snake.external_force();
  for (const int i : {0, 17, 60, 119}) {
    for (int k = 0; k < 2; ++k) {
      Eigen::Matrix2Xd plus = snake.points_px(), minus = plus;
      plus(k, i) += 1e-4;
      minus(k, i) -= 1e-4;
      EXPECT_NEAR(force(k, i), -(total_at(plus) - total_at(minus)) / 2e-4, 1e-5) << i << ' ' << k;
    }
  }
}

TEST(KassSnake, WithoutAnImageItCollapsesAndABalloonLeavesThePicture) {
  SnakeParameters p;
  p.alpha = 1.0;
  p.balloon = 0.0;
  KassSnake snake(p);
  EXPECT_FALSE(snake.step()) << "no picture yet";
  snake.set_field(std::make_shared<SnakeField>(Eigen::ArrayXXd::Zero(150, 160)));
  snake.start({80.0, 75.0}, 30.0);
  run(snake, 100000);
  EXPECT_EQ(snake.state(), SnakeState::kCollapsed);
  EXPECT_FALSE(snake.step());
  p.alpha = 0.01;
  p.balloon = 0.2;
  snake.set_parameters(p);
  snake.start({80.0, 75.0}, 30.0);
  EXPECT_EQ(snake.iteration(), 0);
  run(snake, 100000);
  EXPECT_EQ(snake.state(), SnakeState::kLeftPicture);
  EXPECT_GE(snake.points_px().minCoeff(), 0.0);
}

TEST(KassSnake, ASmallGammaStepsOverTheLine) {
  SnakeParameters p;
  p.balloon = 0.0;
  p.gamma = 0.02;
  KassSnake hasty(p);
  hasty.set_field(ring());
  hasty.start({80.0, 75.0}, 44.0);
  run(hasty, 500);
  EXPECT_EQ(hasty.state(), SnakeState::kMoving) << "an explicit force above its limit never comes to rest";
}

TEST(KassSnake, ParametersOutOfRangeAreRefusedWhole) {
  KassSnake snake;
  SnakeParameters p;
  p.gamma = 0.0;
  EXPECT_THROW(snake.set_parameters(p), UsageError);
  EXPECT_EQ(snake.parameters().gamma, SnakeParameters().gamma);
  p = {};
  p.attraction = "light";
  EXPECT_THROW(snake.set_parameters(p), UsageError);
}

}  // namespace
}  // namespace pellucida
