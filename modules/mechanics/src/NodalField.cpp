#include "NodalField.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pellucida {
namespace {

/// How a tool's force is spread over its patch depends on bond and wall: single nodes differ from a solid's by about
/// this share of their root mean square (docs/method.md, 4.5).
constexpr double kNeedleSpread_ratio = 1.5, kHolderSpread_ratio = 1.0;

/// The tool's force on the membrane's nodes.
Eigen::Matrix3Xd load_of(const AttachmentTerm& tool, const Eigen::Matrix3Xd& x_um) {
  Eigen::Matrix3Xd gradient_uN = Eigen::Matrix3Xd::Zero(3, x_um.cols());
  tool.add(x_um, &gradient_uN, nullptr);
  return -gradient_uN;
}

/// Adds to the variance of the nodes under a tool what its distribution leaves open.
void add_spread(const AttachmentTerm& tool, const Eigen::Matrix3Xd& load_uN, double spread_ratio,
                Eigen::VectorXd& variance_uN2) {
  if (tool.nodes().empty()) return;
  const double mean_square_uN2 = load_uN.squaredNorm() / static_cast<double>(tool.nodes().size());
  for (const int node : tool.nodes()) variance_uN2[node] += spread_ratio * spread_ratio * mean_square_uN2;
}

/// What the springs' tension lacks of a solid's, over the root mean square of their own in a zone, and over the node's
/// own on the free wall (docs/method.md, 4.5). The zones are those of section 4.5: under and about the tip, the
/// dimple's flank, the holder's ring and a node's distance about it.
constexpr double kTipTension_ratio = 4.5, kFlankTension_ratio = 1.5, kHolderTension_ratio = 4.0,
                 kFreeTension_ratio = 0.12;
constexpr double kFlank_rad = 1.0, kBesideHolder_rad = 0.18;

Eigen::VectorXd tension_sigmas(const MembraneModel& model, const Eigen::VectorXd& tension, double relative) {
  enum Zone : std::uint8_t { kTip, kFlank, kHolder, kFree, kZones };
  const MembraneSetup& setup = model.setup();
  const CellProfile& profile = model.profile();
  const double radius_um = setup.mid_radius_um, tip_rad = 2.0 * profile.tip_radius_um / radius_um;
  const double holder_rad =
      kBesideHolder_rad + std::asin(std::min(1.0, (profile.holder_ring_um + profile.holder_half_width_um) / radius_um));
  const Eigen::Matrix3Xd& rest = model.rest().points_um;
  std::vector<Zone> zones(static_cast<std::size_t>(rest.cols()));
  std::array<double, kZones> squares{}, counts{};
  for (Eigen::Index i = 0; i < rest.cols(); ++i) {
    const Eigen::Vector3d place = rest.col(i).normalized();
    const double from_needle = std::acos(std::clamp(place.z(), -1.0, 1.0));
    const double from_holder = std::acos(std::clamp(place.dot(setup.holder), -1.0, 1.0));
    Zone zone = from_needle < kFlank_rad ? kFlank : kFree;
    if (from_holder < holder_rad) zone = kHolder;
    if (from_needle < tip_rad) zone = kTip;
    zones[static_cast<std::size_t>(i)] = zone;
    squares[zone] += tension[i] * tension[i];
    counts[zone] += 1.0;
  }
  constexpr std::array kShares{kTipTension_ratio, kFlankTension_ratio, kHolderTension_ratio, kFreeTension_ratio};
  Eigen::VectorXd sigma(tension.size());
  for (Eigen::Index i = 0; i < tension.size(); ++i) {
    const Zone zone = zones[static_cast<std::size_t>(i)];
    const double usual = zone == kFree ? std::abs(tension[i]) : std::sqrt(squares[zone] / counts[zone]);
    sigma[i] = std::hypot(relative * tension[i], kShares[zone] * usual);
  }
  return sigma;
}

/// What the liquid's push on the springs' nodes is multiplied by. A solid's pressure acts on the wall's inner face, the
/// springs carry it on the middle surface. Where the profile has no terms for the pressure it is the springs' own.
double push_ratio(const Indenter& indenter) {
  const double of_pressure = indenter.pressure_ratio();
  if (of_pressure == indenter.force_ratio()) return of_pressure;
  const MembraneSetup& cell = indenter.model().setup();
  const double inner = 1.0 - 0.5 * cell.thickness_um / cell.mid_radius_um;
  return of_pressure * inner * inner;
}

}  // namespace

void fill_nodes(const Indenter& indenter, double scale, double of_liquid_ratio, bool contact, ForceEstimate& estimate) {
  const MembraneModel& model = indenter.model();
  const Eigen::Matrix3Xd& x = indenter.positions_um();
  const double of_tools = scale * indenter.force_ratio(), of_liquid = scale * of_liquid_ratio * push_ratio(indenter);
  // In equilibrium a node's elastic force balances the liquid's push, P grad V, and the tools'.
  const double pressure_uN_per_um2 = model.setup().keeps_volume ? model.volume().pressure_uN_per_um2(x) : 0.0;
  const Eigen::Matrix3Xd liquid_uN = pressure_uN_per_um2 * model.volume().gradient_of_volume(x);
  const Eigen::Matrix3Xd force = of_tools * indenter.elastic_force_uN() + (of_tools - of_liquid) * liquid_uN;
  estimate.force_uN = estimate.rotation_WC * force;
  // A cell that was let go lies at rest, and its bonds where they were last.
  const double borne = contact ? of_tools : 0.0;
  const Eigen::Matrix3Xd needle = borne * load_of(model.tip(), x), holder = borne * load_of(model.holder(), x);
  estimate.needle_force_uN = estimate.rotation_WC * needle;
  estimate.holder_force_uN = estimate.rotation_WC * holder;
  const double relative = estimate.errors.relative();
  Eigen::VectorXd variance_uN2 = relative * relative * force.colwise().squaredNorm().transpose();
  if (contact) {
    variance_uN2 += std::pow(of_tools * estimate.depth_sigma_um, 2) *
                    indenter.elastic_slope_uN_per_um().colwise().squaredNorm().transpose();
    add_spread(model.tip(), needle, kNeedleSpread_ratio, variance_uN2);
    add_spread(model.holder(), holder, kHolderSpread_ratio, variance_uN2);
  }
  estimate.force_sigma_uN = variance_uN2.array().sqrt().matrix();
  const Eigen::VectorXd areas_um2 = node_areas_um2(x, model.rest().triangles);
  const Eigen::VectorXd rest_um2 = node_areas_um2(model.rest().points_um, model.rest().triangles);
  estimate.tension_uN_per_um = of_liquid * model.springs().tension_uN_per_um(x, areas_um2);
  // The depth's error moves the tension as it moves the force.
  const double force_uN = contact ? needle.rowwise().sum().norm() : 0.0;
  const double by_depth = force_uN > 0.0 ? estimate.errors.depth_uN / force_uN : 0.0;
  estimate.tension_sigma_uN_per_um = tension_sigmas(model, estimate.tension_uN_per_um, std::hypot(relative, by_depth));
  estimate.area_strain_percent = 100.0 * (areas_um2.array() / rest_um2.array() - 1.0);
}

double damping_uN_s_per_um(const Indenter& indenter, double connector_damping_uN_s_per_um) {
  const Eigen::Matrix3Xd& velocity = indenter.depth_tangent();
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, velocity.cols());
  indenter.model().springs().add_damping(indenter.positions_um(), velocity, connector_damping_uN_s_per_um, force);
  return -(force.array() * velocity.array()).sum();
}

}  // namespace pellucida
