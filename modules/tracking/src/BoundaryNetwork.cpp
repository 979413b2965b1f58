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
// Normals of a reading near a place, and the spread of the others' places, of the radius.
constexpr int kNormalsNear = 32;
constexpr double kUnreadSpread = 0.02;
// Of the radius: the spread of a place that is half believed.
constexpr double kHalfBelieved = 0.02;

}  // namespace

Eigen::VectorXd confidence_of(const Eigen::VectorXd& sigma_px, double radius_px) {
  return (1.0 + (sigma_px / (kHalfBelieved * radius_px)).array().square()).inverse();
}

class BoundaryNetwork::Impl {
 public:
  BoundaryReading read(const FrameSampler& image, const Eigen::Matrix2Xd& outline) {
    return read(image, outline, nullptr, whole_);
  }

  BoundaryReading read_near(const FrameSampler& image, const Eigen::Matrix2Xd& outline, const Eigen::Vector2d& place) {
    return read(image, outline, &place, near_);
  }

 private:
  // The network for strips of so many normals: OpenCV lays its memory out anew for each other size.
  struct Strip {
    explicit Strip(int count) : normals(count), grey(count + 2 * kWrap, kColumns), network(read_network("boundary")) {}

    int normals;
    cv::Mat1f grey;
    cv::dnn::Net network;
  };

  // On as many normals as the strip has, about `place`; all where that is null.
  BoundaryReading read(const FrameSampler& image, const Eigen::Matrix2Xd& outline, const Eigen::Vector2d* place,
                       Strip& strip) {
    BoundaryReading reading;
    reading.points = contour::resample(outline, kNormals);
    contour::outward_normals(reading.points, reading.normals);
    Eigen::Index first = 0;
    if (place) {
      (reading.points.colwise() - *place).colwise().squaredNorm().minCoeff(&first);
      first -= strip.normals / 2;
    }
    const double radius_px = std::sqrt(std::abs(contour::signed_area(outline)) / M_PI);
    const double spacing_px = radius_px / kRadiusSamples;
    const auto normal_of = [&](int row) { return contour::wrap(first + row - kWrap, kNormals); };
    strip.network.setInput(strip_of(image, reading, spacing_px, normal_of, strip.grey));
    const cv::Mat out = strip.network.forward();
    const auto places = [&](int boundary) {
      BoundaryPlaces found{Eigen::VectorXd::Zero(kNormals),
                           Eigen::VectorXd::Constant(kNormals, kUnreadSpread * radius_px)};
      for (int row = kWrap; row < kWrap + strip.normals; ++row) {
        const PeakPlace peak = peak_of(out.ptr<float>(0, boundary, row), kColumns);
        found.offset_px[normal_of(row)] = (peak.mean - kZero) * spacing_px;
        found.sigma_px[normal_of(row)] = peak.spread * spacing_px;
      }
      return found;
    };
    reading.outer = places(0);
    reading.inner = places(1);
    return reading;
  }

  // Grey values on the normals, the normals' directions, and how far apart the samples are.
  template <typename NormalOf>
  static cv::Mat strip_of(const FrameSampler& image, const BoundaryReading& reading, double spacing_px,
                          const NormalOf& normal_of, cv::Mat1f& grey) {
    for (int row = 0; row < grey.rows; ++row) {
      const auto i = normal_of(row);
      const Eigen::Vector2d along = spacing_px * reading.normals.col(i);
      sample_blurred(image, reading.points.col(i) - kZero * along, along, kColumns, grey.ptr<float>(row));
    }
    normalise(grey);
    const int sizes[] = {1, 4, grey.rows, kColumns};
    cv::Mat strip(4, sizes, CV_32F);
    for (int row = 0; row < grey.rows; ++row) {
      const Eigen::Vector2d normal = reading.normals.col(normal_of(row));
      std::copy_n(grey.ptr<float>(row), kColumns, strip.ptr<float>(0, 0, row));
      for (const int axis : {0, 1})
        std::fill_n(strip.ptr<float>(0, 1 + axis, row), kColumns, static_cast<float>(normal[axis]));
      std::fill_n(strip.ptr<float>(0, 3, row), kColumns, spacing_code(spacing_px));
    }
    return strip;
  }

  Strip whole_{kNormals}, near_{kNormalsNear};
};

BoundaryNetwork::BoundaryNetwork() : impl_(std::make_unique<Impl>()) {}
BoundaryNetwork::~BoundaryNetwork() = default;
BoundaryNetwork::BoundaryNetwork(BoundaryNetwork&&) noexcept = default;
BoundaryNetwork& BoundaryNetwork::operator=(BoundaryNetwork&&) noexcept = default;

BoundaryReading BoundaryNetwork::read(const FrameSampler& image, const Eigen::Matrix2Xd& outline) {
  return impl_->read(image, outline);
}

BoundaryReading BoundaryNetwork::read_near(const FrameSampler& image, const Eigen::Matrix2Xd& outline,
                                           const Eigen::Vector2d& place) {
  return impl_->read_near(image, outline, place);
}

}  // namespace pellucida
