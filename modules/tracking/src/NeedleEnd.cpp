// Where a needle ends, and how, learnt while nothing hides it: in a half ball, rounded off, or cut off straight.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "NeedleTracker.h"

namespace pellucida {
namespace {

// How round an end may be; one that is no half ball must leave less unexplained than that by this, in the logarithm's
// mean over so many frames at most. Round ends of plain drawings leave 0.1 (noisy) to 1.8 more with the others,
// straight ones 0.8 to 1.3 less.
constexpr std::array kRoundness{1.0, 0.5, 0.0};
constexpr double kLessRound = 0.03;
constexpr int kEndFrames = 20;
// Of the half width: how far apart the places may be where ends of two kinds fit best.
constexpr double kEndReach = 0.5;
// Of the misfits, from the least to the most: the end is seen plainly.
constexpr double kPlainEnd = 0.5;
// Errors along the needle that noise does not explain, in units: of the end where a membrane is about.
constexpr double kEndHidden = 0.45;
// Of the end against a membrane that is known: at its resting place, and more for each unit past it. In 1,400 frames of
// plain drawings of tuning (seeds 302001 to 302150, 305001 to 305160) its errors have a standard deviation of 0.1 up to
// the membrane and 0.16 at 5 to 8 units. Taken for plain medium it is 0.2 too short at the membrane, 0.2 too long at 8.
constexpr double kEndAgainst = 0.12, kEndAgainstDepth = 0.02;
// In units: so far past the resting membrane the reading against it counts half, because in deep dimples the last
// outline is not known well enough to take its line away; so far from the reading in plain medium it counts half,
// because a membrane that is elsewhere by now, as one that has given way, explains nothing (95 of 100 of these frames
// differ by less than 0.6). The depth was set on validation films 80001 to 81455: 25 made three frames of
// 80056 a puncture, and 10 lost half of the gain in shallow pushes.
constexpr double kHalfDepth = 15.0, kHalfApart = 1.0;
// Of the contrast learnt: a shaft with less is out of focus, and blurred by as much more.
constexpr double kSameContrast = 0.9;
// So many blurs ahead of the tip must be free of other bodies for a blurred end to be located.
constexpr double kEndBlurs = 2.5;

// How far ahead of the tip the axis enters a circle; without end when it passes beside it.
double way_to(const contour::Circle& body, const NeedleAxis& axis) {
  const Eigen::Vector2d from = axis.tip - body.center;
  const double along = from.dot(axis.direction), across = from.dot(axis.across());
  const double inside = body.radius * body.radius - across * across;
  return inside > 0.0 ? -along - std::sqrt(inside) : std::numeric_limits<double>::infinity();
}

// Share of the reading against the membrane in the end that counts; `depth` and `apart` in units. It fades, so that no
// decision hangs on which of the two was taken.
double share_against(double depth, double apart) {
  return 1.0 / ((1.0 + std::pow(depth / kHalfDepth, 4)) * (1.0 + std::pow(apart / kHalfApart, 4)));
}

}  // namespace

NeedleTracker::Along NeedleTracker::find_end(const FrameSampler& image, double noise, const ShaftResult& shaft,
                                             double reach_px, const NeedleCue& cue) {
  const double clear_px = cue.body ? way_to(*cue.body, axis_) : std::numeric_limits<double>::infinity();
  if (clear_px < kEndBlurs * shaft_.blur_px()) return {};
  if (!tip_.sample(image, axis_, reach_px, clear_px)) return {};
  TipResult tip = tip_.find(shaft.gain, shaft.medium, noise);
  double floor = cue.in_the_clear ? kEndFloor : kEndHidden;
  if (cue.membrane) {
    cue.membrane->push(axis_.tip + (tip.found ? tip.ahead : 0.0) * axis_.direction - axis_before_.tip);
    const TipResult against = tip_.find(shaft.gain, shaft.medium, noise, cue.membrane);
    if (against.found && !tip.found) {
      tip = against;
    } else if (against.found) {
      const double depth = std::max(0.0, cue.depth_px / model_.unit_px);
      const double apart = (against.ahead - tip.ahead) / model_.unit_px;
      const double share = share_against(depth, apart);
      tip.ahead += share * (against.ahead - tip.ahead);
      tip.ahead_sigma += share * (against.ahead_sigma - tip.ahead_sigma);
      tip.disagreement += share * (against.disagreement - tip.disagreement);
      floor += share * (std::min(kEndHidden, kEndAgainst + kEndAgainstDepth * depth) - floor);
    }
  }
  if (!tip.found) return {};
  floor *= model_.unit_px;
  const double noisy = tip.ahead_sigma * std::max(1.0, tip.disagreement);
  const double blurred = shaft_.blur_px() * std::max(0.0, kSameContrast / shaft.gain - 1.0);
  return {true, tip.ahead + end_bias_, noisy * noisy + floor * floor + blurred * blurred};
}

// Tries ends from a half ball to one cut off straight. Where another one fits better, the tip lies elsewhere by as much
// as the places differ where either fits best; and at first sight where that is.
void NeedleTracker::learn_end(const FrameSampler& image, double noise, const ShaftResult& shaft) {
  constexpr double kNothingAhead = std::numeric_limits<double>::infinity();
  const double reach_px = again_px() + kEndReach * model_.cone.tip_radius();
  static_assert(kRoundness.size() == kEnds);
  std::array<TipResult, kEnds> ends;
  bool all = true;
  const double roundness = model_.cone.roundness();
  for (std::size_t k = 0; all && k < ends.size(); ++k) {
    model_.cone.set_roundness(kRoundness[k]);
    tip_.prepare(model_);
    all = k > 0 || tip_.sample(image, axis_, reach_px, kNothingAhead);
    if (all) ends[k] = tip_.find(shaft.gain, shaft.medium, noise);
    all = all && ends[k].found && ends[k].unexplained > 0.0;
  }
  model_.cone.set_roundness(roundness);
  if (all) {
    const bool is_first = end_frames_ == 0;
    end_frames_ = std::min(end_frames_ + 1, kEndFrames);
    for (std::size_t k = 0; k < ends.size(); ++k)
      end_misfits_[k] += (std::log(ends[k].unexplained / ends[0].unexplained) - end_misfits_[k]) / end_frames_;
    const auto least = std::min_element(end_misfits_.begin(), end_misfits_.end());
    const auto best = *least < -kLessRound ? static_cast<std::size_t>(least - end_misfits_.begin()) : 0;
    if (best != end_) {
      const double further = ends[best].ahead - (is_first ? 0.0 : ends[end_].ahead);
      end_ = best;
      axis_.tip += further * axis_.direction;
      model_.cone.move(further, 0.0);
      model_.cone.set_roundness(kRoundness[best]);
      end_bias_ = 0.0;
    }
  }
  prepare();
}

// Edges show what the end is like: ends of another kind fit far worse.
bool NeedleTracker::is_end_plain() const {
  const auto [least, most] = std::minmax_element(end_misfits_.begin(), end_misfits_.end());
  return *most - *least > kPlainEnd;
}

}  // namespace pellucida
