#include "CellNetwork.h"

#include <cmath>

#include "NetworkInput.h"

namespace pellucida {
namespace {

// As in training: samples each way, and to the circle's radius.
constexpr int kCellSide = 80;
constexpr double kCellSamples = 25.0;

}  // namespace

class CellNetwork::Impl {
 public:
  Impl() : network_(read_network("cell")), grey_(kCellSide, kCellSide) {}

  double read(const FrameSampler& image, const Eigen::Vector2d& center, double radius_px) {
    const double spacing_px = radius_px / kCellSamples, reach_px = 0.5 * (kCellSide - 1) * spacing_px;
    for (int row = 0; row < kCellSide; ++row)
      sample_blurred(image, center + Eigen::Vector2d(-reach_px, row * spacing_px - reach_px), {spacing_px, 0.0},
                     kCellSide, grey_.ptr<float>(row));
    normalise(grey_);
    network_.setInput(with_mirror_image(grey_, spacing_px));
    const cv::Mat out = network_.forward();
    const double logit = 0.5 * (double{out.at<float>(0, 0)} + double{out.at<float>(1, 0)});
    return 1.0 / (1.0 + std::exp(-logit));
  }

 private:
  cv::dnn::Net network_;
  cv::Mat1f grey_;
};

CellNetwork::CellNetwork() : impl_(std::make_unique<Impl>()) {}
CellNetwork::~CellNetwork() = default;
CellNetwork::CellNetwork(CellNetwork&&) noexcept = default;
CellNetwork& CellNetwork::operator=(CellNetwork&&) noexcept = default;

double CellNetwork::read(const FrameSampler& image, const Eigen::Vector2d& center, double radius_px) {
  return impl_->read(image, center, radius_px);
}

}  // namespace pellucida
