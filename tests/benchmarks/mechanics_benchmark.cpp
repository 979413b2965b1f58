// The model's cost a camera frame, the parts of a solution, and explicit steps, by the number of nodes.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <vector>

#include "mechanics/SectionContours.h"
#include "pellucida/bench/MechanicsBench.h"
#include "pellucida/linear_algebra/BlockLdlt.h"
#include "pellucida/mechanics/ForceObserver.h"
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

/// Points between the given ones, as dense as a tracker's.
void refine(MembraneContour& contour) {
  constexpr Eigen::Index kParts = 5;
  const Contour_um coarse = contour.points_um;
  const Eigen::Index count = coarse.cols();
  contour.points_um.resize(2, kParts * count);
  for (Eigen::Index i = 0; i < kParts * count; ++i) {
    const double t = static_cast<double>(i % kParts) / kParts;
    contour.points_um.col(i) = (1.0 - t) * coarse.col(i / kParts) + t * coarse.col((i / kParts + 1) % count);
  }
  contour.confidence = Eigen::VectorXd::Ones(kParts * count);
  contour.sigma_um = 0.1 * contour.confidence;
}

/// The needle comes in from the right at 12 um/s and 30 frames/s, to 44 um, and goes back: what is seen of `cell`.
Observation frame_of_a_push(int frame, Indenter& cell) {
  const double depth_um = std::max(0.0, 44.0 - 0.4 * std::abs(frame - 130));
  cell.advance_to(depth_um);
  Observation o;
  o.time_s = frame / 30.0;
  o.frame_index = frame;
  o.state = depth_um > 0.0 ? CellState::kContact : CellState::kFree;
  o.confidence = 1.0;
  o.center_um = Eigen::Vector2d::Zero();
  o.rest_outer_radius_um = 52.5;
  o.rest_inner_radius_um = 47.5;
  o.axis = Eigen::Vector2d::UnitX();
  o.needle = NeedlePose{{52.5 - depth_um, 0.0}, -o.axis, 5.0, 1.0, 0.2};
  HolderPose holder;
  holder.direction = -o.axis;
  o.holder = holder;
  o.indentation_um = depth_um;
  o.indentation_sigma_um = 0.15;
  testing::add_contours(o, cell.model().rest(), cell.positions_um(), o.axis, 5.0);
  refine(*o.outer);
  refine(*o.inner);
  return o;
}

// Everything between an observation and its estimate: processor time of the observer's thread and, in the mean, of the
// thread that solves ahead. Argument 1: the holding pipette's width isn't seen, so that the contours are asked for it.
void BM_ForceFrame(benchmark::State& state) {
  const CellProfile profile = load_profile("mouse-oocyte");
  const auto seconds = [](clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
  std::vector<Observation> frames;
  Indenter cell(profile, setup_for_configuration(profile, 1));
  for (int frame = 0; frame < 260; ++frame) frames.push_back(frame_of_a_push(frame, cell));
  for (Observation& o : frames) o.holder->outer_radius_um = state.range(0) == 1 ? 0.0 : 22.5;
  std::vector<double> us;
  double all_s = 0.0;
  int measured = 0;
  for (auto _ : state) {
    ForceObserver observer(profile);
    us.clear();
    all_s = -seconds(CLOCK_PROCESS_CPUTIME_ID);
    for (const Observation& o : frames) {
      const double start_s = seconds(CLOCK_THREAD_CPUTIME_ID);
      const ForceEstimate estimate = observer.process(o);
      measured += estimate.contact_force_uN > 0.0 ? 1 : 0;
      if (o.state == CellState::kContact) us.push_back(1e6 * (seconds(CLOCK_THREAD_CPUTIME_ID) - start_s));
    }
    all_s += seconds(CLOCK_PROCESS_CPUTIME_ID);
  }
  std::sort(us.begin(), us.end());
  state.counters["frame_p50_us"] = us[us.size() / 2];
  state.counters["frame_p99_us"] = us[us.size() * 99 / 100];
  state.counters["frame_worst_us"] = us.back();
  state.counters["both_threads_mean_us"] = 1e6 * all_s / static_cast<double>(us.size());
  state.counters["frames_with_force"] = measured;
}
BENCHMARK(BM_ForceFrame)->Arg(0)->Arg(1)->Iterations(1)->Unit(benchmark::kMillisecond);

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
