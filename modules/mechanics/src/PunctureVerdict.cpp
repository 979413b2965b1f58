#include "pellucida/mechanics/PunctureMonitor.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// What a membrane that follows the tip may differ by beside the noise: the tip's roundness, an edge's blur.
constexpr double kUsual_um = 2.0;
constexpr double kSigmas = 4.0;
/// A dimple shallower than this is no puncture when it goes.
constexpr double kShallowest_um = 4.0;
/// A shape that leaves the model's by this from one frame to the next, and is so many times what is usual, has sprung.
constexpr double kSpring_um = 1.0;
constexpr double kUnusual = 2.5;
/// Frames with tip and membrane together that make a contact again.
constexpr int kTogetherFrames = 3;

}  // namespace

bool PunctureMonitor::is_through(const Depths& now) noexcept {
  const double sigma_um = std::hypot(now.tip_sigma_um, now.membrane_sigma_um);
  const bool apart = now.tip_um - now.membrane_um > std::max(kUsual_um, kSigmas * sigma_um);
  if (through_) {
    together_frames_ = apart ? 0 : together_frames_ + 1;
    if (now.tip_um < 0.0 || together_frames_ >= kTogetherFrames) release();
    return through_;
  }
  const double back_um = last_depth_um_ - now.membrane_um;
  const bool came_back = back_um > std::max(kUsual_um, kSigmas * now.membrane_sigma_um);
  // The tip has gone back by less than half of what the membrane has.
  const bool tip_stayed = last_depth_um_ - now.tip_um < 0.5 * back_um;
  through_ = has_contact_ && last_depth_um_ > kShallowest_um && apart && came_back && tip_stayed;
  return through_;
}

bool PunctureMonitor::has_sprung_back(double residual_um, double dimple_residual_um, double usual_um) noexcept {
  // Comparisons with what wasn't seen are false.
  const bool sprang = residual_um - last_residual_um_ > kSpring_um && dimple_residual_um - last_dimple_um_ > kSpring_um;
  if (has_contact_ && !through_ && last_depth_um_ > kShallowest_um && sprang && residual_um > kUnusual * usual_um) {
    through_ = true;
    return true;
  }
  last_residual_um_ = residual_um;
  last_dimple_um_ = dimple_residual_um;
  return false;
}

void PunctureMonitor::add(double depth_um, double force_uN) noexcept {
  if (has_contact_) work_uN_um_ += 0.5 * (force_uN + last_force_uN_) * (depth_um - last_depth_um_);
  if (!has_contact_) work_uN_um_ = 0.5 * force_uN * depth_um;
  has_contact_ = true;
  last_depth_um_ = depth_um;
  last_force_uN_ = force_uN;
  if (force_uN >= peak_force_uN_) {
    peak_force_uN_ = force_uN;
    peak_depth_um_ = depth_um;
  }
}

std::optional<Puncture> PunctureMonitor::take_puncture(double time_s) noexcept {
  if (told_ || !has_contact_) return std::nullopt;
  told_ = true;
  through_ = true;
  return Puncture{time_s, peak_force_uN_, peak_depth_um_, work_uN_um_};
}

void PunctureMonitor::release() noexcept {
  *this = PunctureMonitor{};
}

}  // namespace pellucida
