#include "TipFinder.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

constexpr double kOutlier = 0.7;       // of the needle's contrast: more counts no more
constexpr double kBehindUnits = 16.0;  // how far behind the tip the end is looked at
constexpr double kAheadUnits = 8.0;
constexpr double kBesideBlurs = 2.5;
constexpr int kFewestRows = 8;

}  // namespace

void TipFinder::prepare(const NeedleModel& model) {
  unit_ = model.unit_px;
  step_ = model.look.step();
  lines_ = std::clamp(static_cast<int>(std::lround(unit_)), 1, 4);
  depth_ = std::abs(model.look.depth());
  // Ahead of the row where the look has died away all is medium; behind the last row the shaft goes on.
  before_ = 0.5 * unit_ * std::ceil((model.look.outside() + unit_) / (0.5 * unit_));
  model_rows_ = static_cast<int>(std::ceil((before_ + (kBehindUnits + 8.0) * unit_) / (0.5 * unit_))) + 1;
  const double reach = model.cone.half_width((kBehindUnits + 8.0) * unit_) + kBesideBlurs * model.look.blur();
  columns_ = 2 * static_cast<int>(std::ceil(reach / step_)) + 1;
  half_across_ = step_ * (columns_ / 2);
  model_.resize(columns_, model_rows_);
  for (int i = 0; i < model_rows_; ++i) {
    model.line(i * 0.5 * unit_ - before_, -half_across_, step_, columns_, model_.col(i).data());
    const float mean = model_.col(i).mean();
    model_.col(i).array() -= mean;
  }
}

// What the model leaves unexplained with the tip `ahead` px ahead, a multiple of half a unit.
double TipFinder::cost(double ahead) const {
  const int half_units = static_cast<int>(std::lround(ahead / (0.5 * unit_)));
  const int before = static_cast<int>(std::lround(before_ / (0.5 * unit_)));
  float sum = 0.0F;
  const float limit = limit_;
  for (int k = 0; k < rows_; ++k) {
    const float* values = values_.col(k).data();
    const int row = 2 * (first_ + k) + half_units + before;
    if (row < 0) {
      for (int j = 0; j < columns_; ++j) sum += std::min(values[j] * values[j], limit);
      continue;
    }
    const float* look = model_.col(std::min(row, model_rows_ - 1)).data();
    for (int j = 0; j < columns_; ++j) {
      const float off = values[j] - look[j];
      sum += std::min(off * off, limit);
    }
  }
  return sum;
}

// One row of the image: the mean of lines spread over a unit.
void TipFinder::sample_row(const FrameSampler& image, const Eigen::Vector2d& from, const Eigen::Vector2d& step,
                           const Eigen::Vector2d& direction, float* row) {
  image.sample_line(from - 0.5 * (lines_ - 1) / lines_ * unit_ * direction, step, columns_, row);
  if (lines_ < 2) return;
  line_.resize(static_cast<std::size_t>(columns_));
  for (int l = 1; l < lines_; ++l) {
    image.sample_line(from + (l - 0.5 * (lines_ - 1)) / lines_ * unit_ * direction, step, columns_, line_.data());
    for (int j = 0; j < columns_; ++j) row[j] += line_[static_cast<std::size_t>(j)];
  }
  for (int j = 0; j < columns_; ++j) row[j] /= static_cast<float>(lines_);
}

bool TipFinder::sample(const FrameSampler& image, const NeedleAxis& axis, double reach_px, double clear_px) {
  axis_ = axis;
  reach_ = std::max(2, static_cast<int>(std::ceil(reach_px / unit_)));
  first_ = -reach_ - static_cast<int>(kAheadUnits);
  const int most = std::min(reach_, static_cast<int>(kBehindUnits)) + static_cast<int>(kAheadUnits);
  const int last = clear_px < most * unit_ ? static_cast<int>(std::floor(clear_px / unit_)) : most;
  rows_ = last - first_ + 1;
  if (rows_ < kFewestRows) return false;
  for (Eigen::MatrixXf* rows : {&samples_, &values_})
    if (rows->rows() != columns_ || rows->cols() < rows_) rows->resize(columns_, rows_);
  const Eigen::Vector2d step = step_ * axis.across();
  int inside = 0;
  for (int k = 0; k < rows_; ++k) {
    inside += image.inside(axis.at((first_ + k) * unit_, 0.0), 1.0) ? 1 : 0;
    sample_row(image, axis.at((first_ + k) * unit_, -half_across_), step, axis.direction, samples_.col(k).data());
  }
  return inside >= kFewestRows;
}

TipResult TipFinder::find(double gain, double medium, double noise, const MembraneBackdrop* backdrop) {
  TipResult result;
  const float scale = static_cast<float>(1.0 / std::max(medium * gain, 1e-6));
  for (int k = 0; k < rows_; ++k) {
    const float* samples = samples_.col(k).data();
    float* values = values_.col(k).data();
    float mean = 0.0F;
    for (int j = 0; j < columns_; ++j) {
      values[j] = samples[j];
      if (backdrop) values[j] /= backdrop->at(axis_.at((first_ + k) * unit_, j * step_ - half_across_));
      mean += values[j];
    }
    mean /= static_cast<float>(columns_);
    for (int j = 0; j < columns_; ++j) values[j] = scale * (values[j] - mean);
  }
  const double relative_noise = noise * scale / std::sqrt(double(lines_));
  limit_ = static_cast<float>(std::pow(kOutlier * depth_ + 2.0 * relative_noise, 2));

  const int candidates = 4 * reach_ + 1;
  costs_.resize(static_cast<std::size_t>(candidates));
  int best = 0;
  for (int c = 0; c < candidates; ++c) {
    costs_[static_cast<std::size_t>(c)] = cost((c - 2 * reach_) * 0.5 * unit_);
    if (costs_[static_cast<std::size_t>(c)] < costs_[static_cast<std::size_t>(best)]) best = c;
  }
  if (best < 2 || best > candidates - 3) return result;
  // A parabola through five costs: less at the mercy of one.
  const double* c = costs_.data() + best;
  const double slope = (2.0 * c[2] + c[1] - c[-1] - 2.0 * c[-2]) / 10.0;
  const double curvature = (2.0 * c[2] - c[1] - 2.0 * c[0] - c[-1] + 2.0 * c[-2]) / 7.0;
  if (!(curvature > 0.0)) return result;
  const double half = 0.5 * unit_;
  result.found = true;
  result.ahead = half * (best - 2 * reach_ + std::clamp(-slope / curvature, -1.0, 1.0));
  // cost = sum of squares: its second derivative is twice the information over the variance. Samples closer than a
  // pixel share its noise.
  const double shared = std::max(1.0, 1.0 / step_);
  result.ahead_sigma = relative_noise * std::sqrt(2.0 * shared / (curvature / (half * half)));
  result.unexplained = costs_[static_cast<std::size_t>(best)] / (rows_ * columns_);
  result.disagreement = std::sqrt(result.unexplained) / relative_noise;
  return result;
}

}  // namespace pellucida
