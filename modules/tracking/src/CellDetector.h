#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "GrayImage.h"
#include "pellucida/tracking/ContourMath.h"
#include "pellucida/tracking/EdgeProfile.h"
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

/// A person's hint in px: `inside` is a point in the cell; `outline`, (2 x n), may be empty.
struct DetectionHint {
  Eigen::Vector2d inside = Eigen::Vector2d::Zero();
  Eigen::Matrix2Xd outline;
};

/// Finds the roundest, most completely closed edge of an image: gradient voting over a pyramid for centres, then a
/// closed shortest path in the unrolled ring, then a search for the second membrane beside it. Nothing when no
/// candidate reaches `options.min_detection_score`.
std::optional<DetectedCell> detect_cell(const GrayImage& image, const TrackerOptions& options,
                                        const DetectionHint* hint = nullptr);

/// A centre the voting proposes (full image px).
struct CellCandidate {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0;
  int level = 0;
  double votes = 0.0;
};
/// The most voted first.
std::vector<CellCandidate> propose_cells(const std::vector<GrayImage>& pyramid, const TrackerOptions& options);

}  // namespace pellucida
