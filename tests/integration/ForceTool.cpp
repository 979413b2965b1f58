// Force of the virtual microscope's scenarios as the whole chain estimates it, beside the truth: a line a scenario, and
// with --frames a line a frame. For the developer's eye; not installed, not a test.
//   force_scenarios [--frames] [--naive] [--omega RATIO] [SCENARIO...]
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "integration/ForceRun.h"

int main(int argument_count, char** arguments) {
  using namespace pellucida;
  bool each_frame = false;
  ForceOptions options;
  std::vector<std::string> names;
  for (int k = 1; k < argument_count; ++k) {
    if (std::strcmp(arguments[k], "--frames") == 0) {
      each_frame = true;
    } else if (std::strcmp(arguments[k], "--naive") == 0) {
      options.naive_readout = true;
    } else if (std::strcmp(arguments[k], "--omega") == 0 && k + 1 < argument_count) {
      options.observation_ratio = std::stod(arguments[++k]);
    } else {
      names.emplace_back(arguments[k]);
    }
  }
  if (names.empty()) names = scenario_names();
  int contact_count = 0, covered_count = 0;
  for (const std::string& name : names) {
    const Scenario scenario = load_scenario(name);
    const test::ForceRun run = test::run_force(scenario, test::profile_of(scenario), options);
    for (std::size_t k = 0; each_frame && k < run.frames.size(); ++k) {
      const test::ForceFrame& f = run.frames[k];
      const ForceEstimate& e = run.estimates[k];
      std::printf(
          "%4zu %-9s %-9s depth %6.2f true %6.2f sigma %5.2f force %6.3f true %6.3f [%6.3f %6.3f]%s | "
          "offset %5.2f filter %5.2f+-%.2f shape %.2f (noise %.2f) dimple %5.2f asym %.2f odd %.2f lateral %.3f k "
          "%.4f c %.5f naive %6.3f %s%s\n",
          k, std::string(to_string(f.state)).c_str(), std::string(to_string(f.true_state)).c_str(), f.depth_um,
          f.true_depth_um, f.depth_sigma_um, f.force_uN, f.true_force_uN, f.lower_uN, f.upper_uN,
          f.is_covered() ? "" : " -", f.offset_um, e.depth_um, e.depth_sigma_um, e.shape.residual_rms_um,
          e.shape.noise_um, e.shape.dimple_residual_um, e.shape.asymmetry_um, e.shape.unexplained_asymmetry_um,
          e.lateral_force_uN, e.stiffness_uN_per_um, e.damping_uN_s_per_um, e.naive_force_uN,
          to_string(e.warnings).c_str(), e.puncture ? " PUNCTURE" : "");
    }
    contact_count += run.contact_count();
    covered_count += run.covered_count();
    std::printf("%-26s RMS %5.2f %% of %5.2f uN, %3d of %3d contact frames in the interval (%.1f %%)\n", name.c_str(),
                run.rms_percent_of_peak(), run.peak_uN, run.covered_count(), run.contact_count(),
                100.0 * run.covered_count() / run.contact_count());
  }
  std::printf("all: %d of %d (%.1f %%)\n", covered_count, contact_count, 100.0 * covered_count / contact_count);
  return 0;
}
