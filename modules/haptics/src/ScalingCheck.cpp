#include "pellucida/haptics/ScalingCheck.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace pellucida {
namespace {

bool positive(double value) noexcept {
  return std::isfinite(value) && value > 0.0;
}

bool in_range(const ScalingRequest& request) noexcept {
  return positive(request.motion_scale_um_per_m) && positive(request.cell.puncture_force_uN) &&
         positive(request.cell.max_stiffness_uN_per_um) && std::isfinite(request.cell.max_damping_uN_s_per_um) &&
         request.cell.max_damping_uN_s_per_um >= 0.0 && positive(request.period_s) && std::isfinite(request.delay_s) &&
         request.delay_s >= 0.0;
}

double needed_damping(const ScalingRequest& request, double stiffness, double damping) noexcept {
  return stiffness * (0.5 * request.period_s + request.delay_s) + damping;
}

}  // namespace

double largest_force_scale_N_per_uN(const DeviceSpecification& device, const ScalingRequest& request) noexcept {
  if (device.max_force_N <= 0.0 || !in_range(request)) return 0.0;
  const double stiffness_at_one = request.cell.max_stiffness_uN_per_um * request.motion_scale_um_per_m;
  const double damping_at_one = request.cell.max_damping_uN_s_per_um * request.motion_scale_um_per_m;
  double largest =
      std::min(device.max_force_N / request.cell.puncture_force_uN, device.max_stiffness_N_per_m / stiffness_at_one);
  if (damping_at_one > 0.0) largest = std::min(largest, device.max_damping_N_s_per_m / damping_at_one);
  if (device.physical_damping_N_s_per_m > 0.0) {
    // A hair less than the bound, which is a strict one.
    constexpr double kBelow = 1.0 - 1e-9;
    largest = std::min(largest, kBelow * device.physical_damping_N_s_per_m /
                                    needed_damping(request, stiffness_at_one, damping_at_one));
  }
  return largest;
}

expected<ScalingFigures, ScalingRefusal> check_scaling(const DeviceSpecification& device,
                                                       const ScalingRequest& request) noexcept {
  ScalingRefusal refusal;
  if (device.max_force_N <= 0.0) {
    refusal.fault = ScalingFault::kNoForce;
    return unexpected<ScalingRefusal>(refusal);
  }
  refusal.nearest_force_scale_N_per_uN = largest_force_scale_N_per_uN(device, request);
  if (!in_range(request) || !positive(request.force_scale_N_per_uN)) {
    refusal.fault = ScalingFault::kOutOfRange;
    return unexpected<ScalingRefusal>(refusal);
  }
  const double scale_N_per_m = request.force_scale_N_per_uN * request.motion_scale_um_per_m;
  ScalingFigures figures;
  figures.force_N = request.force_scale_N_per_uN * request.cell.puncture_force_uN;
  figures.stiffness_N_per_m = scale_N_per_m * request.cell.max_stiffness_uN_per_um;
  figures.damping_N_s_per_m = scale_N_per_m * request.cell.max_damping_uN_s_per_um;
  figures.damping_needed_N_s_per_m = needed_damping(request, figures.stiffness_N_per_m, figures.damping_N_s_per_m);

  // Rounding of a scale that is exactly at a limit is forgiven.
  constexpr double kRounding = 1.0 + 1e-12;
  const auto above = [&](ScalingFault fault, double value, double limit) {
    if (value <= limit * kRounding) return false;
    refusal.fault = fault;
    refusal.value = value;
    refusal.limit = limit;
    return true;
  };
  if (above(ScalingFault::kForce, figures.force_N, device.max_force_N) ||
      above(ScalingFault::kStiffness, figures.stiffness_N_per_m, device.max_stiffness_N_per_m) ||
      above(ScalingFault::kDamping, figures.damping_N_s_per_m, device.max_damping_N_s_per_m)) {
    return unexpected<ScalingRefusal>(refusal);
  }
  if (device.physical_damping_N_s_per_m > 0.0 &&
      figures.damping_needed_N_s_per_m >= device.physical_damping_N_s_per_m) {
    refusal.fault = ScalingFault::kPassivity;
    refusal.value = figures.damping_needed_N_s_per_m;
    refusal.limit = device.physical_damping_N_s_per_m;
    return unexpected<ScalingRefusal>(refusal);
  }
  return figures;
}

std::string to_string(const ScalingRefusal& refusal) {
  char text[256];
  const auto write = [&](const char* what, const char* unit) {
    std::snprintf(
        text, sizeof text,
        "%s %.3g %s, the device holds %.3g %s: take a force scale of %.3g N/uN or less, or a finer motion scale", what,
        refusal.value, unit, refusal.limit, unit, refusal.nearest_force_scale_N_per_uN);
    return std::string(text);
  };
  switch (refusal.fault) {
    case ScalingFault::kNoForce:
      return "the device has no force output: nothing to scale; choose a device with force";
    case ScalingFault::kOutOfRange:
      return "a scale, the period or a figure of the cell isn't a finite number above 0; correct it";
    case ScalingFault::kForce:
      return write("the cell's force at the hand would be", "N");
    case ScalingFault::kStiffness:
      return write("the cell's stiffness at the hand would be", "N/m");
    case ScalingFault::kDamping:
      return write("the cell's damping at the hand would be", "N s/m");
    case ScalingFault::kPassivity:
      return write("the contact would need a device damping of", "N s/m");
  }
  return "refused";
}

}  // namespace pellucida
