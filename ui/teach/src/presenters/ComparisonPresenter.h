#pragma once
#include <string>
#include <vector>

#include "pellucida/teaching/ReadoutComparison.h"
#include "presenters/NumberScale.h"
#include "presenters/Phrase.h"

namespace pellucida {

/// The numbers of two read-outs that have a slider.
enum class ReadoutSlider { kDepth, kNoise, kMesh };
inline constexpr int kReadoutSliderCount = 3;

NumberScale readout_scale(ReadoutSlider which);

/// What Teach mode says about a contour read in two ways, UTF-8.
struct ComparisonTexts {
  Phrase state;                              ///< how far off the prescribed one is; its colour is the pill's
  std::vector<Phrase> figures;               ///< true force, by equilibrium, by prescribing, depth as it is seen
  Phrase equilibrium_note, prescribed_note;  ///< errors, "-57 %"
};
ComparisonTexts comparison_texts(const ReadoutPair& pair, const ThemeColors& theme);

}  // namespace pellucida
