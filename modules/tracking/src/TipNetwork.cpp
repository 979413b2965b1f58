#include "TipNetwork.h"

#include <algorithm>
#include <cmath>

#include "NetworkInput.h"

namespace pellucida {
namespace {

// As in training: samples along the needle and across, the supposed tip's place along; samples to the half width, and
// the finest and coarsest they lie, px.
constexpr int kAlong = 96, kAcross = 64, kSupposed = 56;
constexpr double kHalfWidthSamples = 5.0, kFinest_px = 0.5, kCoarsest_px = 3.0;

}  // namespace

class TipNetwork::Impl {
 public:
  Impl() : network_(read_network("tip")), grey_(kAcross, kAlong) {}

  TipReading read(const FrameSampler& image, const NeedleAxis& axis, double half_width_px) {
    const double spacing_px = std::clamp(half_width_px / kHalfWidthSamples, kFinest_px, kCoarsest_px);
    constexpr double kMiddle = 0.5 * (kAcross - 1);
    for (int row = 0; row < kAcross; ++row)
      sample_blurred(image, axis.at(kSupposed * spacing_px, (row - kMiddle) * spacing_px), spacing_px * axis.direction,
                     kAlong, grey_.ptr<float>(row));
    normalise(grey_);
    const int sizes[] = {1, 2, kAcross, kAlong};
    cv::Mat patch(4, sizes, CV_32F);
    std::copy(grey_.begin(), grey_.end(), patch.ptr<float>(0, 0));
    std::fill_n(patch.ptr<float>(0, 1), kAcross * kAlong, spacing_code(spacing_px));
    network_.setInput(patch);
    const cv::Mat out = network_.forward();

    // The answer summed along and across, each with its own peak.
    const Eigen::Map<const Eigen::Array<float, kAcross, kAlong, Eigen::RowMajor>> logits(out.ptr<float>(0, 0));
    const Eigen::Array<float, kAcross, kAlong, Eigen::RowMajor> weights = (logits - logits.maxCoeff()).exp();
    const Eigen::Array<float, 1, kAlong> along = weights.colwise().sum().max(kLeastWeight).log();
    const Eigen::Array<float, kAcross, 1> across = weights.rowwise().sum().max(kLeastWeight).log();
    const PeakPlace u = peak_of(along.data(), kAlong), v = peak_of(across.data(), kAcross);
    TipReading reading;
    reading.tip = axis.at((kSupposed - u.mean) * spacing_px, (v.mean - kMiddle) * spacing_px);
    reading.along_sigma_px = u.spread * spacing_px;
    const int row = static_cast<int>(std::lround(v.mean)), column = static_cast<int>(std::lround(u.mean));
    const int top = std::max(0, row - kNear), left = std::max(0, column - kNear);
    const int height = std::min(kAcross, row + kNear + 1) - top, width = std::min(kAlong, column + kNear + 1) - left;
    reading.share = double{weights.block(top, left, height, width).sum()} / double{weights.sum()};
    return reading;
  }

 private:
  static constexpr float kLeastWeight = 1e-12F;
  static constexpr int kNear = 4;  // samples about the peak that count as there

  cv::dnn::Net network_;
  cv::Mat1f grey_;
};

TipNetwork::TipNetwork() : impl_(std::make_unique<Impl>()) {}
TipNetwork::~TipNetwork() = default;
TipNetwork::TipNetwork(TipNetwork&&) noexcept = default;
TipNetwork& TipNetwork::operator=(TipNetwork&&) noexcept = default;

TipReading TipNetwork::read(const FrameSampler& image, const NeedleAxis& axis, double half_width_px) {
  return impl_->read(image, axis, half_width_px);
}

}  // namespace pellucida
