#include "films/RelaxingTruth.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace pellucida::test {
namespace {

/// The push that the scale was measured in, from rest.
constexpr double kAnchorRamp_s = 2.2;

}  // namespace

RelaxingTruth::RelaxingTruth(std::uint64_t seed) {
  std::mt19937_64 dice(13 * seed + 1);
  const auto about = [&](double value, double log_sigma) {
    return value * std::exp(log_sigma * std::normal_distribution<double>(0.0, 1.0)(dice));
  };
  arms_ = {
      {about(0.12, 0.1), about(0.6, 0.3)}, {about(0.33, 0.1), about(1.8, 0.3)}, {about(0.26, 0.1), about(9.0, 0.3)}};
  // A push as long as the anchor's ends where the table does; its force grows with the power 1.8 of depth.
  constexpr int kParts = 400;
  double mean = 0.0;
  for (int k = 0; k < kParts; ++k) {
    const double share = (k + 0.5) / kParts;
    mean += 1.8 * std::pow(share, 0.8) * left_after(kAnchorRamp_s * (1.0 - share)) / kParts;
  }
  elastic_ratio_ = 1.0 / mean;
}

double RelaxingTruth::left_after(double time_s) const {
  double left = 1.0;
  for (const Arm& arm : arms_) left -= arm.fraction * -std::expm1(-time_s / arm.time_s);
  return left;
}

double RelaxingTruth::add(double time_s, double elastic_uN) {
  if (!(elastic_uN > 0.0)) {
    past_.clear();
    before_s_ = time_s;
    before_uN_ = 0.0;
    return 0.0;
  }
  past_.push_back({0.5 * (before_s_ + time_s), elastic_uN - before_uN_});
  before_s_ = time_s;
  before_uN_ = elastic_uN;
  double force_uN = 0.0;
  for (const Step& step : past_) force_uN += step.rise_uN * left_after(time_s - step.time_s);
  return std::max(0.0, elastic_ratio_ * force_uN);
}

CellProfile with_relaxation(CellProfile profile) {
  profile.relaxation_arms = {{0.43, 1.25}, {0.28, 7.4}};
  profile.relaxation_elastic_ratio = 1.27;
  profile.relaxation_anchor_ramp_s = kAnchorRamp_s;
  return profile;
}

}  // namespace pellucida::test
