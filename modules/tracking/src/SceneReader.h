#pragma once
#include <memory>

#include "BoundaryNetwork.h"
#include "CellDetector.h"
#include "CellNetwork.h"
#include "NeedleStart.h"
#include "PunctureNetwork.h"
#include "SceneReading.h"
#include "ThicknessNetwork.h"
#include "TipNetwork.h"
#include "TipWidthNetwork.h"
#include "ToolFinder.h"

namespace pellucida {

/// Reads whole images and, closer, the cells found in them. Loads the networks on first use.
class SceneReader {
 public:
  /// Everything in the image; each cell's outlines from a closer look at it. Allocates; for detection, not for every
  /// frame.
  SceneReading read(const GrayImage& image);

  /// To read the boundaries and the zona's thickness of a cell that is followed, the tip of a needle, and its width
  /// there.
  BoundaryNetwork& boundaries();
  ThicknessNetwork& thicknesses();
  TipNetwork& tips();
  TipWidthNetwork& tip_widths();
  /// To read whether the membrane lies on it.
  PunctureNetwork& punctures();
  /// To judge what is found before it is followed.
  CellNetwork& cells();

 private:
  SceneNetwork& network();
  SceneReading look_at(const GrayImage& image, const Eigen::Vector2d& center, double radius_px);
  void look_at_tip(const GrayImage& image, SceneTool& needle, double scale);
  std::unique_ptr<SceneNetwork> network_;
  std::unique_ptr<BoundaryNetwork> boundaries_;
  std::unique_ptr<ThicknessNetwork> thicknesses_;
  std::unique_ptr<TipNetwork> tips_;
  std::unique_ptr<TipWidthNetwork> tip_widths_;
  std::unique_ptr<PunctureNetwork> punctures_;
  std::unique_ptr<CellNetwork> cells_;
};

/// A cell of the scene as a detection of edges of no known kind.
DetectedCell detected(const SceneCell& cell);
/// One whose outline (2 x n, n >= 3, px) a person has drawn.
DetectedCell detected(const Eigen::Matrix2Xd& outline);

/// How well a scene shows how wide a tool is: standard deviation of the logarithm.
inline constexpr double kSceneWidthSigma = 0.35;

/// A tool of the scene as one to be followed; offsets count from its tip.
FoundTool found_tool(const SceneTool& needle);

/// Where its tip is expected.
ExpectedTip expected_tip(const SceneTool& needle);

/// Whether a tool found by lines is this one.
bool is_same(const FoundTool& tool, const SceneTool& needle);

}  // namespace pellucida
