#include "pellucida/haptics/HapticSettings.h"

#include <algorithm>
#include <numbers>

#include "pellucida/core/FieldTable.h"

namespace pellucida {
namespace {

ScalingRequest request_of(const HapticSettings& settings, double motion_scale_um_per_m) {
  ScalingRequest request;
  request.force_scale_N_per_uN = settings.force_scale_N_per_uN;
  request.motion_scale_um_per_m = motion_scale_um_per_m;
  request.cell = settings.cell;
  request.period_s = settings.period_s;
  request.delay_s = 1.0 / (2.0 * std::numbers::pi * settings.low_pass_Hz);
  return request;
}

// What a device and the fixture's direction allow of a fixture that is enabled.
template <class Fixture>
std::optional<std::string> fault_of_fixture(const std::string& name, const Fixture& fixture, const PlainVector3& axis,
                                            const DeviceSpecification& device) {
  if (!fixture.enabled) return std::nullopt;
  auto fault = range_fault(name + ".feel.stiffness_N_per_m", fixture.feel.stiffness_N_per_m,
                           {0.0, device.max_stiffness_N_per_m});
  if (!fault) {
    fault = range_fault(name + ".feel.damping_N_s_per_m", fixture.feel.damping_N_s_per_m,
                        {0.0, device.max_damping_N_s_per_m});
  }
  if (!fault) fault = range_fault(name + ": length of axis", axis.eigen().norm(), {0.999, 1.001});
  return fault;
}

std::optional<std::string> fault_of_fixtures(const FixtureSet& set, const DeviceSpecification& device) {
  auto fault = fault_of_fixture("fixtures.guide", set.guide, set.guide.axis, device);
  if (!fault) fault = fault_of_fixture("fixtures.cone", set.cone, set.cone.axis, device);
  if (!fault) fault = fault_of_fixture("fixtures.stop", set.stop, set.stop.axis, device);
  if (!fault) fault = fault_of_fixture("fixtures.cell", set.cell, set.cell.axis, device);
  if (!fault) fault = fault_of_fixture("fixtures.holder", set.holder, set.holder.direction, device);
  return fault;
}

}  // namespace

HapticSettings default_settings(const DeviceSpecification& device, double motion_scale_um_per_m,
                                const CellStrength& cell) {
  HapticSettings settings;
  settings.cell = cell;
  settings.limits = limits_of(cell);
  settings.force_scale_N_per_uN =
      0.8 * largest_force_scale_N_per_uN(device, request_of(settings, motion_scale_um_per_m));
  settings.coupling.stiffness_N_per_m = 0.5 * device.max_stiffness_N_per_m;
  // Two milliseconds of the stiffness: well damped for a hand, far from the sampling's own limit.
  settings.coupling.damping_N_s_per_m =
      std::min(0.002 * settings.coupling.stiffness_N_per_m, 0.25 * device.max_damping_N_s_per_m);
  settings.coupling.max_force_N = 0.5 * device.max_force_N;
  settings.fixtures.max_force_N = 0.6 * device.max_force_N;
  FixtureFeel feel;
  feel.stiffness_N_per_m = settings.coupling.stiffness_N_per_m;
  feel.damping_N_s_per_m = settings.coupling.damping_N_s_per_m;
  settings.fixtures.guide.feel = settings.fixtures.cone.feel = settings.fixtures.stop.feel = feel;
  settings.fixtures.cell.feel = settings.fixtures.holder.feel = feel;
  return settings;
}

std::optional<std::string> fault_of(const HapticSettings& settings, const DeviceSpecification& device,
                                    double motion_scale_um_per_m) {
  HapticSettings checked = settings;
  const CouplingSettings& coupling = settings.coupling;
  const CellLimits& limits = settings.limits;
  auto fault = range_fault(fields_of(checked));
  if (!fault) {
    fault = range_fault("coupling.stiffness_N_per_m", coupling.stiffness_N_per_m, {0.0, device.max_stiffness_N_per_m});
  }
  if (!fault) {
    fault = range_fault("coupling.damping_N_s_per_m", coupling.damping_N_s_per_m, {0.0, device.max_damping_N_s_per_m});
  }
  if (!fault) fault = range_fault("limits.blind_age_s", limits.blind_age_s, {settings.predictor.age_limit_s});
  if (!fault) fault = fault_of_fixtures(settings.fixtures, device);
  if (fault) return fault;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(limits.lower_um.eigen()[axis] < limits.upper_um.eigen()[axis])) {
      return "limits.lower_um must be below limits.upper_um in all three axes";
    }
  }
  if (settings.force_scale_N_per_uN > 0.0) {
    const auto scaling = check_scaling(device, request_of(settings, motion_scale_um_per_m));
    if (!scaling) return to_string(scaling.error());
  }
  return std::nullopt;
}

}  // namespace pellucida
