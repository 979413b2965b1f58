#include "ThicknessNetwork.h"

#include <algorithm>
#include <cmath>

#include "ContourMath.h"
#include "NetworkInput.h"

namespace pellucida {
namespace {

// As in training: normals, samples of a normal from the outside to the inside, the outline's place among them, samples
// to the supposed thickness, which is no less than this share of the radius; the places of the answer.
constexpr int kRingNormals = 96, kRingColumns = 64, kRingZero = 20;
constexpr double kThicknessSamples = 14.0, kNarrowest_ratio = 0.03;
constexpr int kLogs = 49;
constexpr double kLeastLog = -1.2, kMostLog = 1.2;
// Looks at most, and how far from the supposed thickness, in its logarithm, one is read again from there: training's
// pictures lie within it mostly.
constexpr int kMostLooks = 3;
constexpr double kNear_log = 0.15;

}  // namespace

class ThicknessNetwork::Impl {
 public:
  ThicknessReading read(const FrameSampler& image, const Eigen::Matrix2Xd& outline, double supposed_px) {
    points_ = contour::resample(outline, kRingNormals);
    contour::outward_normals(points_, normals_);
    const double radius_px = std::sqrt(std::abs(contour::signed_area(outline)) / M_PI);
    ThicknessReading seen{supposed_px, 0.0};
    for (int look = 0; look < kMostLooks; ++look) {
      const double from_px = std::max(seen.thickness_px, kNarrowest_ratio * radius_px);
      const LogRatio ratio = look_from(image, from_px, radius_px);
      seen = {from_px * std::exp(ratio.mean), ratio.sigma};
      if (std::abs(ratio.mean) < kNear_log) break;
    }
    return seen;
  }

 private:
  struct LogRatio {
    double mean = 0.0, sigma = 0.0;
  };

  LogRatio look_from(const FrameSampler& image, double supposed_px, double radius_px) {
    const double spacing_px = supposed_px / kThicknessSamples;
    for (int row = 0; row < kRingNormals; ++row) {
      const Eigen::Vector2d inwards = -spacing_px * normals_.col(row);
      sample_blurred(image, points_.col(row) - kRingZero * inwards, inwards, kRingColumns, grey_.ptr<float>(row));
    }
    normalise(grey_);
    std::copy(grey_.begin(), grey_.end(), ring_.ptr<float>(0, 0));
    for (int row = 0; row < kRingNormals; ++row)
      for (const int axis : {0, 1})
        std::fill_n(ring_.ptr<float>(0, 1 + axis, row), kRingColumns, static_cast<float>(normals_(axis, row)));
    std::fill_n(ring_.ptr<float>(0, 3), grey_.total(), spacing_code(spacing_px));
    std::fill_n(ring_.ptr<float>(0, 4), grey_.total(), curving_code(supposed_px, radius_px));
    network_.setInput(ring_);
    const cv::Mat out = network_.forward();

    const Eigen::Map<const Eigen::Array<float, kLogs, 1>> logits(out.ptr<float>());
    const Eigen::ArrayXd weights = (logits - logits.maxCoeff()).exp().cast<double>();
    const Eigen::ArrayXd places = Eigen::ArrayXd::LinSpaced(kLogs, kLeastLog, kMostLog);
    const double sum = weights.sum(), mean = (weights * places).sum() / sum;
    return {mean, std::sqrt((weights * (places - mean).square()).sum() / sum)};
  }

  // How thick a shell the zona is supposed to be.
  static float curving_code(double thickness_px, double radius_px) {
    return static_cast<float>(std::clamp(std::log2(thickness_px / radius_px) + 3.0, -3.0, 3.0) / 2.0);
  }

  cv::dnn::Net network_ = read_network("thickness");
  cv::Mat1f grey_ = cv::Mat1f(kRingNormals, kRingColumns);
  const int sizes_[4] = {1, 5, kRingNormals, kRingColumns};
  cv::Mat ring_ = cv::Mat(4, sizes_, CV_32F);
  Eigen::Matrix2Xd points_, normals_;
};

ThicknessNetwork::ThicknessNetwork() : impl_(std::make_unique<Impl>()) {}
ThicknessNetwork::~ThicknessNetwork() = default;
ThicknessNetwork::ThicknessNetwork(ThicknessNetwork&&) noexcept = default;
ThicknessNetwork& ThicknessNetwork::operator=(ThicknessNetwork&&) noexcept = default;

ThicknessReading ThicknessNetwork::read(const FrameSampler& image, const Eigen::Matrix2Xd& outline,
                                        double supposed_px) {
  return impl_->read(image, outline, supposed_px);
}

}  // namespace pellucida
