// How a needle ends, learnt while nothing hides it: in a half ball, rounded off, or cut off straight.
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

}  // namespace

// Tries ends from a half ball to one cut off straight. Where another one fits better, the tip lies elsewhere by as much
// as the places differ where either fits best; and at first sight where that is.
void NeedleTracker::learn_end(const FrameSampler& image, double noise, const ShaftResult& shaft) {
  constexpr double kNothingAhead = std::numeric_limits<double>::infinity();
  const double reach_px = again_px() + kEndReach * model_.cone.tip_radius();
  static_assert(kRoundness.size() == kEnds);
  std::array<TipResult, kEnds> ends;
  bool all = true;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    NeedleModel tried = model_;
    tried.cone.set_roundness(kRoundness[k]);
    tip_.prepare(tried);
    ends[k] = tip_.find(image, axis_, shaft.gain, shaft.medium, noise, reach_px, kNothingAhead);
    all = all && ends[k].found && ends[k].unexplained > 0.0;
  }
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
