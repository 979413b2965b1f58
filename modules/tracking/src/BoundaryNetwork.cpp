#include "BoundaryNetwork.h"

#include <algorithm>
#include <cmath>

#include "ContourMath.h"
#include "NetworkInput.h"

namespace pellucida {
namespace {

// As in training: normals, those repeated at both ends, samples of a normal, the outline's place among them, samples to
// the outline's radius.
constexpr int kNormals = 128, kWrap = 16, kColumns = 96, kZero = 58;
constexpr double kRadiusSamples = 160.0;
// Of the radius: the spread of a place that is half believed.
constexpr double kHalfBelieved = 0.02;

}  // namespace

Eigen::VectorXd confidence_of(const Eigen::VectorXd& sigma_px, double radius_px) {
  return (1.0 + (sigma_px / (kHalfBelieved * radius_px)).array().square()).inverse();
}

class BoundaryNetwork::Impl {
 public:
  BoundaryReading read(const FrameSampler& image, const Eigen::Matrix2Xd& outline) {
    BoundaryReading reading;
    reading.points = contour::resample(outline, kNormals);
    contour::outward_normals(reading.points, reading.normals);
    const double spacing_px = std::sqrt(std::abs(contour::signed_area(outline)) / M_PI) / kRadiusSamples;
    network_.setInput(strip_of(image, reading, spacing_px));
    const cv::Mat out = network_.forward();
    const auto places = [&](int boundary) {
      BoundaryPlaces found{Eigen::VectorXd(kNormals), Eigen::VectorXd(kNormals)};
      for (int i = 0; i < kNormals; ++i) {
        const PeakPlace peak = peak_of(out.ptr<float>(0, boundary, kWrap + i), kColumns);
        found.offset_px[i] = (peak.mean - kZero) * spacing_px;
        found.sigma_px[i] = peak.spread * spacing_px;
      }
      return found;
    };
    reading.outer = places(0);
    reading.inner = places(1);
    return reading;
  }

 private:
  // Grey values on the normals, the normals' directions, and how far apart the samples are.
  cv::Mat strip_of(const FrameSampler& image, const BoundaryReading& reading, double spacing_px) {
    const auto normal_of = [](int row) { return contour::wrap(row - kWrap, kNormals); };
    for (int row = 0; row < grey_.rows; ++row) {
      const auto i = normal_of(row);
      const Eigen::Vector2d along = spacing_px * reading.normals.col(i);
      sample_blurred(image, reading.points.col(i) - kZero * along, along, kColumns, grey_.ptr<float>(row));
    }
    normalise(grey_);
    const int sizes[] = {1, 4, grey_.rows, kColumns};
    cv::Mat strip(4, sizes, CV_32F);
    for (int row = 0; row < grey_.rows; ++row) {
      const Eigen::Vector2d normal = reading.normals.col(normal_of(row));
      std::copy_n(grey_.ptr<float>(row), kColumns, strip.ptr<float>(0, 0, row));
      for (const int axis : {0, 1})
        std::fill_n(strip.ptr<float>(0, 1 + axis, row), kColumns, static_cast<float>(normal[axis]));
      std::fill_n(strip.ptr<float>(0, 3, row), kColumns, spacing_code(spacing_px));
    }
    return strip;
  }

  cv::dnn::Net network_ = read_network("boundary");
  cv::Mat1f grey_ = cv::Mat1f(kNormals + 2 * kWrap, kColumns);
};

BoundaryNetwork::BoundaryNetwork() : impl_(std::make_unique<Impl>()) {}
BoundaryNetwork::~BoundaryNetwork() = default;
BoundaryNetwork::BoundaryNetwork(BoundaryNetwork&&) noexcept = default;
BoundaryNetwork& BoundaryNetwork::operator=(BoundaryNetwork&&) noexcept = default;

BoundaryReading BoundaryNetwork::read(const FrameSampler& image, const Eigen::Matrix2Xd& outline) {
  return impl_->read(image, outline);
}

}  // namespace pellucida
