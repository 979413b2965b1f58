#include "pellucida/membrane/Relaxation.h"

#include <cmath>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

/// (1 - exp(-x)) / x, the mean of exp over 0..x; 1 at 0.
double mean_decay(double x) noexcept {
  return x > 0.0 ? -std::expm1(-x) / x : 1.0;
}

}  // namespace

Relaxation::Relaxation(std::vector<RelaxationArm> arms) : arms_(std::move(arms)), arm_force_uN_(arms_.size(), 0.0) {
  for (const RelaxationArm& arm : arms_) {
    if (!(arm.fraction > 0.0 && arm.time_s > 0.0 && std::isfinite(arm.time_s))) {
      throw UsageError("relaxation: an arm's fraction and time must be above 0");
    }
    spring_fraction_ -= arm.fraction;
  }
  if (!(spring_fraction_ > 0.0)) throw UsageError("relaxation: the arms' fractions must sum up to less than 1");
}

void Relaxation::start(double time_s, double elastic_uN) noexcept {
  for (double& force : arm_force_uN_) force = 0.0;
  elastic_uN_ = elastic_uN;
  time_s_ = time_s;
  started_ = true;
}

void Relaxation::reset() noexcept {
  start(0.0);
  started_ = false;
}

double Relaxation::advance(double time_s, double elastic_uN) noexcept {
  if (!started_) start(time_s);
  const double dt_s = time_s > time_s_ ? time_s - time_s_ : 0.0;
  const double rise_uN = elastic_uN - elastic_uN_;
  for (std::size_t k = 0; k < arms_.size(); ++k) {
    const double x = dt_s / arms_[k].time_s;
    arm_force_uN_[k] = arm_force_uN_[k] * std::exp(-x) + arms_[k].fraction * rise_uN * mean_decay(x);
  }
  elastic_uN_ = elastic_uN;
  time_s_ += dt_s;
  return force_uN();
}

double Relaxation::force_uN() const noexcept {
  double force = spring_fraction_ * elastic_uN_;
  for (const double arm : arm_force_uN_) force += arm;
  return force;
}

double Relaxation::rate_uN_per_s() const noexcept {
  double rate = 0.0;
  for (std::size_t k = 0; k < arms_.size(); ++k) rate -= arm_force_uN_[k] / arms_[k].time_s;
  return rate;
}

double Relaxation::storage_ratio(double omega_per_s) const noexcept {
  double ratio = 1.0;
  for (const RelaxationArm& arm : arms_) {
    const double x = omega_per_s * arm.time_s;
    ratio -= arm.fraction / (1.0 + x * x);
  }
  return ratio;
}

double Relaxation::loss_s(double omega_per_s) const noexcept {
  double loss = 0.0;
  for (const RelaxationArm& arm : arms_) {
    const double x = omega_per_s * arm.time_s;
    loss += arm.fraction * arm.time_s / (1.0 + x * x);
  }
  return loss;
}

double Relaxation::modulus_ratio(double time_s) const noexcept {
  double ratio = spring_fraction_;
  for (const RelaxationArm& arm : arms_) ratio += arm.fraction * std::exp(-time_s / arm.time_s);
  return ratio;
}

double Relaxation::ramp_ratio(double ramp_s) const noexcept {
  double ratio = spring_fraction_;
  for (const RelaxationArm& arm : arms_) ratio += arm.fraction * mean_decay(ramp_s / arm.time_s);
  return ratio;
}

}  // namespace pellucida
