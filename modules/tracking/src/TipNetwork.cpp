#include "TipNetwork.h"

#include <algorithm>
#include <cmath>

#include "NetworkInput.h"

namespace pellucida {
namespace {

// As in training: samples along the needle and across, the supposed tip's place along.
constexpr int kAlong = 96, kAcross = 64, kSupposed = 56;
constexpr double kMiddle = 0.5 * (kAcross - 1);
constexpr float kLeastWeight = 1e-12F;
constexpr int kAboutPeak = 4;  // samples about the peak that count as there
// A needle at least so wide, px, half its width, is looked at once more from nearer by; what is seen there counts where
// so much of the answer is in one place, within so many of the first look's samples.
constexpr double kWide_px = 4.0, kLeastFineShare = 0.5, kRefined_samples = 2.5;

}  // namespace

class TipNetwork::Impl {
 public:
  TipReading read(const FrameSampler& image, const NeedleAxis& axis, double half_width_px) {
    const double spacing_px = whole_.spacing_px(half_width_px);
    TipReading reading = read(image, axis, spacing_px, whole_.network);
    if (half_width_px < kWide_px || reading.share < kLeastFineShare) return reading;
    const TipReading fine = read(image, {reading.tip, axis.direction}, near_.spacing_px(half_width_px), near_.network);
    if (fine.share < kLeastFineShare || (fine.tip - reading.tip).norm() > kRefined_samples * spacing_px) return reading;
    reading.tip = fine.tip;
    reading.along_sigma_px = fine.along_sigma_px;
    return reading;
  }

 private:
  // As in training: samples to the half width, and the finest and coarsest they lie, px.
  struct Look {
    cv::dnn::Net network;
    double half_width_samples, finest_px, coarsest_px;

    double spacing_px(double half_width_px) const {
      return std::clamp(half_width_px / half_width_samples, finest_px, coarsest_px);
    }
  };

  TipReading read(const FrameSampler& image, const NeedleAxis& axis, double spacing_px, cv::dnn::Net& network) {
    for (int row = 0; row < kAcross; ++row)
      sample_blurred(image, axis.at(kSupposed * spacing_px, (row - kMiddle) * spacing_px), spacing_px * axis.direction,
                     kAlong, grey_.ptr<float>(row));
    normalise(grey_);
    const int sizes[] = {1, 2, kAcross, kAlong};
    cv::Mat patch(4, sizes, CV_32F);
    std::copy(grey_.begin(), grey_.end(), patch.ptr<float>(0, 0));
    std::fill_n(patch.ptr<float>(0, 1), kAcross * kAlong, spacing_code(spacing_px));
    network.setInput(patch);
    const cv::Mat out = network.forward();

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
    const int top = std::max(0, row - kAboutPeak), left = std::max(0, column - kAboutPeak);
    const int height = std::min(kAcross, row + kAboutPeak + 1) - top,
              width = std::min(kAlong, column + kAboutPeak + 1) - left;
    reading.share = double{weights.block(top, left, height, width).sum()} / double{weights.sum()};
    return reading;
  }

  Look whole_{read_network("tip"), 5.0, 0.5, 3.0}, near_{read_network("tip_fine"), 12.0, 0.5, 1.5};
  cv::Mat1f grey_ = cv::Mat1f(kAcross, kAlong);
};

TipNetwork::TipNetwork() : impl_(std::make_unique<Impl>()) {}
TipNetwork::~TipNetwork() = default;
TipNetwork::TipNetwork(TipNetwork&&) noexcept = default;
TipNetwork& TipNetwork::operator=(TipNetwork&&) noexcept = default;

TipReading TipNetwork::read(const FrameSampler& image, const NeedleAxis& axis, double half_width_px) {
  return impl_->read(image, axis, half_width_px);
}

}  // namespace pellucida
