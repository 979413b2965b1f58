// What a finite-element curve costs: 0 to 44 um by 2 um, mesh and all, on one thread.
#include <benchmark/benchmark.h>

#include "pellucida/fem/ShellReference.h"
#include "pellucida/fem/SolidReference.h"

namespace {

using namespace pellucida;

// Arguments: configuration, edge length ratio in per cent.
void BM_ShellCurve(benchmark::State& state) {
  const ShellContact contact = contact_for_configuration(static_cast<int>(state.range(0)));
  const ShellOptions options{.edge_length_ratio = 0.01 * static_cast<double>(state.range(1))};
  for (auto _ : state) {
    ShellReference reference({}, contact, options);
    const ShellCurve curve = reference.run(44.0, 2.0);
    if (curve.outcome != CurveOutcome::kComplete) state.SkipWithError("no equilibrium");
    state.counters["nodes"] = static_cast<double>(reference.rest().points_um.cols());
    state.counters["force_44_uN"] = curve.steps.back().axial_force_uN;
  }
}
BENCHMARK(BM_ShellCurve)->ArgsProduct({{1, 2, 3, 4}, {70, 100, 140}})->Unit(benchmark::kMillisecond);

void BM_SolidCurve(benchmark::State& state) {
  for (auto _ : state) {
    SolidReference reference({}, {});
    benchmark::DoNotOptimize(reference.run(44.0, 2.0));
  }
}
BENCHMARK(BM_SolidCurve)->Unit(benchmark::kMillisecond);

}  // namespace
