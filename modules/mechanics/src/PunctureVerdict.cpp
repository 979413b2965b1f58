#include "PunctureVerdict.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// What a membrane that follows the tip may differ by beside the noise: the tip's roundness, an edge's blur.
constexpr double kUsual_um = 2.0;
constexpr double kSigmas = 4.0;
/// A dimple shallower than this is no puncture when it goes.
constexpr double kShallowest_um = 1.5;
/// Probability from which on the membrane is through; and that something is amiss from which on a contact is in doubt.
constexpr double kSure = 0.9, kInDoubt = 0.5;
/// In a deep, narrow dimple the contour lags behind the tip, and back, by about this share of the depth.
constexpr double kLag_ratio = 0.07;
/// Flanks below this share of their depth are back; deeper again by so many times their noise, pushed.
constexpr double kFlankBack_ratio = 0.5, kFlankOverNoise = 3.0;
/// Flanks that go deeper by so many times their noise within a frame are still pushed.
constexpr double kDeepensNoises = 1.5;
/// In contact nothing is learnt of the rest: its radius stays, but for this share.
constexpr double kSameRest_ratio = 0.002;
/// Of the tip's depth, what the membrane may have kept where no contact came before.
constexpr double kAtRest_ratio = 0.5;
/// From this share of their depth on they are on their way back; and the sides, of their bulge.
constexpr double kFlankLeaving_ratio = 0.15, kSidesLeaving_ratio = 0.25;
/// What a sprung shape counts as: most of the depth.
constexpr double kSprungBack_ratio = 0.8, kSprungSigma_ratio = 0.1;
/// How the depth of late fades, per frame: a pipette drawn back slowly punctures nothing.
constexpr double kFade = 0.9;
/// A frame seen worse than this sets no depth to come back from.
constexpr double kLeastSeen = 0.3;
/// A shape that leaves the model's by this from one frame to the next, and is so many times what is usual, has sprung.
constexpr double kSpring_um = 1.0;
constexpr double kUnusual = 2.5;
/// Frames with tip and membrane together that make a contact again.
constexpr int kTogetherFrames = 3;
/// Flanks go ever deeper with the needle. The sides' bulge says nothing of how far it should be, and turns back slowly
/// in a push deeper than this share of the radius.
constexpr double kTurnsBack_ratio = 0.55;
constexpr double kLeastFlank_um = 0.1, kFlankFade = 0.98, kFlankOnward = 1.2;
constexpr double kLeastSide_um = 0.1, kSideFade = 0.9, kSideOnward = 1.0;

}  // namespace

PunctureVerdict::PunctureVerdict() noexcept
    : flanks_({.least_um = kLeastFlank_um, .fade_ratio = kFlankFade, .most_onward_ratio = kFlankOnward}),
      sides_({.least_um = kLeastSide_um, .fade_ratio = kSideFade, .most_onward_ratio = kSideOnward}) {}

bool PunctureVerdict::is_apart(const Sight& now) noexcept {
  const double sigma_um = std::hypot(now.tip_sigma_um, now.membrane_sigma_um);
  return now.tip_um - now.membrane_um > std::max(kUsual_um, kSigmas * sigma_um);
}

bool PunctureVerdict::judge(const Sight& now) noexcept {
  is_doubted_ = is_revoked_ = is_pushed_ = false;
  confidence_ = now.confidence;
  is_apart_ = now.has_depths && is_apart(now);
  if (through_ && !(now.has_depths && may_end(now))) return true;
  // Without a contact before, or a look at it, there is only the tracker's word, and whether the membrane is at rest.
  if (!has_contact_) {
    is_doubted_ = now.is_tracked_punctured && now.has_depths && now.membrane_um > kAtRest_ratio * now.tip_um;
    return now.is_tracked_punctured && !is_doubted_;
  }
  depth_by_flanks_um_ = std::numeric_limits<double>::infinity();
  are_sides_leaving_ = true;
  flanks_.set_least_noise(now.shape_sigma_um);
  sides_.set_least_noise(now.shape_sigma_um);
  // A cell found anew has another resting outline: depths before and after don't compare.
  if (now.has_depths && std::abs(now.rest_radius_um - rest_radius_um_) > kSameRest_ratio * rest_radius_um_) {
    if (rest_radius_um_ > 0.0) forget_deepest();
    rest_radius_um_ = now.rest_radius_um;
  }
  // In a very deep push the sides' bulge turns back while the flanks go ever deeper: then it says nothing.
  const PushedShape::Share flank = flanks_.back(now.flank_um, now.tip_um, now.tip_sigma_um);
  const PushedShape::Share side = sides_.back(now.side_um, now.tip_um, now.tip_sigma_um);
  const bool is_very_deep = now.tip_um > kTurnsBack_ratio * now.rest_radius_um;
  turns_back_ = (now.flank_um > flank_before_um_ && flank.back <= 0.0) ||
                (is_very_deep && flank.back < kFlankLeaving_ratio && side.back > flank.back);
  if (now.has_depths && deepest_um_ > kShallowest_um) {
    const PunctureOdds::Evidence evidence = evidence_of(now, flank, turns_back_ ? PushedShape::Share{} : side);
    odds_.weigh(evidence);
    if (!std::isnan(evidence.flank_ratio))
      depth_by_flanks_um_ = std::max(0.0, 1.0 - evidence.flank_ratio) * deepest_um_;
    are_sides_leaving_ =
        std::isnan(evidence.side_ratio) || evidence.side_ratio > kSidesLeaving_ratio + evidence.side_sigma_ratio;
    // The sides know best; false where neither is seen.
    is_pushed_ = std::isnan(evidence.side_ratio) ? evidence.flank_ratio < kFlankLeaving_ratio
                                                 : evidence.side_ratio < kSidesLeaving_ratio;
  }
  flank_before_um_ = now.flank_um;
  least_membrane_um_ = least_flank_um_ = std::numeric_limits<double>::infinity();
  through_ = odds_.probability() > kSure;
  is_doubted_ = !through_ && ((now.is_tracked_punctured && !is_pushed_) || odds_.doubt() > kInDoubt);
  if (now.has_depths && !through_) follow_deepest(now);
  return through_;
}

// Whether a puncture is over: left, or none.
bool PunctureVerdict::may_end(const Sight& now) noexcept {
  // A contour that is tied to the tip proves nothing while the flanks are back.
  const bool is_flank_known = flanks_.is_telling(flanks_.most_um());
  const bool is_flank_back = is_flank_known && now.flank_um < kFlankBack_ratio * flanks_.most_um();
  // Flanks as deep as before are pushed, wherever the contour under the tip is.
  const bool is_flank_deep = is_flank_known && now.flank_um > (1.0 - kFlankLeaving_ratio) * flanks_.most_um();
  const bool is_together = is_flank_deep || is_pushed_again(now) || !(is_apart(now) || is_flank_back);
  together_frames_ = is_together ? together_frames_ + 1 : 0;
  if (now.tip_um >= 0.0 && together_frames_ < kTogetherFrames) return false;
  if (now.tip_um < 0.0 || now.membrane_um < kShallowest_um || !has_contact_) {
    release();
    return true;
  }
  through_ = reported_ = false;
  is_revoked_ = true;
  together_frames_ = 0;
  odds_.reset();
  forget_deepest();
  follow_deepest(now);
  return true;
}

// A membrane that has given way comes to rest. One that goes deeper from there, and its flanks with it, is pushed, even
// where the contour has lost the dimple.
bool PunctureVerdict::is_pushed_again(const Sight& now) noexcept {
  if (std::isnan(now.flank_um)) return false;
  least_membrane_um_ = std::min(least_membrane_um_, now.membrane_um);
  least_flank_um_ = std::min(least_flank_um_, now.flank_um);
  return now.membrane_um - least_membrane_um_ > std::max(kUsual_um, kSigmas * now.membrane_sigma_um) &&
         now.flank_um - least_flank_um_ > kFlankOverNoise * flanks_.noise_um();
}

PunctureOdds::Evidence PunctureVerdict::evidence_of(const Sight& now, const PushedShape::Share& flank,
                                                    const PushedShape::Share& side) const noexcept {
  const double back_um = std::max(0.0, deepest_um_ - now.membrane_um);
  const double usual_um = std::hypot(now.membrane_sigma_um, kUsual_um / kSigmas, kLag_ratio * deepest_um_);
  // A way too short to tell says nothing of the tip's share in it.
  double way_um = std::max(back_um, kUsual_um);
  PunctureOdds::Evidence evidence{.back_ratio = back_um / deepest_um_,
                                  .back_sigma_ratio = usual_um / deepest_um_,
                                  .confidence = now.confidence,
                                  .is_apart = is_apart(now),
                                  .is_astray = lies_beyond_tip(now)};
  evidence.flank_ratio = flank.back;
  evidence.flank_sigma_ratio = flank.sigma;
  evidence.pierced = now.pierced_probability;
  evidence.side_ratio = side.back;
  evidence.side_sigma_ratio = side.sigma;
  if (!std::isnan(flank.back)) way_um = std::max(way_um, flank.back * deepest_um_);
  // Also where they are too shallow to come back, or the resting outline is off.
  evidence.is_deepening = now.flank_um - flank_before_um_ > kDeepensNoises * flanks_.noise_um();
  evidence.tip_share = (tip_at_deepest_um_ - now.tip_um) / way_um;
  evidence.tip_share_sigma = now.tip_sigma_um / way_um;
  return evidence;
}

void PunctureVerdict::forget_deepest() noexcept {
  deepest_um_ = 0.0;
  flanks_.forget();
  sides_.forget();
}

// A contour that lags in the dimple while the needle is drawn back shows a membrane where nothing pushes it: when it
// comes back to the tip, that is no recoil.
bool PunctureVerdict::lies_beyond_tip(const Sight& now) noexcept {
  const double sigma_um = std::hypot(now.tip_sigma_um, now.membrane_sigma_um);
  return now.membrane_um - now.tip_um > std::max(kUsual_um, kSigmas * sigma_um);
}

void PunctureVerdict::follow_deepest(const Sight& now) noexcept {
  const bool is_pushed = !lies_beyond_tip(now) && now.confidence >= kLeastSeen;
  if (is_pushed && !is_doubted_) {
    flanks_.learn_noise(now.flank_um);
    sides_.learn_noise(now.side_um);
  }
  // While a puncture is doubted, a membrane that creeps back is measured against where it was.
  if (!is_doubted_) {
    deepest_um_ *= kFade;
    flanks_.fade(now.tip_um);
    sides_.fade(now.tip_um);
  }
  if (!is_pushed) return;
  if (turns_back_) sides_.restart();
  flanks_.follow(now.flank_um, now.tip_um);
  sides_.follow(now.side_um, now.tip_um);
  if (now.membrane_um < deepest_um_) return;
  deepest_um_ = now.membrane_um;
  tip_at_deepest_um_ = now.tip_um;
}

bool PunctureVerdict::judge(const Shape& now) noexcept {
  // Comparisons with what wasn't seen are false.
  const bool sprang = now.residual_um - last_residual_um_ > kSpring_um &&
                      now.dimple_residual_um - last_dimple_um_ > kSpring_um &&
                      now.residual_um > kUnusual * now.usual_um;
  // Where the flanks are seen they say so themselves; for a tip that lies beyond the membrane already they need not be
  // back, but on their way. As deep as ever they are pushed, and it is the contour that cuts across a narrow dimple.
  const bool are_leaving = depth_by_flanks_um_ < (1.0 - kFlankLeaving_ratio) * deepest_um_;
  const bool may_show = are_sides_leaving_ && (std::isinf(depth_by_flanks_um_) || (is_apart_ && are_leaving));
  if (has_contact_ && !through_ && last_depth_um_ > kShallowest_um && sprang && may_show) {
    odds_.weigh({.back_ratio = kSprungBack_ratio,
                 .back_sigma_ratio = kSprungSigma_ratio,
                 .confidence = confidence_,
                 .is_apart = true});
    through_ = odds_.probability() > kSure;
    is_doubted_ = !through_;
    if (through_) return true;
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
  const PushedShape flanks = flanks_, sides = sides_;
  *this = PunctureVerdict{};
  flanks_ = flanks;
  sides_ = sides;
  flanks_.forget();
  sides_.forget();
}

void PunctureVerdict::watch(const Sight& untouched) noexcept {
  flanks_.learn_noise(untouched.flank_um);
  sides_.learn_noise(untouched.side_um);
}

}  // namespace pellucida
