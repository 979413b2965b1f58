#include "pellucida/simulation/OperatorModel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

constexpr double kTremorBandwidth_Hz = 1.0;
constexpr double kHaltTime_s = 0.04;
constexpr double kFeelingTime_s = 0.02;

void require(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw UsageError("operator." + std::string(name) + " is " + csv_number(value) + "; allowed: " + csv_number(low) +
                   " to " + csv_number(high));
}

// Frame W of the picture and frame H of the hand: the same half turn about x, either way.
PlainVector3 turned(const Eigen::Vector3d& v) noexcept {
  return {v.x(), -v.y(), -v.z()};
}

// splitmix64, to fill the state; xoshiro256++ (Blackman and Vigna, 2021) for the numbers.
std::uint64_t mixed(std::uint64_t& state) noexcept {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

std::uint64_t next(std::array<std::uint64_t, 4>& s) noexcept {
  auto turn = [](std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); };
  const std::uint64_t result = turn(s[0] + s[3], 23) + s[0], t = s[1] << 17;
  s[2] ^= s[0];
  s[3] ^= s[1];
  s[1] ^= s[2];
  s[0] ^= s[3];
  s[2] ^= t;
  s[3] = turn(s[3], 45);
  return result;
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

OperatorModel::OperatorModel(const OperatorOptions& options, const OperatorPlan& plan, std::uint64_t seed)
    : options_(options),
      plan_(plan),
      haptics_(options.modality == Modality::kSpaceAndHaptics || options.modality == Modality::kSpaceAndFixture),
      depth_noise_um_(options.modality == Modality::kFlatImage ? options.flat_depth_noise_um
                                                               : options.space_depth_noise_um) {
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
  for (auto& word : random_) word = mixed(seed);
  const Eigen::Vector3d line = plan.target_um.eigen() - plan.entry_um.eigen();
  if (line.norm() > 0) against_ = turned(-line.normalized());

  // Tremor: white noise through two poles at its frequency; the gain gives each of three axes its share.
  const double pi = std::numbers::pi, r = std::exp(-pi * kTremorBandwidth_Hz * kStep_s);
  const double angle = 2 * pi * options.tremor_Hz * kStep_s, r2 = r * r;
  tremor_pole_ = r2;
  tremor_turn_ = 2 * r * std::cos(angle);
  const double variance = (1 + r2) / ((1 - r2) * (1 + r2 * r2 - 2 * r2 * std::cos(2 * angle)));
  tremor_gain_m_ = options.tremor_rms_m / std::sqrt(3 * variance);
  // A second and more, so that it has settled before anybody looks.
  for (int k = 0; k < 2000; ++k) shake();
  sight_error_um_ = normals();
}

double OperatorModel::normal() noexcept {
  if (spare_known_) {
    spare_known_ = false;
    return spare_;
  }
  // Box and Muller; 53 bits, never 0.
  const double u = (static_cast<double>(next(random_) >> 11) + 0.5) * 0x1.0p-53;
  const double angle = 2 * std::numbers::pi * static_cast<double>(next(random_) >> 11) * 0x1.0p-53;
  const double radius = std::sqrt(-2 * std::log(u));
  spare_ = radius * std::sin(angle);
  spare_known_ = true;
  return radius * std::cos(angle);
}

PlainVector3 OperatorModel::normals() noexcept {
  const double x = normal(), y = normal(), z = normal();
  return {x, y, z};
}

void OperatorModel::shake() noexcept {
  const Eigen::Vector3d now = tremor_turn_ * tremor_state_[0].eigen() - tremor_pole_ * tremor_state_[1].eigen() +
                              tremor_gain_m_ * normals().eigen();
  tremor_state_[1] = tremor_state_[0];
  tremor_state_[0] = now;
  tremor_m_ = now;
}

void OperatorModel::see(const OperatorView& view) noexcept {
  if (!view.tip_um.eigen().allFinite()) return;
  // Before the first tick nothing was commanded.
  const long lag = std::min(std::lround(plan_.lag_s / kStep_s), static_cast<long>(intended_m_.size()) - 1);
  const long told = tick_ - 1 - lag;
  const PlainVector3 intended_m =
      told >= 0 ? intended_m_[static_cast<std::size_t>(told) % intended_m_.size()] : PlainVector3{};
  seen_[static_cast<std::size_t>(seen_next_)] = {view, intended_m};
  seen_next_ = (seen_next_ + 1) % static_cast<int>(seen_.size());
  seen_count_ = std::min(seen_count_ + 1, static_cast<int>(seen_.size()));
}

bool OperatorModel::newest_seen(Seen& seen) const noexcept {
  const int size = static_cast<int>(seen_.size());
  for (int k = 1; k <= seen_count_; ++k) {
    const Seen& candidate = seen_[static_cast<std::size_t>((seen_next_ - k + size) % size)];
    if (candidate.view.time_s > time_s() - options_.visual_delay_s) continue;
    seen = candidate;
    return candidate.view.tip_seen;
  }
  return false;
}

PlainVector3 OperatorModel::goal_um() const noexcept {
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

void OperatorModel::enter(OperatorPhase phase) noexcept {
  phase_ = phase;
  reached_looks_ = 0;
}

// A minimum-jerk submovement; its length, not its start, has the noise.
void OperatorModel::aim(const PlainVector3& way_um, double least_duration_s) noexcept {
  if (move_count_ == static_cast<int>(moves_.size())) return;
  constexpr double kTargetWidth_um = 3.0;
  const Eigen::Vector3d way = way_um.eigen();
  const double length_um = way.norm();
  const double wanted_s = options_.fitts_offset_s + options_.fitts_slope_s * std::log2(1 + length_um / kTargetWidth_um);
  const Eigen::Vector3d done = way + options_.motor_noise_ratio * length_um / std::sqrt(3.0) * normals().eigen();
  Submovement& move = moves_[static_cast<std::size_t>(move_count_++)];
  move.start_s = time_s();
  move.duration_s = std::max(wanted_s, least_duration_s);
  move.way_m = turned(done / plan_.scale_um_per_m);
  ++submovement_count_;
}

// Lets the submovements under way run out at once: what speed they had fades.
void OperatorModel::halt() noexcept {
  base_m_ = intent_.position_m;
  drift_m_per_s_ = intent_.velocity_m_per_s;
  move_count_ = 0;
}

// What was felt a reaction time ago: a force that rose and then fell is the membrane that gave way.
void OperatorModel::feel(const PlainVector3& force_N) noexcept {
  // Feeling follows slow changes: tremor is not taken for a force.
  const double resistance_N = std::max(0.0, force_N.eigen().dot(against_.eigen()));
  felt_now_N_ += kStep_s / kFeelingTime_s * (resistance_N - felt_now_N_);
  const auto size = static_cast<long>(felt_N_.size());
  felt_N_[static_cast<std::size_t>(tick_ % size)] = felt_now_N_;
  const long delay = std::min(std::lround(options_.haptic_delay_s / kStep_s), size - 1);
  if (!haptics_ || phase_ != OperatorPhase::kInsert || noticed_s_ >= 0 || tick_ < delay) {
    felt_peak_N_ = felt_late_N_ = 0.0;
    return;
  }
  felt_late_N_ = felt_N_[static_cast<std::size_t>((tick_ - delay) % size)];
  felt_peak_N_ = std::max(felt_peak_N_, felt_late_N_);
  if (felt_peak_N_ < options_.just_felt_N || felt_late_N_ >= options_.drop_ratio * felt_peak_N_) return;
  noticed_s_ = time_s();
  halt();
  next_look_s_ = time_s() + options_.look_interval_s;
}

// The picture a reaction time ago shows that the membrane has closed about the shaft.
void OperatorModel::notice(const Seen& seen) noexcept {
  if (phase_ != OperatorPhase::kInsert || noticed_s_ >= 0 || !seen.view.membrane_closed) return;
  noticed_s_ = time_s();
  halt();
  next_look_s_ = time_s() + options_.look_interval_s;
}

// One look: is the point reached, and if not, which submovement leads there?
void OperatorModel::decide(const Seen& seen) noexcept {
  // Sight: its error changes slowly.
  const double memory = options_.noise_memory, fresh = std::sqrt(1 - memory * memory);
  sight_error_um_ = Eigen::Vector3d(memory * sight_error_um_.eigen() + fresh * normals().eigen());
  const Eigen::Vector3d noise_um(options_.lateral_noise_um, options_.lateral_noise_um, depth_noise_um_);
  const Eigen::Vector3d seen_um = seen.view.tip_um.eigen() + noise_um.cwiseProduct(sight_error_um_.eigen());

  // The motion commanded since, and the one still being commanded.
  Eigen::Vector3d end_m = base_m_.eigen() + kHaltTime_s * drift_m_per_s_.eigen();
  for (int k = 0; k < move_count_; ++k) end_m += moves_[static_cast<std::size_t>(k)].way_m.eigen();
  const Eigen::Vector3d told = plan_.scale_um_per_m * turned(end_m - seen.intended_m.eigen()).eigen();
  const Eigen::Vector3d error_um = goal_um().eigen() - seen_um;
  Eigen::Vector3d way_um = error_um - told;

  // Into the cell: steadily on along the line, whatever lies before the tip, until the membrane has given way.
  if (phase_ == OperatorPhase::kInsert && noticed_s_ < 0) {
    const Eigen::Vector3d line = plan_.target_um.eigen() - plan_.entry_um.eigen();
    const double length_um = line.norm();
    const Eigen::Vector3d along = length_um > 0 ? Eigen::Vector3d(line / length_um) : Eigen::Vector3d::Zero();
    if ((seen_um - plan_.entry_um.eigen()).dot(along) >= plan_.deepest_push_um) {
      noticed_s_ = time_s();  // taken for granted
      halt();
      return;
    }
    const Eigen::Vector3d sideways = way_um - way_um.dot(along) * along;
    const double slower = options_.slowing_N > 0 ? 1 / (1 + felt_late_N_ / options_.slowing_N) : 1.0;
    const double step_um = slower * plan_.insertion_speed_um_per_s * options_.look_interval_s;
    aim(Eigen::Vector3d(sideways + step_um * along), 2 * options_.look_interval_s);
    return;
  }

  // A point is reached when two looks say so.
  const Eigen::Vector3d allowed_um = (noise_um.array() + options_.tolerance_um).matrix();
  const bool reached = (error_um.array().abs() <= allowed_um.array()).all();
  reached_looks_ = reached ? reached_looks_ + 1 : 0;
  if (reached_looks_ >= 2) {
    if (phase_ == OperatorPhase::kApproach) {
      enter(OperatorPhase::kInsert);
      return;
    }
    if (phase_ == OperatorPhase::kInsert) {
      enter(OperatorPhase::kDeposit);
      inject_until_s_ = time_s() + plan_.inject_s;
      return;
    }
    if (phase_ == OperatorPhase::kRemove) {
      enter(OperatorPhase::kDone);
      return;
    }
  }
  if ((way_um.array().abs() <= 0.5 * allowed_um.array()).all()) return;
  constexpr double kPeakOverMean = 1.875;  // of a minimum-jerk move's speed
  const bool slow = phase_ == OperatorPhase::kInsert;
  aim(way_um, slow ? kPeakOverMean * way_um.norm() / plan_.insertion_speed_um_per_s : 0.0);
}

const OperatorIntent& OperatorModel::tick(const PlainVector3& force_N) noexcept {
  shake();
  feel(force_N);
  const double now_s = time_s();

  // The first look takes a reaction; then one now and then.
  if (phase_ == OperatorPhase::kDeposit && now_s >= inject_until_s_) enter(OperatorPhase::kRemove);
  Seen seen;
  if (phase_ != OperatorPhase::kDone && newest_seen(seen)) {
    notice(seen);
    if (now_s >= next_look_s_) {
      if (phase_ == OperatorPhase::kLook) enter(OperatorPhase::kApproach);
      decide(seen);
      next_look_s_ = now_s + options_.look_interval_s;
    }
  }

  // The equilibrium: ended moves, those under way, and what a halt has left.
  drift_m_per_s_ = Eigen::Vector3d(std::exp(-kStep_s / kHaltTime_s) * drift_m_per_s_.eigen());
  base_m_ = Eigen::Vector3d(base_m_.eigen() + kStep_s * drift_m_per_s_.eigen());
  Eigen::Vector3d position = base_m_.eigen(), velocity = drift_m_per_s_.eigen();
  int kept = 0;
  for (int k = 0; k < move_count_; ++k) {
    const Submovement& move = moves_[static_cast<std::size_t>(k)];
    const double u = (now_s + kStep_s - move.start_s) / move.duration_s;
    if (u >= 1) {
      base_m_ = Eigen::Vector3d(base_m_.eigen() + move.way_m.eigen());
      position += move.way_m.eigen();
      continue;
    }
    position += u * u * u * (10 + u * (6 * u - 15)) * move.way_m.eigen();
    velocity += 30 * u * u * (1 - u) * (1 - u) / move.duration_s * move.way_m.eigen();
    moves_[static_cast<std::size_t>(kept++)] = move;
  }
  move_count_ = kept;
  intent_ = {position, velocity, phase_ == OperatorPhase::kDeposit};
  intended_m_[static_cast<std::size_t>(tick_) % intended_m_.size()] = intent_.position_m;
  ++tick_;
  return intent_;
}

}  // namespace pellucida
