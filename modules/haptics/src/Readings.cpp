#include "pellucida/haptics/Readings.h"

#include <utility>

namespace pellucida {

HandReadout HandReader::read(const HandSample* sample, double now_s, double dt_s, const CellLimits& limits,
                             ActingLimits& acting) noexcept {
  HandReadout readout;
  if (!sample) {
    acting.add(LimitKind::kHandLost);
    guard_.clear();
    velocity_.clear();
    return readout;
  }
  const HandReading reading = guard_.check(*sample, dt_s, limits.max_hand_speed_m_per_s);
  if (reading == HandReading::kNotFinite) {
    acting.add(LimitKind::kHandInvalid);
    return readout;
  }
  readout.good = true;
  readout.position_m = sample->position_m.eigen();
  if (reading == HandReading::kJump) {
    acting.add(LimitKind::kHandJump);
    readout.anew = true;
  }
  if (dt_s > limits.late_tick_s) {
    acting.add(LimitKind::kLateTick, dt_s, limits.late_tick_s);
    readout.anew = true;
  }
  if (readout.anew) velocity_.clear();
  const Eigen::Vector3d estimated = velocity_.update(now_s, readout.position_m);
  readout.velocity_m_per_s = sample->velocity_known ? sample->velocity_m_per_s.eigen() : estimated;
  return readout;
}

void PipetteReader::see(const PipetteState& state, double max_speed_um_per_s) noexcept {
  const auto report = guard_.check(state, max_speed_um_per_s);
  known_ = report != PipetteGuard::Report::kUnknown;
  jumped_ = jumped_ || report == PipetteGuard::Report::kJump;
  if (known_) state_ = state;
}

bool PipetteReader::take_jump() noexcept {
  return std::exchange(jumped_, false);
}

}  // namespace pellucida
