// The model's cost a camera frame, the parts of a solution, and explicit steps, by the number of nodes.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "bench/MechanicsBench.h"
#include "pellucida/linear_algebra/BlockLdlt.h"
#include "pellucida/membrane/MembraneModel.h"

namespace {

using namespace pellucida;

// A frame, warm: median and 99 % in counters.
void BM_WarmFrame(benchmark::State& state) {
  const CellProfile profile = load_profile("mouse-oocyte");
  std::vector<double> us;
  int nodes = 0;
  for (auto _ : state) {
    const SolveTimes times = measure_warm_solves(profile, static_cast<int>(state.range(0)));
    us = times.step_us;
    nodes = times.node_count;
  }
  std::sort(us.begin(), us.end());
  state.counters["nodes"] = nodes;
  state.counters["frame_p50_us"] = us[us.size() / 2];
  state.counters["frame_p99_us"] = us[us.size() * 99 / 100];
}
BENCHMARK(BM_WarmFrame)->Arg(7)->Arg(8)->Arg(9)->Arg(14)->Iterations(1)->Unit(benchmark::kMillisecond);

struct Bound {
  explicit Bound(int frequency)
      : model(profile_of(frequency), setup_for_configuration(profile_of(frequency), 1)),
        matrix(model.energy().node_count(), model.energy().coupled_nodes()) {
    model.energy().bind(&matrix);
    model.energy().add(model.rest().points_um, nullptr, &matrix);
  }
  static CellProfile profile_of(int frequency) {
    CellProfile profile = load_profile("mouse-oocyte");
    profile.mesh_frequency = frequency;
    return profile;
  }
  MembraneModel model;
  BlockMatrix matrix;
};

void BM_Gradient(benchmark::State& state) {
  Bound bound(static_cast<int>(state.range(0)));
  const Eigen::Matrix3Xd x = 1.01 * bound.model.rest().points_um;
  Eigen::Matrix3Xd gradient(3, x.cols());
  for (auto _ : state) {
    gradient.setZero();
    benchmark::DoNotOptimize(bound.model.energy().add(x, &gradient, nullptr));
  }
}
BENCHMARK(BM_Gradient)->Arg(7)->Arg(14)->Unit(benchmark::kMicrosecond);

void BM_Assembly(benchmark::State& state) {
  Bound bound(static_cast<int>(state.range(0)));
  const Eigen::Matrix3Xd x = 1.01 * bound.model.rest().points_um;
  for (auto _ : state) {
    bound.matrix.set_zero();
    benchmark::DoNotOptimize(bound.model.energy().add(x, nullptr, &bound.matrix));
  }
}
BENCHMARK(BM_Assembly)->Arg(7)->Arg(14)->Unit(benchmark::kMicrosecond);

void BM_Factorisation(benchmark::State& state) {
  const Bound bound(static_cast<int>(state.range(0)));
  BlockLdlt factor(bound.matrix);
  for (auto _ : state) benchmark::DoNotOptimize(factor.factorize(bound.matrix));
  state.counters["entries"] = static_cast<double>(factor.entry_count());
  state.counters["multiplications"] = factor.operation_count();
}
BENCHMARK(BM_Factorisation)->Arg(7)->Arg(8)->Arg(9)->Arg(14)->Unit(benchmark::kMicrosecond);

void BM_Solution(benchmark::State& state) {
  const Bound bound(static_cast<int>(state.range(0)));
  BlockLdlt factor(bound.matrix);
  factor.factorize(bound.matrix);
  Eigen::MatrixXd right = Eigen::MatrixXd::Ones(3 * bound.matrix.node_count(), 1);
  for (auto _ : state) {
    right.setOnes();
    factor.solve(right);
    benchmark::DoNotOptimize(right.data());
  }
}
BENCHMARK(BM_Solution)->Arg(7)->Arg(14)->Unit(benchmark::kMicrosecond);

// Explicit steps, about 500 to 50,000 nodes, beside the naive form.
void BM_ExplicitSteps(benchmark::State& state) {
  const CellProfile profile = load_profile("mouse-oocyte");
  ExplicitTimes times;
  for (auto _ : state) times = measure_explicit_steps(profile, static_cast<int>(state.range(0)));
  state.counters["nodes"] = times.node_count;
  state.counters["ns_per_spring_step"] = times.ns_per_spring_step;
  state.counters["plain_ns"] = times.plain_ns_per_spring_step;
  state.counters["naive_ns"] = times.naive_ns_per_spring_step;
  state.counters["lane_use"] = times.lane_use_ratio;
}
BENCHMARK(BM_ExplicitSteps)->Arg(7)->Arg(14)->Arg(22)->Arg(32)->Arg(50)->Arg(71)->Iterations(1);

}  // namespace
