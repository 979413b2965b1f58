#include "TipWidthNetwork.h"

#include <algorithm>
#include <cmath>

#include "NetworkInput.h"

namespace pellucida {
namespace {

// As in training: samples along the needle and across, the tip's place along; samples to the half width, and the finest
// and coarsest they lie, px; the range of the standard deviation's logarithm.
constexpr int kWidthAlong = 80, kWidthAcross = 48, kTipPlace = 56;
constexpr double kWidthSamples = 7.0, kFinestWidth_px = 0.4, kCoarsestWidth_px = 3.0;
constexpr double kLeastSigmaLog = -3.5, kMostSigmaLog = 1.0;

}  // namespace

class TipWidthNetwork::Impl {
 public:
  Impl() : network_(read_network("tip_width")), grey_(kWidthAcross, kWidthAlong) {}

  TipWidthReading read(const FrameSampler& image, const NeedleAxis& axis, double half_width_px) {
    const double spacing_px = std::clamp(half_width_px / kWidthSamples, kFinestWidth_px, kCoarsestWidth_px);
    constexpr double kMiddle = 0.5 * (kWidthAcross - 1);
    for (int row = 0; row < kWidthAcross; ++row)
      sample_blurred(image, axis.at(kTipPlace * spacing_px, (row - kMiddle) * spacing_px), spacing_px * axis.direction,
                     kWidthAlong, grey_.ptr<float>(row));
    normalise(grey_);
    network_.setInput(with_mirror_image(grey_, spacing_px));
    const cv::Mat out = network_.forward();

    const auto sigma = [&](int guise) {
      return std::exp(std::clamp(double{out.at<float>(guise, 1)}, kLeastSigmaLog, kMostSigmaLog));
    };
    const double a = out.at<float>(0, 0), b = out.at<float>(1, 0);
    return {spacing_px * std::exp(0.5 * (a + b)), std::hypot(0.5 * (sigma(0) + sigma(1)), 0.5 * (a - b))};
  }

 private:
  cv::dnn::Net network_;
  cv::Mat1f grey_;
};

TipWidthNetwork::TipWidthNetwork() : impl_(std::make_unique<Impl>()) {}
TipWidthNetwork::~TipWidthNetwork() = default;
TipWidthNetwork::TipWidthNetwork(TipWidthNetwork&&) noexcept = default;
TipWidthNetwork& TipWidthNetwork::operator=(TipWidthNetwork&&) noexcept = default;

TipWidthReading TipWidthNetwork::read(const FrameSampler& image, const NeedleAxis& axis, double half_width_px) {
  return impl_->read(image, axis, half_width_px);
}

}  // namespace pellucida
