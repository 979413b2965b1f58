#include "PunctureVerdict.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// What a membrane that follows the tip may differ by beside the noise: the tip's roundness, an edge's blur.
constexpr double kUsual_um = 2.0;
constexpr double kSigmas = 4.0;
/// A dimple shallower than this is no puncture when it goes.
constexpr double kShallowest_um = 4.0;
/// The share of its depth by which a membrane has come back that confirms a tracked puncture.
constexpr double kBack_ratio = 0.35;
/// The same from one frame to the next, for a puncture that only this verdict sees.
constexpr double kBackAtOnce_ratio = 0.3;
/// How the depth of late fades, per frame: a pipette drawn back slowly punctures nothing.
constexpr double kFade = 0.9;
/// A shape that leaves the model's by this from one frame to the next, and is so many times what is usual, has sprung.
constexpr double kSpring_um = 1.0;
constexpr double kUnusual = 2.5;
/// Frames with tip and membrane together that make a contact again.
constexpr int kTogetherFrames = 3;

}  // namespace

bool PunctureVerdict::is_apart(const Sight& now) noexcept {
  const double sigma_um = std::hypot(now.tip_sigma_um, now.membrane_sigma_um);
  return now.tip_um - now.membrane_um > std::max(kUsual_um, kSigmas * sigma_um);
}

bool PunctureVerdict::judge(const Sight& now) noexcept {
  is_doubted_ = false;
  if (through_ && now.has_depths) {
    together_frames_ = is_apart(now) ? 0 : together_frames_ + 1;
    if (now.tip_um < 0.0 || together_frames_ >= kTogetherFrames) release();
  }
  // Without a contact before, or a look at it, there is only the tracker's word.
  if (through_) return true;
  const double membrane_before_um = membrane_um_;
  if (now.has_depths) membrane_um_ = now.membrane_um;
  if (!has_contact_) return now.is_tracked_punctured;
  through_ =
      now.has_depths && (is_through_by(now, membrane_before_um) || (now.is_tracked_punctured && is_confirmed_by(now)));
  is_doubted_ = now.is_tracked_punctured && !through_;
  if (now.has_depths && !through_) follow_deepest(now);
  return through_;
}

bool PunctureVerdict::is_through_by(const Sight& now, double before_um) const noexcept {
  const double back_um = before_um - now.membrane_um;
  const double usual_um = std::max(kUsual_um, kSigmas * now.membrane_sigma_um);
  // In a deep, narrow dimple the contour lags behind the tip, and back by some micrometres at a time.
  const bool came_back = back_um > std::max(usual_um, kBackAtOnce_ratio * before_um);
  // The tip has gone back by less than half of what the membrane has.
  const bool tip_stayed = before_um - now.tip_um < 0.5 * back_um;
  return before_um > kShallowest_um && is_apart(now) && came_back && tip_stayed;
}

bool PunctureVerdict::is_confirmed_by(const Sight& now) const noexcept {
  const double back_um = deepest_um_ - now.membrane_um;
  const double usual_um = std::max(kUsual_um, kSigmas * now.membrane_sigma_um);
  return back_um > std::max(usual_um, kBack_ratio * deepest_um_) && tip_at_deepest_um_ - now.tip_um < 0.5 * back_um;
}

void PunctureVerdict::follow_deepest(const Sight& now) noexcept {
  // While a puncture is doubted, a membrane that creeps back is measured against where it was.
  if (!is_doubted_) deepest_um_ *= kFade;
  if (now.membrane_um < deepest_um_) return;
  deepest_um_ = now.membrane_um;
  tip_at_deepest_um_ = now.tip_um;
}

bool PunctureVerdict::judge(const Shape& now) noexcept {
  // Comparisons with what wasn't seen are false.
  const bool sprang = now.residual_um - last_residual_um_ > kSpring_um &&
                      now.dimple_residual_um - last_dimple_um_ > kSpring_um &&
                      now.residual_um > kUnusual * now.usual_um;
  if (has_contact_ && !through_ && last_depth_um_ > kShallowest_um && sprang) {
    through_ = true;
    is_doubted_ = false;
    return true;
  }
  last_residual_um_ = now.residual_um;
  last_dimple_um_ = now.dimple_residual_um;
  return false;
}

void PunctureVerdict::add(double depth_um, double force_uN) noexcept {
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

std::optional<Puncture> PunctureVerdict::take_puncture(double time_s) noexcept {
  if (reported_ || !has_contact_) return std::nullopt;
  reported_ = true;
  through_ = true;
  return Puncture{time_s, peak_force_uN_, peak_depth_um_, work_uN_um_};
}

void PunctureVerdict::release() noexcept {
  *this = PunctureVerdict{};
}

}  // namespace pellucida
