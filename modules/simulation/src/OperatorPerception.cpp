#include "pellucida/simulation/OperatorPerception.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

constexpr double kFeelingTime_s = 0.02;

}  // namespace

OperatorPerception::OperatorPerception(const OperatorOptions& options, const PlainVector3& against,
                                       NormalNoise& noise) noexcept
    : options_(options),
      haptics_(options.modality == Modality::kSpaceAndHaptics || options.modality == Modality::kSpaceAndFixture),
      depth_noise_um_(options.modality == Modality::kFlatImage ? options.flat_depth_noise_um
                                                               : options.space_depth_noise_um),
      against_(against),
      sight_error_(noise.three()) {}

void OperatorPerception::see(const OperatorView& view, const PlainVector3& intended_m) noexcept {
  if (!view.tip_um.eigen().allFinite()) return;
  seen_[static_cast<std::size_t>(seen_next_)] = {view, intended_m};
  seen_next_ = (seen_next_ + 1) % static_cast<int>(seen_.size());
  seen_count_ = std::min(seen_count_ + 1, static_cast<int>(seen_.size()));
}

std::optional<OperatorPerception::Seen> OperatorPerception::newest(double time_s) const noexcept {
  const int size = static_cast<int>(seen_.size());
  for (int k = 1; k <= seen_count_; ++k) {
    const Seen& candidate = seen_[static_cast<std::size_t>((seen_next_ - k + size) % size)];
    if (candidate.view.time_s > time_s - options_.visual_delay_s) continue;
    if (!candidate.view.tip_seen) return std::nullopt;
    return candidate;
  }
  return std::nullopt;
}

Eigen::Vector3d OperatorPerception::noise_um() const noexcept {
  return {options_.lateral_noise_um, options_.lateral_noise_um, depth_noise_um_};
}

Eigen::Vector3d OperatorPerception::look(const Seen& seen, NormalNoise& noise) noexcept {
  const double memory = options_.noise_memory, fresh = std::sqrt(1 - memory * memory);
  sight_error_ = Eigen::Vector3d(memory * sight_error_.eigen() + fresh * noise.three().eigen());
  return seen.view.tip_um.eigen() + noise_um().cwiseProduct(sight_error_.eigen());
}

bool OperatorPerception::feel(const PlainVector3& force_N, bool attends) noexcept {
  const double resistance_N = std::max(0.0, force_N.eigen().dot(against_.eigen()));
  felt_now_N_ += kOperatorStep_s / kFeelingTime_s * (resistance_N - felt_now_N_);
  const auto size = static_cast<long>(felt_N_.size());
  const long tick = tick_++;
  felt_N_[static_cast<std::size_t>(tick % size)] = felt_now_N_;
  const long delay = std::min(std::lround(options_.haptic_delay_s / kOperatorStep_s), size - 1);
  if (!haptics_ || !attends || tick < delay) {
    felt_peak_N_ = felt_late_N_ = 0.0;
    return false;
  }
  felt_late_N_ = felt_N_[static_cast<std::size_t>((tick - delay) % size)];
  felt_peak_N_ = std::max(felt_peak_N_, felt_late_N_);
  return felt_peak_N_ >= options_.just_felt_N && felt_late_N_ < options_.drop_ratio * felt_peak_N_;
}

}  // namespace pellucida
