#include "BoundaryNetwork.h"

#include <algorithm>
#include <cmath>

#include "ContourMath.h"
#include "NetworkInput.h"

namespace pellucida {
namespace {

// As in training: normals, those repeated at both ends, samples of a normal, the outline's place among them, samples to
// the outline's radius.
constexpr int kNormals = 128, kWrap = 16, kRows = kNormals + 2 * kWrap, kColumns = 96, kZero = 58;
constexpr double kRadiusSamples = 160.0;
// Of the radius: the spread of a place that is half believed.
constexpr double kHalfBelieved = 0.02;

}  // namespace

Eigen::VectorXd confidence_of(const Eigen::VectorXd& sigma_px, double radius_px) {
  return (1.0 + (sigma_px / (kHalfBelieved * radius_px)).array().square()).inverse();
}

class BoundaryNetwork::Impl {
 public:
  Impl() : network_(read_network("boundary")), grey_(kRows, kColumns) {}

  BoundaryReading read(const FrameSampler& image, const Eigen::Matrix2Xd& outline) {
    BoundaryReading reading;
    reading.points = contour::resample(outline, kNormals);
    contour::outward_normals(reading.points, reading.normals);
    const double spacing_px = std::sqrt(std::abs(contour::signed_area(outline)) / M_PI) / kRadiusSamples;
    sample(image, reading, spacing_px);
    const int sizes[] = {1, 4, kRows, kColumns};
    cv::Mat strip(4, sizes, CV_32F);
    normalise(grey_);
    for (int plane = 0; plane < 4; ++plane) {
      for (int row = 0; row < kRows; ++row) {
        float* to = strip.ptr<float>(0, plane, row);
        const Eigen::Vector2d normal = reading.normals.col((row + kNormals - kWrap) % kNormals);
        if (plane == 0)
          std::copy_n(grey_.ptr<float>(row), kColumns, to);
        else
          std::fill_n(to, kColumns, plane == 3 ? spacing_code(spacing_px) : static_cast<float>(normal[plane - 1]));
      }
    }
    network_.setInput(strip);
    const cv::Mat out = network_.forward();
    const auto places = [&](int boundary) {
      BoundaryPlaces found{Eigen::VectorXd(kNormals), Eigen::VectorXd(kNormals)};
      for (int i = 0; i < kNormals; ++i) {
        const PeakPlace peak = peak_of(out.ptr<float>(0, boundary, i + kWrap), kColumns);
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
  void sample(const FrameSampler& image, const BoundaryReading& reading, double spacing_px) {
    for (int row = 0; row < kRows; ++row) {
      const int i = (row + kNormals - kWrap) % kNormals;
      const Eigen::Vector2d along = spacing_px * reading.normals.col(i);
      sample_blurred(image, reading.points.col(i) - kZero * along, along, kColumns, grey_.ptr<float>(row));
    }
  }

  cv::dnn::Net network_;
  cv::Mat1f grey_;
};

BoundaryNetwork::BoundaryNetwork() : impl_(std::make_unique<Impl>()) {}
BoundaryNetwork::~BoundaryNetwork() = default;
BoundaryNetwork::BoundaryNetwork(BoundaryNetwork&&) noexcept = default;
BoundaryNetwork& BoundaryNetwork::operator=(BoundaryNetwork&&) noexcept = default;

BoundaryReading BoundaryNetwork::read(const FrameSampler& image, const Eigen::Matrix2Xd& outline) {
  return impl_->read(image, outline);
}

}  // namespace pellucida
