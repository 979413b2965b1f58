#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace pellucida {

/// What an edge looks like along the outward normal: a mixture of a dark line and of a step.
/// feature(u) = line * sigma^2 (G''_sigma * I)(u) + step * sigma (G'_sigma * I)(u), with line^2 + step^2 = 1:
/// line > 0 a dark line, line < 0 a bright one, step > 0 brighter outside.
struct EdgeKind {
  double line = 1.0;
  double step = 0.0;
};

/// The edge filter sampled at `step_px`: derivative-of-Gaussian kernels of standard deviation `sigma_px`.
class EdgeFilter {
 public:
  /// sigma_px > 0, 0 < step_px <= sigma_px; others are brought into that range.
  EdgeFilter(double sigma_px, double step_px, EdgeKind kind);

  /// feature(j) for j = 0..count-1 of a profile of `count` samples; the border value continues outside.
  void apply(const float* profile, int count, float* feature) const;

  /// Standard deviation of the feature that white noise of standard deviation 1 per sample brings about.
  double noise_gain() const noexcept { return noise_gain_; }
  /// The same for the feature's derivative along the normal, per px.
  double slope_noise_gain() const noexcept { return slope_noise_gain_; }

  /// The taps, an odd number of them, in the order of the samples they weigh.
  const std::vector<float>& kernel() const noexcept { return kernel_; }

  const EdgeKind& kind() const noexcept { return kind_; }
  double sigma_px() const noexcept { return sigma_px_; }

 private:
  EdgeKind kind_;
  double sigma_px_;
  int half_;
  std::vector<float> kernel_;
  double noise_gain_ = 0.0;
  double slope_noise_gain_ = 0.0;
};

/// A local maximum of a feature, sub-sample.
struct Peak {
  double position = 0.0;  ///< in samples
  double height = 0.0;
  double curvature = 0.0;  ///< second derivative per sample^2, negative at a maximum
};

/// Climbs from sample `start` to the nearest local maximum within `reach` samples, and fits a parabola through it and
/// its neighbours. When the climb ends at the border or at `reach`, the position is that sample and the curvature 0.
Peak climb_to_peak(const float* feature, int count, int start, int reach);

/// Most rewarding closed path through a strip: one column j(i) for each row i of `reward` (rows x columns), going
/// round, with |j(i+1) - j(i)| <= max_slope and a cost of slope_penalty * |j(i+1) - j(i)|. Viterbi over one and a half
/// turns, so that the ends meet. Cost rows * columns * (2 max_slope + 1).
std::vector<int> best_closed_path(const Eigen::MatrixXf& reward, int max_slope, float slope_penalty);

/// Two coupled closed paths on the same strip: `outer` at j(i), `inner` at j(i) - t(i) with min_gap <= t(i) <= max_gap
/// samples. Rewards: reward_outer(i, j) + reward_inner(i, j - t) - slope_penalty |dj| - gap_penalty |dt|;
/// |dj|, |dt| <= 1. Cost 6 rows * columns * (max_gap - min_gap + 1), four states at a time.
struct PathPair {
  std::vector<int> outer;
  std::vector<int> inner;
};
PathPair best_closed_path_pair(const Eigen::MatrixXf& reward_outer, const Eigen::MatrixXf& reward_inner, int min_gap,
                               int max_gap, float slope_penalty, float gap_penalty);

/// The same two searches with their memory kept from call to call: no allocation once the sizes have been seen.
class PathSearch {
 public:
  /// As best_closed_path(); valid until the next call.
  const std::vector<int>& closed_path(const Eigen::MatrixXf& reward, int max_slope, float slope_penalty);
  /// As best_closed_path_pair(); valid until the next call.
  const PathPair& closed_pair(const Eigen::MatrixXf& reward_outer, const Eigen::MatrixXf& reward_inner, int min_gap,
                              int max_gap, float slope_penalty, float gap_penalty);

 private:
  std::vector<float> score_, next_, across_, code_, row_outer_, row_inner_;
  std::vector<std::int8_t> back_;
  std::vector<int> path_;
  PathPair pair_;
};

}  // namespace pellucida
