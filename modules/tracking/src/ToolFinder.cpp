#include "ToolFinder.h"

#include <algorithm>
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

// Gradients at reduced resolution: tools are long, not fine.
struct Gradients {
  int factor = 2;
  GrayImage small;
  cv::Mat x, y, magnitude;
};

Gradients gradients_of(const GrayImage& image, int factor) {
  Gradients result;
  result.factor = factor;
  const cv::Mat input(image.height, image.width, CV_32F, const_cast<float*>(image.pixels.data()));
  GrayImage& small = result.small;
  small.width = std::max(1, image.width / factor);
  small.height = std::max(1, image.height / factor);
  small.pixels.resize(static_cast<std::size_t>(small.width) * small.height);
  cv::Mat smooth(small.height, small.width, CV_32F, small.pixels.data());
  cv::resize(input(cv::Rect(0, 0, small.width * factor, small.height * factor)), smooth, smooth.size(), 0, 0,
             cv::INTER_AREA);
  cv::GaussianBlur(smooth, smooth, {5, 5}, 0.6, 0.6, cv::BORDER_REPLICATE);
  cv::Scharr(smooth, result.x, CV_32F, 1, 0, 1.0 / 32.0, 0, cv::BORDER_REPLICATE);
  cv::Scharr(smooth, result.y, CV_32F, 0, 1, 1.0 / 32.0, 0, cv::BORDER_REPLICATE);
  cv::magnitude(result.x, result.y, result.magnitude);
  return result;
}

// The q-th part of the values in order.
float quantile(std::vector<float>& values, double q) {
  const auto k = static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[static_cast<std::size_t>(k)];
}

// The strongest cells of a table of votes, each with its neighbourhood cleared: angles go round.
std::vector<EdgeLine> strongest(cv::Mat& votes, int offset_half, double bin_angle, double least, std::size_t count) {
  std::vector<EdgeLine> lines;
  while (lines.size() < count) {
    double value = 0.0;
    cv::Point where;
    cv::minMaxLoc(votes, nullptr, &value, nullptr, &where);
    if (value < least || (!lines.empty() && value < 0.12 * lines.front().votes)) break;
    lines.push_back({where.y * bin_angle, static_cast<double>(where.x - offset_half), value});
    for (int a = -4; a <= 4; ++a) {
      const int row = ((where.y + a) % votes.rows + votes.rows) % votes.rows;
      for (int o = -2; o <= 2; ++o) {
        const int column = where.x + o;
        if (column >= 0 && column < votes.cols) votes.at<float>(row, column) = 0.0F;
      }
    }
  }
  return lines;
}

}  // namespace

bool passes(const FoundTool& tool, const Eigen::Vector2d& place, double beside_px) {
  const double beside = (place - tool.origin).dot(Eigen::Vector2d(-tool.direction.y(), tool.direction.x()));
  return beside > tool.offset_from - beside_px && beside < tool.offset_to + beside_px;
}

std::vector<FoundTool> find_tools(const GrayImage& image, const contour::Circle& cell) {
  const Gradients gradients = gradients_of(image, 2);
  const GrayImage& half = gradients.small;
  const cv::Mat &gx = gradients.x, &gy = gradients.y, &magnitude = gradients.magnitude;
  // A reduced pixel represents the middle of its block.
  const Eigen::Vector2d center = 0.5 * (cell.center - Eigen::Vector2d(0.5, 0.5));
  const double radius = 0.5 * cell.radius;
  std::vector<float> around;
  for (int y = 2; y < half.height - 2; ++y) {
    for (int x = 2; x < half.width - 2; x += 2) {
      if ((Eigen::Vector2d(x, y) - center).squaredNorm() > 1.25 * radius * radius)
        around.push_back(magnitude.at<float>(y, x));
    }
  }
  if (around.size() < 64) return {};
  const float typical = quantile(around, 0.5), low = std::max(2.5F * typical, quantile(around, 0.75));

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

  const std::vector<EdgeLine> lines = strongest(votes, offset_half, kBinAngle, std::max(8.0, 0.25 * radius), 24);

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

std::vector<FoundTool> find_tools(const GrayImage& image) {
  const int factor = std::clamp((std::max(image.width, image.height) + 299) / 300, 2, 8);
  const Gradients gradients = gradients_of(image, factor);
  const GrayImage& small = gradients.small;
  if (small.width < 24 || small.height < 24) return {};
  std::vector<float> all;
  for (int y = 2; y < small.height - 2; ++y)
    for (int x = 2; x < small.width - 2; ++x) all.push_back(gradients.magnitude.at<float>(y, x));
  const float low = std::max(2.0F * quantile(all, 0.5), 1e-4F);

  // Half a turn of lines, each by the side the gradient points to: an edge and its counterpart vote apart.
  const Eigen::Vector2d center(0.5 * (small.width - 1), 0.5 * (small.height - 1));
  const int offset_half = static_cast<int>(std::ceil(center.norm())), offsets = 2 * offset_half + 1;
  cv::Mat votes = cv::Mat::zeros(kAngleCount, offsets, CV_32F);
  for (int y = 2; y < small.height - 2; ++y) {
    for (int x = 2; x < small.width - 2; ++x) {
      const float m = gradients.magnitude.at<float>(y, x);
      if (m < low) continue;
      const Eigen::Vector2d d = Eigen::Vector2d(x, y) - center;
      const double angle = std::atan2(gradients.x.at<float>(y, x), -gradients.y.at<float>(y, x));
      for (int k = -2; k <= 2; ++k) {
        const double a = angle + k * kBinAngle;
        const int column = static_cast<int>(std::lround(std::cos(a) * d.y() - std::sin(a) * d.x())) + offset_half;
        if (column < 0 || column >= offsets) continue;
        const int row = ((static_cast<int>(std::lround(a / kBinAngle)) % kAngleCount) + kAngleCount) % kAngleCount;
        votes.at<float>(row, column) += k == 0 ? 1.0F : 0.6F;
      }
    }
  }
  cv::Mat padded;
  cv::copyMakeBorder(votes, padded, 4, 4, 0, 0, cv::BORDER_WRAP);
  cv::GaussianBlur(padded, padded, {3, 3}, 0.8);
  votes = padded.rowRange(4, 4 + kAngleCount).clone();
  const double shorter = std::min(small.width, small.height);
  const std::vector<EdgeLine> lines = strongest(votes, offset_half, kBinAngle, 0.15 * shorter, 24);

  // Two edges of opposite sense that run alongside each other: one line turned by half a turn has its offset negated.
  std::vector<FoundTool> tools;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      const double turn = std::remainder(lines[j].angle - lines[i].angle - std::numbers::pi, 2.0 * std::numbers::pi);
      const double apart = std::abs(lines[i].offset + lines[j].offset);
      if (std::abs(turn) > 0.16 || apart > 0.12 * shorter) continue;
      const double angle = lines[i].angle + 0.5 * turn, scale = factor;
      FoundTool tool;
      tool.origin = scale * center + Eigen::Vector2d::Constant(0.5 * (scale - 1.0));
      tool.direction = {std::cos(angle), std::sin(angle)};
      tool.offset_from = scale * std::min(lines[i].offset, -lines[j].offset) - scale;
      tool.offset_to = scale * std::max(lines[i].offset, -lines[j].offset) + scale;
      tool.strength = scale * (lines[i].votes + lines[j].votes);
      tools.push_back(tool);
      tool.direction = -tool.direction;
      std::swap(tool.offset_from, tool.offset_to);
      tool.offset_from = -tool.offset_from;
      tool.offset_to = -tool.offset_to;
      tools.push_back(tool);
    }
  }
  std::stable_sort(tools.begin(), tools.end(),
                   [](const FoundTool& a, const FoundTool& b) { return a.strength > b.strength; });
  if (tools.size() > 16) tools.resize(16);
  return tools;
}

}  // namespace pellucida
