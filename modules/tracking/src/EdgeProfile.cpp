#include "EdgeProfile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pellucida {
namespace {

constexpr float kImpossible = -1e30F;

}  // namespace

EdgeFilter::EdgeFilter(double sigma_px, double step_px, EdgeKind kind) : kind_(kind) {
  sigma_px_ = std::max(sigma_px, 0.3);
  const double step = std::clamp(step_px, 0.05, sigma_px_);
  half_ = static_cast<int>(std::ceil(3.5 * sigma_px_ / step));
  kernel_.resize(static_cast<std::size_t>(2 * half_ + 1));
  std::vector<double> line(kernel_.size()), step_kernel(kernel_.size());
  double line_sum = 0.0;
  for (int k = -half_; k <= half_; ++k) {
    const double x = k * step / sigma_px_;
    const double gauss = std::exp(-0.5 * x * x) / (std::sqrt(2.0 * M_PI) * sigma_px_) * step;
    line[static_cast<std::size_t>(k + half_)] = (x * x - 1.0) * gauss;
    step_kernel[static_cast<std::size_t>(k + half_)] = x * gauss;
    line_sum += line[static_cast<std::size_t>(k + half_)];
  }
  // A flat profile must give exactly 0.
  for (std::size_t k = 0; k < kernel_.size(); ++k) {
    line[k] -= line_sum / static_cast<double>(kernel_.size());
    kernel_[k] = static_cast<float>(kind.line * line[k] + kind.step * step_kernel[k]);
  }
  double squares = 0.0, slopes = 0.0;
  for (std::size_t k = 0; k < kernel_.size(); ++k) {
    squares += double(kernel_[k]) * kernel_[k];
    const double before = k > 0 ? kernel_[k - 1] : 0.0, after = k + 1 < kernel_.size() ? kernel_[k + 1] : 0.0;
    const double slope = (after - before) / (2.0 * step);
    slopes += slope * slope;
  }
  // Neighbouring samples share pixels: with a step below one pixel there are 1 / step times fewer independent ones.
  const double shared = std::sqrt(std::max(1.0, 1.0 / step));
  noise_gain_ = std::sqrt(squares) * shared;
  slope_noise_gain_ = std::sqrt(slopes) * shared;
}

void EdgeFilter::apply(const float* profile, int count, float* feature) const {
  const int taps = 2 * half_ + 1;
  const auto at_end = [&](int j) {
    float sum = 0.0F;
    for (int k = 0; k < taps; ++k)
      sum += kernel_[static_cast<std::size_t>(k)] * profile[std::clamp(j + k - half_, 0, count - 1)];
    return sum;
  };
  const int from = std::min(half_, count), to = std::max(from, count - half_);
  for (int j = 0; j < from; ++j) feature[j] = at_end(j);
  for (int j = to; j < count; ++j) feature[j] = at_end(j);
  // Tap by tap: the compiler takes many places at once.
  std::fill(feature + from, feature + to, 0.0F);
  for (int k = 0; k < taps; ++k) {
    const float tap = kernel_[static_cast<std::size_t>(k)];
    for (int j = from; j < to; ++j) feature[j] += tap * profile[j + k - half_];
  }
}

Peak climb_to_peak(const float* feature, int count, int start, int reach) {
  Peak peak;
  if (count < 1) return peak;
  int j = std::clamp(start, 0, count - 1);
  const int low = std::max(0, start - reach), high = std::min(count - 1, start + reach);
  for (;;) {
    const float here = feature[j];
    const float left = j > low ? feature[j - 1] : here, right = j < high ? feature[j + 1] : here;
    if (left > here && left >= right) {
      --j;
    } else if (right > here) {
      ++j;
    } else {
      break;
    }
  }
  peak.position = j;
  peak.height = feature[j];
  if (j > 0 && j + 1 < count) {
    const double curvature = double(feature[j - 1]) - 2.0 * feature[j] + feature[j + 1];
    if (curvature < 0.0 && feature[j] >= feature[j - 1] && feature[j] >= feature[j + 1]) {
      const double offset = 0.5 * (double(feature[j - 1]) - feature[j + 1]) / curvature;
      peak.position = j + std::clamp(offset, -0.5, 0.5);
      peak.height = feature[j] - 0.25 * (double(feature[j - 1]) - feature[j + 1]) * offset;
      peak.curvature = curvature;
    }
  }
  return peak;
}

std::vector<int> best_closed_path(const Eigen::MatrixXf& reward, int max_slope, float slope_penalty) {
  PathSearch search;
  return search.closed_path(reward, max_slope, slope_penalty);
}

PathPair best_closed_path_pair(const Eigen::MatrixXf& reward_outer, const Eigen::MatrixXf& reward_inner, int min_gap,
                               int max_gap, float slope_penalty, float gap_penalty) {
  PathSearch search;
  return search.closed_pair(reward_outer, reward_inner, min_gap, max_gap, slope_penalty, gap_penalty);
}

const std::vector<int>& PathSearch::closed_path(const Eigen::MatrixXf& reward, int max_slope, float slope_penalty) {
  const int rows = static_cast<int>(reward.rows()), columns = static_cast<int>(reward.cols());
  path_.assign(static_cast<std::size_t>(rows), 0);
  if (rows < 1 || columns < 1) return path_;
  const int lead = rows / 4 + 1, total = rows + 2 * lead;
  // A margin of impossible places on both sides spares the inner loop its bounds.
  const int stride = columns + 2 * max_slope;
  back_.resize(static_cast<std::size_t>(total) * columns);
  score_.assign(static_cast<std::size_t>(stride), kImpossible);
  std::fill_n(score_.begin() + max_slope, columns, 0.0F);
  across_.resize(static_cast<std::size_t>(columns));
  code_.resize(static_cast<std::size_t>(columns));
  for (int r = 0; r < total; ++r) {
    const int i = ((r - lead) % rows + rows) % rows;
    float *best = across_.data(), *code = code_.data();
    const float* score = score_.data() + max_slope;
    for (int j = 0; j < columns; ++j) {
      best[j] = score[j];
      code[j] = 0.0F;
    }
    for (int d = 1; d <= max_slope; ++d) {
      const float cost = slope_penalty * static_cast<float>(d), step = static_cast<float>(d);
      for (int j = 0; j < columns; ++j) {
        const float low = score[j - d] - cost, high = score[j + d] - cost;
        code[j] = low > best[j] ? -step : code[j];
        best[j] = low > best[j] ? low : best[j];
        code[j] = high > best[j] ? step : code[j];
        best[j] = high > best[j] ? high : best[j];
      }
    }
    std::int8_t* back = back_.data() + static_cast<std::size_t>(r) * columns;
    for (int j = 0; j < columns; ++j) {
      back[j] = static_cast<std::int8_t>(code[j]);
      score_[static_cast<std::size_t>(j + max_slope)] = best[j] + reward(i, j);
    }
  }
  // Backward: only the middle turn is kept, where both ends have been forgotten.
  const auto first = score_.begin() + max_slope;
  int j = static_cast<int>(std::max_element(first, first + columns) - first);
  for (int r = total - 1; r >= lead; --r) {
    if (r < lead + rows) path_[static_cast<std::size_t>(r - lead)] = j;
    j = std::clamp(j + back_[static_cast<std::size_t>(r) * columns + j], 0, columns - 1);
  }
  return path_;
}

const PathPair& PathSearch::closed_pair(const Eigen::MatrixXf& reward_outer, const Eigen::MatrixXf& reward_inner,
                                        int min_gap, int max_gap, float slope_penalty, float gap_penalty) {
  const int rows = static_cast<int>(reward_outer.rows()), columns = static_cast<int>(reward_outer.cols());
  const int gaps = std::max(1, max_gap - min_gap + 1);
  pair_.outer.assign(static_cast<std::size_t>(rows), 0);
  pair_.inner.assign(static_cast<std::size_t>(rows), 0);
  if (rows < 1 || columns < 1) return pair_;
  const int lead = rows / 5 + 1, total = rows + 2 * lead;
  // State (gap, outer place): one row a gap, with an impossible place on both sides and an impossible row above and
  // below. The moves' costs add up, so the best move over the gap and then over the place is the best of all nine.
  const int stride = columns + 2, states = stride * gaps;
  back_.resize(static_cast<std::size_t>(total) * states);
  score_.assign(static_cast<std::size_t>(states + 2 * stride), kImpossible);
  across_.assign(static_cast<std::size_t>(stride), kImpossible);
  code_.assign(static_cast<std::size_t>(stride), 0.0F);
  row_outer_.resize(static_cast<std::size_t>(columns));
  row_inner_.resize(static_cast<std::size_t>(columns));
  std::vector<float>& next = next_;
  next.assign(score_.size(), kImpossible);
  for (int g = 0; g < gaps; ++g) std::fill_n(score_.begin() + (g + 1) * stride + 1, columns, 0.0F);
  for (int r = 0; r < total; ++r) {
    const int i = ((r - lead) % rows + rows) % rows;
    for (int j = 0; j < columns; ++j) {
      row_outer_[static_cast<std::size_t>(j)] = reward_outer(i, j);
      row_inner_[static_cast<std::size_t>(j)] = reward_inner(i, j);
    }
    for (int g = 0; g < gaps; ++g) {
      const float* here = score_.data() + (g + 1) * stride;
      const float *thinner = here - stride, *thicker = here + stride;
      float *across = across_.data(), *code = code_.data();
      for (int j = 1; j <= columns; ++j) {
        float best = here[j], from = 4.0F;
        const float a = thinner[j] - gap_penalty, b = thicker[j] - gap_penalty;
        from = a > best ? 3.0F : from;
        best = a > best ? a : best;
        from = b > best ? 5.0F : from;
        best = b > best ? b : best;
        across[j] = best;
        code[j] = from;
      }
      std::int8_t* back = back_.data() + static_cast<std::size_t>(r) * states + static_cast<std::size_t>(g) * stride;
      float* result = next.data() + (g + 1) * stride;
      const int first = std::min(columns, min_gap + g);  // outer places whose inner partner is on the strip
      const float *outer = row_outer_.data() - 1, *inner = row_inner_.data() - 1 - (min_gap + g);
      std::fill_n(result + 1, first, kImpossible);
      std::fill_n(back + 1, first, std::int8_t{4});
      for (int j = 1 + first; j <= columns; ++j) {
        float best = across[j], from = code[j];
        const float a = across[j - 1] - slope_penalty, b = across[j + 1] - slope_penalty;
        from = a > best ? code[j - 1] - 3.0F : from;
        best = a > best ? a : best;
        from = b > best ? code[j + 1] + 3.0F : from;
        best = b > best ? b : best;
        result[j] = best + outer[j] + inner[j];
        back[j] = static_cast<std::int8_t>(from);
      }
    }
    score_.swap(next);
  }
  int state =
      static_cast<int>(std::max_element(score_.begin() + stride, score_.end() - stride) - score_.begin()) - stride;
  for (int r = total - 1; r >= lead; --r) {
    const int g = std::clamp(state / stride, 0, gaps - 1), j = std::clamp(state % stride, 1, columns);
    if (r < lead + rows) {
      pair_.outer[static_cast<std::size_t>(r - lead)] = j - 1;
      pair_.inner[static_cast<std::size_t>(r - lead)] = std::max(0, j - 1 - min_gap - g);
    }
    const int from = back_[static_cast<std::size_t>(r) * states + static_cast<std::size_t>(g) * stride + j];
    state = (std::clamp(g + from % 3 - 1, 0, gaps - 1)) * stride + std::clamp(j + from / 3 - 1, 1, columns);
  }
  return pair_;
}

}  // namespace pellucida
