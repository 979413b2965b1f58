// The snakes' own parts against closed forms and dense algebra: the band solver, the edge template, the paths.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <random>

#include "ContourMath.h"
#include "CyclicBandSolver.h"
#include "EdgeProfile.h"
#include "EdgeTemplate.h"
#include "Snake.h"

namespace pellucida {
namespace {

constexpr int kTaps = EdgeTemplate::kTaps;
constexpr int kReach = 6;

TEST(CyclicBandSolver, SolutionAndInverseDiagonalAreThoseOfDenseAlgebra) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  CyclicBandSolver solver;
  for (const int n : {5, 6, 7, 8, 64, 192, 193}) {
    SCOPED_TRACE(n);
    solver.reset(n);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) {
      solver.diagonal()[i] = 4.2 + entry(random);
      solver.next()[i] = entry(random);
      solver.second_next()[i] = 0.5 * entry(random);
      dense(i, i) += solver.diagonal()[i];
      for (const auto& [step, value] : {std::pair{1, solver.next()[i]}, std::pair{2, solver.second_next()[i]}}) {
        dense(i, (i + step) % n) += value;
        dense((i + step) % n, i) += value;
      }
    }
    Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(n, [&] { return entry(random); });
    const Eigen::VectorXd expected = dense.ldlt().solve(x);
    ASSERT_TRUE(solver.factorize());
    solver.solve(x.data());
    EXPECT_LT((x - expected).lpNorm<Eigen::Infinity>(), 1e-12);
    Eigen::VectorXd diagonal(n);
    solver.inverse_diagonal(diagonal.data());
    EXPECT_LT((diagonal - dense.inverse().diagonal()).lpNorm<Eigen::Infinity>(), 1e-12);
  }
}

TEST(CyclicBandSolver, AnIndefiniteMatrixIsRefused) {
  CyclicBandSolver solver;
  solver.reset(12);
  for (int i = 0; i < 12; ++i) {
    solver.diagonal()[i] = 1.0;
    solver.next()[i] = 1.0;
  }
  EXPECT_FALSE(solver.factorize());
}

TEST(Snake, KeepsAShapeWhoseEdgesAreSeen) {
  // Edges seen exactly on a wave of eight points' length: the smoothing must not flatten it.
  const Eigen::Index n = 192;
  Eigen::Matrix2Xd points(2, n), normals;
  Eigen::VectorXd edges(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(n);
    points.col(i) = 61.0 * Eigen::Vector2d(std::cos(t), std::sin(t));
    edges[i] = 0.5 * std::sin(24.0 * t);
  }
  contour::outward_normals(points, normals);
  const Eigen::VectorXd sigma = Eigen::VectorXd::Constant(n, 0.05), rigidity = Eigen::VectorXd::Constant(n, 60.0);
  const Eigen::VectorXd share = Eigen::VectorXd::Constant(n, 0.1);
  Snake snake;
  const Eigen::VectorXd u = snake.relax(points, normals, edges, sigma, rigidity, share, {});
  EXPECT_LT((u - edges).lpNorm<Eigen::Infinity>(), 0.06);
}

TEST(Snake, DeviationIsTheSpreadOfNoisyEdges) {
  const Eigen::Index n = 192;
  Eigen::Matrix2Xd points(2, n), normals;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(n);
    points.col(i) = 61.0 * Eigen::Vector2d(std::cos(t), std::sin(t));
  }
  contour::outward_normals(points, normals);
  const double noise = 0.1;
  const Eigen::VectorXd sigma = Eigen::VectorXd::Constant(n, noise), rigidity = Eigen::VectorXd::Constant(n, 60.0);
  const Eigen::VectorXd share = Eigen::VectorXd::Zero(n);
  std::mt19937 random(9);
  std::normal_distribution<double> normal(0.0, noise);
  Snake snake;
  int covered = 0, count = 0;
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::VectorXd edges = Eigen::VectorXd::NullaryExpr(n, [&] { return normal(random); });
    const Eigen::VectorXd u = snake.relax(points, normals, edges, sigma, rigidity, share, {});
    const Eigen::VectorXd deviation = snake.deviation(edges);
    for (Eigen::Index i = 0; i < n; ++i, ++count) covered += std::abs(u[i]) <= deviation[i] ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(covered) / count, 0.68, 0.06);
}

// The profile across the edge: a line of depth and width, a step beside it, a halo.
struct Edge {
  double depth, width, step, halo;
};

double brightness(const Edge& e, double u) {
  return 0.6 - e.depth * std::exp(-u * u / (2.0 * e.width * e.width)) +
         0.5 * e.step * std::erfc(-(u + 1.9 * e.width) / (e.width * std::sqrt(2.0))) +
         e.halo * std::exp(-std::pow(u - 3.0 * e.width, 2) / (2.0 * e.width * e.width));
}

Eigen::Matrix2Xd all_round(Eigen::Index n) {
  Eigen::Matrix2Xd normals(2, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(n);
    normals.col(i) = Eigen::Vector2d(std::cos(t), std::sin(t));
  }
  return normals;
}

bool learn(EdgeTemplate& look, const Edge& edge, EdgeKind kind) {
  const Eigen::Index n = 96;
  std::vector<float> profiles;
  for (Eigen::Index i = 0; i < n; ++i)
    for (int k = 0; k < kTaps; ++k) profiles.push_back(static_cast<float>(brightness(edge, k - EdgeTemplate::kHalf)));
  return look.learn(profiles.data(), all_round(n), Eigen::VectorXd::Ones(n), kind, 1.0);
}

class EdgeTemplateBias : public testing::TestWithParam<std::pair<Edge, EdgeKind>> {};

TEST_P(EdgeTemplateBias, PlaceIsSubPixelWhateverStandsBesideTheLineAndHoweverBrightItIs) {
  const Edge& edge = GetParam().first;
  const EdgeKind& kind = GetParam().second;
  EdgeTemplate look;
  ASSERT_TRUE(learn(look, edge, kind));
  std::vector<float> profile(kTaps + 2 * kReach);
  const auto place = [&](double shift, double light, double contrast) {
    for (std::size_t k = 0; k < profile.size(); ++k)
      profile[k] = static_cast<float>(
          light *
          (0.6 + contrast * (brightness(edge, static_cast<double>(k) - EdgeTemplate::kHalf - kReach - shift) - 0.6)));
    return look.match(profile.data(), kReach, 3);
  };
  const double zero = double{place(0.0, 1.0, 1.0).place};
  for (double shift = -3.0; shift <= 3.0; shift += 0.13) {
    const EdgeTemplate::Match m = place(shift, 0.7, 0.8);
    ASSERT_TRUE(m.inside) << shift;
    EXPECT_NEAR(m.place - zero, shift, 0.02) << shift;
    EXPECT_NEAR(m.gain, 0.8, 0.12) << shift;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Edges, EdgeTemplateBias,
    testing::Values(std::pair{Edge{0.2, 2.0, 0.0, 0.0}, EdgeKind{1.0, 0.0}},     // dark line
                    std::pair{Edge{-0.2, 2.0, 0.0, 0.0}, EdgeKind{-1.0, 0.0}},   // bright line
                    std::pair{Edge{0.2, 2.0, 0.1, 0.05}, EdgeKind{1.0, 0.0}},    // darker inside, a halo outside
                    std::pair{Edge{0.2, 2.6, -0.1, 0.05}, EdgeKind{1.0, 0.0}},   // blurred, brighter inside
                    std::pair{Edge{0.2, 1.6, 0.1, 0.05}, EdgeKind{1.0, 0.0}}));  // sharper

TEST(EdgeTemplate, CentreOfASymmetricLineIsItsMiddle) {
  EdgeTemplate look;
  ASSERT_TRUE(learn(look, {0.2, 2.0, 0.0, 0.0}, {1.0, 0.0}));
  std::vector<float> profile(kTaps + 2 * kReach);
  for (std::size_t k = 0; k < profile.size(); ++k)
    profile[k] = static_cast<float>(brightness({0.2, 2.0, 0.0, 0.0}, static_cast<double>(k) - 14.0 - 0.3));
  EXPECT_NEAR(look.match(profile.data(), kReach, 0).place, 0.3, 0.012);
  EXPECT_LT(look.center_deviation(0), 1e-9);
  EXPECT_NEAR(look.width(), 2.0, 1e-9);
}

TEST(EdgeTemplate, ALineThatIsTheSameOnBothSidesIsEvenAndAnyOtherIsNot) {
  const auto asymmetry = [](const Edge& edge) {
    EdgeTemplate look;
    EXPECT_TRUE(learn(look, edge, {1.0, 0.0}));
    return look.asymmetry();
  };
  EXPECT_LT(asymmetry({0.2, 2.0, 0.0, 0.0}), 0.01);
  EXPECT_GT(asymmetry({0.2, 2.0, 0.1, 0.0}), 0.2);
  EXPECT_GT(asymmetry({0.2, 2.0, 0.0, 0.1}), 0.2);
}

TEST(EdgeTemplate, SpreadOfPlacesIsAsPredicted) {
  const Edge edge{0.2, 2.0, 0.1, 0.05};
  EdgeTemplate look;
  ASSERT_TRUE(learn(look, edge, {1.0, 0.0}));
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 0.02);
  std::vector<float> profile(kTaps + 2 * kReach);
  double sum = 0.0, squares = 0.0, predicted = 0.0;
  const int trials = 1000;
  for (int t = 0; t < trials; ++t) {
    for (std::size_t k = 0; k < profile.size(); ++k)
      profile[k] = static_cast<float>(brightness(edge, static_cast<double>(k) - 14.0) + noise(random));
    const EdgeTemplate::Match m = look.match(profile.data(), kReach, 0);
    sum += m.place;
    squares += double{m.place} * m.place;
    predicted += 0.02 / m.mean * std::sqrt(look.place_variance(0)) / trials;
  }
  const double spread = std::sqrt(squares / trials - std::pow(sum / trials, 2));
  EXPECT_NEAR(spread / predicted, 1.0, 0.2);
}

TEST(EdgeTemplate, RowsOfAnotherBodyHaveNoSay) {
  // A quarter of the rows show another, stronger edge two samples off.
  const Edge edge{0.2, 2.0, 0.0, 0.0};
  const Eigen::Index n = 96;
  std::vector<float> profiles;
  for (Eigen::Index i = 0; i < n; ++i)
    for (int k = 0; k < kTaps; ++k)
      profiles.push_back(
          static_cast<float>(i % 4 == 0 ? brightness({0.4, 3.0, 0.1, 0.0}, k - 10.0) : brightness(edge, k - 8.0)));
  EdgeTemplate look;
  ASSERT_TRUE(look.learn(profiles.data(), all_round(n), Eigen::VectorXd::Ones(n), {1.0, 0.0}, 1.0));
  std::vector<float> profile(kTaps + 2 * kReach);
  for (std::size_t k = 0; k < profile.size(); ++k)
    profile[k] = static_cast<float>(brightness(edge, static_cast<double>(k) - 14.0));
  EXPECT_NEAR(look.match(profile.data(), kReach, 5).place, 0.0, 1.2e-4);
}

TEST(EdgeTemplate, TooFewRowsTeachNothing) {
  const std::vector<float> profiles(10 * kTaps, 0.5F);
  EdgeTemplate look;
  EXPECT_FALSE(look.learn(profiles.data(), all_round(10), Eigen::VectorXd::Ones(10), {1.0, 0.0}, 1.0));
  EXPECT_FALSE(look.valid());
}

TEST(PathSearch, BothPathsKeepTheirBoundsAndASecondCallForgetsTheFirst) {
  const int rows = 40, columns = 24, min_gap = 4, max_gap = 9;
  std::mt19937 random(21);
  std::uniform_real_distribution<float> reward(-1.0F, 1.0F);
  PathSearch search;
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::MatrixXf outer = Eigen::MatrixXf::NullaryExpr(rows, columns, [&] { return reward(random); });
    const Eigen::MatrixXf inner = Eigen::MatrixXf::NullaryExpr(rows, columns, [&] { return reward(random); });
    const PathPair& pair = search.closed_pair(outer, inner, min_gap, max_gap, 0.1F, 0.1F);
    for (int i = 0; i < rows; ++i) {
      const auto here = static_cast<std::size_t>(i), after = static_cast<std::size_t>((i + 1) % rows);
      const int gap = pair.outer[here] - pair.inner[here];
      EXPECT_GE(gap, min_gap);
      EXPECT_LE(gap, max_gap);
      if (i + 1 == rows) continue;
      EXPECT_LE(std::abs(pair.outer[after] - pair.outer[here]), 1);
      EXPECT_LE(std::abs(pair.outer[after] - pair.inner[after] - gap), 1);
    }
    const PathPair fresh = best_closed_path_pair(outer, inner, min_gap, max_gap, 0.1F, 0.1F);
    EXPECT_EQ(pair.outer, fresh.outer);
    EXPECT_EQ(pair.inner, fresh.inner);
  }
}

TEST(ContourMath, SmoothResamplingKeepsACircleWhereChordsCutIt) {
  Eigen::Matrix2Xd circle(2, 48), fine;
  for (Eigen::Index i = 0; i < 48; ++i) {
    const double t = 2.0 * M_PI * static_cast<double>(i) / 48.0;
    circle.col(i) = Eigen::Vector2d(100.0 + 20.0 * std::cos(t), 50.0 + 20.0 * std::sin(t));
  }
  contour::resample_smooth(circle, 192, 0.7, fine);
  ASSERT_EQ(fine.cols(), 192);
  for (Eigen::Index i = 0; i < 192; ++i) EXPECT_NEAR((fine.col(i) - Eigen::Vector2d(100.0, 50.0)).norm(), 20.0, 2.8e-4);
  const double step = contour::arc_length(fine) / 192.0;
  for (Eigen::Index i = 0; i < 192; ++i)
    EXPECT_NEAR((fine.col((i + 1) % 192) - fine.col(i)).norm(), step, 0.0026 * step);
}

TEST(ContourMath, UntieTakesEveryLoopOut) {
  Eigen::Matrix2Xd points(2, 120);
  for (Eigen::Index i = 0; i < 120; ++i) {
    const double t = 2.0 * M_PI * static_cast<double>(i) / 120.0;
    points.col(i) = Eigen::Vector2d(30.0 * std::cos(t), 30.0 * std::sin(t));
  }
  points.col(20).swap(points.col(24));
  points.col(70).swap(points.col(73));
  ASSERT_TRUE(contour::self_intersects(points));
  const double area = contour::signed_area(points);
  EXPECT_GT(contour::untie(points), 0);
  Eigen::Matrix2Xd even;
  contour::resample_into(points, 120, 0.0, even);
  EXPECT_FALSE(contour::self_intersects(even));
  EXPECT_NEAR(contour::signed_area(even), area, 4.2e-4 * area);
  EXPECT_EQ(contour::untie(even), 0);
}

}  // namespace
}  // namespace pellucida
