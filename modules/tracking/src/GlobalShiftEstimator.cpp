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
constexpr double kExplained = 0.9;  // of the change may be left once the jump is undone

// Mean change from `before`, moved by whole thumbnail pixels, to `now`, where both are in view.
double change_after(const cv::Mat1f& before, const cv::Mat1f& now, cv::Point move, float brighter) {
  const cv::Rect whole({0, 0}, now.size()), common = whole & (whole + move);
  if (common.area() == 0) return kNothingYet;
  double sum = 0.0;
  for (int y = common.y; y < common.y + common.height; ++y) {
    const float *a = now.ptr<float>(y), *b = before.ptr<float>(y - move.y) - move.x;
    float row = 0.0F;
    for (int x = common.x; x < common.x + common.width; ++x) row += std::abs(a[x] - brighter * b[x]);
    sum += row;
  }
  return sum / common.area();
}

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
  const double change = change_after(before_, now_, {0, 0}, static_cast<float>(brighter));
  if (first) {
    usual_change_ = kNothingYet;  // the first frame has nothing to be compared with
    return std::nullopt;
  }
  const bool suspicious = usual_change_ < kNothingYet && change > kSuspicious * usual_change_;
  if (suspicious) {
    double response = 0.0;
    // Copies: where no padding is needed, OpenCV multiplies its inputs by the window.
    const cv::Point2d shift = cv::phaseCorrelate(before_.clone(), now_.clone(), window_, &response);
    const Eigen::Vector2d jump = kThinning * Eigen::Vector2d(shift.x, shift.y);
    const bool possible = response > kLeastResponse && jump.norm() > kLeastJump_px && jump.norm() < 0.25 * image.width;
    // A membrane that springs back changes as much, and no jump of the whole picture explains it.
    const cv::Point whole(cvRound(shift.x), cvRound(shift.y));
    if (possible && change_after(before_, now_, whole, static_cast<float>(brighter)) < kExplained * change) return jump;
  }
  usual_change_ = usual_change_ < kNothingYet ? usual_change_ + 0.1 * (change - usual_change_) : change;
  return std::nullopt;
}

}  // namespace pellucida
