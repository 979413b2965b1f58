#include "TipFollower.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

// Looked at on tuning films from 303001 and validation films from 54929 and 55305. Frames at most
// between two that the large networks read; readings of both in a row before the small one goes on.
constexpr int kMostBetween = 3, kLeastComparisons = 3;
// The small network counts with this share of its answer in one place at least, and of what it had there with the
// large ones; and so near to them, px and in half widths.
constexpr double kLeastShare = 0.3, kKeptShare = 0.75, kAlike_px = 3.0, kAlikeHalfWidths = 0.5;
// The large ones' answer has this share in one place at least, for the small one to go on with.
constexpr double kSureShare = 0.7;
// So near to where it is due, px and in half widths.
constexpr double kDue_px = 2.0, kDueHalfWidths = 0.2;
// What a comparison adds to the mean.
constexpr double kNewShare = 0.5;

}  // namespace

TipReading TipFollower::read(TipNetwork& network, const FrameSampler& image, const NeedleAxis& axis,
                             double half_width_px, bool may_be_quick) {
  TipReading reading;
  if (may_be_quick && comparisons_ >= kLeastComparisons && frames_ < kMostBetween &&
      go_on(network, image, axis, half_width_px, reading)) {
    ++frames_;
    return reading;
  }
  read_ = network.read(image, axis, half_width_px);
  frames_ = 0;
  const bool is_sure = read_.share >= kSureShare && is_due(read_, axis, half_width_px);
  if (!may_be_quick || !is_sure || !compare(network, image, {read_.tip, axis.direction}, half_width_px))
    comparisons_ = 0;
  return read_;
}

bool TipFollower::is_due(const TipReading& reading, const NeedleAxis& axis, double half_width_px) {
  return (reading.tip - axis.tip).norm() < std::max(kDue_px, kDueHalfWidths * half_width_px);
}

bool TipFollower::go_on(TipNetwork& network, const FrameSampler& image, const NeedleAxis& axis, double half_width_px,
                        TipReading& reading) const {
  reading = network.read_quickly(image, axis, half_width_px);
  if (reading.share < kKeptShare * share_) return false;
  reading.tip += apart_px_.x() * axis.direction + apart_px_.y() * axis.across();
  reading.share = read_.share;
  reading.along_sigma_px = read_.along_sigma_px;
  return is_due(reading, axis, half_width_px);
}

// `axis` ends where the large networks have the tip.
bool TipFollower::compare(TipNetwork& network, const FrameSampler& image, const NeedleAxis& axis,
                          double half_width_px) {
  const TipReading quick = network.read_quickly(image, axis, half_width_px);
  const Eigen::Vector2d apart = axis.tip - quick.tip;
  if (quick.share < kLeastShare || apart.norm() > std::max(kAlike_px, kAlikeHalfWidths * half_width_px)) return false;
  const Eigen::Vector2d apart_px(apart.dot(axis.direction), apart.dot(axis.across()));
  apart_px_ += std::max(kNewShare, 1.0 / (comparisons_ + 1)) * (apart_px - apart_px_);
  share_ = quick.share;
  ++comparisons_;
  return true;
}

}  // namespace pellucida
