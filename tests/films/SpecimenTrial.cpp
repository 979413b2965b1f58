#include "films/SpecimenTrial.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace pellucida::test {
namespace {

constexpr int kDraws = 16;
constexpr double kPalpation_um = 5.0, kPalpation_ratio = 0.05;

double normal(std::mt19937_64& dice) {
  return std::normal_distribution<double>(0.0, 1.0)(dice);
}

double over_a_factor_of_ten(std::mt19937_64& dice) {
  return std::uniform_real_distribution<double>(-0.5, 0.5)(dice) * std::log(10.0);
}

}  // namespace

SpecimenTrial::SpecimenTrial(const RandomFilm& film, const CellProfile& profile)
    : profile_(profile), palpated_(profile), seed_(film.seed) {
  result_.specimen = load_reference_geometry(film.scenario.cell.reference);
  scale_ = film.scenario.cell.size_scale;
  std::mt19937_64 dice(7 * seed_ + 3);
  wide_log_ = over_a_factor_of_ten(dice);
  noise_ = normal(dice);
}

void SpecimenTrial::add(const Observation& seen, const ForceEstimate& estimate, bool contact, double true_uN,
                        double true_um) {
  const ForceEstimate palpated = palpated_.process(seen);
  peak_uN_ = std::max(peak_uN_, true_uN);
  if (!contact) return;
  deepest_um_ = std::max(deepest_um_, true_um);
  if (!std::isfinite(estimate.contact_force_uN)) return;
  ++count_;
  squares_ += std::pow(estimate.contact_force_uN - true_uN, 2);
  sum_ += estimate.contact_force_uN - true_uN;

  // The same draws for every frame of the film: one cell.
  std::mt19937_64 dice(11 * seed_ + 5);
  const auto holds = [&](double log_ratio) {
    const double force_uN = std::exp(log_ratio) * true_uN;
    return estimate.contact_force_lower_uN <= force_uN && force_uN <= estimate.contact_force_upper_uN ? 1.0 : 0.0;
  };
  for (int k = 0; k < kDraws; ++k) whole_count_ += holds(profile_.kind_spread_ratio * normal(dice)) / kDraws;
  for (int k = 0; k < kDraws; ++k) wide_count_ += holds(over_a_factor_of_ten(dice)) / kDraws;

  if (is_palpated_ && std::isfinite(palpated.contact_force_uN)) {
    ++palpated_count_;
    palpated_squares_ += std::pow(palpated.contact_force_uN / std::exp(wide_log_) - true_uN, 2);
  }
  if (!is_palpated_ && true_um >= kPalpation_um && estimate.depth_um > 1.0) {
    ScaleMeasurement push;
    push.known_force_uN = true_uN * std::exp(wide_log_ + kPalpation_ratio * noise_);
    push.known_force_sigma_percent = 100.0 * kPalpation_ratio;
    push.at_indentation_um = estimate.depth_um;
    push.at_indentation_sigma_um = std::max(0.2, estimate.depth_sigma_um);
    push.since_s = seen.time_s;
    palpated_.set_scale_measurements({push});
    is_palpated_ = true;
  }
}

SpecimenResult SpecimenTrial::result() const {
  SpecimenResult result = result_;
  result.deepest_ratio = deepest_um_ / (scale_ * result.specimen.middle_radius_um);
  const auto percent = [&](double squares, int count) {
    return count > 0 && peak_uN_ > 0.0 ? 100.0 * std::sqrt(squares / count) / peak_uN_ : -1.0;
  };
  result.given_percent = percent(squares_, count_);
  result.palpated_percent = percent(palpated_squares_, palpated_count_);
  if (count_ > 0) {
    result.bias_percent = 100.0 * sum_ / count_ / peak_uN_;
    result.in_whole = whole_count_ / count_;
    result.in_wide = wide_count_ / count_;
  }
  return result;
}

}  // namespace pellucida::test
