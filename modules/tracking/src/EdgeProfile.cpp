#include "pellucida/tracking/EdgeProfile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pellucida {

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
  for (int j = 0; j < count; ++j) {
    float sum = 0.0F;
    if (j >= half_ && j + half_ < count) {
      const float* p = profile + j - half_;
      for (int k = 0; k < taps; ++k) sum += kernel_[static_cast<std::size_t>(k)] * p[k];
    } else {
      for (int k = 0; k < taps; ++k) {
        sum += kernel_[static_cast<std::size_t>(k)] * profile[std::clamp(j + k - half_, 0, count - 1)];
      }
    }
    feature[j] = sum;
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
  const int rows = static_cast<int>(reward.rows()), columns = static_cast<int>(reward.cols());
  std::vector<int> path(static_cast<std::size_t>(rows), 0);
  if (rows < 1 || columns < 1) return path;
  const int lead = rows / 4 + 1, total = rows + 2 * lead;
  std::vector<std::int8_t> back(static_cast<std::size_t>(total) * columns, 0);
  std::vector<float> score(static_cast<std::size_t>(columns), 0.0F), next(score);
  // Forward: best sum that ends in column j.
  for (int r = 0; r < total; ++r) {
    const int i = ((r - lead) % rows + rows) % rows;
    for (int j = 0; j < columns; ++j) {
      float best = -1e30F;
      int from = 0;
      for (int d = -max_slope; d <= max_slope; ++d) {
        const int k = j + d;
        if (k < 0 || k >= columns) continue;
        const float value = score[static_cast<std::size_t>(k)] - slope_penalty * static_cast<float>(std::abs(d));
        if (value > best || (value == best && std::abs(d) < std::abs(from))) {
          best = value;
          from = d;
        }
      }
      next[static_cast<std::size_t>(j)] = best + reward(i, j);
      back[static_cast<std::size_t>(r) * columns + j] = static_cast<std::int8_t>(from);
    }
    score.swap(next);
  }
  // Backward: only the middle turn is kept, where both ends have been forgotten.
  int j = static_cast<int>(std::max_element(score.begin(), score.end()) - score.begin());
  for (int r = total - 1; r >= lead; --r) {
    if (r < lead + rows) path[static_cast<std::size_t>(r - lead)] = j;
    j = std::clamp(j + back[static_cast<std::size_t>(r) * columns + j], 0, columns - 1);
  }
  return path;
}

PathPair best_closed_path_pair(const Eigen::MatrixXf& reward_outer, const Eigen::MatrixXf& reward_inner, int min_gap,
                               int max_gap, float slope_penalty, float gap_penalty) {
  const int rows = static_cast<int>(reward_outer.rows()), columns = static_cast<int>(reward_outer.cols());
  const int gaps = std::max(1, max_gap - min_gap + 1);
  PathPair pair{std::vector<int>(static_cast<std::size_t>(rows), 0),
                std::vector<int>(static_cast<std::size_t>(rows), 0)};
  if (rows < 1 || columns < 1) return pair;
  const int lead = rows / 5 + 1, total = rows + 2 * lead;
  const int states = columns * gaps;
  std::vector<std::int8_t> back(static_cast<std::size_t>(total) * states, 0);
  std::vector<float> score(static_cast<std::size_t>(states), 0.0F), next(score);
  constexpr float kImpossible = -1e30F;
  for (int r = 0; r < total; ++r) {
    const int i = ((r - lead) % rows + rows) % rows;
    std::int8_t* back_row = back.data() + static_cast<std::size_t>(r) * states;
    for (int j = 0; j < columns; ++j) {
      const float outer = reward_outer(i, j);
      for (int g = 0; g < gaps; ++g) {
        const int inner = j - min_gap - g;
        const int state = j * gaps + g;
        if (inner < 0) {
          next[static_cast<std::size_t>(state)] = kImpossible;
          continue;
        }
        // Nine predecessors: both contours move by at most one sample.
        float best = kImpossible;
        int from = 4;
        for (int dj = -1; dj <= 1; ++dj) {
          if (j + dj < 0 || j + dj >= columns) continue;
          for (int dg = -1; dg <= 1; ++dg) {
            if (g + dg < 0 || g + dg >= gaps) continue;
            float value = score[static_cast<std::size_t>(state + dj * gaps + dg)];
            if (dj != 0) value -= slope_penalty;
            if (dg != 0) value -= gap_penalty;
            if (value > best) {
              best = value;
              from = 3 * (dj + 1) + dg + 1;
            }
          }
        }
        next[static_cast<std::size_t>(state)] = best + outer + reward_inner(i, inner);
        back_row[state] = static_cast<std::int8_t>(from);
      }
    }
    score.swap(next);
  }
  int state = static_cast<int>(std::max_element(score.begin(), score.end()) - score.begin());
  for (int r = total - 1; r >= lead; --r) {
    const int j = state / gaps, g = state % gaps;
    if (r < lead + rows) {
      pair.outer[static_cast<std::size_t>(r - lead)] = j;
      pair.inner[static_cast<std::size_t>(r - lead)] = std::max(0, j - min_gap - g);
    }
    const int from = back[static_cast<std::size_t>(r) * states + state];
    state = std::clamp(state + (from / 3 - 1) * gaps + from % 3 - 1, 0, states - 1);
  }
  return pair;
}

}  // namespace pellucida
