#include "pellucida/membrane/MembraneModel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pellucida/core/Error.h"
#include "pellucida/membrane/SphereMesh.h"

namespace pellucida {
namespace {

/// 1 well inside `angle`, 0 well outside, smooth between (+-20 %), so that a holder that turns a little changes the
/// constants a little.
double belongs(double angle_rad, double border_rad) {
  const double u = std::clamp((1.2 * border_rad - angle_rad) / (0.4 * border_rad), 0.0, 1.0);
  return u * u * (3.0 - 2.0 * u);
}

double angle_between_rad(const Eigen::Vector3d& p, const Eigen::Vector3d& direction) {
  return std::acos(std::clamp(p.normalized().dot(direction), -1.0, 1.0));
}

/// A constant of the profile at each node.
Eigen::VectorXd blend(const TriangleMesh& rest, const CellProfile& profile, const Eigen::Vector3d& holder,
                      double (*value)(const RegionConstants&)) {
  const RegionShares shares = region_shares(rest, profile, holder);
  return value(profile.tip) * shares.tip + value(profile.body) * shares.body + value(profile.holder) * shares.holder;
}

SpringConstants spring_constants(const TriangleMesh& rest, const CellProfile& profile, const MembraneSetup& setup) {
  const double scale = 1e-3 * profile.effective_young_modulus_kPa * setup.thickness_um;
  return {
      scale * blend(rest, profile, setup.holder, [](const RegionConstants& r) { return r.k2_ratio; }),
      scale * blend(rest, profile, setup.holder, [](const RegionConstants& r) { return r.k2_ratio * r.k1_over_k2; })};
}

Eigen::VectorXd hinge_rigidity(const TriangleMesh& rest, const CellProfile& profile, const MembraneSetup& setup) {
  const double e = 1e-3 * profile.effective_young_modulus_kPa;
  const double plate =
      e * std::pow(setup.thickness_um, 3) / (12.0 * (1.0 - profile.poisson_ratio * profile.poisson_ratio));
  return plate * blend(rest, profile, setup.holder, [](const RegionConstants& r) { return r.hinge_ratio; });
}

/// A radius on the outer surface, brought to the middle surface along the normal; areas shrink by the ratio's square.
double mid_over_outer(const MembraneSetup& setup) {
  return setup.mid_radius_um / (setup.mid_radius_um + 0.5 * setup.thickness_um);
}

AttachmentTerm holder_attachment(const TriangleMesh& rest, const CellProfile& profile, const MembraneSetup& setup) {
  const double ratio = mid_over_outer(setup);
  const double density = 1e-3 * profile.effective_young_modulus_kPa * profile.holder_bond_per_um / (ratio * ratio);
  return {rest.points_um, holder_weights_uN_per_um(rest, setup.holder, ratio * profile.holder_ring_um,
                                                   ratio * profile.holder_half_width_um, density)};
}

AttachmentTerm tip_attachment(const TriangleMesh& rest, const CellProfile& profile, const MembraneSetup& setup) {
  const double ratio = mid_over_outer(setup);
  const double density = 1e-3 * profile.effective_young_modulus_kPa * profile.tip_bond_per_um / (ratio * ratio);
  return {rest.points_um,
          tip_weights_uN_per_um(rest, Eigen::Vector3d::UnitZ(), ratio * profile.tip_radius_um, density)};
}

}  // namespace

RegionShares region_shares(const TriangleMesh& rest, const CellProfile& profile, const Eigen::Vector3d& holder) {
  const Eigen::Index count = rest.points_um.cols();
  RegionShares shares{Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::VectorXd(count)};
  for (Eigen::Index n = 0; n < count; ++n) {
    const Eigen::Vector3d p = rest.points_um.col(n);
    const double tip = belongs(angle_between_rad(p, Eigen::Vector3d::UnitZ()), profile.tip_angle_rad);
    const double held = belongs(angle_between_rad(p, holder), profile.holder_angle_rad);
    shares.tip[n] = tip;
    shares.holder[n] = (1.0 - tip) * held;
    shares.body[n] = (1.0 - tip) * (1.0 - held);
  }
  return shares;
}

MembraneSetup setup_for_needle(const CellProfile& profile, double holder_angle_rad, double offset_um) {
  const double outer_radius_um = profile.mid_radius_um + 0.5 * profile.thickness_um;
  if (!(holder_angle_rad >= 0.0 && holder_angle_rad <= 0.5 * std::numbers::pi)) {
    throw UsageError("angle between needle and holder: give 0 to 90 degrees");
  }
  if (!(std::abs(offset_um) < 0.8 * outer_radius_um)) {
    throw UsageError("offset of the needle: it must meet the cell, so give less than 0.8 outer radii, " +
                     std::to_string(0.8 * outer_radius_um) + " um");
  }
  // The contact point is the +z of the frame: seen from there, push and holder both turn by the offset's angle.
  const double turn_rad = std::asin(offset_um / outer_radius_um);
  const double between_rad = std::numbers::pi - holder_angle_rad - turn_rad;
  const double reach_rad =
      std::asin(std::min(1.0, (profile.holder_ring_um + profile.holder_half_width_um) / outer_radius_um)) +
      2.0 * std::asin(std::min(1.0, 0.5 * profile.tip_radius_um / outer_radius_um));
  if (!(std::min(between_rad, 2.0 * std::numbers::pi - between_rad) > reach_rad)) {
    throw UsageError("needle and holder bear on the same place; give a smaller angle or offset");
  }
  const auto turned = [](double angle_rad) { return Eigen::Vector3d(std::sin(angle_rad), 0.0, -std::cos(angle_rad)); };
  return {profile.mid_radius_um, profile.thickness_um, turned(turn_rad), turned(holder_angle_rad + turn_rad)};
}

MembraneSetup setup_for_configuration(const CellProfile& profile, int configuration, double offset_um) {
  switch (configuration) {
    case 1:
      return setup_for_needle(profile, 0.0, 0.0);
    case 2:
      return setup_for_needle(profile, 0.25 * std::numbers::pi, 0.0);
    case 3:
      return setup_for_needle(profile, 0.5 * std::numbers::pi, 0.0);
    case 4:
      return setup_for_needle(profile, 0.0, offset_um);
    default:
      throw UsageError("configuration " + std::to_string(configuration) + ": give 1, 2, 3 or 4");
  }
}

MembraneModel::MembraneModel(const CellProfile& profile, const MembraneSetup& setup)
    : profile_(profile),
      setup_(setup),
      rest_(make_sphere_mesh(setup.mid_radius_um, {profile.mesh_frequency, profile.mesh_grading})),
      pairs_(triangle_pairs(rest_.triangles)),
      springs_(rest_, pairs_, spring_constants(rest_, profile, setup)),
      hinges_(rest_, pairs_, hinge_rigidity(rest_, profile, setup)),
      volume_(rest_, 1e-3 * profile.effective_young_modulus_kPa * profile.volume_stiffness_ratio),
      tip_(tip_attachment(rest_, profile, setup)),
      holder_(holder_attachment(rest_, profile, setup)),
      energy_(static_cast<int>(rest_.points_um.cols()),
              1e-3 * profile.effective_young_modulus_kPa * setup.thickness_um) {
  energy_.add_term(springs_);
  energy_.add_term(hinges_);
  if (setup_.keeps_volume) energy_.add_term(volume_);
  energy_.add_term(tip_);
  energy_.add_term(holder_);
}

void MembraneModel::set_holder(const Eigen::Vector3d& direction) {
  setup_.holder = direction;
  springs_.set_constants(spring_constants(rest_, profile_, setup_));
  hinges_.set_rigidity(hinge_rigidity(rest_, profile_, setup_));
  holder_ = holder_attachment(rest_, profile_, setup_);
  energy_.rebind(holder_);
}

Eigen::Matrix3Xd MembraneModel::elastic_force_uN(const Eigen::Matrix3Xd& x_um) const {
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, x_um.cols());
  springs_.add(x_um, &gradient, nullptr);
  hinges_.add(x_um, &gradient, nullptr);
  return -gradient;
}

Eigen::Matrix3Xd MembraneModel::residual_uN(const Eigen::Matrix3Xd& x_um, const Eigen::Matrix3Xd& elastic_uN) const {
  Eigen::Matrix3Xd gradient = -elastic_uN;
  if (setup_.keeps_volume) volume_.add(x_um, &gradient, nullptr);
  tip_.add(x_um, &gradient, nullptr);
  holder_.add(x_um, &gradient, nullptr);
  return -gradient;
}

}  // namespace pellucida
