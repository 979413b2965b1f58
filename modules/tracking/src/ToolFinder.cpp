#include "ToolFinder.h"

#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace pellucida {
namespace {

constexpr int kAngleCount = 240;  // 1.5 degrees a bin
constexpr double kBinAngle = 2.0 * std::numbers::pi / kAngleCount;

struct EdgeLine {
  double angle, offset, votes;
};

// How wide a tool is, and where its middle runs: the extent of what differs from the medium in the median
// cross-section. Half resolution.
void measure_width(const GrayImage& half, const Eigen::Vector2d& center, double radius, FoundTool& tool) {
  const Eigen::Vector2d across(-tool.direction.y(), tool.direction.x());
  const int reach = static_cast<int>(std::ceil(0.95 * radius));
  std::vector<std::vector<float>> columns(static_cast<std::size_t>(2 * reach + 1));
  for (double s = 1.25 * radius; s < 8.0 * radius; s += 1.5) {
    if (!half.inside(center + s * tool.direction + tool.offset() * across, 1.0)) break;
    std::vector<float> row;
    for (int v = -reach; v <= reach; ++v) row.push_back(half.sample(center + s * tool.direction + double(v) * across));
    // Against the row's own median, so that an illumination gradient along the tool cancels.
    std::vector<float> sorted = row;
    std::nth_element(sorted.begin(), sorted.begin() + reach, sorted.end());
    const float medium = sorted[static_cast<std::size_t>(reach)];
    for (std::size_t v = 0; v < row.size(); ++v) columns[v].push_back(row[v] - medium);
  }
  if (columns.front().size() < 8) return;
  std::vector<float> profile;
  for (std::vector<float>& column : columns) {
    std::nth_element(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(column.size() / 2), column.end());
    profile.push_back(std::abs(column[column.size() / 2]));
  }
  const float threshold = 0.3F * *std::max_element(profile.begin(), profile.end());
  int from = -1, to = -1;
  for (int v = 0; v <= 2 * reach; ++v) {
    if (profile[static_cast<std::size_t>(v)] < threshold) continue;
    if (from < 0) from = v;
    to = v;
  }
  if (from < 0) return;
  tool.offset_from = from - reach;
  tool.offset_to = to - reach;
}

}  // namespace

std::vector<FoundTool> find_tools(const GrayImage& image, const contour::Circle& cell) {
  // Gradients at half resolution: tools are long, not fine.
  const GrayImage half = reduced(image, 1.2, 2);
  const cv::Mat input(half.height, half.width, CV_32F, const_cast<float*>(half.pixels.data()));
  cv::Mat gx, gy, magnitude;
  cv::Scharr(input, gx, CV_32F, 1, 0, 1.0 / 32.0, 0, cv::BORDER_REPLICATE);
  cv::Scharr(input, gy, CV_32F, 0, 1, 1.0 / 32.0, 0, cv::BORDER_REPLICATE);
  cv::magnitude(gx, gy, magnitude);
  const Eigen::Vector2d center = 0.5 * cell.center;
  const double radius = 0.5 * cell.radius;
  std::vector<float> around;
  for (int y = 2; y < half.height - 2; ++y) {
    for (int x = 2; x < half.width - 2; ++x) {
      if ((Eigen::Vector2d(x, y) - center).norm() > 1.12 * radius) around.push_back(magnitude.at<float>(y, x));
    }
  }
  if (around.size() < 64) return {};
  const auto quantile = [&](double q) {
    const auto k = static_cast<std::ptrdiff_t>(q * static_cast<double>(around.size() - 1));
    std::nth_element(around.begin(), around.begin() + k, around.end());
    return around[static_cast<std::size_t>(k)];
  };
  const float typical = quantile(0.5), low = std::max(2.5F * typical, quantile(0.75));

  // Every clear pixel votes for the line through it across its gradient, on the side of the cell where it lies.
  const int offset_half = static_cast<int>(std::ceil(0.95 * radius)), offsets = 2 * offset_half + 1;
  cv::Mat votes = cv::Mat::zeros(kAngleCount, offsets, CV_32F);
  for (int y = 2; y < half.height - 2; ++y) {
    for (int x = 2; x < half.width - 2; ++x) {
      const float m = magnitude.at<float>(y, x);
      if (m < low) continue;
      const Eigen::Vector2d d = Eigen::Vector2d(x, y) - center;
      if (d.norm() < 1.12 * radius) continue;
      Eigen::Vector2d along(-gy.at<float>(y, x) / m, gx.at<float>(y, x) / m);
      if (along.dot(d) < 0.0) along = -along;
      if (along.dot(d) < 0.5 * d.norm()) continue;
      // The gradient's direction is good to a few degrees: spread the vote, each angle with its own offset.
      const double angle = std::atan2(along.y(), along.x());
      for (int k = -2; k <= 2; ++k) {
        const double a = angle + k * kBinAngle;
        const double o = std::cos(a) * d.y() - std::sin(a) * d.x();
        const int column = static_cast<int>(std::lround(o)) + offset_half;
        if (column < 0 || column >= offsets) continue;
        const int row = ((static_cast<int>(std::lround(a / kBinAngle)) % kAngleCount) + kAngleCount) % kAngleCount;
        votes.at<float>(row, column) += k == 0 ? 1.0F : 0.6F;
      }
    }
  }
  // Smooth, round the circle of angles too.
  cv::Mat padded;
  cv::copyMakeBorder(votes, padded, 4, 4, 0, 0, cv::BORDER_WRAP);
  cv::GaussianBlur(padded, padded, {3, 3}, 0.8);
  votes = padded.rowRange(4, 4 + kAngleCount).clone();

  // The strongest lines.
  std::vector<EdgeLine> lines;
  const double least = std::max(8.0, 0.25 * radius);
  for (int k = 0; k < 24; ++k) {
    double value = 0.0;
    cv::Point where;
    cv::minMaxLoc(votes, nullptr, &value, nullptr, &where);
    if (value < least || (!lines.empty() && value < 0.12 * lines.front().votes)) break;
    lines.push_back({where.y * kBinAngle, static_cast<double>(where.x - offset_half), value});
    for (int a = -4; a <= 4; ++a) {
      const int row = ((where.y + a) % kAngleCount + kAngleCount) % kAngleCount;
      for (int o = -2; o <= 2; ++o) {
        const int column = where.x + o;
        if (column >= 0 && column < offsets) votes.at<float>(row, column) = 0.0F;
      }
    }
  }

  // Nearly parallel lines on one side belong to one tool.
  std::vector<FoundTool> tools;
  std::vector<bool> used(lines.size(), false);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (used[i]) continue;
    double cosine = 0.0, sine = 0.0, weight = 0.0, from = 1e9, to = -1e9;
    for (std::size_t j = i; j < lines.size(); ++j) {
      const double difference = std::remainder(lines[j].angle - lines[i].angle, 2.0 * std::numbers::pi);
      if (used[j] || std::abs(difference) > 0.16) continue;
      used[j] = true;
      cosine += lines[j].votes * std::cos(lines[j].angle);
      sine += lines[j].votes * std::sin(lines[j].angle);
      weight += lines[j].votes;
      from = std::min(from, lines[j].offset);
      to = std::max(to, lines[j].offset);
    }
    FoundTool tool;
    tool.origin = cell.center;
    tool.direction = Eigen::Vector2d(cosine, sine).normalized();
    tool.offset_from = from;
    tool.offset_to = to;
    measure_width(half, center, radius, tool);
    tool.offset_from *= 2.0;
    tool.offset_to *= 2.0;
    tool.strength = 2.0 * weight;
    tools.push_back(tool);
  }
  std::sort(tools.begin(), tools.end(), [](const FoundTool& a, const FoundTool& b) { return a.strength > b.strength; });
  return tools;
}

}  // namespace pellucida
