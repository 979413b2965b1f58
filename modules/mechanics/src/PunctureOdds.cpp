#include "PunctureOdds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pellucida {
namespace {

/// A contact of some 50 frames may end in a puncture.
constexpr double kPuncture_rate = 0.02;
/// A misreading begins in so many of the frames seen with full confidence, and in ten times as many for each
/// `kTenfold` of confidence less. It is over in a frame seen with this confidence, and lasts in poor ones.
constexpr double kMisread_rate = 3e-4;
constexpr double kTenfold = 0.22;
constexpr double kMostMisread_rate = 0.3;
constexpr double kMisread_over = 0.8;
/// A membrane that gives way comes back by three tenths of its depth and more; a contour that is misread by less
/// mostly.
constexpr double kLeastBack_ratio = 0.3, kBackEdge_ratio = 0.04;
/// Its flanks come back later than what lay on the tip.
constexpr double kLeastFlankBack_ratio = 0.25;
/// Further back than the resting outline, and it is that outline which is wrong: the cell has moved.
constexpr double kMostBack_ratio = 1.2;
/// The bulge of its sides goes with the membrane; of frames misread under the tip, those that show the sides as they
/// are.
constexpr double kLeastSideBack_ratio = 0.15, kSidesSeen_ratio = 0.8;
constexpr double kMisreadBack_ratio = 0.3;
/// How far the tip's share spreads about 0 at a puncture, about 1 where both go back: a needle halts, and is drawn back
/// soon after.
constexpr double kStays_sigma = 0.25, kGoesOn_sigma = 1.0;
/// Of the frames in contact, those in which both go back.
constexpr double kDrawnBack_ratio = 0.2;
/// Of the frames in contact, those in which the contour cuts across the dimple and its flanks or the cell's sides show
/// that it is pushed: it may do so for long, however well it is seen.
constexpr double kCuts_ratio = 0.02;
/// Of punctures, those in which the contour is still tied to the tip.
constexpr double kTied_ratio = 0.5;
/// What a picture about the tip that is sure of one leaves the other: it may be a look like none before.
constexpr double kPictureLeaves = 0.04;
/// Of the frames of a puncture, those in which the membrane, on its way back, still lies near the tip.
constexpr double kStillNear_ratio = 0.2;
/// Of the frames in contact, those in which the picture begins to mislead, and those in which that is over.
constexpr double kMisled_rate = 0.004, kMisledOver_rate = 0.05;
/// Of misreadings, those of the tip, which leave no membrane on it; else the picture about it shows what is so.
constexpr double kTipMisread_ratio = 0.5;
/// A dimple deepens as long as something pushes it; behind a needle that is through it seems to so often.
constexpr double kDeepensThrough_ratio = 0.1;
/// What even an impossible frame leaves a hypothesis.
constexpr double kFloor = 1e-4;
/// A frame that shows what the one before did, but for so much of it, tells a misreading from a puncture to this power
/// only: both last. Against the contact it is evidence anew.
constexpr double kRepeated = 0.3, kSame_ratio = 0.75;

struct Odds {
  double contact = 1.0, misread = 1.0, punctured = 1.0;
};

double rise(double off) {
  return 1.0 / (1.0 + std::exp(-off / kBackEdge_ratio));
}

double gone(double back_ratio) {
  return rise(back_ratio - kLeastBack_ratio) * rise(kMostBack_ratio - back_ratio);
}

double flanks_gone(double back_ratio) {
  return rise(back_ratio - kLeastFlankBack_ratio) * rise(kMostBack_ratio - back_ratio);
}

double sides_gone(double back_ratio) {
  return rise(back_ratio - kLeastSideBack_ratio);
}

double of_misread(double back_ratio) {
  return std::exp(-back_ratio / kMisreadBack_ratio) / kMisreadBack_ratio;
}

double normal(double off, double sigma) {
  const double z = off / sigma;
  return std::exp(-0.5 * z * z) / (sigma * std::sqrt(2.0 * std::numbers::pi));
}

}  // namespace

void PunctureOdds::advance(double misread_rate, double lasting) noexcept {
  const double misled = contact_ * kMisled_rate, shown = misled_ * kMisledOver_rate;
  const double through_it = misled_ * kPuncture_rate;
  contact_ += shown - misled;
  misled_ += misled - shown - through_it;
  punctured_ += through_it;
  const double over = (1.0 - lasting) * misread_;
  const double began = contact_ * misread_rate, through = contact_ * kPuncture_rate;
  // A misreading hides what happens under it, as long as it lasts.
  const double hidden = lasting * misread_ * kPuncture_rate;
  contact_ += over - began - through;
  misread_ += began - over - hidden;
  punctured_ += through + hidden;
}

void PunctureOdds::normalise() noexcept {
  const double all = sum();
  contact_ /= all;
  misled_ /= all;
  misread_ /= all;
  punctured_ /= all;
}

void PunctureOdds::weigh(const Evidence& now) noexcept {
  const double back = std::max(0.0, now.back_ratio), share = std::clamp(now.tip_share, -3.0, 3.0);
  const bool has_flank = !std::isnan(now.flank_ratio);
  const double flank = has_flank ? std::max(0.0, now.flank_ratio) : 0.0;
  // A frame that shows the membrane on the tip, as before, is not misread in a way that matters, however poor it is.
  const bool has_side = !std::isnan(now.side_ratio);
  const double side = has_side ? std::max(0.0, now.side_ratio) : 0.0;
  const bool is_odd = now.is_apart || flank > kLeastBack_ratio || side > kLeastBack_ratio;
  const double confidence = now.is_astray ? 0.0 : is_odd ? std::clamp(now.confidence, 0.0, 1.0) : 1.0;
  advance(std::min(kMostMisread_rate, kMisread_rate * std::pow(10.0, (1.0 - confidence) / kTenfold)),
          std::max(0.0, 1.0 - std::pow(confidence / kMisread_over, 2)));

  const bool has_picture = !std::isnan(now.pierced);
  Odds picture;
  if (has_picture) {
    const double pierced = std::clamp(now.pierced, 0.0, 1.0);
    const double near = 2.0 * (1.0 - pierced) + kPictureLeaves, away = 2.0 * pierced + kPictureLeaves;
    picture = {.contact = near, .punctured = kStillNear_ratio * near + (1.0 - kStillNear_ratio) * away};
    picture.misread = kTipMisread_ratio + (1.0 - kTipMisread_ratio) * picture.contact;
  }
  // Of the membrane under the tip: while the flanks are back a contour may stay tied there, as in contact, or be
  // anywhere on its way.
  const bool has_other = has_flank || has_side || has_picture;
  const double tied = has_other ? kTied_ratio : 0.0;
  const double on_tip = 2.0 * normal(back, now.back_sigma_ratio);
  const double cuts = has_other ? kCuts_ratio : 0.0;
  Odds axis{.contact = (1.0 - cuts) * on_tip + cuts * of_misread(back),
            .misread = of_misread(back),
            .punctured = tied * 0.5 * (on_tip + 1.0) + (1.0 - tied) * (now.is_apart || has_picture ? gone(back) : 0.0)};
  Odds flanks;
  if (has_flank)
    flanks = {.contact = 2.0 * normal(flank, now.flank_sigma_ratio),
              .misread = of_misread(flank),
              .punctured = flanks_gone(flank)};
  Odds sides;
  if (has_side) {
    const double still = 2.0 * normal(side, now.side_sigma_ratio);
    sides = {.contact = still,
             .misread = kSidesSeen_ratio * still + (1.0 - kSidesSeen_ratio) * of_misread(side),
             .punctured = sides_gone(side)};
  }
  // Of the tip's own way: it may have gone anywhere before; at a puncture it stays, or goes on.
  const double stays = std::hypot(share > 0.0 ? kStays_sigma : kGoesOn_sigma, now.tip_share_sigma);
  const double anywhere = normal(0.0, kGoesOn_sigma);
  const double together = normal(share - 1.0, std::hypot(kStays_sigma, now.tip_share_sigma));

  const double shown = std::max({flank, side, now.is_apart ? back : 0.0});
  const double power = is_odd && shown_before_ > kSame_ratio * shown ? kRepeated : 1.0;
  shown_before_ = shown;
  const double stays_there = normal(share, stays) * stays / kStays_sigma;
  const auto contact = [&](double by_picture) {
    const double on_it = axis.contact * flanks.contact * sides.contact * by_picture * anywhere;
    return (1.0 - kDrawnBack_ratio) * on_it + kDrawnBack_ratio * together + kFloor;
  };
  const double misread = axis.misread * flanks.misread * sides.misread * picture.misread * anywhere + kFloor;
  const double deepening = now.is_deepening ? kDeepensThrough_ratio : 1.0;
  const double punctured =
      deepening * axis.punctured * flanks.punctured * sides.punctured * picture.punctured * stays_there + kFloor;
  const double either =
      (misread_ * misread + punctured_ * punctured) / std::max(misread_ + punctured_, kFloor * kFloor);
  contact_ *= contact(picture.contact);
  misled_ *= contact(1.0);
  misread_ *= std::pow(misread, power) * std::pow(either, 1.0 - power);
  punctured_ *= std::pow(punctured, power) * std::pow(either, 1.0 - power);
  normalise();
}

}  // namespace pellucida
