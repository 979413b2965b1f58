#include "pellucida/simulation/SpecimenContact.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace pellucida {
namespace {

constexpr double kCubicMicrometresPerPicolitre = 1000.0;

}  // namespace

double Droplet::radius_um() const noexcept {
  return std::cbrt(3 * kCubicMicrometresPerPicolitre * volume_pL / (4 * std::numbers::pi));
}

double puncture_share(std::uint64_t seed, double spread_ratio) {
  if (spread_ratio <= 0) return 1.0;
  std::seed_seq words{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), 0x70756e63U};
  std::mt19937_64 random(words);
  // 53 bits of it, the same on every machine.
  return 1.0 - spread_ratio * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

SpecimenContact::SpecimenContact(const SpecimenForce& force, const Scenario& scenario)
    : force_(force),
      enabled_(scenario.puncture.enabled),
      residual_um_(scenario.puncture.residual_um),
      relaxation_s_(scenario.puncture.relaxation_s) {
  const double offset_um = scenario.tools.configuration == 4 ? 10.0 * scenario.cell.size_scale : 0.0;
  const auto nominal = force.at(force.tip_at(offset_um, scenario.puncture.indentation_um));
  bears_uN_ = puncture_share(scenario.seed, scenario.puncture.spread_ratio) * nominal.axial_force_uN;
}

void SpecimenContact::reset() noexcept {
  moment_ = {};
  started_ = false;
  last_axial_uN_ = 0.0;
}

const SpecimenMoment& SpecimenContact::advance(const PlainVector3& tip_um, double time_s, double expelled_pL) noexcept {
  SpecimenMoment& now = moment_;
  const double before_s = started_ ? now.time_s : time_s;
  now.tip_um = tip_um;
  now.time_s = time_s;
  now.reply = force_.at(tip_um);
  SpecimenReply& reply = now.reply;
  const double axial_uN = reply.axial_force_uN;

  // Has the membrane given way, or the needle left it?
  const bool whole = now.puncture_time_s < 0;
  const double away_um = std::hypot(reply.offset_um, reply.out_of_plane_um);
  const bool at_end = reply.depth_um > force_.max_indentation_um() + 1e-6 && away_um <= force_.max_offset_um();
  if (enabled_ && whole && reply.depth_um > 0 && (axial_uN >= bears_uN_ || (at_end && bears_uN_ > 0))) {
    // At the moment the force passed, between the last call and this one.
    const double rise = axial_uN - last_axial_uN_;
    const double left = rise > 0 ? std::clamp((axial_uN - bears_uN_) / rise, 0.0, 1.0) : 0.0;
    now.puncture_time_s = time_s - left * (time_s - before_s);
    now.puncture_force_uN = std::min(axial_uN, bears_uN_);
    now.puncture_depth_um = std::min(reply.depth_um, force_.max_indentation_um());
    if (reply.stiffness_uN_per_um > 0)
      now.puncture_depth_um = std::min(
          now.puncture_depth_um, reply.depth_um - std::max(0.0, axial_uN - bears_uN_) / reply.stiffness_uN_per_um);
    ++now.puncture_count;
  }
  if (reply.depth_um <= 0) now.puncture_time_s = -1.0;
  last_axial_uN_ = axial_uN;
  started_ = true;

  now.pressure_depth_um = 0.0;
  if (now.puncture_time_s >= 0) {
    const double decay = std::exp(-(time_s - now.puncture_time_s) / relaxation_s_);
    const double relaxed_um = residual_um_ + (now.puncture_depth_um - residual_um_) * decay;
    now.state = CellState::kPunctured;
    reply.indentation_um = std::clamp(reply.depth_um, 0.0, std::max(0.0, relaxed_um));
    reply.in_range = away_um <= force_.max_offset_um();
    reply.force_uN = {};
    reply.axial_force_uN = reply.lateral_force_uN = reply.energy_uN_um = reply.stiffness_uN_per_um = 0.0;
  } else {
    now.state = reply.indentation_um > 0 ? CellState::kContact : CellState::kFree;
    now.pressure_depth_um = reply.indentation_um;
  }
  if (expelled_pL > expelled_pL_) expel(expelled_pL - expelled_pL_);
  expelled_pL_ = std::max(expelled_pL_, expelled_pL);
  return now;
}

// Into the newest droplet while the tip is in or at it, into a new one elsewhere in the cell.
void SpecimenContact::expel(double volume_pL) noexcept {
  SpecimenMoment& now = moment_;
  const bool inside = now.state == CellState::kPunctured && now.reply.depth_um > now.reply.indentation_um;
  const Eigen::Vector3d tip = now.tip_um.eigen();
  if (inside && now.droplet_count > 0) {
    Droplet& newest = now.droplets[static_cast<std::size_t>(now.droplet_count - 1)];
    if ((tip - newest.center_um.eigen()).norm() <= newest.radius_um() + 2.0) {
      newest.volume_pL += volume_pL;
      now.deposited_pL += volume_pL;
      return;
    }
  }
  if (!inside || now.droplet_count == SpecimenMoment::kMaxDroplets) {
    now.lost_pL += volume_pL;
    return;
  }
  now.droplets[static_cast<std::size_t>(now.droplet_count++)] = {now.tip_um, volume_pL};
  now.deposited_pL += volume_pL;
}

}  // namespace pellucida
