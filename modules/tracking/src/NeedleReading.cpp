// The needle's tip by a network: beside the followed shaft, or by itself where no shaft can be followed.
#include <algorithm>
#include <cmath>
#include <utility>

#include "NeedleTracker.h"

namespace pellucida {
namespace {

// Of the image's longer side: how far behind the tip the width is taken that a patch for the network is scaled by.
// Least share of its answer in one place; px from where it was read that a tip is read again from there.
constexpr double kWidthBehind = 0.05, kLeastTipShare = 0.5, kReadAgain_px = 3.0;
// A needle known by its tip alone: of its half width further back, that of its tip; px, its edges' blur; of the last
// motion, what it goes on with.
constexpr double kTipOfWidth = 0.5, kReadBlur_px = 1.0, kGoesOn = 0.7;

// Lines may run inside the needle: of its width as the scene shows it, at least and at most that at the tip's patch.
constexpr double kLeastOfScene = 0.6, kMostOfScene = 1.3;

// Nearer than this, or than so many half widths of the tip, both have it in the same place: on 156 first frames of
// tuning films (seeds 63001 to 63090) a tip was read within 2 px of where it was.
constexpr double kSameRead_px = 3.0, kSameReadHalfWidths = 0.3;

// Along the needle, so many half widths of the tip: networks may read the end of the lumen for that of the needle,
// where edges show the end plainly.
constexpr double kRimHalfWidths = 0.6;

// In contact: a tip read so far further back, px and in standard deviations, than the shaft has gone has sprung back
// with the membrane; so many readings in a row of that kind, and it is there.
constexpr double kSprung_px = 5.0, kSprungSigmas = 3.0;
constexpr int kSprungReadings = 4;
// Likewise of a tip read where it was not sent.
constexpr int kUncommandedReadings = 12;
// A bevel's tip lies so far beside the middle of the needle's end, px and in half widths of it; and no further.
constexpr double kBeside_px = 2.5, kBesideHalfWidths = 0.35, kMostBesideHalfWidths = 1.4;

// In contact: a tip read so far across the needle, px and in half widths, from where its shaft and the frame before
// have it, is another corner of its end; a needle is rigid. Looked at on films by path (relief06 of seed 737373,
// phase01 of 757575).
constexpr double kAcross_px = 4.0, kAcrossHalfWidths = 0.5;

// A tip known by readings alone that leaps by so much, px and in half widths, from where it is due, in frames once it
// has been followed for some: so many in a row, and it is there. What the leap adds to its standard deviation.
constexpr double kLeap_px = 5.0, kLeapHalfWidths = 1.0, kLeapSigma = 0.5;
constexpr int kLeaps = 2, kSettled_frames = 3;
// So far in a frame, px, what lines follow may have run away along the needle: no needle leaps so far, and the reading
// where it was before counts if it has this share of the other's sureness. Looked at on validation film 54982.
constexpr double kRunAway_px = 10.0, kAsSure = 0.8;
// Readings beside a shaft whose place is known: so many standard deviations apart, the tip is read elsewhere; so many
// in a row while nothing is touched, and the shaft is not what was learnt. What a reading's standard deviation is times
// in a dimple.
constexpr double kMisreadSigmas = 3.0, kCoveredSigma = 1.5;
constexpr int kMostMisreadings = 6;
constexpr double kRests_px = 1.0;  // a frame: a needle slower than this does not draw back
// So many readings of a tip's width say what there is to be said; none is surer than this, nor are all together. Where
// the edges followed differ from it by less than this, or than its standard deviation, they are the outline.
constexpr int kMostWidthReadings = 12;
constexpr double kSurestWidth = 0.08, kSameWidth = 0.12;
// Even lines are drawn where the edges are, however a network takes their look: how uneven they may be, and how many
// standard deviations away it may read the width. Of plain drawings of tuning (seeds 302001 to 302240) 92 of 100 are as
// even, their lines right to 0.05; of looks of the optical model 5, with the lumen's lines 1 to 2 away from the width.
constexpr double kEvenLines = 0.15, kEvenLinesSigmas = 3.0;
// Two lines blurred into each other are read nearer together than they are: a narrow tip's half width, px, is the
// hypotenuse of what is read and of this (the same drawings).
constexpr double kLinesBlur_px = 0.35;

}  // namespace

bool NeedleTracker::is_even() const {
  return !is_read() && model_.look.unevenness() < kEvenLines;
}

double NeedleTracker::width_behind(const FrameSampler& image) const {
  const double by_lines_px = model_.cone.half_width(kWidthBehind * std::max(image.width, image.height));
  if (!(scene_half_width_ > 0.0)) return by_lines_px;
  return std::clamp(by_lines_px, kLeastOfScene * scene_half_width_, kMostOfScene * scene_half_width_);
}

std::optional<Eigen::Vector2d> NeedleTracker::tip_read(TipNetwork& network, const FrameSampler& image) const {
  if (!valid_ || is_read()) return std::nullopt;
  const TipReading seen = network.read(image, axis_, width_behind(image));
  return seen.share < kLeastTipShare ? std::nullopt : std::optional(seen.tip);
}

bool NeedleTracker::is_where_read(TipNetwork& network, const FrameSampler& image) const {
  const std::optional<Eigen::Vector2d> read = tip_read(network, image);
  if (!read) return true;
  const Eigen::Vector2d off = *read - tip();
  const double same_px = std::max(kSameRead_px, kSameReadHalfWidths * now_.tip_half_width);
  if (off.norm() < same_px) return true;
  const bool is_rim = std::abs(off.dot(axis_.direction)) < kRimHalfWidths * now_.tip_half_width;
  return is_rim && is_end_plain() && std::abs(off.dot(axis_.across())) < same_px;
}

// Read where it is expected, or where that leads; `share` becomes 1 where what was followed has run away.
std::optional<TipReading> NeedleTracker::best_reading(TipNetwork& network, const FrameSampler& image, bool is_quick,
                                                      double& share) {
  const double half_width = width_behind(image);
  const double went_px = (axis_.tip - axis_before_.tip).dot(axis_.direction);
  const bool has_leapt = std::abs(went_px) > std::max(kRunAway_px, kLeapHalfWidths * half_width);
  TipReading seen = tip_follower_.read(network, image, {tip(), axis_.direction}, half_width, is_quick && !has_leapt);
  if (seen.share < kLeastTipShare || has_leapt) {
    // What was followed may have run away: there where it was before?
    NeedleAxis earlier = axis_;
    earlier.tip -= went_px * axis_.direction;
    const TipReading there = network.read(image, earlier, half_width);
    if (there.share >= std::max(kLeastTipShare, kAsSure * seen.share)) {
      share = 1.0;
      return there;
    }
    if (seen.share < kLeastTipShare) return std::nullopt;
  }
  if ((seen.tip - tip()).norm() > kReadAgain_px) {
    NeedleAxis nearer = axis_;
    nearer.tip += (seen.tip - axis_.tip).dot(axis_.direction) * axis_.direction;
    const TipReading again = network.read(image, nearer, half_width);
    if (again.share > seen.share) seen = again;
  }
  return seen;
}

void NeedleTracker::take(const TipReading& seen, double share) {
  const Eigen::Vector2d off = seen.tip - tip();
  const double way = share * off.dot(axis_.direction);
  axis_.tip += way * axis_.direction;
  beside_ += share * off.dot(axis_.across());
  motion_ += way * axis_.direction;
  // What had run ahead of the reading had been taken for speed.
  const double went = motion_.dot(axis_.direction);
  if (std::abs(way) > kSprung_px && std::abs(went) < std::abs(speed_)) speed_ = went;
  end_bias_ += way;
  model_.cone.move(way, 0.0);
  covariance_(0, 0) = seen.along_sigma_px * seen.along_sigma_px;
  covariance_(0, 1) = covariance_(1, 0) = 0.0;
  prepare();
  now_.tip = tip();
  now_.tip_sigma = seen.along_sigma_px;
  now_.is_disputed = false;
  now_.confidence = confidence();
  now_.tip_half_width = model_.cone.tip_radius();
  if (is_by_shaft_) now_.evidence = now_.evidence | kKnownCone;
  take_width();
}

// A reading held against where the shaft has the tip, and the shaft learnt where nothing is touched. A rigid needle
// ends where its shaft says: what is read far from there is another end, and a reading that is not sure is none.
TipReading NeedleTracker::beside_shaft(const FrameSampler& image, const TipReading& read, const NeedleCue& cue) {
  const Eigen::Vector2d aside = beside_ * axis_.across(), before = axis_before_.tip + cue.scene_jump_px + aside;
  NeedleAxis due{due_ + aside, axis_.direction};
  std::optional<ShaftMotion::Place> place = shaft_motion_.find(image, due, cue.covered_px);
  if (!place && (due.tip - before).norm() > kRests_px) {
    // What was followed may have run away.
    due.tip = before;
    place = shaft_motion_.find(image, due, cue.covered_px);
  }
  const bool is_sure = read.share >= kLeastTipShare;
  TipReading seen = read;
  is_by_shaft_ = false;
  if (place && shaft_motion_.is_known()) {
    const Eigen::Vector2d by_shaft = due.tip + place->ahead_px * due.direction + place->across_px * due.across();
    const double apart_px = (read.tip - by_shaft).dot(due.direction);
    const double read_px = (cue.is_free ? 1.0 : kCoveredSigma) * read.along_sigma_px, shaft_px = place->sigma_px;
    const bool is_apart = is_sure && std::abs(apart_px) > kMisreadSigmas * std::hypot(read_px, shaft_px);
    if (is_apart && cue.is_free) {
      // In the clear readings are right.
      if (++misreadings_ < kMostMisreadings) return read;
      misreadings_ = 0;
      shaft_motion_ = {};
      return read;
    }
    misreadings_ = 0;
    is_by_shaft_ = true;
    if (is_apart || !is_sure) {
      seen.tip = by_shaft;
      seen.along_sigma_px = shaft_px;
      seen.share = std::max(read.share, kLeastTipShare);
    } else {
      seen.tip -= read_px * read_px / (read_px * read_px + shaft_px * shaft_px) * apart_px * due.direction;
      seen.along_sigma_px = read_px * shaft_px / std::hypot(read_px, shaft_px);
    }
  }
  if (cue.is_free && is_sure)
    shaft_motion_.learn(image, due, place, read.tip, read.along_sigma_px,
                        is_read() ? read_half_width_ : width_behind(image));
  return seen;
}

bool NeedleTracker::read_tip(TipNetwork& network, const FrameSampler& image, double share, const NeedleCue* cue) {
  if (!valid_) return false;
  std::optional<TipReading> seen = best_reading(network, image, cue && cue->is_quick, share);
  if (!seen) return false;
  if (cue) seen = beside_shaft(image, *seen, *cue);
  sprung_readings_ = 0;
  take(*seen, share);
  return true;
}

bool NeedleTracker::find_tip(TipNetwork& network, const FrameSampler& image, const Eigen::Vector2d& last) {
  if (!valid_) return false;
  const TipReading seen = network.find(image, axis_, width_behind(image), last);
  if (seen.share < kLeastTipShare) return false;
  sprung_readings_ = 0;
  take(seen, 1.0);
  return true;
}

double NeedleTracker::leap_across_px(const Eigen::Vector2d& read, const Eigen::Vector2d& due) const {
  // One that is in doubt may be elsewhere.
  if (!is_clear()) return 0.0;
  const Eigen::Vector2d before = axis_before_.tip + beside_ * axis_before_.across();
  const double off_px = (read - due).dot(axis_.across()), since_px = (read - before).dot(axis_.across());
  const double most_px = std::max(kAcross_px, kAcrossHalfWidths * now_.tip_half_width);
  return std::min(std::abs(off_px), std::abs(since_px)) > most_px ? off_px : 0.0;
}

bool NeedleTracker::read_tip_in_contact(TipNetwork& network, const FrameSampler& image, const NeedleCue& cue,
                                        const CommandedMotion* command) {
  doubted_.reset();
  if (!valid_) return false;
  double share = 1.0;
  std::optional<TipReading> seen = best_reading(network, image, cue.is_quick, share);
  seen = beside_shaft(image, seen.value_or(TipReading{}), cue);
  if (seen->share < kLeastTipShare) return false;
  seen->tip -= leap_across_px(seen->tip, tip()) * axis_.across();
  const double back_px = (tip() - seen->tip).dot(axis_.direction);
  const double went_back_px = std::max(0.0, (axis_before_.tip - axis_.tip).dot(axis_.direction));
  const double sigma_px = std::hypot(now_.tip_sigma, seen->along_sigma_px);
  const bool is_against = command && command->contradicts(seen->tip, seen->along_sigma_px);
  // Read where the needle was due, it has not: what was followed has run ahead.
  const bool is_due = (due_ - seen->tip).dot(axis_.direction) < kSprung_px;
  const bool has_sprung = !is_due && back_px > std::max(kSprung_px, kSprungSigmas * sigma_px) + went_back_px;
  if ((is_against || has_sprung) && ++sprung_readings_ < (is_against ? kUncommandedReadings : kSprungReadings)) {
    if (!is_against) doubted_ = *seen;
    return false;
  }
  sprung_readings_ = 0;
  take(*seen, share);
  return true;
}

void NeedleTracker::believe_reading() {
  if (!valid_ || !doubted_) return;
  sprung_readings_ = 0;
  take(*doubted_, 1.0);
  doubted_.reset();
}

bool NeedleTracker::take_bevel(TipNetwork& network, const FrameSampler& image) {
  if (!valid_ || is_read()) return false;
  double share = 1.0;
  const std::optional<TipReading> seen = best_reading(network, image, false, share);
  if (!seen) return false;
  const Eigen::Vector2d off = seen->tip - tip();
  const double half_width = now_.tip_half_width, across = std::abs(off.dot(axis_.across()));
  const double beside = std::abs(beside_ + off.dot(axis_.across())), along = std::abs(off.dot(axis_.direction));
  const bool is_at_side = across > std::max(kBeside_px, kBesideHalfWidths * half_width) &&
                          beside < kMostBesideHalfWidths * half_width && along < across + kBeside_px;
  if (!is_at_side) return false;
  take(*seen, share);
  return true;
}

void NeedleTracker::read_width(TipWidthNetwork& network, const FrameSampler& image) {
  if (!valid_ || width_readings_ >= kMostWidthReadings) return;
  const TipWidthReading seen =
      network.read(image, {tip(), axis_.direction}, is_read() ? read_half_width_ : width_behind(image));
  const double information = 1.0 / (seen.sigma * seen.sigma + kSurestWidth * kSurestWidth);
  width_information_ += information;
  width_log_sum_ += information * std::log(seen.radius_px);
  ++width_readings_;
  take_width();
}

void NeedleTracker::take_width() {
  const double by_lines_px =
      is_read() ? now_.tip_half_width : std::hypot(model_.cone.fitted_tip_radius(), kLinesBlur_px);
  now_.tip_radius = by_lines_px;
  now_.tip_radius_sigma = 0.0;
  if (width_readings_ == 0) return;
  const double log_px = width_log_sum_ / width_information_, sigma = std::sqrt(width_readings_ / width_information_);
  const double apart = std::abs(std::log(by_lines_px) - log_px);
  if (!is_read() && apart < std::max(kSameWidth, sigma)) return;
  if (is_even() && apart < kEvenLinesSigmas * sigma) return;
  now_.tip_radius = std::exp(log_px);
  now_.tip_radius_sigma = sigma;
}

bool NeedleTracker::start_read(TipNetwork& network, const FrameSampler& image, const NeedleAxis& axis,
                               double half_width_px) {
  reset();
  read_half_width_ = half_width_px;
  axis_ = axis_before_ = axis;
  valid_ = true;
  for (int round = 0; round < 2 && valid_; ++round) valid_ = follow_read(network, image, {});
  return valid_;
}

bool NeedleTracker::go_on_read(TipNetwork& network, const FrameSampler& image) {
  if (!valid_ || is_read()) return false;
  NeedleTracker read = *this;
  read.read_half_width_ = width_behind(image);
  read.motion_.setZero();
  read.axis_.tip = tip();
  read.beside_ = 0.0;
  read.is_across_known_ = true;
  if (!read.follow_read(network, image, {})) return false;
  *this = std::move(read);
  return true;
}

bool NeedleTracker::follow_read(TipNetwork& network, const FrameSampler& image, const NeedleCue& cue) {
  learn_confidence();
  axis_before_ = axis_;
  const auto sent = cue.command ? cue.command->due(axis_.tip + cue.scene_jump_px) : std::nullopt;
  const Eigen::Vector2d going = sent ? Eigen::Vector2d(sent->ahead_px * axis_.direction) : kGoesOn * motion_;
  const Eigen::Vector2d expected = going + cue.scene_jump_px;
  TipReading seen;
  due_ = axis_.tip + expected;
  for (const Eigen::Vector2d& from : {due_, axis_.tip}) {
    const TipReading there =
        tip_follower_.read(network, image, {from, axis_.direction}, read_half_width_, cue.is_quick);
    if (there.share > seen.share) seen = there;
    if (seen.share >= kLeastTipShare) break;
  }
  seen = beside_shaft(image, seen, cue);
  if (seen.share < kLeastTipShare) {
    now_.confidence *= 0.5;
    motion_.setZero();
    return false;
  }
  // A leap that no motion of late announces is believed when a second frame shows it.
  is_across_known_ = is_across_known_ || read_frames_ > kSettled_frames;
  if (!cue.in_the_clear && is_across_known_) seen.tip -= leap_across_px(seen.tip, due_) * axis_.across();
  const double leap_px = (seen.tip - due_).norm();
  const bool is_leap = leap_px > std::max(kLeap_px, kLeapHalfWidths * read_half_width_);
  leaps_ = is_leap ? leaps_ + 1 : 0;
  // In a dimple, one that leaps back while the needle does not draw back may be the membrane's, which has sprung back:
  // the needle is seen no worse.
  const bool may_have_sprung = cue.depth_px > kSprung_px && motion_.dot(axis_.direction) > -kRests_px &&
                               (due_ - seen.tip).dot(axis_.direction) > kSprung_px;
  if (is_leap && leaps_ < kLeaps && read_frames_ > kSettled_frames) {
    axis_.tip = due_;
    now_.tip = due_;
    now_.tip_sigma = std::max(now_.tip_sigma, kLeapSigma * leap_px);
    if (!may_have_sprung) now_.confidence *= 0.5;
    motion_ = expected - cue.scene_jump_px;
    return true;
  }
  ++read_frames_;
  axis_.tip = seen.tip;
  motion_ = axis_.tip - axis_before_.tip - cue.scene_jump_px;
  now_.tip = seen.tip;
  now_.direction = axis_.direction;
  now_.tip_half_width = kTipOfWidth * read_half_width_;
  take_width();
  now_.edge_blur = kReadBlur_px;
  now_.tip_sigma = seen.along_sigma_px;
  now_.confidence = seen.share;
  now_.evidence = kTipEnd;
  if (sent) now_.evidence = now_.evidence | kCommandedMotion;
  if (is_by_shaft_) now_.evidence = now_.evidence | kKnownCone;
  return true;
}

}  // namespace pellucida
