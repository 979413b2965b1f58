#include "SceneReader.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pellucida {
namespace {

// Network pixels: width of a whole image, and the finest and coarsest that it may be seen, a px.
constexpr double kOverviewWidth = 256.0, kCoarsest = 0.31, kFinest = 1.0;
// Network pixels: a cell's radius in a closer look; how much of its surroundings that takes in, in radii.
constexpr double kCloseRadius = 62.0, kSurroundings = 3.0, kMostMagnified = 2.0;
// The same of a needle's tip: how finely it is looked at, network pixels a px at most, and over how many network
// pixels.
constexpr double kTipScale = 1.0, kTipSide = 128.0, kTipMagnified = 3.0;
// Not worth another look unless magnified by so much; the same needle from nearer by (cosine).
constexpr double kWorthwhile = 1.2, kSameFromNearer = 0.935;
// A closer look that finds the cell elsewhere has found another, radii.
constexpr double kElsewhere = 0.3;
constexpr std::size_t kMostCells = 3;
// A tool found by lines is a needle of the scene when their directions (cosine) and axes (map pixels) are as near.
constexpr double kSameDirection = 0.985, kSameShortDirection = 0.93, kSameAxis = 2.5;
// A needle ends within so many map pixels of where the scene has its tip.
constexpr double kTipError = 2.5;
// Of the radius: within this of its circle a point of an outline belongs to the undeformed part.
constexpr Eigen::Index kDrawnPoints = 128;  // of a drawn outline
constexpr double kCircleTolerance = 0.06;

double close_scale(double radius_px) {
  return std::min(kMostMagnified, kCloseRadius / radius_px);
}

// How wide holding pipettes are shows better from nearer by.
void take_widths(std::vector<SceneTool>& holders, const std::vector<SceneTool>& closer) {
  for (SceneTool& holder : holders)
    for (const SceneTool& other : closer) {
      const bool is_same = other.pitch_px < holder.pitch_px && other.direction.dot(holder.direction) > kSameFromNearer;
      if (is_same) holder.half_width_px = other.half_width_px;
    }
}

}  // namespace

SceneNetwork& SceneReader::network() {
  if (!network_) network_ = std::make_unique<SceneNetwork>();
  return *network_;
}

SceneReading SceneReader::look_at(const GrayImage& image, const Eigen::Vector2d& center, double radius_px) {
  const double side = kSurroundings * radius_px;
  return read_scene(network().read(image, {center, side, side}, close_scale(radius_px)), image.width, image.height);
}

// The tip's place from nearer by; the axis stays that of the whole shaft.
void SceneReader::look_at_tip(const GrayImage& image, SceneTool& needle, double scale) {
  const double nearer = std::min(kTipScale, kTipMagnified * scale), side = kTipSide / nearer;
  if (nearer < kWorthwhile * scale) return;
  const SceneReading close =
      read_scene(network().read(image, {needle.tip, side, side}, nearer), image.width, image.height);
  for (const SceneTool& other : close.needles) {
    const bool same = other.direction.dot(needle.direction) > kSameFromNearer && other.tip_share > kLeastNeedleTipShare;
    if (!same || (other.tip - needle.tip).norm() > kTipError * needle.pitch_px) continue;
    needle.tip = other.tip;
    needle.tip_share = other.tip_share;
    needle.pitch_px = other.pitch_px;
    return;
  }
}

BoundaryNetwork& SceneReader::boundaries() {
  if (!boundaries_) boundaries_ = std::make_unique<BoundaryNetwork>();
  return *boundaries_;
}

ThicknessNetwork& SceneReader::thicknesses() {
  if (!thicknesses_) thicknesses_ = std::make_unique<ThicknessNetwork>();
  return *thicknesses_;
}

TipNetwork& SceneReader::tips() {
  if (!tips_) tips_ = std::make_unique<TipNetwork>();
  return *tips_;
}

TipWidthNetwork& SceneReader::tip_widths() {
  if (!tip_widths_) tip_widths_ = std::make_unique<TipWidthNetwork>();
  return *tip_widths_;
}

PunctureNetwork& SceneReader::punctures() {
  if (!punctures_) punctures_ = std::make_unique<PunctureNetwork>();
  return *punctures_;
}

CellNetwork& SceneReader::cells() {
  if (!cells_) cells_ = std::make_unique<CellNetwork>();
  return *cells_;
}

SceneReading SceneReader::read(const GrayImage& image) {
  const double scale = std::clamp(kOverviewWidth / image.width, kCoarsest, kFinest);
  const SceneWindow whole{
      {0.5 * (image.width - 1), 0.5 * (image.height - 1)}, double(image.width), double(image.height)};
  SceneReading reading = read_scene(network().read(image, whole, scale), image.width, image.height);
  if (reading.cells.size() > kMostCells) reading.cells.resize(kMostCells);
  std::vector<SceneCell> closer;
  for (const SceneCell& cell : reading.cells) {
    const SceneReading close = look_at(image, cell.center, cell.radius_px);
    take_widths(reading.holders, close.holders);
    const auto same = std::find_if(close.cells.begin(), close.cells.end(), [&](const SceneCell& other) {
      return (other.center - cell.center).norm() < kElsewhere * cell.radius_px;
    });
    if (same != close.cells.end()) closer.push_back(*same);
  }
  reading.cells = std::move(closer);
  for (SceneTool& needle : reading.needles) look_at_tip(image, needle, scale);
  return reading;
}

DetectedCell detected(const SceneCell& cell) {
  DetectedCell result;
  result.outer.points = cell.outer;
  if (cell.inner.cols() > 0) {
    result.inner = result.outer;
    result.inner->points = cell.inner;
  }
  result.circle = contour::fit_circle(cell.outer, kCircleTolerance * cell.radius_px);
  result.score = cell.share;
  return result;
}

DetectedCell detected(const Eigen::Matrix2Xd& outline) {
  SceneCell cell;
  cell.outer = contour::resample(contour::positively_oriented(outline), kDrawnPoints);
  cell.radius_px = std::sqrt(contour::signed_area(cell.outer) / std::numbers::pi);
  cell.share = 1.0;
  return detected(cell);
}

FoundTool found_tool(const SceneTool& needle) {
  FoundTool tool;
  tool.origin = needle.tip;
  tool.direction = -needle.direction;
  tool.offset_from = -needle.half_width_px;
  tool.offset_to = needle.half_width_px;
  tool.strength = needle.length_px;
  tool.width_sigma = kSceneWidthSigma;
  return tool;
}

ExpectedTip expected_tip(const SceneTool& needle) {
  return {needle.tip, kTipError * needle.pitch_px};
}

bool is_same(const FoundTool& tool, const SceneTool& needle) {
  if (-tool.direction.dot(needle.direction) < (needle.is_short ? kSameShortDirection : kSameDirection)) return false;
  const Eigen::Vector2d across(-tool.direction.y(), tool.direction.x());
  const double apart = (needle.tip - tool.origin).dot(across) - tool.offset();
  return std::abs(apart) < kSameAxis * needle.pitch_px + needle.half_width_px;
}

}  // namespace pellucida
