#pragma once
#include <string>

#include "pellucida/core/Words.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/membrane/CellProfile.h"
#include "presenters/Phrase.h"

namespace pellucida {

/// What the figures mean that need no other words; said by who shows them.
inline constexpr const char* kIndentationTip = PELLUCIDA_WORDS(
    "How far the needle has pushed the outer membrane in, along the needle, from where it was at rest.");
inline constexpr const char* kPressureTip =
    PELLUCIDA_WORDS("Excess pressure inside the cell, by the model: the push raises it, since the volume stays.");
inline constexpr const char* kConfidenceTip = PELLUCIDA_WORDS(
    "How sure the tracking is of cell and needle in this frame. Below 50 % look at the image before you use a number.");

/// What the readouts say of one scene, UTF-8. A tip is the text shown while the mouse rests on the figure.
struct ReadoutTexts {
  Phrase state;  ///< its colour is the pill's ground
  Phrase indentation;
  Phrase force;
  Phrase force_note;   ///< "95 %: 3.10 – 3.75 µN", that there is none, or that the force should be doubted
  Phrase force_parts;  ///< "picture ±9 %, kind of cell ±46 %": which of the two opens the interval
  std::string force_parts_short;  ///< "±9 %, kind ±46 %"
  std::string force_tip;
  Phrase pressure;
  Phrase confidence;
  Phrase profile;  ///< whose forces these are
  std::string profile_tip;
};

/// The texts for `scene`; nullptr before the first measured one: dashes. The force is the scene's own, as the 3-D view
/// labels it.
ReadoutTexts readout_texts(const Scene* scene, const CellProfile& profile);

/// One line of what a person should know of this scene's force: why there is none, else why it should be doubted;
/// empty for neither.
Phrase force_notice(const Scene& scene);

}  // namespace pellucida
