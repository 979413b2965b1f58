#include "GeometryEstimate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ForcePowers.h"

namespace pellucida {
namespace {

/// A resting radius is known to this by a tracker, um.
constexpr double kRadiusSigma_um = 0.2;
/// Where in its blurred edge a membrane begins is a matter of definition: both together, um.
constexpr double kEdgeSigma_um = 0.4;
/// What is known of a length that isn't seen: how zonae of a kind differ; how the tools of different benches differ, of
/// their logarithms. Beside a length that is seen none of them would count.
constexpr double kUnseenThickness_ratio = 0.5, kBenchTip_ratio = 0.7, kBenchHolder_ratio = 0.4;
/// A holder so many of those deviations from the usual one is none: something else was seen, or a part of it.
constexpr double kFarthestHolder_sigmas = 3.4;
/// How well a tool's radius is seen: of its logarithm.
constexpr double kSeenTip_ratio = 0.15, kSeenHolder_ratio = 0.08;
/// An inner edge that would have been seen from a distance on, and wasn't: how much that distance may differ, over
/// itself, and how likely the edge has no contrast at all.
constexpr double kLimitBlur_ratio = 0.25, kNoContrast = 0.05;
/// No zona is thinner, over the cell's outer radius: two contours that near lie on one edge.
constexpr double kThinnestZona_ratio = 0.02;
/// From so many frames on, a tool's width follows what is seen at that pace.
constexpr int kMostFrames = 50;
/// So far from the profile's own geometry, in logarithms, the correction's whole spread counts; nearer in proportion.
constexpr double kWholeSpread = 0.5;

// The thickness of a zona whose inner edge would show from `limit_um` on, by Bayes' rule on its logarithm: mean, and
// standard deviation in um.
GeometryEstimate::Thickness thickness_below(double limit_um, double usual_um) {
  constexpr int kHalf = 40;        // nodes to each side
  constexpr double kWidest = 4.0;  // standard deviations to each side
  double weight = 0.0, first = 0.0, second = 0.0;
  for (int k = -kHalf; k <= kHalf; ++k) {
    const double z = kWidest * k / kHalf, log_um = std::log(usual_um) + kUnseenThickness_ratio * z;
    const double beyond = (std::exp(log_um) - limit_um) / (kLimitBlur_ratio * limit_um);
    const double missed = kNoContrast + (1.0 - kNoContrast) * 0.5 * std::erfc(beyond / std::numbers::sqrt2);
    const double w = std::exp(-0.5 * z * z) * missed;
    weight += w;
    first += w * log_um;
    second += w * log_um * log_um;
  }
  const double mean = first / weight, variance = second / weight - mean * mean;
  return {std::exp(mean), std::exp(mean) * std::sqrt(variance)};
}

}  // namespace

void GeometryEstimate::Seen::add(double length_um, double log_sigma) {
  if (!std::isfinite(length_um) || !(length_um > 0.0)) return;
  count = std::min(count + 1, kMostFrames);
  log_um += (std::log(length_um) - log_um) / count;
  sigma += (log_sigma - sigma) / count;
}

bool GeometryEstimate::is_likely_holder(double radius_um) const noexcept {
  const double usual_um = profile_->holder_ring_um + profile_->holder_half_width_um;
  return radius_um > 0.0 && std::abs(std::log(radius_um / usual_um)) < kFarthestHolder_sigmas * kBenchHolder_ratio;
}

void GeometryEstimate::update(const Observation& o) {
  const bool clear = o.state == CellState::kFree;
  const auto sigma_or = [](double sigma, double usual) { return sigma > 0.0 ? sigma : usual; };
  if (o.needle && (clear || tip_.count == 0))
    tip_.add(o.needle->tip_radius_um, sigma_or(o.needle->tip_radius_sigma, kSeenTip_ratio));
  if (o.holder && is_likely_holder(o.holder->outer_radius_um) && (clear || holder_.count == 0))
    holder_.add(o.holder->outer_radius_um, sigma_or(o.holder->outer_radius_sigma, kSeenHolder_ratio));

  Thickness thickness{o.rest_outer_radius_um - o.rest_inner_radius_um,
                      std::hypot(kEdgeSigma_um, o.rest_thickness_sigma_um)};
  thickness_assumed_ = !(o.rest_inner_radius_um > 0.5 * o.rest_outer_radius_um &&
                         thickness.mean_um > kThinnestZona_ratio * o.rest_outer_radius_um);
  if (thickness_assumed_) {
    const double usual_um = profile_->thickness_um;
    thickness = o.rest_thickness_limit_um > 0.0 ? thickness_below(o.rest_thickness_limit_um, usual_um)
                                                : Thickness{usual_um, kUnseenThickness_ratio * usual_um};
  }
  seen_thickness_um_ = thickness.mean_um;
  thickness_sigma_um_ = thickness.sigma_um;
  geometry_.thickness_um = seen_thickness_um_;
  geometry_.mid_radius_um = o.rest_outer_radius_um - 0.5 * geometry_.thickness_um;

  // No wider than a tool on this cell can be.
  const double radius_um = geometry_.mid_radius_um;
  // What reads a tip knows how wide tips are: to draw it towards the usual one would count that twice.
  const Length tip =
      tip_.count > 0 ? Length{std::exp(tip_.log_um), tip_.sigma} : Length{profile_->tip_radius_um, kBenchTip_ratio};
  const Length holder =
      known_holder(holder_, {profile_->holder_ring_um + profile_->holder_half_width_um, kBenchHolder_ratio});
  geometry_.tip_radius_um = std::min(tip.length_um, 0.45 * radius_um);
  geometry_.holder_radius_um = std::min(holder.length_um, 0.9 * radius_um);
  tip_sigma_ = tip.sigma;
  holder_sigma_ = holder.sigma;
}

// A holder seen less surely than edges show it is drawn towards the bench's usual one: by Bayes' rule, for that part of
// its variance that comes on top.
GeometryEstimate::Length GeometryEstimate::known_holder(const Seen& seen, const Length& usual) {
  if (seen.count == 0) return usual;
  const double excess = std::max(0.0, seen.sigma * seen.sigma - kSeenHolder_ratio * kSeenHolder_ratio),
               own = usual.sigma * usual.sigma;
  const double share = own / (own + excess);
  return {std::exp(share * seen.log_um + (1.0 - share) * std::log(usual.length_um)),
          std::hypot(std::min(seen.sigma, kSeenHolder_ratio), std::sqrt(share * excess))};
}

double GeometryEstimate::force_sigma_ratio(std::optional<double> by_solid) const noexcept {
  // Seen at rest, a thickness moves the middle radius with it; the solid's is at the outer one.
  const double radius_sigma_um = by_solid ? kRadiusSigma_um : std::hypot(kRadiusSigma_um, 0.5 * thickness_sigma_um_);
  const LogSizes sigmas = log_sigmas();
  const double by_powers = std::hypot(kThicknessPower * sigmas[0], kTipPower * sigmas[1], kHolderPower * sigmas[2]);
  const double by_sizes = by_solid.value_or(std::hypot(by_powers, springs_spread_ratio()));
  return std::hypot(kRadiusPower * radius_sigma_um / geometry_.mid_radius_um, by_sizes);
}

double GeometryEstimate::springs_spread_ratio() const noexcept {
  const double away = std::min(1.0, shape_distance(geometry_, geometry_of(*profile_)) / kWholeSpread);
  return away * profile_->geometry_range.spread_ratio;
}

}  // namespace pellucida
