#include "PunctureNetwork.h"

#include <algorithm>
#include <cmath>

#include "NetworkInput.h"

namespace pellucida {
namespace {

// As in training: samples along the needle and across, the tip's place along; samples to the tip's depth, and the
// finest and coarsest they lie, px; how far within the resting outline a sample is shown to lie, of the tip's depth, at
// most; the places of the answer.
constexpr int kPatchSize = 64, kPatchTip = 40;
constexpr double kDepthSamples = 16.0, kFinestPatch_px = 0.35, kCoarsestPatch_px = 4.0;
constexpr double kMostWithin = 2.0;
constexpr int kShares = 24;
constexpr double kLeastShare = 0.0, kMostShare = 1.15;

}  // namespace

class PunctureNetwork::Impl {
 public:
  double read(const FrameSampler& image, const NeedleAxis& axis, double depth_px, const Eigen::Vector2d& center) {
    const double spacing_px = std::clamp(depth_px / kDepthSamples, kFinestPatch_px, kCoarsestPatch_px);
    const double rest_px = (axis.at(depth_px, 0.0) - center).norm();
    float* within = patch_.ptr<float>(0, 2);
    for (int row = 0; row < kPatchSize; ++row) {
      const Eigen::Vector2d from = axis.at(kPatchTip * spacing_px, (row - 0.5 * (kPatchSize - 1)) * spacing_px);
      const Eigen::Vector2d step = spacing_px * axis.direction;
      sample_blurred(image, from, step, kPatchSize, grey_.ptr<float>(row));
      for (int column = 0; column < kPatchSize; ++column) {
        const double inside_px = rest_px - (from + column * step - center).norm();
        *within++ = static_cast<float>(std::clamp(inside_px / depth_px, -kMostWithin, kMostWithin));
      }
    }
    normalise(grey_);
    std::copy(grey_.begin(), grey_.end(), patch_.ptr<float>(0, 0));
    std::fill_n(patch_.ptr<float>(0, 1), kPatchSize * kPatchSize, spacing_code(spacing_px));
    network_.setInput(patch_);
    const cv::Mat out = network_.forward();

    const Eigen::Map<const Eigen::Array<float, kShares, 1>> logits(out.ptr<float>());
    const Eigen::Array<float, kShares, 1> weights = (logits - logits.maxCoeff()).exp();
    double through = 0.0;
    for (int k = 0; k < kShares; ++k) {
      const double share = kLeastShare + (kMostShare - kLeastShare) * k / (kShares - 1);
      if (share < kLeastPushed_ratio) through += double{weights[k]};
    }
    return through / double{weights.sum()};
  }

 private:
  cv::dnn::Net network_ = read_network("puncture");
  cv::Mat1f grey_ = cv::Mat1f(kPatchSize, kPatchSize);
  const int sizes_[4] = {1, 3, kPatchSize, kPatchSize};
  cv::Mat patch_ = cv::Mat(4, sizes_, CV_32F);
};

PunctureNetwork::PunctureNetwork() : impl_(std::make_unique<Impl>()) {}
PunctureNetwork::~PunctureNetwork() = default;
PunctureNetwork::PunctureNetwork(PunctureNetwork&&) noexcept = default;
PunctureNetwork& PunctureNetwork::operator=(PunctureNetwork&&) noexcept = default;

double PunctureNetwork::read(const FrameSampler& image, const NeedleAxis& axis, double depth_px,
                             const Eigen::Vector2d& center) {
  return impl_->read(image, axis, depth_px, center);
}

}  // namespace pellucida
