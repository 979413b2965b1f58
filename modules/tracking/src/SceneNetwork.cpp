#include "SceneNetwork.h"

#include <algorithm>
#include <cmath>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/core/Resources.h"

namespace pellucida {
namespace {

// The network halves its input five times.
constexpr int kMultiple = 32;
// As in training: the furthest from the median that a pixel may be, in mean absolute deviations; the least deviation.
constexpr float kFurthest = 6.0F, kLeastDeviation = 1e-3F / 255.0F;
// Blur before the picture is reduced, network pixels: as in training.
constexpr double kReducingBlur = 0.42, kReduces = 0.7;

int rounded_up(double size) {
  return kMultiple * std::max(1, static_cast<int>(std::ceil(size / kMultiple - 1e-9)));
}

// Zero median, unit mean absolute deviation.
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

}  // namespace

class SceneNetwork::Impl {
 public:
  Impl() {
    const auto path = find_resource("networks", "scene", ".onnx");
    try {
      network_ = cv::dnn::readNetFromONNX(path.string());
    } catch (const cv::Exception& error) {
      throw InputError(path.string() + ": not a network that can be read (" + error.err + "); install pellucida anew");
    }
    network_.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
  }

  SceneMap read(const GrayImage& image, const SceneWindow& window, double pixel_per_px) {
    const int width = rounded_up(window.width_px * pixel_per_px), height = rounded_up(window.height_px * pixel_per_px);
    cv::Mat1f whole(image.height, image.width, const_cast<float*>(image.pixels.data())), smooth = whole;
    if (pixel_per_px < kReduces) cv::GaussianBlur(whole, smooth, {}, kReducingBlur / pixel_per_px);
    const Eigen::Vector2d first = window.center_px - 0.5 * Eigen::Vector2d(width - 1, height - 1) / pixel_per_px;
    const cv::Matx23d place(1.0 / pixel_per_px, 0.0, first.x(), 0.0, 1.0 / pixel_per_px, first.y());
    cv::Mat1f picture;
    cv::warpAffine(smooth, picture, place, {width, height}, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                   cv::BORDER_REFLECT_101);
    normalise(picture);

    const int sizes[] = {1, 1, height, width};
    network_.setInput(cv::Mat(4, sizes, CV_32F, picture.data));
    const cv::Mat out = network_.forward();
    SceneMap map;
    map.pitch_px = kSceneMapStep / pixel_per_px;
    // In training every second label was kept, from the first one on.
    map.origin_px = first;
    const int map_height = out.size[2], map_width = out.size[3];
    const auto plane = [&](int k) {
      return Eigen::Map<const SceneMap::Plane>(out.ptr<float>(0, k), map_height, map_width);
    };
    SceneMap::Plane largest = plane(0);
    for (int k = 1; k < kSceneClassCount; ++k) largest = largest.cwiseMax(plane(k));
    SceneMap::Plane sum = SceneMap::Plane::Zero(map_height, map_width);
    for (int k = 0; k < kSceneClassCount; ++k) {
      SceneMap::Plane& share = map.shares[static_cast<std::size_t>(k)];
      share = (plane(k) - largest).array().exp();
      sum += share;
    }
    for (SceneMap::Plane& share : map.shares) share.array() /= sum.array();
    map.tip = 1.0F / (1.0F + (-plane(kSceneClassCount)).array().exp());
    return map;
  }

 private:
  cv::dnn::Net network_;
};

SceneNetwork::SceneNetwork() : impl_(std::make_unique<Impl>()) {}
SceneNetwork::~SceneNetwork() = default;
SceneNetwork::SceneNetwork(SceneNetwork&&) noexcept = default;
SceneNetwork& SceneNetwork::operator=(SceneNetwork&&) noexcept = default;

SceneMap SceneNetwork::read(const GrayImage& image, const SceneWindow& window, double pixel_per_px) {
  return impl_->read(image, window, pixel_per_px);
}

}  // namespace pellucida
