#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/microscopy/Look.h"
#include "pellucida/simulation/Scenario.h"

namespace pellucida::test {

/// What a film may be used for.
enum class Split {
  kTuning,      ///< constants may be set on it, and networks learn from it
  kValidation,  ///< it is only ever reported
  kWide,        ///< networks learn from it: looks further out than those of tuning
  kUnseen       ///< it is only ever reported, and its ranges lie outside all that networks have learnt
};
/// "tuning", "validation", "wide" or "unseen"; throws UsageError for another word.
Split split_of(const std::string& word);

/// A film of the virtual microscope drawn from the whole space of looks, cells, tools, motions and cameras.
struct RandomFilm {
  std::uint64_t seed = 0;
  std::string family;    ///< of tests/films/families.json
  std::string contrast;  ///< "bright field", "relief", "phase", or "none" where no cell is in view
  Scenario scenario;
  Look look;
  bool drawing = false;  ///< plain bright field instead of the look
  bool relaxes = false;  ///< the force, by a law of its own (`RelaxingTruth`), under a profile with arms
};

/// The film of a seed: a family of the split, then all that families.json says, then geometry and motion: a cell of 35
/// to 65 um radius, 60 to 500 px across in a picture of at most `widest_px` columns, 0.2 to 2 um a pixel, needle from
/// any side; 30 to 60 frames. The same seed is the same film. Throws InputError for a damaged file of families.
///
/// With `specimens` (names or paths of finite-element tables) the cell is one of those, needle and holder as wide as
/// its mechanics has them, opposite each other; without, the needle is drawn at random and the forces don't fit it.
RandomFilm draw_film(Split split, std::uint64_t seed, int widest_px = 2048,
                     const std::vector<std::string>& specimens = {});

/// The first frame of a film that is in this state by its truth; the number of its frames where none is.
long first_frame_in(const RandomFilm& film, CellState state);

/// The tables NAME-geometry.json in a folder, as specimens; sorted. Throws UsageError where there are none.
std::vector<std::string> specimens_in(const std::string& folder);

}  // namespace pellucida::test
