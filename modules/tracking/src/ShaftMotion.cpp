#include "ShaftMotion.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

// Samples to the half width; px between them at least.
constexpr double kHalfWidthSamples = 6.0, kFinest_px = 0.8;
// Rounds of least squares; px: it has settled, the longest step of a round, and what no needle moves unforeseen.
constexpr int kRounds = 8;
constexpr double kSettled_px = 0.02, kLongestStep_px = 4.0, kFarthest_px = 8.0;
// Rows that show the shaft at least; frames that the mean reading reaches back.
constexpr float kLeastRows = 24.0F;
constexpr int kMostFrames = 20;
// Smoothing along the needle, three times over so many rows to both sides: its standard deviation in rows, of how many
// samples in a row each is as good as one, and the variance of a slope by noise of 1 in each.
constexpr int kSmoothed = 5;
constexpr double kSmoothed_rows = 5.48, kShared = 3.545 * kSmoothed_rows,
                 kSlopeNoise = 1.0 / (7.09 * kSmoothed_rows * kSmoothed_rows * kSmoothed_rows);
// Of what changes along the shaft, the part that noise may be for a place to be known.
constexpr double kMostNoise = 0.5;
// Of the usual likeness, what still is the shaft; contrast, of that learnt, likewise.
constexpr double kAlike = 0.6;
constexpr float kLeastContrast = 0.25F, kMostContrast = 4.0F;
// In standard deviations by what is left unexplained: how far off a place is, since light and halos that stay where
// they are are taken for a little of the needle's motion; px: a place less sure than this says nothing. In 108 films of
// tuning and wide families (303001, 307001, 311001, 312001 on) places strayed in contact by 1 to 2 of these, RMS, in
// the median film.
constexpr double kStray = 3.0, kVague_px = 2.0;
// Drift of the shaft against the readings, per px of way: beyond so many standard deviations of its own it counts.
constexpr double kSureDrift = 1.5, kLeastWay_px = 4.0;
// Of a reading's standard deviation: what readings of one film share, and their mean keeps.
constexpr double kSharedError = 0.5;

}  // namespace

void ShaftMotion::sample(const FrameSampler& image, const NeedleAxis& axis, Grid& grid, Rows& inside) const {
  const double side_px = 0.5 * (kColumns - 1) * step_px_;
  const Eigen::Vector2d across = step_px_ * axis.across();
  const Eigen::Array<float, 1, kColumns> slope = Eigen::Array<float, 1, kColumns>::LinSpaced(-1.0F, 1.0F);
  const float slopes = slope.square().sum();
  for (int row = 0; row < kRows; ++row) {
    const Eigen::Vector2d from = axis.at(row * step_px_, -side_px), to = axis.at(row * step_px_, side_px);
    inside[row] = image.inside(from, 1.0) && image.inside(to, 1.0) ? 1.0F : 0.0F;
    image.sample_line(from, across, kColumns, &grid(row, 0));
    auto line = grid.row(row);
    line -= line.mean();
    line -= (line * slope).sum() / slopes * slope;
  }
}

// Rows that are not seen have no part in it.
void ShaftMotion::smooth(const Grid& grid, const Rows& seen, Grid& out) {
  Grid now = grid.colwise() * seen;
  Rows weight = seen;
  for (int round = 0; round < 3; ++round) {
    Eigen::Array<float, 1, kColumns> sum = now.topRows(kSmoothed).colwise().sum();
    float total = weight.head(kSmoothed).sum();
    Rows weights;
    for (int row = 0; row < kRows; ++row) {
      if (row + kSmoothed < kRows) {
        sum += now.row(row + kSmoothed);
        total += weight[row + kSmoothed];
      }
      if (row > kSmoothed) {
        sum -= now.row(row - kSmoothed - 1);
        total -= weight[row - kSmoothed - 1];
      }
      out.row(row) = sum;
      weights[row] = total;
    }
    now = out;
    weight = weights;
  }
  out = now.colwise() / weight.max(1e-6F);
}

std::optional<ShaftMotion::Place> ShaftMotion::find(const FrameSampler& image, const NeedleAxis& due,
                                                    double covered_px) const {
  if (frames_ == 0) return std::nullopt;
  NeedleAxis axis = due;
  axis.tip -= ahead_px_ * due.direction;
  const NeedleAxis begun = axis;
  Grid raw, now, known, along = Grid::Zero(), across = Grid::Zero();
  Rows seen, usable = (count_ > 0.0F).cast<float>();
  usable.head(std::clamp(static_cast<int>(std::ceil(covered_px / step_px_)), 1, kRows)).setZero();
  sample(image, axis, raw, seen);
  usable *= seen;
  smooth(sum_.colwise() / count_.max(1.0F), usable, known);
  const auto per_px = static_cast<float>(0.5 / step_px_);
  // What changes as the grid moves ahead, and to the side.
  for (int row = 1; row + 1 < kRows; ++row) along.row(row) = per_px * (known.row(row - 1) - known.row(row + 1));
  for (int k = 1; k + 1 < kColumns; ++k) across.col(k) = per_px * (known.col(k + 1) - known.col(k - 1));
  const Rows far = Rows::LinSpaced(-1.0F, 1.0F), farther = far.square();
  // At both ends of what is in view slopes would be taken across the end.
  Rows inner = usable;
  inner[0] = inner[kRows - 1] = 0.0F;
  for (int row = 1; row + 1 < kRows; ++row) inner[row] *= usable[row - 1] * usable[row + 1];
  if (inner.sum() < kLeastRows) return std::nullopt;

  Eigen::Array3f contrast(1.0F, 0.0F, 0.0F);
  Place place;
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) sample(image, axis, raw, seen);
    smooth(raw, usable, now);
    const Rows contrasts = contrast[0] + contrast[1] * far + contrast[2] * farther;
    const Grid left = now - known.colwise() * contrasts;
    const Rows misfit = left.square().rowwise().sum();
    Rows weight = inner;
    for (int k = 0; k < 4; ++k) {
      const float usual = std::max(1e-12F, (misfit * weight).sum() / weight.sum());
      weight = inner * (1.0F + (misfit / (2.0F * usual)).square()).inverse();
    }
    const Grid parts[kUnknowns] = {along.colwise() * contrasts, across.colwise() * contrasts, known,
                                   known.colwise() * far, known.colwise() * farther};
    const auto dot = [&](const Grid& a, const Grid& b) { return double{((a * b).rowwise().sum() * weight).sum()}; };
    Eigen::Matrix<double, kUnknowns, kUnknowns> normal;
    Eigen::Matrix<double, kUnknowns, 1> right;
    for (int i = 0; i < kUnknowns; ++i) {
      right[i] = dot(parts[i], left);
      for (int j = 0; j <= i; ++j) normal(i, j) = normal(j, i) = dot(parts[i], parts[j]);
    }
    const Eigen::LDLT<Eigen::Matrix<double, kUnknowns, kUnknowns>> solver(normal);
    const Eigen::Matrix<double, kUnknowns, 1> step = solver.solve(right);
    if (!step.allFinite()) return std::nullopt;
    // The grid has moved too far by as much as its picture has.
    const double ahead = std::clamp(-step[0], -kLongestStep_px, kLongestStep_px);
    const double aside = std::clamp(-step[1], -kLongestStep_px, kLongestStep_px);
    axis.tip += ahead * axis.direction + aside * axis.across();
    contrast += step.tail<3>().cast<float>().array();
    const double variance = kShared * dot(left, left) / (double{weight.sum()} * kColumns);
    // What is known of the place along, beside the other unknowns, less what noise adds to it.
    const double told = 1.0 / std::max(1e-30, solver.solve(Eigen::Matrix<double, kUnknowns, 1>::UnitX())[0]);
    const double noise = kSlopeNoise / (step_px_ * step_px_) * dot(raw - now, raw - now);
    if (noise > kMostNoise * told) return std::nullopt;
    place.sigma_px = std::hypot(kStray * std::sqrt(variance / (told - noise)), kSharedError * read_sigma_px_);
    place.likeness =
        std::max(0.0, 1.0 - dot(left, left) / std::max(1e-12, dot(now, now))) * double{weight.sum() / inner.sum()};
    if (std::abs(ahead) < kSettled_px && std::abs(aside) < kSettled_px) break;
  }
  const Rows contrasts = (inner > 0.0F).select(contrast[0] + contrast[1] * far + contrast[2] * farther, 1.0F);
  place.ahead_px = (axis.tip - begun.tip).dot(axis.direction);
  place.across_px = (axis.tip - begun.tip).dot(axis.across());
  const bool is_shaft = contrasts.minCoeff() > kLeastContrast && contrasts.maxCoeff() < kMostContrast;
  place.sigma_px = std::hypot(place.sigma_px, drift_per_px() * std::abs(along_of(axis) - way_.mean_px));
  if (place.sigma_px > kVague_px) return std::nullopt;
  return is_shaft && place.likeness > kAlike * likeness_ && std::abs(place.ahead_px) < kFarthest_px
             ? std::optional(place)
             : std::nullopt;
}

double ShaftMotion::along_of(const NeedleAxis& axis) {
  return axis.tip.dot(axis.direction);
}

// Of the readings' distance from the shaft by the way gone, by least squares.
double ShaftMotion::drift_per_px() const {
  if (way_.count < kLeastFrames || way_.squares < kLeastWay_px * kLeastWay_px) return 0.0;
  const double slope = way_.products / way_.squares, sigma = read_sigma_px_ / std::sqrt(way_.squares);
  return std::max(0.0, std::abs(slope) - kSureDrift * sigma);
}

void ShaftMotion::Way::add(double way_px, double apart_px) {
  ++count;
  const double way = way_px - mean_px, apart = apart_px - mean_apart_px;
  mean_px += way / count;
  mean_apart_px += apart / count;
  squares += way * (way_px - mean_px);
  products += way * (apart_px - mean_apart_px);
}

void ShaftMotion::add(const FrameSampler& image, const NeedleAxis& axis) {
  Grid now;
  Rows inside;
  sample(image, axis, now, inside);
  sum_ += now.colwise() * inside;
  count_ += inside;
}

void ShaftMotion::learn(const FrameSampler& image, const NeedleAxis& due, const std::optional<Place>& found,
                        const Eigen::Vector2d& read, double sigma_px, double half_width_px) {
  if (frames_ == 0) step_px_ = std::max(kFinest_px, half_width_px / kHalfWidthSamples);
  NeedleAxis axis{read, due.direction};
  if (found) {
    axis.tip = due.tip + (found->ahead_px - ahead_px_) * due.direction + found->across_px * due.across();
    likeness_ += (found->likeness - likeness_) / frames_;
  } else {
    axis.tip -= ahead_px_ * due.direction;
  }
  add(image, axis);
  frames_ = std::min(frames_ + 1, kMostFrames);
  const double apart_px = (read - axis.tip).dot(due.direction);
  ahead_px_ += (apart_px - ahead_px_) / frames_;
  if (found) way_.add(along_of(axis), apart_px);
  read_sigma_px_ += (sigma_px - read_sigma_px_) / frames_;
}

}  // namespace pellucida
