#include "pellucida/teleoperation/EppendorfManipulator.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <exception>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// A motion and a question with their answers are some 80 characters of 10 bits: 42 ms of the line at 19200 baud.
constexpr double kRate_Hz = 20.0;

}  // namespace

EppendorfManipulator::EppendorfManipulator(const EppendorfOptions& options) : options_(options) {
  for (const double value :
       {options.max_speed_um_per_s, options.travel_um, options.answer_timeout_s, options.standstill_timeout_s}) {
    if (value > 0.0 && std::isfinite(value)) continue;
    throw UsageError("Eppendorf manipulator: speed, travel and times must be above 0, not " + std::to_string(value));
  }
  if (!(options.microsteps_per_um >= 0.0) || !std::isfinite(options.microsteps_per_um)) {
    throw UsageError("Eppendorf manipulator: microsteps per um must be 0 (use um) or above, not " +
                     std::to_string(options.microsteps_per_um));
  }
  for (int column = 0; column < 3; ++column) world_from_device_.col(column) = options.axes[column].eigen();
  if (!world_from_device_.allFinite() || !(std::abs(world_from_device_.determinant()) > 0.01)) {
    throw UsageError("Eppendorf manipulator: the three axes must be unit vectors that span space");
  }
  if (options.microsteps_per_um > 0.0) units_per_um_ = options.microsteps_per_um;
  specification_.name = "Eppendorf manipulator at " + options.port;
  place_travel();
  specification_.max_speed_um_per_s = options.max_speed_um_per_s;
  specification_.resolution_um = 1.0 / units_per_um_;
  specification_.rate_Hz = kRate_Hz;
  specification_.source = "PatchMan NP 2 operating manual, appendix PC interface; travel and speed: chosen";
}

EppendorfManipulator::~EppendorfManipulator() {
  close();
}

void EppendorfManipulator::open() {
  if (line_) return;
  line_ = std::make_unique<EppendorfLine>(options_.port);
  sent_ = stopped_ = polled_ = clamped_ = false;
  try {
    version_ = line_->ask(EppendorfCode::kVersion, options_.answer_timeout_s).text;
  } catch (...) {
    line_.reset();
    throw;
  }
  ask(EppendorfCode::kRemoteControl, eppendorf_command(EppendorfCode::kRemoteControl), options_.standstill_timeout_s);
  position_ = ask_position();
}

void EppendorfManipulator::close() noexcept {
  if (!line_) return;
  try {
    // Finally: stop, and return joystick and keys to the user.
    line_->ask(EppendorfCode::kStop, options_.answer_timeout_s);
    line_->ask(EppendorfCode::kManualControl, options_.answer_timeout_s);
  } catch (const std::exception&) {
    // It has disappeared: there is nothing left to command.
  }
  line_.reset();
}

void EppendorfManipulator::ask(EppendorfCode code, const std::string& command, double timeout_s) {
  try {
    line_->ask(code, command, timeout_s);
  } catch (...) {
    line_.reset();
    throw;
  }
}

Eigen::Vector3d EppendorfManipulator::ask_position() {
  const EppendorfCode code =
      options_.microsteps_per_um > 0.0 ? EppendorfCode::kPositionMicrosteps : EppendorfCode::kPositionMicrometres;
  try {
    const EppendorfPosition position = line_->ask_position(code, options_.answer_timeout_s);
    at_switch_ = position.limit_switches != 0;
    return {static_cast<double>(position.coordinates[0]), static_cast<double>(position.coordinates[1]),
            static_cast<double>(position.coordinates[2])};
  } catch (...) {
    line_.reset();
    throw;
  }
}

void EppendorfManipulator::demand_open() const {
  if (!line_) throw DeviceError(specification_.name + ": not open; open it first");
}

void EppendorfManipulator::place_travel() {
  const Eigen::Vector3d reach_um = world_from_device_.cwiseAbs() * Eigen::Vector3d::Constant(options_.travel_um);
  specification_.lower_um = Eigen::Vector3d(origin_um_ - reach_um);
  specification_.upper_um = Eigen::Vector3d(origin_um_ + reach_um);
}

void EppendorfManipulator::register_tip(const PlainVector3& tip_um) {
  demand_open();
  position_ = ask_position();
  origin_um_ = tip_um.eigen() - world_from_device_ * (position_ / units_per_um_);
  place_travel();
}

void EppendorfManipulator::halt() {
  ask(EppendorfCode::kStop, eppendorf_command(EppendorfCode::kStop), options_.standstill_timeout_s);
  sent_ = false;
}

void EppendorfManipulator::command(const PipetteCommand& command, double) {
  demand_open();
  if (command.stop) {
    if (!stopped_) halt();
    stopped_ = true;
    return;
  }
  stopped_ = false;
  const double speed_um_per_s = std::min(command.max_speed_um_per_s, options_.max_speed_um_per_s);
  if (!(speed_um_per_s > 0.0) || !command.tip_um.eigen().allFinite()) {
    if (sent_) halt();
    return;
  }
  // Frame W to the device's axes and units, within the travel.
  const Eigen::Vector3d wished = world_from_device_.inverse() * (command.tip_um.eigen() - origin_um_) * units_per_um_;
  const double travel = options_.travel_um * units_per_um_;
  const Eigen::Vector3d target = wished.cwiseMax(-travel).cwiseMin(travel);
  clamped_ = target != wished;
  move(target, speed_um_per_s);
}

void EppendorfManipulator::move(const Eigen::Vector3d& target, double speed_um_per_s) {
  const Eigen::Vector3d way = target.array().round().matrix() - position_;
  const double length = way.norm();
  if (length < 0.5 && !sent_) return;
  std::array<long, 3> position{}, speed{};
  for (int axis = 0; axis < 3; ++axis) {
    position[axis] = std::lround(target[axis]);
    // The speed shared so that the axes arrive together; an axis with nothing to do gets 0.
    const double share = length > 0.0 ? std::abs(way[axis]) / length : 0.0;
    speed[axis] = share > 0.0 ? std::max(1L, std::lround(share * speed_um_per_s * units_per_um_)) : 0;
  }
  if (sent_ && position == sent_position_ && speed_um_per_s == sent_speed_um_per_s_) return;
  const EppendorfCode code =
      options_.microsteps_per_um > 0.0 ? EppendorfCode::kGoToMicrosteps : EppendorfCode::kGoToMicrometres;
  ask(code, eppendorf_go_to(code, position, speed), options_.answer_timeout_s);
  sent_position_ = position;
  sent_speed_um_per_s_ = speed_um_per_s;
  sent_ = true;
}

PipetteState EppendorfManipulator::state(double now_s) {
  demand_open();
  const Eigen::Vector3d before = position_;
  position_ = ask_position();
  PipetteState state;
  state.time_s = now_s;
  state.known = true;
  state.tip_um = Eigen::Vector3d(origin_um_ + world_from_device_ * (position_ / units_per_um_));
  if (polled_ && now_s > polled_s_) {
    state.velocity_um_per_s =
        Eigen::Vector3d(world_from_device_ * (position_ - before) / units_per_um_ / (now_s - polled_s_));
  }
  state.moving = polled_ && position_ != before;
  state.at_limit = at_switch_ || clamped_;
  state.stopped = stopped_;
  polled_ = true;
  polled_s_ = now_s;
  return state;
}

}  // namespace pellucida
