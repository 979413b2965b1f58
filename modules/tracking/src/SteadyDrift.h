#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace pellucida {

/// Where a cell goes by itself, px: the straight line through its places in the last frames in which nothing touched
/// it, by least squares, gone on with frame by frame.
class SteadyDrift {
 public:
  void reset() { *this = {}; }
  /// A further frame, whatever it shows, into which the picture has jumped by `jump`.
  void advance(const Eigen::Vector2d& jump) {
    place_ += velocity_ + jump;
    ++unseen_frames_;
  }
  /// The place in this frame of a cell that nothing touches.
  void learn(const Eigen::Vector2d& place) {
    count_ = std::min(count_ + 1, kMemory);
    const double n = count_;
    const Eigen::Vector2d off = place - place_;
    // The line through n places, from the one through n - 1 of them.
    place_ = count_ == 1 ? place : Eigen::Vector2d(place_ + 2.0 * (2.0 * n - 1.0) / (n * (n + 1.0)) * off);
    if (count_ > 1) velocity_ += 6.0 / (n * (n + 1.0)) * off;
    unseen_frames_ = 0;
  }
  const Eigen::Vector2d& place() const noexcept { return place_; }
  /// Of `place`, in each direction: of the line, or, of few frames, of a cell that usually stays; and as a drift may
  /// change.
  double sigma_px() const noexcept {
    if (count_ == 0) return kUnknown_px;
    const double n = count_, ahead = unseen_frames_ + 0.5 * n;
    const double of_line = kPlaceSigma_px * std::sqrt(1.0 / n + 12.0 * ahead * ahead / (n * n * n));
    return std::hypot(std::min(of_line, std::hypot(kPlaceSigma_px, kUsual_px * ahead)), kChange_px * unseen_frames_);
  }

 private:
  static constexpr int kMemory = 60;
  // Standard deviations: of one frame's place; of how a drift changes and of what it usually is, per frame.
  static constexpr double kPlaceSigma_px = 0.15, kChange_px = 0.02, kUsual_px = 0.3, kUnknown_px = 1e3;
  Eigen::Vector2d place_ = Eigen::Vector2d::Zero(), velocity_ = Eigen::Vector2d::Zero();
  int count_ = 0, unseen_frames_ = 0;
};

}  // namespace pellucida
