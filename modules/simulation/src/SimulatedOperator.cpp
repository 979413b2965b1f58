#include "pellucida/simulation/SimulatedOperator.h"

#include <cmath>
#include <string>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/haptics/HapticDevice.h"

namespace pellucida {
namespace {

constexpr int kLooksToArrive = 2;
constexpr double kPeakOverMean = 1.875;  // of a minimum-jerk move's speed

void require(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw UsageError("operator." + std::string(name) + " is " + csv_number(value) + "; allowed: " + csv_number(low) +
                   " to " + csv_number(high));
}

const OperatorOptions& checked(const OperatorOptions& options, const OperatorPlan& plan) {
  require("visual_delay_s", options.visual_delay_s, 0.0, 1.0);
  require("haptic_delay_s", options.haptic_delay_s, 0.0, 0.5);
  require("tremor_rms_m", options.tremor_rms_m, 0.0, 1e-3);
  require("tremor_Hz", options.tremor_Hz, 8.0, 12.0);
  require("lateral_noise_um", options.lateral_noise_um, 0.0, 100.0);
  require("flat_depth_noise_um", options.flat_depth_noise_um, 0.0, 100.0);
  require("space_depth_noise_um", options.space_depth_noise_um, 0.0, 100.0);
  require("noise_memory", options.noise_memory, 0.0, 0.999);
  require("motor_noise_ratio", options.motor_noise_ratio, 0.0, 0.5);
  require("look_interval_s", options.look_interval_s, 0.01, 2.0);
  require("tolerance_um", options.tolerance_um, 0.1, 100.0);
  require("fitts_offset_s", options.fitts_offset_s, 0.05, 2.0);
  require("fitts_slope_s", options.fitts_slope_s, 0.0, 2.0);
  require("drop_ratio", options.drop_ratio, 0.0, 1.0);
  require("just_felt_N", options.just_felt_N, 0.0, 10.0);
  require("slowing_N", options.slowing_N, 0.0, 100.0);
  require("plan.scale_um_per_m", plan.scale_um_per_m, 1.0, 1e6);
  require("plan.insertion_speed_um_per_s", plan.insertion_speed_um_per_s, 0.1, 1e4);
  require("plan.inject_s", plan.inject_s, 0.0, 600.0);
  require("plan.deepest_push_um", plan.deepest_push_um, 0.0, 1e4);
  require("plan.lag_s", plan.lag_s, 0.0, 0.5);
  return options;
}

// Unit vector from entry to target, frame W; zero where they are one place.
Eigen::Vector3d line_of(const OperatorPlan& plan) noexcept {
  const Eigen::Vector3d line = plan.target_um.eigen() - plan.entry_um.eigen();
  const double length_um = line.norm();
  return length_um > 0 ? Eigen::Vector3d(line / length_um) : Eigen::Vector3d::Zero();
}

}  // namespace

const char* to_string(OperatorPhase phase) noexcept {
  switch (phase) {
    case OperatorPhase::kLook:
      return "look";
    case OperatorPhase::kApproach:
      return "approach";
    case OperatorPhase::kInsert:
      return "insert";
    case OperatorPhase::kDeposit:
      return "deposit";
    case OperatorPhase::kRemove:
      return "remove";
    case OperatorPhase::kDone:
      return "done";
  }
  return "";
}

SimulatedOperator::SimulatedOperator(const OperatorOptions& options, const OperatorPlan& plan, std::uint64_t seed)
    : options_(checked(options, plan)),
      plan_(plan),
      noise_(seed),
      tremor_(options, noise_),
      perception_(options, hand_from_world(Eigen::Vector3d(-line_of(plan))), noise_),
      motion_(options, plan.scale_um_per_m) {}

void SimulatedOperator::see(const OperatorView& view) noexcept {
  perception_.see(view, motion_.position_before_m(plan_.lag_s));
}

const PlainVector3& SimulatedOperator::goal_um() const noexcept {
  switch (phase_) {
    case OperatorPhase::kInsert:
    case OperatorPhase::kDeposit:
      return plan_.target_um;
    case OperatorPhase::kRemove:
    case OperatorPhase::kDone:
      return plan_.removal_um;
    default:
      return plan_.approach_um;
  }
}

void SimulatedOperator::enter(OperatorPhase phase) noexcept {
  phase_ = phase;
  reached_looks_ = 0;
}

void SimulatedOperator::notice_puncture() noexcept {
  noticed_s_ = time_s();
  motion_.halt();
  next_look_s_ = time_s() + options_.look_interval_s;
}

// Into the cell: steadily on along the line, whatever lies before the tip, until the membrane has given way.
void SimulatedOperator::push_on(const Eigen::Vector3d& seen_um, const Eigen::Vector3d& way_um) noexcept {
  const Eigen::Vector3d along = line_of(plan_);
  if ((seen_um - plan_.entry_um.eigen()).dot(along) >= plan_.deepest_push_um) {
    noticed_s_ = time_s();  // taken for granted
    motion_.halt();
    return;
  }
  const Eigen::Vector3d sideways = way_um - way_um.dot(along) * along;
  const double slower = options_.slowing_N > 0 ? 1 / (1 + perception_.resistance_N() / options_.slowing_N) : 1.0;
  const double step_um = slower * plan_.insertion_speed_um_per_s * options_.look_interval_s;
  motion_.aim(Eigen::Vector3d(sideways + step_um * along), 2 * options_.look_interval_s, time_s(), noise_);
}

// The goal is reached: what comes next.
void SimulatedOperator::arrive() noexcept {
  if (phase_ == OperatorPhase::kApproach) {
    enter(OperatorPhase::kInsert);
  } else if (phase_ == OperatorPhase::kInsert) {
    enter(OperatorPhase::kDeposit);
    inject_until_s_ = time_s() + plan_.inject_s;
  } else {
    enter(OperatorPhase::kDone);
  }
}

// One look: is the goal reached, and if not, which submovement leads there?
void SimulatedOperator::decide(const OperatorPerception::Seen& seen) noexcept {
  const Eigen::Vector3d seen_um = perception_.look(seen, noise_);
  // The motion commanded since, and the one still being commanded.
  const Eigen::Vector3d done_um =
      plan_.scale_um_per_m * world_from_hand(Eigen::Vector3d(motion_.end_m() - seen.intended_m.eigen())).eigen();
  const Eigen::Vector3d error_um = goal_um().eigen() - seen_um;
  const Eigen::Vector3d way_um = error_um - done_um;
  if (phase_ == OperatorPhase::kInsert && noticed_s_ < 0) {
    push_on(seen_um, way_um);
    return;
  }
  const Eigen::Vector3d allowed_um = (perception_.noise_um().array() + options_.tolerance_um).matrix();
  const bool reached = (error_um.array().abs() <= allowed_um.array()).all();
  reached_looks_ = reached ? reached_looks_ + 1 : 0;
  if (reached_looks_ >= kLooksToArrive && phase_ != OperatorPhase::kDeposit) {
    arrive();
    return;
  }
  if ((way_um.array().abs() <= 0.5 * allowed_um.array()).all()) return;
  const bool slow = phase_ == OperatorPhase::kInsert;
  const double least_s = slow ? kPeakOverMean * way_um.norm() / plan_.insertion_speed_um_per_s : 0.0;
  motion_.aim(way_um, least_s, time_s(), noise_);
}

const OperatorIntent& SimulatedOperator::tick(const PlainVector3& force_N) noexcept {
  tremor_.step(noise_);
  const auto pushes = [this] { return phase_ == OperatorPhase::kInsert && noticed_s_ < 0; };
  if (perception_.feel(force_N, pushes())) notice_puncture();
  const double now_s = time_s();
  if (phase_ == OperatorPhase::kDeposit && now_s >= inject_until_s_) enter(OperatorPhase::kRemove);

  // The first look takes a reaction; then one now and then.
  const auto seen = phase_ == OperatorPhase::kDone ? std::nullopt : perception_.newest(now_s);
  if (seen) {
    if (pushes() && seen->view.membrane_closed) notice_puncture();
    if (now_s >= next_look_s_) {
      if (phase_ == OperatorPhase::kLook) enter(OperatorPhase::kApproach);
      decide(*seen);
      next_look_s_ = now_s + options_.look_interval_s;
    }
  }
  motion_.step(now_s);
  intent_ = {motion_.position_m(), motion_.velocity_m_per_s(), phase_ == OperatorPhase::kDeposit};
  ++tick_;
  return intent_;
}

}  // namespace pellucida
