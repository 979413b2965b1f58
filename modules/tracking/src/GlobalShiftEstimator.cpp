#include "GlobalShiftEstimator.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace pellucida {
namespace {

constexpr int kThinning = 4;             // every so many pixels, both ways
constexpr int kSmallest = 16;            // smaller thumbnails carry no information
constexpr double kSuspicious = 1.2;      // times the usual change
constexpr double kLeastResponse = 0.04;  // of the phase correlation's peak
constexpr double kLeastJump_px = 3.0;
constexpr double kNothingYet = 1e9;

}  // namespace

void GlobalShiftEstimator::thin_out(const FrameSampler& image) {
  const int width = image.width / kThinning, height = image.height / kThinning;
  if (now_.cols != width || now_.rows != height) {
    now_.create(height, width, CV_32F);
    before_.create(height, width, CV_32F);
    reset();
    cv::createHanningWindow(window_, now_.size(), CV_32F);
  }
  for (int y = 0; y < height; ++y) {
    float* row = now_.ptr<float>(y);
    for (int x = 0; x < width; ++x) row[x] = image.at(x * kThinning + 1, y * kThinning + 1);
  }
}

std::optional<Eigen::Vector2d> GlobalShiftEstimator::update(const FrameSampler& image) {
  if (image.width / kThinning < kSmallest || image.height / kThinning < kSmallest) return std::nullopt;
  cv::swap(now_, before_);
  thin_out(image);
  const bool first = usual_change_ < 0.0;
  // A change of brightness alone is no change.
  const double brighter = cv::sum(now_)[0] / std::max(cv::sum(before_)[0], 1e-6);
  double change = 0.0;
  for (int y = 0; y < now_.rows; ++y) {
    const float *a = now_.ptr<float>(y), *b = before_.ptr<float>(y);
    float sum = 0.0F;
    for (int x = 0; x < now_.cols; ++x) sum += std::abs(a[x] - static_cast<float>(brighter) * b[x]);
    change += sum;
  }
  change /= static_cast<double>(now_.total());
  if (first) {
    usual_change_ = kNothingYet;  // the first frame has nothing to be compared with
    return std::nullopt;
  }
  const bool suspicious = usual_change_ < kNothingYet && change > kSuspicious * usual_change_;
  if (suspicious) {
    double response = 0.0;
    const cv::Point2d shift = cv::phaseCorrelate(before_, now_, window_, &response);
    const Eigen::Vector2d jump = kThinning * Eigen::Vector2d(shift.x, shift.y);
    if (response > kLeastResponse && jump.norm() > kLeastJump_px && jump.norm() < 0.25 * image.width) return jump;
  }
  usual_change_ = usual_change_ < kNothingYet ? usual_change_ + 0.1 * (change - usual_change_) : change;
  return std::nullopt;
}

}  // namespace pellucida
