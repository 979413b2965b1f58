#include "NetworkInput.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/core/Resources.h"

namespace pellucida {
namespace {

// As in training: the furthest from the median that a pixel may be, in mean absolute deviations; the least deviation.
constexpr float kFurthest = 6.0F, kLeastDeviation = 1e-3F / 255.0F;
// Blur before samples further apart than a pixel, as a sum of three samples so far apart, in spacings.
constexpr double kReducingReach = 0.6;
constexpr std::array kReducingWeights{0.26F, 0.48F, 0.26F};
// An answer counts so many places to both sides of its highest one; training's labels have a spread of their own, and
// no answer is surer than this.
constexpr int kPeakReach = 8;
constexpr double kLabelSpread = 1.0, kLeastSpread = 0.15;

// What of a variance the labels' own spread doesn't explain, as a standard deviation.
double beyond_label(double variance) {
  return std::sqrt(std::max(variance - kLabelSpread * kLabelSpread, kLeastSpread * kLeastSpread));
}

}  // namespace

cv::dnn::Net read_network(std::string_view name) {
  const auto path = find_resource("networks", std::string(name), ".onnx");
  try {
    cv::dnn::Net network = cv::dnn::readNetFromONNX(path.string());
    network.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    return network;
  } catch (const cv::Exception& error) {
    throw InputError(path.string() + ": not a network that can be read (" + error.err + "); install pellucida anew");
  }
}

void normalise(cv::Mat1f& picture) {
  std::vector<float> values(picture.begin(), picture.end());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  picture -= *middle;
  const auto spread = static_cast<float>(cv::norm(picture, cv::NORM_L1) / static_cast<double>(values.size()));
  picture /= spread + kLeastDeviation;
  cv::min(picture, kFurthest, picture);
  cv::max(picture, -kFurthest, picture);
}

void sample_blurred(const FrameSampler& image, const Eigen::Vector2d& from, const Eigen::Vector2d& step, int count,
                    float* out) {
  if (step.norm() <= 1.0) {
    image.sample_line(from, step, count, out);
    return;
  }
  const Eigen::Vector2d across(-step.y(), step.x());
  std::vector<float> line(static_cast<std::size_t>(count));
  std::fill_n(out, count, 0.0F);
  for (std::size_t a = 0; a < kReducingWeights.size(); ++a) {
    for (std::size_t b = 0; b < kReducingWeights.size(); ++b) {
      const Eigen::Vector2d beside =
          kReducingReach * ((static_cast<double>(a) - 1.0) * step + (static_cast<double>(b) - 1.0) * across);
      image.sample_line(from + beside, step, count, line.data());
      for (int k = 0; k < count; ++k)
        out[k] += kReducingWeights[a] * kReducingWeights[b] * line[static_cast<std::size_t>(k)];
    }
  }
}

float spacing_code(double spacing_px) {
  return static_cast<float>(std::clamp(std::log2(spacing_px), -3.0, 3.0) / 2.0);
}

cv::Mat with_mirror_image(const cv::Mat1f& patch, double spacing_px) {
  const int sizes[] = {2, 2, patch.rows, patch.cols};
  cv::Mat batch(4, sizes, CV_32F);
  for (const int guise : {0, 1}) {
    for (int row = 0; row < patch.rows; ++row)
      std::copy_n(patch.ptr<float>(guise == 0 ? row : patch.rows - 1 - row), patch.cols,
                  batch.ptr<float>(guise, 0, row));
    std::fill_n(batch.ptr<float>(guise, 1), patch.total(), spacing_code(spacing_px));
  }
  return batch;
}

PeakPlace peak_of(const float* logits, int count) {
  const int top = static_cast<int>(std::max_element(logits, logits + count) - logits);
  const int from = std::max(0, top - kPeakReach), to = std::min(count - 1, top + kPeakReach);
  double sum = 0.0, first = 0.0, second = 0.0;
  for (int k = from; k <= to; ++k) {
    const double weight = std::exp(double{logits[k]} - double{logits[top]});
    sum += weight;
    first += weight * k;
    second += weight * k * k;
  }
  const double mean = first / sum;
  return {mean, beyond_label(second / sum - mean * mean)};
}

double spread_about(const float* logits, int count, double mean) {
  const float top = *std::max_element(logits, logits + count);
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < count; ++k) {
    const double weight = std::exp(double{logits[k]} - double{top});
    sum += weight;
    squares += weight * (k - mean) * (k - mean);
  }
  return beyond_label(squares / sum);
}

}  // namespace pellucida
