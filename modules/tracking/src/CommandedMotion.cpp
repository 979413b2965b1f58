#include "CommandedMotion.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

// Before anything is learnt, standard deviations: of scale and axes, as a share; of a drift, px a frame, beyond what
// the scene is seen to move.
constexpr double kGainSigma = 1.0, kDriftSigma_px = 0.1;
// How place, gain and drift wander, a frame; the place also by this share of a change of the command: a frame may show
// the needle half a frame earlier or later, and a gear with play swallows what turns it round.
constexpr double kPlaceWalk_px = 0.1, kGainWalk = 0.002, kDriftWalk_px = 0.005, kChangeWalk = 0.5;
// It goes where it is sent: after so many frames and so long a way, with a gain of so much at least, known to this
// share of itself, and surprises of at most so many times the variance expected.
constexpr int kLeastFrames = 5, kSettledFrames = 3;
constexpr double kLeastWay_px = 5.0, kLeastGain = 0.2, kGainKnown_ratio = 0.35, kMostExcess = 3.0;
// What a frame counts in that excess; a surprise counts as so many standard deviations at most.
constexpr double kNewest_ratio = 0.15, kMostSurprise = 3.0;
// A tip is misread from so far off on, px and in standard deviations, where it has itself gone by so much, likewise.
constexpr double kLeastOff_px = 2.0, kOffSigmas = 2.0, kLeastGone_px = 1.0, kGoneSigmas = 1.0;
constexpr int kMostMisread = 10;
// A command moves something from so much a frame on. How the most of late fades.
constexpr double kMoves_px = 0.05, kFade = 0.6;
// Of the cosine: a needle that points elsewhere is another. Of a tip's standard deviation.
constexpr double kSameDirection = 0.97, kLeastSigma_px = 0.1;

}  // namespace

void CommandedMotion::begin(const std::optional<Eigen::Vector2d>& commanded_px) {
  if (!commanded_px) has_place_ = false;
  const Eigen::Vector2d change = commanded_px.value_or(command_) - command_;
  command_ = commanded_px.value_or(Eigen::Vector2d::Zero());
  if (!has_place_) return;
  if (command_.norm() > kMoves_px) heading_ = command_.normalized();
  const Eigen::Vector2d gain = state_.segment<2>(1);
  const double along = gain.dot(command_);
  Eigen::Matrix4d transition = Eigen::Matrix4d::Identity();
  transition.row(0) << 1.0, command_.x(), command_.y(), 1.0;
  state_ = (transition * state_).eval();
  covariance_ = (transition * covariance_ * transition.transpose()).eval();
  covariance_(0, 0) += std::pow(kPlaceWalk_px, 2) + std::pow(kChangeWalk * gain.dot(change), 2);
  covariance_(1, 1) += kGainWalk * kGainWalk;
  covariance_(2, 2) += kGainWalk * kGainWalk;
  covariance_(3, 3) += kDriftWalk_px * kDriftWalk_px;
  way_px_ += std::abs(along);
  least_px_ += std::min(0.0, along) + state_[3];
  back_px_ = std::max(kFade * back_px_, -along);
}

void CommandedMotion::move_scene(const Eigen::Vector2d& way_px) {
  const double along = direction_.dot(way_px);
  state_[0] += along;
  least_px_ += along;
}

bool CommandedMotion::is_believed() const {
  if (!has_place_ || learnt_ < kLeastFrames || settled_ < kSettledFrames || way_px_ < kLeastWay_px ||
      excess_ > kMostExcess)
    return false;
  const double gain = std::abs(state_.segment<2>(1).dot(heading_));
  const double variance = heading_.dot(covariance_.block<2, 2>(1, 1) * heading_);
  return gain > kLeastGain && variance < std::pow(kGainKnown_ratio * gain, 2);
}

std::optional<CommandedMotion::Along> CommandedMotion::due(const Eigen::Vector2d& tip) const {
  if (!is_believed()) return std::nullopt;
  return Along{state_[0] - direction_.dot(tip), std::sqrt(covariance_(0, 0) * std::max(1.0, excess_))};
}

bool CommandedMotion::contradicts(const Eigen::Vector2d& tip, double sigma_px) const {
  const std::optional<Along> place = due(tip);
  if (!place || misread_ >= kMostMisread) return false;
  const double off_px = std::max(kLeastOff_px, kOffSigmas * std::hypot(place->sigma_px, sigma_px));
  const double gone_px = std::max(kLeastGone_px, kGoneSigmas * sigma_px);
  return place->ahead_px > off_px && direction_.dot(tip) < least_px_ - back_px_ - gone_px;
}

// Where it is begins anew; what was learnt of the commands stays while the needle points where it did.
void CommandedMotion::start(const Eigen::Vector2d& tip, const Eigen::Vector2d& direction, double sigma_px) {
  const bool is_same = learnt_ > 0 && direction.dot(direction_) > kSameDirection;
  if (!is_same) {
    *this = CommandedMotion();
    direction_ = direction;
    state_.segment<2>(1) = direction;
    covariance_.diagonal() << 0.0, kGainSigma * kGainSigma, kGainSigma * kGainSigma, kDriftSigma_px * kDriftSigma_px;
  }
  state_[0] = direction_.dot(tip);
  covariance_.row(0).setZero();
  covariance_.col(0).setZero();
  covariance_(0, 0) = sigma_px * sigma_px;
  settled_ = 0;
  has_place_ = true;
}

void CommandedMotion::learn(const Eigen::Vector2d& tip, const Eigen::Vector2d& direction, double sigma_px,
                            bool is_new) {
  const double sigma = std::max(sigma_px, kLeastSigma_px), variance = sigma * sigma;
  const double off = direction_.dot(tip) - state_[0];
  const double surprise = std::abs(off) / std::sqrt(covariance_(0, 0) + variance);
  // So far off it was found wrongly, or is there after all.
  const bool is_elsewhere = surprise > kMostSurprise && (settled_ < kSettledFrames || misread_ >= kMostMisread);
  if (!has_place_ || is_new || is_elsewhere || direction.dot(direction_) < kSameDirection) {
    start(tip, direction, sigma);
  } else {
    const double shrunk = std::min(1.0, kMostSurprise / std::max(surprise, kMostSurprise));
    excess_ += kNewest_ratio * (std::pow(std::min(surprise, kMostSurprise), 2) - excess_);
    const Eigen::Vector4d gain = covariance_.col(0) / (covariance_(0, 0) + variance / (shrunk * shrunk));
    state_ += gain * off;
    covariance_ -= gain * covariance_.row(0).eval();
    covariance_ = 0.5 * (covariance_ + covariance_.transpose().eval());
    ++learnt_;
    ++settled_;
  }
  least_px_ = direction_.dot(tip);
  misread_ = 0;
}

}  // namespace pellucida
