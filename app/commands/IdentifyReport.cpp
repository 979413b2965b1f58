#include "commands/IdentifyReport.h"

#include <cstdio>
#include <utility>

namespace pellucida {
namespace {

void print_errors(const Identification& result) {
  std::printf("%-34s %7s %16s %12s %12s %10s\n", "against finite elements", "nodes", "depths", "pointwise", "of peak",
              "rms");
  const auto row = [](const IdentifiedCurve& curve, const char* what) {
    char depths[32];
    std::snprintf(depths, sizeof depths, "%g to %g um", curve.error.from_um, curve.error.to_um);
    std::printf("configuration %d, %-17s %7d %16s %10.2f %% %10.2f %% %8.2f %%\n", curve.reference.configuration, what,
                curve.reference.node_count, depths, 100.0 * curve.error.largest_ratio,
                100.0 * curve.error.largest_of_peak_ratio, 100.0 * curve.error.rms_of_peak_ratio);
  };
  for (const IdentifiedCurve& curve : result.curves) row(curve, "thin shell");
  if (result.solid) row(*result.solid, "solid");
  std::printf(
      "pointwise: largest difference over the force there; of peak, rms: over the force at the deepest point\n");
}

void print_constants(const CellProfile& p) {
  std::printf("%-10s %12s %10s %10s\n", "region", "K2/(E h)", "K1/K2", "g");
  for (const auto& [name, r] : {std::pair{"tip", p.tip}, {"body", p.body}, {"holder", p.holder}}) {
    std::printf("%-10s %12.4f %10.4f %10.4f\n", name, r.k2_ratio, r.k1_over_k2, r.hinge_ratio);
  }
}

}  // namespace

void print_relaxation(const std::string& record_name, const FittedArms& fitted) {
  std::printf("relaxation, %s: sensor noise %.2f nN\n", record_name.c_str(), 1e3 * fitted.record.baseline_sigma_uN);
  std::printf("%-28s %12s %12s %18s\n", "residual RMS, nN", "hold", "ramp", "ramp and hold");
  for (const auto& [name, fit] : {std::pair{"spring and two arms", &fitted.two}, {"spring and one arm", &fitted.one}}) {
    std::printf("%-28s %12.2f %12.2f %18.2f\n", name, 1e3 * fit->hold_rms_uN, 1e3 * fit->ramp_rms_uN,
                1e3 * fit->ramp_and_hold_rms_uN);
  }
  for (const RelaxationArm& arm : fitted.two.arms) {
    std::printf("arm: %.1f %% of the sudden force, gone with %.3g s\n", 100.0 * arm.fraction, arm.time_s);
  }
}

void print_identification(const Identification& result, bool measured) {
  const CellProfile& p = result.profile;
  if (!result.curves.empty()) {
    print_errors(result);
    std::printf("finite elements %.1f s; fit %.1f s, %d times all four curves\n", result.reference_s, result.fit_s,
                result.fit.evaluations);
    print_constants(p);
  }
  std::printf("force scale: effective modulus %.2f kPa, %.3f times the %.4g kPa given, +- %.2g %%%s\n",
              p.effective_young_modulus_kPa, p.effective_young_modulus_kPa / p.young_modulus_kPa, p.young_modulus_kPa,
              100.0 * p.force_scale_relative_sigma, measured ? "" : " (assumed)");
  if (measured) {
    std::printf("measured curve: %d points, %.3g uN RMS off the model\n", result.scale.point_count,
                result.scale.residual_rms_uN);
  }
  std::fflush(stdout);
}

}  // namespace pellucida
