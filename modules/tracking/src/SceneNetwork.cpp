#include "SceneNetwork.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "NetworkInput.h"

namespace pellucida {
namespace {

// The network halves its input five times.
constexpr int kMultiple = 32;
// Blur before the picture is reduced, network pixels: as in training.
constexpr double kReducingBlur = 0.42, kReduces = 0.7;

int rounded_up(double size) {
  return kMultiple * std::max(1, static_cast<int>(std::ceil(size / kMultiple - 1e-9)));
}

}  // namespace

class SceneNetwork::Impl {
 public:
  Impl() : network_(read_network("scene")) {}

  SceneMap read(const GrayImage& image, const SceneWindow& window, double pixel_per_px) {
    const int width = rounded_up(window.width_px * pixel_per_px), height = rounded_up(window.height_px * pixel_per_px);
    const cv::Mat1f whole(image.height, image.width, const_cast<float*>(image.pixels.data()));
    cv::Mat1f smooth;  // of its own: the image is the caller's
    if (pixel_per_px < kReduces) {
      cv::GaussianBlur(whole, smooth, {}, kReducingBlur / pixel_per_px);
    } else {
      smooth = whole;
    }
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
