#include "pellucida/simulation/OperatorMotion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pellucida/haptics/HapticDevice.h"

namespace pellucida {
namespace {

constexpr double kHaltTime_s = 0.04;
constexpr double kTargetWidth_um = 3.0;
constexpr double kTremorBandwidth_Hz = 1.0;
constexpr int kTremorSettling = 2000;  // steps: two seconds, before anybody looks

}  // namespace

OperatorMotion::OperatorMotion(const OperatorOptions& options, double scale_um_per_m) noexcept
    : options_(options), scale_um_per_m_(scale_um_per_m) {}

void OperatorMotion::aim(const Eigen::Vector3d& way_um, double least_duration_s, double now_s,
                         NormalNoise& noise) noexcept {
  if (move_count_ == static_cast<int>(moves_.size())) return;
  const double length_um = way_um.norm();
  const double wanted_s = options_.fitts_offset_s + options_.fitts_slope_s * std::log2(1 + length_um / kTargetWidth_um);
  const Eigen::Vector3d done = way_um + options_.motor_noise_ratio * length_um / std::sqrt(3.0) * noise.three().eigen();
  Submovement& move = moves_[static_cast<std::size_t>(move_count_++)];
  move.start_s = now_s;
  move.duration_s = std::max(wanted_s, least_duration_s);
  move.way_m = hand_from_world(Eigen::Vector3d(done / scale_um_per_m_));
  ++submovement_count_;
}

void OperatorMotion::halt() noexcept {
  base_m_ = position_m_;
  drift_m_per_s_ = velocity_m_per_s_;
  move_count_ = 0;
}

Eigen::Vector3d OperatorMotion::end_m() const noexcept {
  Eigen::Vector3d end_m = base_m_.eigen() + kHaltTime_s * drift_m_per_s_.eigen();
  for (int k = 0; k < move_count_; ++k) end_m += moves_[static_cast<std::size_t>(k)].way_m.eigen();
  return end_m;
}

PlainVector3 OperatorMotion::position_before_m(double lag_s) const noexcept {
  const auto size = static_cast<long>(past_m_.size());
  const long step = step_count_ - 1 - std::min(std::lround(lag_s / kOperatorStep_s), size - 1);
  return step >= 0 ? past_m_[static_cast<std::size_t>(step % size)] : PlainVector3{};
}

void OperatorMotion::step(double now_s) noexcept {
  // Ended moves, those under way, and what a halt has left.
  drift_m_per_s_ = Eigen::Vector3d(std::exp(-kOperatorStep_s / kHaltTime_s) * drift_m_per_s_.eigen());
  base_m_ = Eigen::Vector3d(base_m_.eigen() + kOperatorStep_s * drift_m_per_s_.eigen());
  Eigen::Vector3d position = base_m_.eigen(), velocity = drift_m_per_s_.eigen();
  int kept = 0;
  for (int k = 0; k < move_count_; ++k) {
    const Submovement& move = moves_[static_cast<std::size_t>(k)];
    const double u = (now_s + kOperatorStep_s - move.start_s) / move.duration_s;
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
  position_m_ = position;
  velocity_m_per_s_ = velocity;
  past_m_[static_cast<std::size_t>(step_count_++) % past_m_.size()] = position_m_;
}

OperatorTremor::OperatorTremor(const OperatorOptions& options, NormalNoise& noise) noexcept {
  // The gain gives each of three axes its share.
  const double pi = std::numbers::pi, r = std::exp(-pi * kTremorBandwidth_Hz * kOperatorStep_s);
  const double angle = 2 * pi * options.tremor_Hz * kOperatorStep_s, r2 = r * r;
  pole_ = r2;
  turn_ = 2 * r * std::cos(angle);
  const double variance = (1 + r2) / ((1 - r2) * (1 + r2 * r2 - 2 * r2 * std::cos(2 * angle)));
  gain_m_ = options.tremor_rms_m / std::sqrt(3 * variance);
  for (int k = 0; k < kTremorSettling; ++k) step(noise);
}

void OperatorTremor::step(NormalNoise& noise) noexcept {
  const Eigen::Vector3d now = turn_ * state_[0].eigen() - pole_ * state_[1].eigen() + gain_m_ * noise.three().eigen();
  state_[1] = state_[0];
  state_[0] = now;
}

}  // namespace pellucida
