#pragma once
#include "CellFollower.h"
#include "SceneReading.h"

namespace pellucida {

/// What the networks, asked about a cell that is followed by its lines, make of it. The two ways share no assumption
/// about what a membrane looks like: lines that follow a halo or a shadow are sure of it.
struct LinesVerdict {
  bool is_same_cell = false;     ///< the scene has a cell with about this outline
  bool is_same_outline = false;  ///< and on each normal the outer boundary lies where the lines have it
  bool is_same_inner = true;     ///< and the zona is as thick, where the network is sure of that
  bool is_fine = false;          ///< and so near that the lines, which measure to a tenth of a pixel, are the finer
  bool is_same_needle = false;   ///< neither sees a needle, or both the same one with its tip in the same place
  bool is_bubble = false;        ///< the scene has no cell at all, and no membrane is as strong and even as these lines
  bool is_strange = false;       ///< the network knows this look less surely than those it has learnt from
  double confidence = 1.0;       ///< the network's in the lines' outline, mean over the normals
  bool is_clear = false;      ///< the lines were seen so well, or are so even, that neither noise nor optics move them
  bool is_sure = false;       ///< the lines were seen well enough to be believed at all
  bool is_lone_edge = false;  ///< one membrane alone, by an edge: the oolemma's too, where the zona does not show
  bool is_soft = false;       ///< they follow the oolemma, and round it a soft edge that has no dimple (`SoftZona`)
  bool is_same() const noexcept { return is_same_cell && is_same_outline && is_same_inner; }
  /// Both see the same cell, and the lines measure it the more finely.
  bool is_by_lines() const noexcept { return is_same() && is_fine && is_clear && !is_soft; }
  /// Lines and networks see the same cell, and the same needle too; a network that hardly knows the look confirms only
  /// what it reads right there. What both take for the zona may be the oolemma where no second membrane shows.
  bool is_confirmed() const noexcept {
    return is_same() && is_same_needle && is_sure && (is_fine || !is_strange) && !is_lone_edge;
  }
};

/// `scene` and `reader` of the frame that `image` shows, `by_lines` as it is in it; a bevel's tip, which lines miss, is
/// taken over (`CellFollower::take_bevel`).
LinesVerdict judge_lines(CellFollower& by_lines, const SceneReading& scene, const FrameSampler& image,
                         SceneReader& reader);

/// The zona's outer boundary by lines, or by its soft edge round them (2 x n, px).
const Eigen::Matrix2Xd& outline_of(const CellFollower& by_lines);
/// Whether the network reads the outer boundary there, on each normal.
bool is_outline_read(const Eigen::Matrix2Xd& outline, const FrameSampler& image, BoundaryNetwork& boundaries);

/// Whether the network saw the membranes as surely as those it has learnt from, enough to be believed where lines have
/// the cell elsewhere.
bool is_known(const CellFollower& by_scene);
/// Whether the network's cell is the better of the two, of which the lines' is not the finer: where it saw the
/// membranes surely enough to begin with them; where clear lines have the cell elsewhere, as surely as those it has
/// learnt from, or so much more surely than it sees any in the lines' outline.
bool is_preferred(const CellFollower& by_scene, const LinesVerdict& verdict);
/// The score from which on its cell is worth that question.
double least_score(const LinesVerdict& verdict);

/// The cell that is followed by its lines as a first guess for the networks.
DetectedCell detected(const CellFollower& by_lines);

/// The tools that the scene shows are at another cell than this one, or at none.
bool is_bystander(const contour::Circle& cell, const SceneReading& scene);
bool is_bystander(const CellFollower& cell, const SceneReading& scene);

/// Whether lines run along one of the walls of a needle of the scene: half its length behind the tip they are far
/// narrower than it.
bool is_one_wall(const NeedleEstimate& lines, const SceneTool& needle);

/// Whether lines and scene see the same needle, or neither sees one; a scene without a needle contradicts no other.
bool is_needle_confirmed(const CellFollower& by_lines, const SceneReading& scene);

}  // namespace pellucida
