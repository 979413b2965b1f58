#include "HolderFinder.h"

#include <algorithm>
#include <cmath>

#include "NeedleStart.h"

namespace pellucida {
namespace {

constexpr double kStraight = 0.4;  // of the cell's radius: how far its axis at the cell and further out may differ
// A tool that another faces, so much broader and so much as strong, is the needle.
constexpr double kBroader = 1.2, kAsStrong = 0.4, kFacing = -0.5;
constexpr double kAlike = 0.6;  // correlation that still is the pipette
// A wall ends in a rounded rim, and stops looking like a wall half its thickness before that: for the usual walls, a
// fifth of the half width thick, this share of the half width.
constexpr double kRimShare = 0.1;

// The two walls' grey values across the pipette, both sides one after the other.
class Walls {
 public:
  Walls(const FrameSampler& image, const HolderFit& holder, const contour::Circle& cell)
      : image_(image),
        holder_(holder),
        center_(cell.center),
        reach_(std::max(4.0, 0.35 * holder.half_width)),
        count_(static_cast<int>(2.0 * reach_) + 1) {}

  // At `along` px from the cell's centre, the mean of `lines` px of length.
  std::vector<float> at(double along, int lines) const {
    std::vector<float> result(static_cast<std::size_t>(2 * count_), 0.0F), line(static_cast<std::size_t>(count_));
    const Eigen::Vector2d across(-holder_.direction.y(), holder_.direction.x());
    for (int l = 0; l < lines; ++l) {
      const Eigen::Vector2d middle =
          center_ + (along + l - 0.5 * (lines - 1)) * holder_.direction + holder_.offset * across;
      for (int side = 0; side < 2; ++side) {
        const double sign = side == 0 ? -1.0 : 1.0;
        image_.sample_line(middle + sign * (holder_.half_width - reach_) * across, sign * across, count_, line.data());
        for (int j = 0; j < count_; ++j)
          result[static_cast<std::size_t>(side * count_ + j)] += line[static_cast<std::size_t>(j)];
      }
    }
    return result;
  }

  double correlation(const std::vector<float>& a, const std::vector<float>& b) const {
    double worst = 1.0;
    for (int side = 0; side < 2; ++side) {
      double sa = 0, sb = 0, aa = 0, bb = 0, ab = 0;
      for (int j = side * count_; j < (side + 1) * count_; ++j) {
        const double x = a[static_cast<std::size_t>(j)], y = b[static_cast<std::size_t>(j)];
        sa += x;
        sb += y;
        aa += x * x;
        bb += y * y;
        ab += x * y;
      }
      const double va = aa - sa * sa / count_, vb = bb - sb * sb / count_;
      worst = std::min(worst, (ab - sa * sb / count_) / std::sqrt(std::max(va * vb, 1e-12)));
    }
    return worst;
  }

 private:
  const FrameSampler& image_;
  const HolderFit& holder_;
  Eigen::Vector2d center_;
  double reach_;
  int count_;
};

// Distance of the mouth from the cell's centre; negative when the glass has no clear end.
double find_mouth(const FrameSampler& image, const HolderFit& holder, const contour::Circle& cell) {
  const Walls walls(image, holder, cell);
  const double radius = cell.radius, from = 1.45 * radius, least = 0.55 * radius;
  const std::vector<float> typical = walls.at(from, std::max(4, static_cast<int>(0.3 * radius)));
  double before = 1.0;
  for (double along = from; along > least; along -= 1.0) {
    const double alike = walls.correlation(walls.at(along, 3), typical);
    if (alike < kAlike) {
      if (along > 1.25 * radius) return -1.0;
      return along + (kAlike - alike) / std::max(before - alike, 1e-3) - kRimShare * holder.half_width;
    }
    before = alike;
  }
  return -1.0;
}

}  // namespace

std::optional<HolderFit> find_holder(const FrameSampler& image, const std::vector<FoundTool>& tools,
                                     const contour::Circle& cell, double noise, double least_ratio) {
  const auto is_needle = [&](const FoundTool& tool) {
    return std::any_of(tools.begin(), tools.end(), [&](const FoundTool& other) {
      return other.half_width() > kBroader * tool.half_width() && other.strength > kAsStrong * tool.strength &&
             other.direction.dot(tool.direction) < kFacing;
    });
  };
  for (const FoundTool& tool : tools) {
    if (tool.half_width() < least_ratio * cell.radius || is_needle(tool)) continue;
    HolderFit holder;
    holder.direction = tool.direction;
    holder.offset = tool.offset();
    holder.half_width = tool.half_width();
    holder.half_width_sigma = tool.width_sigma;
    double sure = 0.5;
    // Its edges close up; where they can't be followed, the lines voted for have to do.
    const std::optional<NeedleGuess> guess = guess_needle(image, tool, noise);
    const auto offset_of = [&](const NeedleGuess& one) {
      return (one.axis.tip - cell.center).dot(Eigen::Vector2d(one.axis.direction.y(), -one.axis.direction.x()));
    };
    // A bent one leads elsewhere from where it comes in.
    if (guess && guess->axis.direction.dot(tool.direction) < -0.95 &&
        std::abs(offset_of(*guess) - tool.offset()) < kStraight * cell.radius) {
      holder.direction = -guess->axis.direction;
      holder.offset = offset_of(*guess);
      const double at_cell = (guess->axis.tip - cell.center).dot(holder.direction);
      const double half_width = guess->model.cone.half_width(std::max(0.0, cell.radius - at_cell));
      if (half_width > least_ratio * cell.radius &&
          std::abs(half_width - tool.half_width()) < 0.4 * tool.half_width()) {
        holder.half_width = half_width;
        holder.half_width_sigma = 0.0;
        holder.unevenness = guess->model.look.unevenness();
        sure = 1.0;
      }
    }
    if (std::abs(holder.offset) > cell.radius) continue;
    holder.confidence = sure * std::clamp(tool.strength / (3.0 * cell.radius), 0.0, 1.0);
    double along = find_mouth(image, holder, cell);
    holder.mouth_seen = along > 0.0;
    if (!holder.mouth_seen) {
      const double sunk = std::min(0.8 * holder.half_width, 0.95 * cell.radius);
      along = std::sqrt(cell.radius * cell.radius - sunk * sunk);
      holder.confidence *= 0.8;
    }
    const Eigen::Vector2d across(-holder.direction.y(), holder.direction.x());
    holder.mouth = cell.center + along * holder.direction + holder.offset * across;
    return holder;
  }
  return std::nullopt;
}

}  // namespace pellucida
