#include "RelaxingContact.h"

#include <algorithm>
#include <numbers>

namespace pellucida {
namespace {

/// How far what has relaxed differs between eight pushes on one oocyte: standard deviation over mean of 1 - G, at 1 s
/// (0.05) to 30 s (0.065). Between cells it isn't known.
constexpr double kSpread_ratio = 0.065;

}  // namespace

RelaxingContact::RelaxingContact(const CellProfile& profile, double hand_frequency_Hz)
    : relaxation_(profile.relaxation_arms) {
  if (profile.relaxation_arms.empty()) return;
  const double omega_per_s = 2.0 * std::numbers::pi * hand_frequency_Hz;
  elastic_ratio_ = profile.relaxation_elastic_ratio;
  storage_ratio_ = relaxation_.storage_ratio(omega_per_s);
  loss_s_ = relaxation_.loss_s(omega_per_s);
}

RelaxingContact::Force RelaxingContact::advance(double time_s, double force_uN, double stiffness_uN_per_um) noexcept {
  if (relaxation_.arms().empty()) {
    return {.force_uN = force_uN, .stiffness_uN_per_um = stiffness_uN_per_um, .relaxed_uN = force_uN};
  }
  const double elastic_uN = elastic_ratio_ * force_uN;
  Force force;
  force.force_uN = std::max(0.0, relaxation_.advance(time_s, elastic_uN));
  force.ratio = force_uN > 0.0 ? force.force_uN / force_uN : 0.0;
  force.stiffness_uN_per_um = storage_ratio_ * elastic_ratio_ * stiffness_uN_per_um;
  force.damping_uN_s_per_um = loss_s_ * elastic_ratio_ * stiffness_uN_per_um;
  force.rate_uN_per_s = relaxation_.rate_uN_per_s();
  force.relaxed_uN = relaxation_.relaxed_uN();
  force.sigma_uN = kSpread_ratio * std::max(0.0, elastic_uN - force.force_uN);
  return force;
}

}  // namespace pellucida
