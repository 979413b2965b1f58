#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "EdgeProfile.h"

namespace pellucida {

/// What a membrane looks like along its outward normal, learnt from the image itself, and the filters that find it
/// again.
///
/// Model of a profile, divided by its own mean brightness: p(k) = a + g T(k - d; n) + noise, k = -kHalf..kHalf samples,
/// with brightness a, contrast g and place d free. One-sided shading lets the look depend on the normal's direction n
/// in the image: T(k; n) = T0(k) + n_x Tx(k) + n_y Ty(k). About d = 0 the model is linear in (a, g, g d), so the best g
/// and g d are two fixed filters for each direction, sum_k gain(k) p(k) and sum_k shift(k) p(k): the matched filter and
/// its slope. The place is where the second one crosses zero; nothing beside the line pulls it aside, because what is
/// beside the line is part of T.
class EdgeTemplate {
 public:
  static constexpr int kHalf = 8;
  static constexpr int kTaps = 2 * kHalf + 1;
  static constexpr int kDirections = 16;
  /// Largest reach of match(), samples.
  static constexpr int kMaxReach = 11;

  /// Where, how strongly and how well a profile shows the look.
  struct Match {
    float place = 0.0F;     ///< of the edge's centre, samples from the profile's middle
    float gain = 0.0F;      ///< contrast, 1 as learnt
    float residual = 0.0F;  ///< mean square of what the model leaves, brightness 1
    float mean = 0.0F;      ///< brightness of the profile
    bool inside = false;    ///< false: the best place is at the end of the reach
  };

  void reset() noexcept { valid_ = false; }
  bool valid() const noexcept { return valid_; }
  /// Standard deviation (line) or half rise (step) of the learnt edge, samples.
  double width() const noexcept { return width_; }

  /// Learns from profiles centred on the contour: row i of `profiles` (kTaps samples each) belongs to column i of
  /// `normals`, and counts if weights[i] > 0. Rows unlike the others lose their say. `share` of what was known before
  /// is replaced; all, when nothing was. False (and unchanged) with too few rows.
  bool learn(const float* profiles, const Eigen::Matrix2Xd& normals, const Eigen::VectorXd& weights, EdgeKind kind,
             double share);

  /// Finds the look in a profile of kTaps + 2 reach samples, climbing from its middle; reach <= kMaxReach.
  Match match(const float* profile, int reach, int direction) const noexcept;

  /// The direction a unit normal belongs to.
  static int direction_of(double nx, double ny) noexcept;

  /// Variance of a place (samples^2) for noise of variance 1 on each sample and a gain of 1.
  double place_variance(int direction) const noexcept { return looks_[static_cast<std::size_t>(direction)].variance; }
  /// Standard deviation of a gain for the same noise.
  double gain_deviation(int direction) const noexcept {
    return looks_[static_cast<std::size_t>(direction)].gain_deviation;
  }
  /// How far the edge's true centre may lie from the one taken for it, samples: common to all profiles.
  double center_deviation(int direction) const noexcept {
    return looks_[static_cast<std::size_t>(direction)].center_deviation;
  }
  /// How unlike its mirror image about its centre the look is: RMS of the odd part over that of the even, all
  /// directions together. 0: a line with the same on both sides.
  double asymmetry() const noexcept;
  /// Brightness `away_px` outside the edge's centre, over that of the window's outer end, which is what it is beyond
  /// it; `step_px`: of a sample. Further in than the window, that of its inner end.
  float relative(float away_px, float step_px, int direction) const noexcept;
  /// Energy of the look: mean square over the window, brightness 1.
  double energy(int direction) const noexcept { return looks_[static_cast<std::size_t>(direction)].energy; }

 private:
  using Taps = std::array<float, kTaps>;
  struct Look {
    Taps shape{};        // T, its mean taken away
    float level = 1.0F;  // that mean, and the profile's own, which is 1
    Taps slope{};        // dT/dk
    Taps gain{}, shift{};
    float center = 0.0F, center_deviation = 0.0F;
    double variance = 1.0, gain_deviation = 1.0, energy = 0.0;
  };

  void build(EdgeKind kind);

  bool valid_ = false;
  double width_ = 2.0;
  Eigen::Matrix<double, kTaps, 3> harmonics_ = Eigen::Matrix<double, kTaps, 3>::Zero();
  std::array<Look, kDirections> looks_{};
  std::vector<double> weights_, misfits_, order_;
};

}  // namespace pellucida
