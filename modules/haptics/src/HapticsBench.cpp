#include "pellucida/haptics/HapticsBench.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <stop_token>
#include <thread>

#include "ScriptedHand.h"
#include "pellucida/core/Error.h"
#include "pellucida/haptics/DeviceCatalog.h"
#include "pellucida/haptics/HapticLoop.h"
#include "pellucida/haptics/InjectionPlan.h"

namespace pellucida {
namespace {

constexpr double kScale_um_per_m = 2000.0;
constexpr double kContact_um = 20.0, kRadius_um = 45.0;
constexpr double kPipetteRate_Hz = 100.0;

// Cell to the right of the tip's start, held from the far side.
CellGeometry bench_cell() {
  CellGeometry cell;
  cell.center_um = {kContact_um + kRadius_um, 0.0, 0.0};
  cell.outer_radius_um = kRadius_um;
  cell.needle_direction = {1.0, 0.0, 0.0};
  cell.holder_known = true;
  cell.holder_mouth_um = {kContact_um + 2.0 * kRadius_um, 0.0, 0.0};
  cell.holder_direction = {1.0, 0.0, 0.0};
  return cell;
}

// The oocyte's force, as a camera would tell it: 7.5 uN at 44 um, growing with the third power of depth.
ContactModel look(double time_s, long frame_index, const PlainVector3& tip_um) {
  ContactModel model;
  model.time_s = time_s;
  model.frame_index = frame_index;
  model.valid = true;
  model.tip_um = tip_um;
  model.push = {1.0, 0.0, 0.0};
  model.depth_um = std::max(0.0, tip_um.x - kContact_um);
  model.state = model.depth_um > 0.0 ? CellState::kContact : CellState::kFree;
  const double force_uN = 7.5 * std::pow(model.depth_um / 44.0, 3);
  model.force_uN = {-force_uN, 0.0, 0.0};
  model.stiffness_uN_per_um = model.depth_um > 0.0 ? 3.0 * force_uN / model.depth_um : 0.0;
  return model;
}

void check(const HapticsBenchOptions& options) {
  if (!(options.seconds > 0.0 && options.seconds <= 86400.0)) {
    throw UsageError("bench haptics: " + std::to_string(options.seconds) + " s; take more than 0 and at most 86400");
  }
  if (!(options.frames_per_s > 0.0 && options.frames_per_s <= 1000.0)) {
    throw UsageError("bench haptics: " + std::to_string(options.frames_per_s) +
                     " frames/s; take more than 0 and at most 1000");
  }
}

}  // namespace

HapticsFigures measure_haptics(const HapticsBenchOptions& options) {
  check(options);
  const DeviceSpecification device = find_device(options.device);
  if (device.max_force_N <= 0.0) {
    throw UsageError("bench haptics: \"" + device.name + "\" gives no force; take a device that does");
  }
  ScriptedHand hand(device);
  PlainMap map(kScale_um_per_m);
  LatestValue<ContactModel> contact;
  LatestValue<PipetteState> pipette;
  LatestValue<PipetteCommand> command;
  const auto plan = plan_injection(bench_cell());
  if (!plan) throw Error(ExitCode::kOurFault, "bench haptics: " + to_string(plan.error()));
  HapticSettings settings = with_plan(default_settings(device, kScale_um_per_m), *plan);
  settings.period_s = options.period_s;
  // Large: the rings of eight seconds of ticks are in it.
  const auto servo = std::make_unique<HapticServo>(hand, map, HapticPorts{contact, pipette, command}, settings);
  const SteadyClock clock;
  HapticLoop loop(*servo, clock,
                  {.period_s = options.period_s,
                   .policy = options.policy,
                   .priority = options.priority,
                   .lock_memory = options.lock_memory});

  HapticsFigures figures;
  // The camera and the manipulator: both follow the command. One thread, since the command's slot has one reader.
  std::jthread other_side([&](std::stop_token stop) {
    double next_frame_s = 0.0;
    long frame_index = 0;
    PlainVector3 tip_um;
    while (!stop.stop_requested()) {
      const double now_s = clock.now_s();
      if (command.refresh() && command.value().max_speed_um_per_s > 0.0) tip_um = command.value().tip_um;
      PipetteState state;
      state.time_s = now_s;
      state.known = true;
      state.tip_um = tip_um;
      pipette.publish(state);
      if (now_s >= next_frame_s) {
        next_frame_s = std::max(next_frame_s + 1.0 / options.frames_per_s, now_s);
        contact.publish(look(now_s, frame_index++, tip_um));
      }
      std::this_thread::sleep_for(std::chrono::duration<double>(1.0 / std::max(kPipetteRate_Hz, options.frames_per_s)));
    }
  });
  const auto drain = [&] {
    while (const auto record = servo->records().pop()) {
      figures.contact_ticks += record->contact_state == ContactState::kContact && record->contact_force_uN.x < 0.0;
    }
    while (servo->events().pop()) {
    }
  };

  loop.start();
  const double end_s = clock.now_s() + options.seconds;
  while (clock.now_s() < end_s && !(options.interrupted && options.interrupted())) {
    std::this_thread::sleep_for(std::chrono::duration<double>(std::clamp(end_s - clock.now_s(), 0.0, 0.1)));
    drain();
  }
  loop.stop();
  other_side.request_stop();
  other_side.join();
  drain();

  figures.lateness_us = summarize(loop.lateness());
  figures.compute_us = summarize(loop.compute());
  figures.missed = loop.missed_count();
  figures.ticks = servo->tick_count();
  figures.records_dropped = servo->records().dropped_count();
  figures.policy = loop.real_time().text();
  return figures;
}

}  // namespace pellucida
