#pragma once
#include <memory>

#include "CellDetector.h"
#include "NeedleStart.h"
#include "SceneReading.h"
#include "ToolFinder.h"

namespace pellucida {

/// Reads whole images and, closer, the cells found in them. Loads the network on first use.
class SceneReader {
 public:
  /// Everything in the image; each cell's outlines from a closer look at it. Allocates; for detection, not for
  /// every frame.
  SceneReading read(const GrayImage& image);

  /// How good an outline of a closer look at such a cell is, px.
  static double outline_error_px(double radius_px) noexcept;

 private:
  SceneNetwork& network();
  SceneReading look_at(const GrayImage& image, const Eigen::Vector2d& center, double radius_px);
  void look_at_tip(const GrayImage& image, SceneTool& needle, double scale);
  std::unique_ptr<SceneNetwork> network_;
};

/// A cell of the scene as a detection whose edges' look is to be learnt.
DetectedCell detected(const SceneCell& cell);

/// A needle of the scene as a tool to be followed; offsets count from its tip.
FoundTool found_tool(const SceneTool& needle);

/// Where its tip is expected.
ExpectedTip expected_tip(const SceneTool& needle);

/// Whether a tool found by lines is this one.
bool is_same(const FoundTool& tool, const SceneTool& needle);

}  // namespace pellucida
