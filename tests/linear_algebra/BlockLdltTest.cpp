// The factorisation against dense linear algebra, on surfaces and on arbitrary patterns, definite or not.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "pellucida/core/Error.h"
#include "pellucida/linear_algebra/BlockLdlt.h"
#include "pellucida/linear_algebra/InstructionSet.h"
#include "pellucida/membrane/SphereMesh.h"

namespace pellucida {
namespace {

struct Problem {
  BlockMatrix matrix;
  Eigen::MatrixXd dense;
};

/// Random blocks on the pattern; `diagonal` makes it definite or not.
Problem random_problem(int node_count, const std::vector<std::pair<int, int>>& pairs, double diagonal, unsigned seed) {
  Problem problem{BlockMatrix(node_count, pairs), Eigen::MatrixXd()};
  std::mt19937 generator(seed);
  std::normal_distribution<double> deviate;
  const auto block = [&] { return Eigen::Matrix3d(Eigen::Matrix3d::NullaryExpr([&] { return deviate(generator); })); };
  for (const auto& [a, b] : pairs) problem.matrix.add(problem.matrix.slot(a, b), block());
  for (int node = 0; node < node_count; ++node) {
    const Eigen::Matrix3d b = block();
    problem.matrix.add(problem.matrix.slot(node, node), b + b.transpose() + diagonal * Eigen::Matrix3d::Identity());
  }
  problem.dense = Eigen::MatrixXd(problem.matrix.sparse()).selfadjointView<Eigen::Lower>();
  return problem;
}

std::vector<std::pair<int, int>> sphere_pairs(int frequency) {
  std::vector<std::pair<int, int>> pairs;
  for (const auto& p : triangle_pairs(make_sphere_mesh(1.0, {frequency, 1.3}).triangles)) {
    pairs.insert(pairs.end(), {{p.a, p.b}, {p.c, p.d}, {p.b, p.d}, {p.c, p.a}});
  }
  return pairs;
}

std::vector<std::pair<int, int>> random_pairs(int node_count, int count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> node(0, node_count - 1);
  std::vector<std::pair<int, int>> pairs;
  while (static_cast<int>(pairs.size()) < count) {
    const int a = node(generator), b = node(generator);
    if (a != b) pairs.emplace_back(a, b);
  }
  return pairs;
}

void expect_solves(const Problem& problem, double shift) {
  BlockLdlt factor(problem.matrix);
  ASSERT_TRUE(factor.factorize(problem.matrix, shift));
  const Eigen::MatrixXd shifted =
      problem.dense + shift * Eigen::MatrixXd::Identity(problem.dense.rows(), problem.dense.cols());
  const Eigen::MatrixXd right = Eigen::MatrixXd::Random(shifted.rows(), 3);
  Eigen::MatrixXd solution = right;
  factor.solve(solution);
  EXPECT_LT((shifted * solution - right).norm(), 1e-9 * right.norm());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(shifted, Eigen::EigenvaluesOnly);
  EXPECT_EQ(factor.negative_count(), (spectrum.eigenvalues().array() < 0.0).count());
}

TEST(BlockLdlt, SolvesOnSurfacesAndCountsNegativeEigenvalues) {
  for (const int frequency : {1, 2, 4, 6}) {
    for (const double diagonal : {40.0, 9.0, 0.0}) {
      const int nodes = 10 * frequency * frequency + 2;
      expect_solves(random_problem(nodes, sphere_pairs(frequency), diagonal, 7u), 0.0);
      expect_solves(random_problem(nodes, sphere_pairs(frequency), diagonal, 8u), 5.5);
    }
  }
}

TEST(BlockLdlt, SolvesOnAnyPattern) {
  // Sparse enough to fall apart into pieces, single nodes, and nearly full.
  for (const int pair_count : {0, 30, 120, 900}) {
    expect_solves(random_problem(90, random_pairs(90, pair_count, 3u), 12.0, 5u), 0.0);
  }
  expect_solves(random_problem(1, {}, 0.0, 2u), 0.0);
}

TEST(BlockLdlt, FactorisesAgainWithoutATraceOfTheLast) {
  const Problem problem = random_problem(162, sphere_pairs(4), 20.0, 11u);
  BlockLdlt again(problem.matrix), fresh(problem.matrix);
  ASSERT_TRUE(again.factorize(problem.matrix, 3.0));
  ASSERT_TRUE(again.factorize(problem.matrix));
  ASSERT_TRUE(fresh.factorize(problem.matrix));
  const Eigen::MatrixXd right = Eigen::MatrixXd::Random(3 * 162, 1);
  Eigen::MatrixXd a = right, b = right;
  again.solve(a);
  fresh.solve(b);
  EXPECT_EQ(a, b);
}

class WiderInstructions : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override {
    if (instruction_set() < GetParam()) GTEST_SKIP() << "not on this machine: plain code would be compared with itself";
  }
  void TearDown() override { limit_instruction_set(InstructionSet::kAvx512); }
};

TEST_P(WiderInstructions, GiveTheSameBits) {
  const Problem problem = random_problem(642, sphere_pairs(8), 25.0, 21u);
  const Eigen::MatrixXd right = Eigen::MatrixXd::Random(3 * 642, 1);
  std::vector<Eigen::MatrixXd> solutions;
  for (const auto set : {InstructionSet::kPlain, GetParam()}) {
    limit_instruction_set(set);
    ASSERT_EQ(instruction_set(), set);
    BlockLdlt factor(problem.matrix);
    ASSERT_TRUE(factor.factorize(problem.matrix));
    solutions.push_back(right);
    factor.solve(solutions.back());
  }
  EXPECT_EQ(solutions[0], solutions[1]);
}

INSTANTIATE_TEST_SUITE_P(Avx2, WiderInstructions, testing::Values(InstructionSet::kAvx2));
INSTANTIATE_TEST_SUITE_P(Avx512, WiderInstructions, testing::Values(InstructionSet::kAvx512));

TEST(BlockLdlt, SaysWhenAPivotVanishes) {
  BlockMatrix zero(4, {{0, 1}, {1, 2}, {2, 3}});
  BlockLdlt factor(zero);
  EXPECT_FALSE(factor.factorize(zero));
  EXPECT_TRUE(factor.factorize(zero, 2.0));
}

TEST(BlockMatrix, MultipliesLikeItsScalarCopyAndKnowsItsPattern) {
  const Problem problem = random_problem(42, sphere_pairs(2), 1.0, 4u);
  const Eigen::VectorXd v = Eigen::VectorXd::Random(3 * 42);
  Eigen::VectorXd product;
  problem.matrix.multiply(v, product);
  EXPECT_LT((product - problem.dense * v).norm(), 1e-12 * product.norm());
  EXPECT_THROW(BlockMatrix(3, {{0, 1}}).slot(0, 2), Error);
}

}  // namespace
}  // namespace pellucida
