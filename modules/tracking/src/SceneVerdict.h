#pragma once
#include "CellFollower.h"
#include "SceneReading.h"

namespace pellucida {

/// Whether the scene, read by a network, shows the cell and the needle that were found by their lines. The two ways
/// share no assumption about what a membrane looks like: lines that follow a halo or a shadow are sure of it.
bool confirms(const SceneReading& scene, const CellFollower& by_lines);

/// Whether the network saw the membranes, as it followed them into the first frame, as surely as those it has learnt
/// from. It is then the better of the two; of other looks it has the outline to some pixels, lines to a tenth of one.
bool is_familiar(const CellFollower& by_scene);

/// Whether a ring of lines is that of a bubble or a drop: nothing that the network takes for a cell, and an outline
/// stronger and more even than any membrane's.
bool is_bubble(const CellFollower& by_lines, const SceneReading& scene);

/// Whether lines and scene see the same needle, or neither sees one; a scene without a needle contradicts no other.
bool is_needle_confirmed(const CellFollower& by_lines, const SceneReading& scene);

}  // namespace pellucida
