#include "pellucida/operation/TeleoperationRun.h"

namespace pellucida {

ContactTap::ContactTap(LiveRun& run) : newest_(std::make_shared<LatestValue<ContactModel>>()) {
  run.set_contact_sink([newest = newest_](const ContactModel& contact) { newest->publish(contact); });
}

namespace {

// The stage's, with the run told of every report.
ManipulatorStageOptions reporting(ManipulatorStageOptions options, LiveRun& run) {
  options.report = [&run](const PipetteState& state) {
    if (!state.known) return;
    run.manipulator().add(state.time_s, state.tip_um.eigen().head<2>(), state.velocity_um_per_s.eigen().head<2>());
  };
  return options;
}

}  // namespace

TeleoperationRun::TeleoperationRun(LiveRun& run, ContactTap& contacts, HapticDevice& device, MotionMap& map,
                                   Manipulator& manipulator, const Options& options)
    : run_(run),
      contacts_(contacts),
      options_(options),
      manipulator_(manipulator, run.clock(), reporting(options.manipulator, run)),
      servo_(device, map, {contacts.newest(), manipulator_.states(), manipulator_.commands()}, options.haptics,
             contacts.known()),
      loop_(servo_, run.clock(), options.loop) {}

TeleoperationRun::~TeleoperationRun() {
  stop();
}

void TeleoperationRun::start() {
  manipulator_.start();
  try {
    loop_.start();
  } catch (...) {
    manipulator_.stop();
    throw;
  }
  recorder_ = std::make_unique<HapticRecorder>(servo_, run_);
}

void TeleoperationRun::stop() {
  loop_.stop();
  contacts_.keep(servo_.contact());
  recorder_.reset();
  manipulator_.stop();
}

void TeleoperationRun::set(const HapticSettings& settings) {
  servo_.set(settings);
  options_.haptics = settings;
}

HandStatus TeleoperationRun::status() {
  HandStatus status;
  servo_.newest().refresh();
  status.tick = servo_.newest().value();
  status.device = servo_.specification().name;
  status.max_force_N = servo_.specification().max_force_N;
  status.real_time = loop_.real_time().text();
  status.tick_count = servo_.tick_count();
  status.missed_count = loop_.missed_count();
  status.lateness_p99_us = loop_.lateness().quantile_us(0.99);
  status.pipette = manipulator_.newest_state();
  if (const auto counts = manipulator_.counts(); counts.lost_count > counts.reopen_count)
    status.fault = counts.last_fault;
  return status;
}

}  // namespace pellucida
