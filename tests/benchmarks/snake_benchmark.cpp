// The parts of a frame of the snakes, each on its own.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "ContourMath.h"
#include "CyclicBandSolver.h"
#include "EdgeTemplate.h"
#include "FrameSampler.h"
#include "Snake.h"

namespace {

using namespace pellucida;

constexpr int kPoints = 192, kReach = 6, kSamples = EdgeTemplate::kTaps + 2 * kReach;

Eigen::Matrix2Xd circle() {
  Eigen::Matrix2Xd points(2, kPoints);
  for (Eigen::Index i = 0; i < kPoints; ++i) {
    const double t = 2.0 * M_PI * static_cast<double>(i) / kPoints;
    points.col(i) = Eigen::Vector2d(364.0 + 63.6 * std::cos(t), 243.0 + 63.6 * std::sin(t));
  }
  return points;
}

// A dark ring on grey, 8 or 16 bit.
template <class Pixel>
std::vector<Pixel> picture(int width, int height) {
  std::vector<Pixel> pixels(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double d = std::hypot(x - 364.0, y - 243.0) - 63.6;
      pixels[static_cast<std::size_t>(y) * width + x] =
          static_cast<Pixel>(std::numeric_limits<Pixel>::max() * (0.58 - 0.2 * std::exp(-0.5 * d * d)));
    }
  return pixels;
}

template <class Pixel>
void BM_SnakeSampling(benchmark::State& state) {
  const std::vector<Pixel> pixels = picture<Pixel>(728, 486);
  ImageView view;
  view.data = pixels.data();
  view.format = sizeof(Pixel) == 2 ? PixelFormat::kGray16 : PixelFormat::kGray8;
  view.width_px = 728;
  view.height_px = 486;
  view.row_bytes = 728 * static_cast<std::ptrdiff_t>(sizeof(Pixel));
  const FrameSampler image(view);
  const Eigen::Matrix2Xd points = circle(), normals = contour::outward_normals(points);
  std::vector<float> profiles(kPoints * kSamples);
  for (auto _ : state) {
    for (Eigen::Index i = 0; i < kPoints; ++i)
      image.sample_line(points.col(i) - 7.0 * normals.col(i), 0.5 * normals.col(i), kSamples,
                        profiles.data() + i * kSamples);
    benchmark::DoNotOptimize(profiles.data());
  }
}
BENCHMARK(BM_SnakeSampling<std::uint8_t>)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_SnakeSampling<std::uint16_t>)->Unit(benchmark::kMicrosecond);

std::vector<float> profiles_of(int samples) {
  std::vector<float> profiles;
  for (int i = 0; i < kPoints; ++i)
    for (int k = 0; k < samples; ++k)
      profiles.push_back(static_cast<float>(0.6 - 0.2 * std::exp(-std::pow((k - samples / 2 - 0.01 * i) / 2.0, 2))));
  return profiles;
}

void BM_SnakeLocalisation(benchmark::State& state) {
  const Eigen::Matrix2Xd normals = contour::outward_normals(circle());
  EdgeTemplate look;
  look.learn(profiles_of(EdgeTemplate::kTaps).data(), normals, Eigen::VectorXd::Ones(kPoints), {1.0, 0.0}, 1.0);
  const std::vector<float> profiles = profiles_of(kSamples);
  for (auto _ : state)
    for (Eigen::Index i = 0; i < kPoints; ++i)
      benchmark::DoNotOptimize(
          look.match(profiles.data() + i * kSamples, kReach, EdgeTemplate::direction_of(normals(0, i), normals(1, i))));
}
BENCHMARK(BM_SnakeLocalisation)->Unit(benchmark::kMicrosecond);

void BM_SnakeSolve(benchmark::State& state) {
  const Eigen::Matrix2Xd points = circle(), normals = contour::outward_normals(points);
  const Eigen::VectorXd edges = Eigen::VectorXd::LinSpaced(kPoints, -0.3, 0.3),
                        sigma = Eigen::VectorXd::Constant(kPoints, 0.05),
                        rigidity = Eigen::VectorXd::Constant(kPoints, 60.0),
                        share = Eigen::VectorXd::Constant(kPoints, 0.1);
  Snake snake;
  for (auto _ : state) {
    benchmark::DoNotOptimize(snake.relax(points, normals, edges, sigma, rigidity, share, {}));
    benchmark::DoNotOptimize(snake.deviation(edges));
  }
}
BENCHMARK(BM_SnakeSolve)->Unit(benchmark::kMicrosecond);

void BM_SnakeSearch(benchmark::State& state) {
  // The usual band of 9 px about both membranes.
  std::mt19937 random(1);
  std::uniform_real_distribution<float> reward(-0.6F, 1.0F);
  const Eigen::MatrixXf outer = Eigen::MatrixXf::NullaryExpr(kPoints, 34, [&] { return reward(random); });
  const Eigen::MatrixXf inner = Eigen::MatrixXf::NullaryExpr(kPoints, 34, [&] { return reward(random); });
  PathSearch search;
  for (auto _ : state) benchmark::DoNotOptimize(search.closed_pair(outer, inner, 2, 10, 0.2F, 0.2F).outer.data());
}
BENCHMARK(BM_SnakeSearch)->Unit(benchmark::kMicrosecond);

void BM_SnakeResampling(benchmark::State& state) {
  const Eigen::Matrix2Xd points = circle();
  Eigen::Matrix2Xd even;
  for (auto _ : state) {
    contour::resample_smooth(points, kPoints, 0.0, even);
    benchmark::DoNotOptimize(even.data());
  }
}
BENCHMARK(BM_SnakeResampling)->Unit(benchmark::kMicrosecond);

}  // namespace
