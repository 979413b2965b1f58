#pragma once
#include <optional>

#include "CellDetector.h"

namespace pellucida {

/// What lies round an oolemma that is found already: the zona pellucida's soft outer edge, and its inner edge where a
/// perivitelline gap parts it from the oolemma. Both are borders between regions (RegionBorder), not lines.

/// The soft outer edge: the outermost closed path of clear evidence between 1.2 and 1.85 radii of `oolemma`. Nothing
/// where evidence is missing on more than three tenths of the outline that lies in the image, or the path is not round.
/// `noise`: standard deviation of what counts as grain, grey value.
std::optional<FoundEdge> find_soft_outer_edge(const GrayImage& image, const FoundEdge& oolemma,
                                              const contour::Circle& circle, double noise);

/// The zona's inner edge, for a gap that is open over a tenth of the outline or more and wider than 7 % of the
/// radius; elsewhere the contour lies on the oolemma. Nothing where there is no such gap.
std::optional<FoundEdge> find_gap_edge(const GrayImage& image, const FoundEdge& oolemma, const contour::Circle& circle,
                                       const FoundEdge& outer, double noise);

}  // namespace pellucida
