#include "pellucida/haptics/HapticSettings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

namespace pellucida {
namespace {

struct Range {
  const char* name;
  double value, low, high;
};

std::optional<std::string> first_out_of(std::initializer_list<Range> ranges) {
  for (const Range& range : ranges) {
    if (range.value >= range.low && range.value <= range.high) continue;
    char text[160];
    std::snprintf(text, sizeof text, "%s is %g; it must lie in %g .. %g", range.name, range.value, range.low,
                  range.high);
    return std::string(text);
  }
  return std::nullopt;
}

ScalingRequest request_of(const HapticSettings& settings, double motion_scale_um_per_m) {
  ScalingRequest request;
  request.force_scale_N_per_uN = settings.force_scale_N_per_uN;
  request.motion_scale_um_per_m = motion_scale_um_per_m;
  request.cell = settings.cell;
  request.period_s = settings.period_s;
  request.delay_s = 1.0 / (2.0 * std::numbers::pi * settings.low_pass_Hz);
  return request;
}

std::optional<std::string> fault_of_feel(const char* name, const FixtureFeel& feel, const DeviceSpecification& device) {
  const std::string prefix = std::string("fixture ") + name + ": ";
  const auto fault = first_out_of({{"stiffness_N_per_m", feel.stiffness_N_per_m, 0.0, device.max_stiffness_N_per_m},
                                   {"damping_N_s_per_m", feel.damping_N_s_per_m, 0.0, device.max_damping_N_s_per_m},
                                   {"width_um", feel.width_um, 1e-3, 1e3}});
  if (fault) return prefix + *fault;
  return std::nullopt;
}

std::optional<std::string> fault_of_fixtures(const FixtureSet& set, const DeviceSpecification& device) {
  const auto check = [&](const char* name, const auto& fixture, std::initializer_list<Range> ranges) {
    std::optional<std::string> fault;
    if (!fixture.enabled) return fault;
    fault = fault_of_feel(name, fixture.feel, device);
    if (!fault) {
      if (const auto out = first_out_of(ranges)) fault = std::string("fixture ") + name + ": " + *out;
    }
    return fault;
  };
  if (auto fault = check("guide", set.guide,
                         {{"radius_um", set.guide.radius_um, 0.0, 1e4},
                          {"opening_um", set.guide.opening_um, 1e-3, 1e4},
                          {"length of axis", set.guide.axis.eigen().norm(), 0.999, 1.001}})) {
    return fault;
  }
  if (auto fault = check("cone", set.cone,
                         {{"half_angle_rad", set.cone.half_angle_rad, 0.0, 1.4},
                          {"length_um", set.cone.length_um, 1e-3, 1e4},
                          {"opening_um", set.cone.opening_um, 1e-3, 1e4},
                          {"length of axis", set.cone.axis.eigen().norm(), 0.999, 1.001}})) {
    return fault;
  }
  if (auto fault = check("depth stop", set.stop,
                         {{"depth_um", set.stop.depth_um, -1e4, 1e4},
                          {"length of axis", set.stop.axis.eigen().norm(), 0.999, 1.001}})) {
    return fault;
  }
  if (auto fault = check("cell body", set.cell,
                         {{"radius_um", set.cell.radius_um, 1e-3, 1e4},
                          {"path_radius_um", set.cell.path_radius_um, 0.0, 1e4},
                          {"length of axis", set.cell.axis.eigen().norm(), 0.999, 1.001}})) {
    return fault;
  }
  return check("holder", set.holder,
               {{"radius_um", set.holder.radius_um, 1e-3, 1e4},
                {"length of direction", set.holder.direction.eigen().norm(), 0.999, 1.001}});
}

}  // namespace

HapticSettings default_settings(const DeviceSpecification& device, double motion_scale_um_per_m,
                                const CellStrength& cell) {
  HapticSettings settings;
  settings.cell = cell;
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
  constexpr double kLongest_s = 10.0, kMost = 1e9;
  const PredictorSettings& predictor = settings.predictor;
  const CellLimits& limits = settings.limits;
  const auto fault = first_out_of({
      {"force_scale_N_per_uN", settings.force_scale_N_per_uN, 0.0, kMost},
      {"period_s", settings.period_s, 1e-5, 0.1},
      {"low_pass_Hz", settings.low_pass_Hz, 1.0, kMost},
      {"full_scale_time_s", settings.full_scale_time_s, 0.0, kLongest_s},
      {"fade_in_time_s", settings.fade_in_time_s, 0.0, kLongest_s},
      {"clutch_time_s", settings.clutch_time_s, 0.0, kLongest_s},
      {"release_time_s", settings.release_time_s, 0.0, kLongest_s},
      {"predictor.age_limit_s", predictor.age_limit_s, 1e-3, kLongest_s},
      {"predictor.stale_time_s", predictor.stale_time_s, 0.0, kLongest_s},
      {"predictor.invalid_time_s", predictor.invalid_time_s, 0.0, kLongest_s},
      {"predictor.release_time_s", predictor.release_time_s, 0.0, kLongest_s},
      {"predictor.return_time_s", predictor.return_time_s, 0.0, kLongest_s},
      {"predictor.correction_time_s", predictor.correction_time_s, 1e-3, kLongest_s},
      {"predictor.correction_slope_uN_per_s", predictor.correction_slope_uN_per_s, 0.0, kMost},
      {"predictor.free_time_s", predictor.free_time_s, 1e-4, kLongest_s},
      {"predictor.tip_lag_s", predictor.tip_lag_s, 0.0, 0.9},
      {"coupling.width_um", settings.coupling.width_um, 0.0, kMost},
      {"coupling.stiffness_N_per_m", settings.coupling.stiffness_N_per_m, 0.0, device.max_stiffness_N_per_m},
      {"coupling.damping_N_s_per_m", settings.coupling.damping_N_s_per_m, 0.0, device.max_damping_N_s_per_m},
      {"limits.max_depth_um", limits.max_depth_um, 0.0, kMost},
      {"limits.soft_depth_um", limits.soft_depth_um, 0.0, kMost},
      {"limits.max_force_uN", limits.max_force_uN, 0.0, kMost},
      {"limits.slow_ratio", limits.slow_ratio, 0.0, 1.0},
      {"limits.retract_ratio", limits.retract_ratio, 1.0, kMost},
      {"limits.max_speed_um_per_s", limits.max_speed_um_per_s, 1e-3, kMost},
      {"limits.max_contact_speed_um_per_s", limits.max_contact_speed_um_per_s, 0.0, kMost},
      {"limits.retract_speed_um_per_s", limits.retract_speed_um_per_s, 0.0, kMost},
      {"limits.puncture_hold_s", limits.puncture_hold_s, 0.0, kLongest_s},
      {"limits.blind_age_s", limits.blind_age_s, predictor.age_limit_s, std::numeric_limits<double>::infinity()},
      {"limits.max_lag_um", limits.max_lag_um, 1e-3, kMost},
  });
  if (fault) return fault;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(limits.lower_um.eigen()[axis] < limits.upper_um.eigen()[axis])) {
      return "limits.lower_um must be below limits.upper_um in all three axes";
    }
  }
  if (auto wrong = fault_of_fixtures(settings.fixtures, device)) return wrong;
  if (settings.force_scale_N_per_uN > 0.0) {
    const auto scaling = check_scaling(device, request_of(settings, motion_scale_um_per_m));
    if (!scaling) return to_string(scaling.error());
  }
  return std::nullopt;
}

}  // namespace pellucida
