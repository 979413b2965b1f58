#include "TipNetwork.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "NetworkInput.h"

namespace pellucida {
namespace {

// Samples along the needle and across, at most.
constexpr int kMostAlong = 96, kMostAcross = 64;
constexpr float kLeastWeight = 1e-12F;
constexpr int kAboutPeak = 4;  // samples about the peak that count as there
// A needle at least so wide, px, half its width, is looked at once more from nearer by; what is seen there counts where
// so much of the answer is in one place, within so many of the first look's samples.
constexpr double kWide_px = 4.0, kLeastFineShare = 0.5, kRefined_samples = 2.5;
// An answer so near the patch's edge, in samples, says no more than which way the tip lies: the next look is from so
// far beyond it, up to so many.
constexpr double kEdge_samples = 6.0, kJump_samples = 20.0;
constexpr int kLooks = 16;
// A speck or a body behind a needle may look like its end. So many looks ahead, so far apart, samples, say whether it
// goes on: a tip farther ahead than this is seen with this share of the answer, again from where it is within so many
// samples. Of 380 wide and tuning pictures (700010 to 708990) looks from 60 and 90 samples beyond a tip had a share of
// 0.7 elsewhere in 1 and 4 %, of 0.9 in 0.3 %.
constexpr int kLooksAhead = 3, kMostEnds = 4;
constexpr double kAhead_samples = 40.0, kFarther_samples = 8.0, kSureShare = 0.85, kSamePlace_samples = 4.0,
                 kAgain_samples = 25.0;
// Where a look shows nothing, the next one is from so far behind, samples: from there it shows which way the tip lies.
constexpr double kBehind_samples = 50.0;

}  // namespace

class TipNetwork::Impl {
 public:
  TipReading read(const FrameSampler& image, const NeedleAxis& axis, double half_width_px) {
    const double spacing_px = whole_.spacing_px(half_width_px);
    return refined(image, follow(image, axis, spacing_px), axis.direction, half_width_px);
  }

  TipReading find(const FrameSampler& image, const NeedleAxis& axis, double half_width_px,
                  const Eigen::Vector2d& last) {
    const double spacing_px = whole_.spacing_px(half_width_px);
    TipReading reading = follow(image, axis, spacing_px);
    if (reading.share < kLeastFineShare)
      reading = follow(image, {axis.at(kBehind_samples * spacing_px, 0.0), axis.direction}, spacing_px);
    NeedleAxis end{reading.share < kLeastFineShare ? axis.tip : reading.tip, axis.direction};
    for (int ends = 0; ends < kMostEnds; ++ends) {
      const std::optional<TipReading> farther = look_ahead(image, end, spacing_px, (last - end.tip).dot(end.direction));
      if (!farther) break;
      reading = *farther;
      end.tip = reading.tip;
    }
    return refined(image, reading, axis.direction, half_width_px);
  }

  TipReading read_quickly(const FrameSampler& image, const NeedleAxis& axis, double half_width_px) {
    const double spacing_px = quick_.spacing_px(half_width_px);
    TipReading reading = read(image, axis, spacing_px, quick_);
    if (quick_.is_at_edge(reading, axis, spacing_px)) reading.share = 0.0;
    return reading;
  }

 private:
  // As in training: samples along the needle and across, the supposed tip's place along; samples to the half width, and
  // the finest and coarsest they lie, px.
  struct Look {
    cv::dnn::Net network;
    int along, across, supposed;
    double half_width_samples, finest_px, coarsest_px;
    cv::Mat1f grey = cv::Mat1f(across, along);

    double middle() const { return 0.5 * (across - 1); }
    double spacing_px(double half_width_px) const {
      return std::clamp(half_width_px / half_width_samples, finest_px, coarsest_px);
    }
    bool is_at_edge(const TipReading& reading, const NeedleAxis& from, double spacing_px) const {
      const Eigen::Vector2d way = (reading.tip - from.tip) / spacing_px;
      const auto is_outside = [](double at, int count) { return at < kEdge_samples || at > count - 1 - kEdge_samples; };
      return is_outside(supposed + way.dot(from.direction), along) ||
             is_outside(middle() + way.dot(from.across()), across);
    }
  };

  // A tip that is seen beyond that end of the needle, and there again.
  std::optional<TipReading> look_ahead(const FrameSampler& image, const NeedleAxis& end, double spacing_px,
                                       double most_px) {
    for (int look = 1; look <= kLooksAhead && (look - 1) * kAhead_samples * spacing_px < most_px; ++look) {
      const NeedleAxis from{end.at(-look * kAhead_samples * spacing_px, 0.0), end.direction};
      if (!image.inside(from.tip, 1.0)) break;
      const TipReading seen = read(image, from, spacing_px, whole_);
      const double ahead_px = (seen.tip - end.tip).dot(end.direction);
      const bool is_farther = ahead_px > kFarther_samples * spacing_px && ahead_px < most_px;
      if (seen.share < kSureShare || !is_farther || whole_.is_at_edge(seen, from, spacing_px)) continue;
      const auto is_seen_from = [&](double behind_samples) {
        const NeedleAxis nearer{seen.tip - behind_samples * spacing_px * end.direction, end.direction};
        const TipReading again = read(image, nearer, spacing_px, whole_);
        return again.share > kSureShare && (again.tip - seen.tip).norm() < kSamePlace_samples * spacing_px;
      };
      if (is_seen_from(0.0) && is_seen_from(kAgain_samples)) return seen;
    }
    return std::nullopt;
  }

  TipReading refined(const FrameSampler& image, TipReading reading, const Eigen::Vector2d& direction,
                     double half_width_px) {
    const double spacing_px = whole_.spacing_px(half_width_px);
    if (half_width_px < kWide_px || reading.share < kLeastFineShare) return reading;
    const TipReading fine = read(image, {reading.tip, direction}, near_.spacing_px(half_width_px), near_);
    if (fine.share < kLeastFineShare || (fine.tip - reading.tip).norm() > kRefined_samples * spacing_px) return reading;
    reading.tip = fine.tip;
    reading.along_sigma_px = fine.along_sigma_px;
    return reading;
  }

  // The tip may lie beyond the patch: the next look is from where the last one pointed.
  TipReading follow(const FrameSampler& image, const NeedleAxis& axis, double spacing_px) {
    NeedleAxis from = axis;
    for (int look = 0; look < kLooks; ++look) {
      const TipReading reading = read(image, from, spacing_px, whole_);
      if (!whole_.is_at_edge(reading, from, spacing_px)) return reading;
      if (!image.inside(reading.tip, 1.0)) break;
      from.tip = reading.tip + kJump_samples * spacing_px * (reading.tip - from.tip).normalized();
    }
    return {axis.tip, whole_.along * spacing_px, 0.0};
  }

  static TipReading read(const FrameSampler& image, const NeedleAxis& axis, double spacing_px, Look& look) {
    for (int row = 0; row < look.across; ++row)
      sample_blurred(image, axis.at(look.supposed * spacing_px, (row - look.middle()) * spacing_px),
                     spacing_px * axis.direction, look.along, look.grey.ptr<float>(row));
    normalise(look.grey);
    const int sizes[] = {1, 2, look.across, look.along};
    cv::Mat patch(4, sizes, CV_32F);
    std::copy(look.grey.begin(), look.grey.end(), patch.ptr<float>(0, 0));
    std::fill_n(patch.ptr<float>(0, 1), look.across * look.along, spacing_code(spacing_px));
    look.network.setInput(patch);
    const cv::Mat out = look.network.forward();

    // The answer summed along and across, each with its own peak.
    using Weights = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMostAcross, kMostAlong>;
    const Eigen::Map<const Weights> logits(out.ptr<float>(0, 0), look.across, look.along);
    const Weights weights = (logits - logits.maxCoeff()).exp();
    const Eigen::Array<float, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMostAlong> along =
        weights.colwise().sum().max(kLeastWeight).log();
    const Eigen::Array<float, Eigen::Dynamic, 1, Eigen::ColMajor, kMostAcross, 1> across =
        weights.rowwise().sum().max(kLeastWeight).log();
    const PeakPlace u = peak_of(along.data(), look.along), v = peak_of(across.data(), look.across);
    TipReading reading;
    reading.tip = axis.at((look.supposed - u.mean) * spacing_px, (v.mean - look.middle()) * spacing_px);
    reading.along_sigma_px = spread_about(along.data(), look.along, u.mean) * spacing_px;
    const int row = static_cast<int>(std::lround(v.mean)), column = static_cast<int>(std::lround(u.mean));
    const int top = std::max(0, row - kAboutPeak), left = std::max(0, column - kAboutPeak);
    const int height = std::min(look.across, row + kAboutPeak + 1) - top,
              width = std::min(look.along, column + kAboutPeak + 1) - left;
    reading.share = double{weights.block(top, left, height, width).sum()} / double{weights.sum()};
    return reading;
  }

  Look whole_{read_network("tip"), 96, 64, 56, 5.0, 0.5, 3.0},
      near_{read_network("tip_fine"), 96, 64, 56, 12.0, 0.5, 1.5},
      quick_{read_network("tip_quick"), 64, 48, 40, 8.0, 0.5, 2.0};
};

TipNetwork::TipNetwork() : impl_(std::make_unique<Impl>()) {}
TipNetwork::~TipNetwork() = default;
TipNetwork::TipNetwork(TipNetwork&&) noexcept = default;
TipNetwork& TipNetwork::operator=(TipNetwork&&) noexcept = default;

TipReading TipNetwork::read(const FrameSampler& image, const NeedleAxis& axis, double half_width_px) {
  return impl_->read(image, axis, half_width_px);
}

TipReading TipNetwork::find(const FrameSampler& image, const NeedleAxis& axis, double half_width_px,
                            const Eigen::Vector2d& last) {
  return impl_->find(image, axis, half_width_px, last);
}

TipReading TipNetwork::read_quickly(const FrameSampler& image, const NeedleAxis& axis, double half_width_px) {
  return impl_->read_quickly(image, axis, half_width_px);
}

}  // namespace pellucida
