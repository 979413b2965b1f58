#include "BoundaryMotion.h"

#include <algorithm>
#include <cmath>

#include "ContourMath.h"

namespace pellucida {
namespace {

// Samples to the radius, px between them at least and at most; how many of them on both sides are held against what was
// read.
constexpr double kStepsOfRadius = 160.0, kFinestStep_px = 0.5, kCoarsestStep_px = 1.5;
constexpr int kTapsAside = 8, kMotionTaps = 2 * kTapsAside + 1;
constexpr int kMotionRounds = 4;
// px beyond what was foreseen: how far a boundary goes, how much it bends from one point to the next (second
// difference), and that of what a needle takes along; further than the last one none is followed.
constexpr double kUnforeseen_px = 1.0, kBent_px = 0.03, kTakenAlong_px = 0.1, kFarthestMove_px = 2.0;
// Of what is seen, the share that no motion explains where it is another picture; over so many points to both sides.
constexpr double kOther_ratio = 0.25;
constexpr Eigen::Index kOtherAside = 4;
// Beside a needle, px from its outline, its own edges are in the picture too.
constexpr double kBesideNeedle_px = 8.0;
constexpr double kLeastContrastKept = 0.25, kMostContrastKept = 4.0;

}  // namespace

void BoundaryMotion::sample(const FrameSampler& image, const Eigen::Matrix2Xd& points) {
  contour::outward_normals(points, normals_);
  const double to_both_sides_px = (kTapsAside + 2) * step_px_ + kFarthestMove_px;
  strip_.sample(image, points, normals_, to_both_sides_px, to_both_sides_px, step_px_);
}

void BoundaryMotion::set(const FrameSampler& image, const Eigen::Matrix2Xd& points) {
  rows_ = points.cols();
  const double radius_px = std::sqrt(std::abs(contour::signed_area(points)) / M_PI);
  step_px_ = std::clamp(radius_px / kStepsOfRadius, kFinestStep_px, kCoarsestStep_px);
  sample(image, points);
  look_.resize(kMotionTaps, rows_);
  slope_.resize(kMotionTaps, rows_);
  information_.resize(rows_);
  const auto per_px = static_cast<float>(0.5 / step_px_);
  for (int row = 0; row < rows_; ++row) {
    const auto at = [&](int k) { return static_cast<float>(strip_.value(row, strip_.column_of(k * step_px_))); };
    for (int k = -kTapsAside; k <= kTapsAside; ++k) {
      look_(k + kTapsAside, row) = at(k);
      slope_(k + kTapsAside, row) = per_px * (at(k + 1) - at(k - 1));
    }
    look_.col(row).array() -= look_.col(row).mean();
    slope_.col(row).array() -= slope_.col(row).mean();
    information_[row] = double{slope_.col(row).squaredNorm()};
  }
}

bool BoundaryMotion::find(const FrameSampler& image, const Eigen::Matrix2Xd& points, double noise,
                          const NeedleZone* needle) {
  if (rows_ == 0 || rows_ != points.cols()) return false;
  sample(image, points);
  place_needle(points, needle);
  if (!settle(noise * noise, needle && needle->touching) || !is_alike(noise * noise)) return false;
  solver_.inverse_diagonal(variance_px2_.data());
  return true;
}

void BoundaryMotion::place_needle(const Eigen::Matrix2Xd& points, const NeedleZone* needle) {
  places_.resize(rows_);
  for (Eigen::Index row = 0; row < rows_; ++row) {
    const auto is_within = [&](double margin_px) { return needle && needle->covers(points.col(row), margin_px); };
    places_[row] = is_within(kNeedleMargin)      ? Place::kCovered
                   : is_within(kBesideNeedle_px) ? Place::kBesideNeedle
                                                 : Place::kOpen;
  }
}

// Gauss-Newton; the slopes are those of what was read. False where it goes too far.
bool BoundaryMotion::settle(double pixel_variance, bool is_touched) {
  const auto n = static_cast<int>(rows_);
  shift_px_.setZero(n);
  next_px_.resize(n);
  variance_px2_.resize(n);
  misfit_.setZero(n);
  square_.setZero(n);
  seen_.resize(kMotionTaps);
  constexpr double stiff = 1.0 / (kBent_px * kBent_px), foreseen = 1.0 / (kUnforeseen_px * kUnforeseen_px);
  constexpr double taken = 1.0 / (kTakenAlong_px * kTakenAlong_px);
  double contrast = 1.0;
  for (int round = 0; round < kMotionRounds; ++round) {
    solver_.reset(n);
    double products = 0.0, squares = 0.0;
    for (int row = 0; row < n; ++row) {
      solver_.diagonal()[row] = foreseen + 6.0 * stiff;
      solver_.next()[row] = -4.0 * stiff;
      solver_.second_next()[row] = stiff;
      next_px_[row] = 0.0;
      if (places_[row] == Place::kCovered) {
        if (is_touched) solver_.diagonal()[row] += taken;
        continue;
      }
      const double first = strip_.column_of(shift_px_[row]) - kTapsAside;
      for (int k = 0; k < kMotionTaps; ++k) seen_[k] = static_cast<float>(strip_.value(row, first + k));
      seen_.array() -= seen_.mean();
      const auto look = look_.col(row);
      const auto slope = slope_.col(row);
      const double product = double{seen_.dot(look)}, square = double{look.squaredNorm()};
      products += product;
      squares += square;
      square_[row] = double{seen_.squaredNorm()};
      misfit_[row] = std::max(0.0, square_[row] - 2.0 * contrast * product + contrast * contrast * square);
      // The samples have moved too far by as much as their picture has changed, over its slope.
      const double change = contrast * (double{slope.dot(seen_)} - contrast * double{slope.dot(look)});
      const double information = contrast * contrast * information_[row];
      const double variance = pixel_variance + misfit_[row] / kMotionTaps;
      solver_.diagonal()[row] += information / variance;
      next_px_[row] = (information * shift_px_[row] - change) / variance;
    }
    if (!(squares > 0.0) || !solver_.factorize()) return false;
    contrast = std::clamp(products / squares, kLeastContrastKept, kMostContrastKept);
    solver_.solve(next_px_.data());
    shift_px_ = next_px_.cwiseMax(-kFarthestMove_px).cwiseMin(kFarthestMove_px);
  }
  return shift_px_.cwiseAbs().maxCoeff() < kFarthestMove_px;
}

// All round, but for beside the needle; what noise explains taken off.
bool BoundaryMotion::is_alike(double pixel_variance) const {
  const double by_noise = pixel_variance * kMotionTaps;
  for (Eigen::Index row = 0; row < rows_; ++row) {
    double misfit = 0.0, all = 0.0;
    for (Eigen::Index k = row - kOtherAside; k <= row + kOtherAside; ++k) {
      const Eigen::Index at = contour::wrap(k, rows_);
      if (places_[at] != Place::kOpen) continue;
      misfit += std::max(0.0, misfit_[at] - by_noise);
      all += square_[at] + by_noise;
    }
    if (misfit > kOther_ratio * all) return false;
  }
  return true;
}

}  // namespace pellucida
