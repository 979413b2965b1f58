#pragma once
#include <optional>

#include "FrameSampler.h"
#include "NeedleModel.h"
#include "ToolFinder.h"

namespace pellucida {

/// Where a tip is taken to be by other evidence, px.
struct ExpectedTip {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double reach_px = 6.0;  ///< no further from it along the needle
};

/// A first guess at a needle: where it is, how long its visible shaft is, and what it looks like.
struct NeedleGuess {
  NeedleAxis axis;
  NeedleModel model;
  double length_px = 0.0;  ///< of the visible shaft
  double strength = 0.0;   ///< length times contrast: what makes one guess better than another
};

/// Follows a tool found by voting from the image's border inwards, block by block, as long as its cross-section stays
/// alike: the first block shows what it looks like and where its two edges are, every further one is fitted with what
/// the last ones looked like. The tip is where that ends, good to a block's length. Nothing when the tool shows no
/// edges, ends within 12 px, or goes right through the image. `skip_px`: how far inside the image to begin, for a shaft
/// that is out of focus at the border. `expected`: the end is not looked for beyond its reach, and is there where the
/// cross-section fades earlier.
std::optional<NeedleGuess> guess_needle(const FrameSampler& image, const FoundTool& tool, double noise,
                                        double skip_px = 0.0, const ExpectedTip* expected = nullptr);

}  // namespace pellucida
