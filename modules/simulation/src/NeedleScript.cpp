#include "pellucida/simulation/NeedleScript.h"

#include <algorithm>

namespace pellucida {

NeedleScript::NeedleScript(const Scenario::Motion& motion) : window_s_(motion.smoothing_s) {
  // The broken line of constant speeds. It begins with half a window of rest, so that the average starts at -gap.
  auto corner = [this](double duration_s, double depth_um) {
    time_s_.push_back((time_s_.empty() ? 0.0 : time_s_.back()) + duration_s);
    depth_um_.push_back(depth_um);
  };
  corner(0, -motion.gap_um);
  corner(window_s_ / 2, -motion.gap_um);
  if (motion.gap_um > 0) corner(motion.gap_um / motion.approach_speed_um_per_s, 0);
  if (motion.indentation_um > 0)
    corner(motion.indentation_um / motion.indentation_speed_um_per_s, motion.indentation_um);
  corner(motion.hold_s, motion.indentation_um);
  if (motion.retraction_speed_um_per_s > 0) {
    corner((motion.indentation_um + motion.gap_um) / motion.retraction_speed_um_per_s, -motion.gap_um);
    corner(window_s_ / 2, -motion.gap_um);
  }
  end_s_ = time_s_.back();

  integral_.assign(1, 0.0);
  for (std::size_t i = 1; i < time_s_.size(); ++i)
    integral_.push_back(integral_.back() + (time_s_[i] - time_s_[i - 1]) * (depth_um_[i] + depth_um_[i - 1]) / 2);
}

double NeedleScript::integral(double time_s) const {
  // Constant before the first and after the last corner.
  if (time_s <= 0) return depth_um_.front() * time_s;
  if (time_s >= end_s_) return integral_.back() + depth_um_.back() * (time_s - end_s_);
  // Corners at the same time (no window, no hold) are passed over: the one after `time_s` is taken.
  const auto i = static_cast<std::size_t>(std::upper_bound(time_s_.begin(), time_s_.end(), time_s) - time_s_.begin());
  const double part = time_s - time_s_[i - 1], length = time_s_[i] - time_s_[i - 1];
  const double slope = (depth_um_[i] - depth_um_[i - 1]) / length;
  return integral_[i - 1] + part * (depth_um_[i - 1] + slope * part / 2);
}

double NeedleScript::depth_um(double time_s) const {
  const double half_s = std::max(window_s_, 1e-6) / 2;
  return (integral(time_s + half_s) - integral(time_s - half_s)) / (2 * half_s);
}

}  // namespace pellucida
