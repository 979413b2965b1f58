#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ContourMath.h"
#include "EdgeProfile.h"
#include "GrayImage.h"
#include "pellucida/tracking/TrackerOptions.h"

namespace pellucida {

/// One closed edge found round a centre, px of the full image.
struct FoundEdge {
  Eigen::Matrix2Xd points;  ///< (2 x n), positive area
  EdgeKind kind;
  double scale_px = 1.0;   ///< sigma of the filter that found it
  double coverage = 0.0;   ///< share of the outline that shows the edge, 0..1
  double contrast = 0.0;   ///< mean feature along the edge over the spread of the feature round about
  bool is_border = false;  ///< no line but a border between regions (RegionBorder); `scale_px` is a third of its window
};

/// A cell found in one image.
struct DetectedCell {
  FoundEdge outer;                   ///< the zona's outer edge, or the one membrane there is
  std::optional<FoundEdge> inner;    ///< the zona's inner edge
  std::optional<FoundEdge> oolemma;  ///< the ooplasm's edge, where a perivitelline gap parts it from `inner`
  contour::Circle circle;            ///< through the undeformed part of the outer edge
  double score = 0.0;                ///< 0..1

  /// The same cell with lines only: without a soft outer edge, the oolemma is the one membrane.
  DetectedCell lines() const {
    if (!outer.is_border) return *this;
    DetectedCell result = *this;
    result.outer = oolemma ? *oolemma : inner ? *inner : outer;
    result.inner.reset();
    result.oolemma.reset();
    return result;
  }
};

/// A person's hint in px: `outline` (2 x n, closed, any orientation) where it has three points or more, else `inside`,
/// a point in the cell.
struct DetectionHint {
  Eigen::Vector2d inside = Eigen::Vector2d::Zero();
  Eigen::Matrix2Xd outline;
  bool is_drawn() const noexcept { return outline.cols() >= 3; }
};

/// Whether a drawn outline encloses something of this picture's size: one round nothing, or so far out that its area is
/// no number, is no cell's.
bool can_be_a_cell(const GrayImage& image, const Eigen::Matrix2Xd& outline);

/// Finds a cell: gradient voting over a pyramid proposes centres, round each the best closed path in the unrolled ring
/// is judged, and what lies beside the best one is its second membrane. Where that leaves doubt, and always with
/// `options.quality` high, a level set starts from the best guess and its outline is judged by the same measure. With a
/// hint only rings that hold the point, or the edge along the outline, come into question, and half the score will do.
/// Nothing when no candidate reaches the score needed.
/// `elsewhere`: a circle whose inside is not looked at again.
std::optional<DetectedCell> detect_cell(const GrayImage& image, const TrackerOptions& options,
                                        const DetectionHint* hint = nullptr,
                                        const contour::Circle* elsewhere = nullptr);

/// A centre the voting proposes (full image px).
struct CellCandidate {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius_px = 0.0;
  int level = 0;
  double votes = 0.0;
};
/// The most voted first.
std::vector<CellCandidate> propose_cells(const std::vector<GrayImage>& pyramid, const TrackerOptions& options);

}  // namespace pellucida
