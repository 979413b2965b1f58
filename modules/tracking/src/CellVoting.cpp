#include <cmath>
#include <opencv2/imgproc.hpp>

#include "CellDetector.h"

namespace pellucida {
namespace {

struct GradientPixel {
  float x, y, gx, gy, weight;
};

// Pixels with a clear gradient, direction normalised; weights saturate so that a few glaring edges do not decide.
std::vector<GradientPixel> strong_gradients(const GrayImage& image) {
  const cv::Mat input(image.height, image.width, CV_32F, const_cast<float*>(image.pixels.data()));
  cv::Mat gx, gy;
  cv::Scharr(input, gx, CV_32F, 1, 0, 1.0 / 32.0, 0, cv::BORDER_REPLICATE);
  cv::Scharr(input, gy, CV_32F, 0, 1, 1.0 / 32.0, 0, cv::BORDER_REPLICATE);
  cv::Mat magnitude, light;
  cv::magnitude(gx, gy, magnitude);
  // Contrast counts against the light round about (Weber): a glaring pipette must not outvote a faint outline in the
  // dark.
  cv::blur(input, light, {25, 25}, {-1, -1}, cv::BORDER_REPLICATE);
  double darkest = 0.0;
  cv::minMaxLoc(light, &darkest, nullptr);
  light = light - 0.8 * darkest;
  cv::Mat sharp = magnitude.clone();
  cv::divide(magnitude, light + 1e-3, magnitude);
  std::vector<float> sorted;
  for (int y = 1; y < image.height; y += 2) {
    for (int x = 1; x < image.width; x += 2) sorted.push_back(magnitude.at<float>(y, x));
  }
  std::vector<GradientPixel> pixels;
  if (sorted.size() < 16) return pixels;
  const auto quantile = [&](double q) {
    const auto k = static_cast<std::ptrdiff_t>(q * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), sorted.begin() + k, sorted.end());
    return sorted[static_cast<std::size_t>(k)];
  };
  const float low = std::max(quantile(0.80), 1e-6F), high = std::max(quantile(0.93), low);
  for (int y = 1; y < image.height - 1; ++y) {
    for (int x = 1; x < image.width - 1; ++x) {
      const float m = magnitude.at<float>(y, x);
      if (m < low) continue;
      pixels.push_back({static_cast<float>(x), static_cast<float>(y), gx.at<float>(y, x) / sharp.at<float>(y, x),
                        gy.at<float>(y, x) / sharp.at<float>(y, x), std::min(m, high) / high});
    }
  }
  return pixels;
}

// Each pixel votes for the centres of the circles of radius `from`..`to` that it may lie on, along its gradient and
// against it.
void vote(const std::vector<GradientPixel>& pixels, float from, float to, cv::Mat& votes) {
  for (const GradientPixel& p : pixels) {
    for (const float side : {-1.0F, 1.0F}) {
      const float dx = side * p.gx, dy = side * p.gy;
      // Half a pixel more, and truncation rounds.
      float x = p.x + from * dx + 0.5F, y = p.y + from * dy + 0.5F;
      for (float r = from; r <= to; r += 1.0F, x += dx, y += dy) {
        if (!(x >= 0.0F && y >= 0.0F)) continue;
        const int column = static_cast<int>(x), row = static_cast<int>(y);
        if (column >= votes.cols || row >= votes.rows) continue;
        votes.at<float>(row, column) += p.weight / r;
      }
    }
  }
}

// Peaks of one accumulator, each at least `apart` px from a higher one.
void take_peaks(cv::Mat& votes, int count, double apart, std::vector<CellCandidate>& out, double radius, int level) {
  const double scale = 1 << level;
  for (int k = 0; k < count; ++k) {
    double value = 0.0;
    cv::Point where;
    cv::minMaxLoc(votes, nullptr, &value, nullptr, &where);
    if (value <= 0.0) return;
    out.push_back({Eigen::Vector2d(where.x * scale, where.y * scale), radius * scale, level, value});
    cv::circle(votes, where, static_cast<int>(std::ceil(apart)), cv::Scalar(0), cv::FILLED);
  }
}

}  // namespace

std::vector<CellCandidate> propose_cells(const std::vector<GrayImage>& pyramid, const TrackerOptions& options) {
  // Radii of each level's bands, px of that level; the levels together cover 9, 18, 36... without gaps.
  constexpr double kBands[][2] = {{9.0, 14.0}, {13.0, 20.0}, {19.0, 29.0}};
  std::vector<CellCandidate> candidates;
  cv::Mat votes;
  for (int level = 0; level < static_cast<int>(pyramid.size()); ++level) {
    const GrayImage& image = pyramid[static_cast<std::size_t>(level)];
    const double scale = 1 << level;
    const bool last = level + 1 == static_cast<int>(pyramid.size());
    // What the next, far cheaper level sees as well, is its job.
    if (!last && 2.0 * kBands[0][0] * 2.0 * scale <= options.min_cell_diameter_px) continue;
    const std::vector<GradientPixel> pixels = strong_gradients(image);
    for (const auto& band : kBands) {
      if (band[0] > 15.0 && !last) continue;
      if (2.0 * band[1] * scale < options.min_cell_diameter_px || 2.0 * band[0] * scale > options.max_cell_diameter_px)
        continue;
      votes = cv::Mat::zeros(image.height, image.width, CV_32F);
      vote(pixels, static_cast<float>(band[0]), static_cast<float>(band[1]), votes);
      const double middle = 0.5 * (band[0] + band[1]);
      cv::GaussianBlur(votes, votes, {0, 0}, 0.11 * middle);
      take_peaks(votes, 5, 0.4 * middle, candidates, middle, level);
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const CellCandidate& a, const CellCandidate& b) { return a.votes > b.votes; });
  return candidates;
}

}  // namespace pellucida
