#include "RingChoice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "SceneVerdict.h"

namespace pellucida {
namespace {

// Of the radius found: the rings tried, each a tenth smaller than the last.
constexpr double kLargestRing_ratio = 1.25, kSmallestRing_ratio = 0.48, kRingStep_ratio = 0.9;
// As sure as a cell with poor boundaries has to be.
constexpr double kSureRing = 0.9;
constexpr Eigen::Index kRingPoints = 128;

SceneCell round_cell(const contour::Circle& circle, double share) {
  SceneCell cell;
  cell.center = circle.center;
  cell.radius_px = circle.radius;
  cell.share = share;
  cell.outer.resize(2, kRingPoints);
  for (Eigen::Index i = 0; i < kRingPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kRingPoints;
    cell.outer.col(i) = circle.center + circle.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return cell;
}

// The ring about a circle that the network that knows cells is surest of, where it is sure of one.
std::optional<SceneCell> likeliest_ring(const contour::Circle& about, const FrameSampler& image, SceneReader& reader) {
  contour::Circle best = about;
  double share = 0.0;
  for (double ratio = kLargestRing_ratio; ratio > kSmallestRing_ratio; ratio *= kRingStep_ratio) {
    const double now = reader.cells().read(image, about.center, ratio * about.radius);
    if (now <= share) continue;
    share = now;
    best.radius = ratio * about.radius;
  }
  if (share < kSureRing) return std::nullopt;
  return round_cell(best, share);
}

}  // namespace

void add_likeliest_ring(SceneReading& scene, const GrayImage& whole, const TrackerOptions& options,
                        const contour::Circle& found, const FrameSampler& image, SceneReader& reader) {
  contour::Circle about = found;
  if (is_bystander(found, scene)) {
    const std::optional<DetectedCell> other = detect_cell(whole, options, nullptr, &found);
    if (!other || is_bystander(other->circle, scene)) return;
    about = other->circle;
  }
  if (const auto ring = likeliest_ring(about, image, reader)) scene.cells.push_back(*ring);
}

void add_ring_behind(SceneReading& scene, const GrayImage& whole, const TrackerOptions& options,
                     const contour::Circle& found, const FrameSampler& image, SceneReader& reader) {
  const auto is_aimed_at = [&](const SceneTool& needle) { return points_into(needle, found.center, found.radius); };
  if (std::none_of(scene.needles.begin(), scene.needles.end(), is_aimed_at)) return;
  const std::optional<DetectedCell> other = detect_cell(whole, options, nullptr, &found);
  if (!other) return;
  const auto passes = [&](const SceneTool& needle) {
    return is_aimed_at(needle) && points_into(needle, other->circle.center, other->circle.radius) &&
           (other->circle.center - found.center).dot(needle.direction) > found.radius;
  };
  if (std::none_of(scene.needles.begin(), scene.needles.end(), passes)) return;
  if (const auto ring = likeliest_ring(other->circle, image, reader)) scene.cells.push_back(*ring);
}

}  // namespace pellucida
