#include "MotionConstants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pellucida/membrane/MembraneModel.h"

namespace pellucida {
namespace {

constexpr double kWaterDensity_kg_per_um3 = 1e-15;

}  // namespace

MotionConstants motion_constants(const CellProfile& profile) {
  const MembraneModel model(profile, setup_for_configuration(profile, 1));
  const TriangleMesh& rest = model.rest();
  const auto count = static_cast<double>(rest.points_um.cols());
  const double outer_um = profile.mid_radius_um + 0.5 * profile.thickness_um;

  // Stiffness of each connector at rest: A K2 / L^2 along its direction.
  const RegionShares shares = region_shares(rest, profile, model.setup().holder);
  const Eigen::VectorXd k2 =
      model.force_scale_uN_per_um() * (profile.tip.k2_ratio * shares.tip + profile.body.k2_ratio * shares.body +
                                       profile.holder.k2_ratio * shares.holder);
  Eigen::VectorXd at_node = Eigen::VectorXd::Zero(rest.points_um.cols());
  double stiffest = 0.0;
  const auto add = [&](int i, int j, double area_um2) {
    const double length2 = (rest.points_um.col(i) - rest.points_um.col(j)).squaredNorm();
    const double stiffness = 0.5 * (k2[i] + k2[j]) * area_um2 / length2;
    stiffest = std::max(stiffest, stiffness);
    at_node[i] += stiffness;
    at_node[j] += stiffness;
  };
  for (const TrianglePair& pair : triangle_pairs(rest.triangles)) {
    const Eigen::Vector3d a = rest.points_um.col(pair.a), b = rest.points_um.col(pair.b);
    const Eigen::Vector3d c = rest.points_um.col(pair.c), d = rest.points_um.col(pair.d);
    const double area = ((b - a).cross(c - a).norm() + (b - a).cross(d - a).norm()) / 12.0;
    add(pair.a, pair.b, area);
    add(pair.c, pair.d, area);
  }

  MotionConstants constants;
  constants.node_mass_kg = kWaterDensity_kg_per_um3 * 4.0 / 3.0 * std::numbers::pi * std::pow(outer_um, 3) / count;
  constants.damping_uN_s_per_um = 2.0 * std::sqrt(0.5 * stiffest * constants.node_mass_kg);

  at_node *= 2.0;
  for (const AttachmentTerm* tool : {&model.tip(), &model.holder()}) {
    for (std::size_t k = 0; k < tool->nodes().size(); ++k) at_node[tool->nodes()[k]] += tool->weights_uN_per_um()[k];
  }
  const double liquid =
      model.volume().rank_one_factor() * model.volume().gradient_of_volume(rest.points_um).squaredNorm();
  constants.stable_step_s = 2.0 / std::sqrt((at_node.maxCoeff() + liquid) / constants.node_mass_kg);
  return constants;
}

}  // namespace pellucida
