#include "pellucida/fem/AspirationReference.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "AxisymmetricMesh.h"
#include "SolidTerms.h"
#include "pellucida/core/Error.h"
#include "pellucida/membrane/AttachmentTerm.h"
#include "pellucida/membrane/EquilibriumSolver.h"

namespace pellucida {
namespace {

/// Young's modulus of the computation, uN/um^2: the results are ratios to it.
constexpr double kModulus = 1.0;
/// Lame's lambda over mu, and the liquid's bulk modulus over E, that count as incompressible.
constexpr double kSolidLambda = 2000.0, kLiquidRatio = 500.0;
/// Of the springs that keep the axis, in terms of E h.
constexpr double kKeptAxis = 1e4;
/// Density of the lip's bond, in terms of E, times the mouth's radius: the lip hardly gives.
constexpr double kLipBond = 300.0;
/// Elements: shortest, at the lip, over the mouth's radius; over the thickness at most; how they grow from there.
constexpr double kLipEdge = 0.06, kThicknessEdge = 0.5, kGrowth = 0.13;
/// Elements through the thickness: so many for a thickness of the mouth's radius, within limits.
constexpr double kAcrossPerRadius = 5.0;
/// Steps of the tongue, over the mouth's radius: aimed at; the smallest that is tried.
constexpr double kTongueStep = 0.08, kLeastStep_ratio = 1e-4;
constexpr double kPhi = 2.1;

void require(bool holds, const std::string& text) {
  if (!holds) throw UsageError("aspiration: " + text);
}

void check_shell(const AspiratedShell& shell) {
  const double radius_um = shell.outer_radius_um;
  require(std::isfinite(radius_um) && radius_um > 0.0, "the cell's outer radius must be above 0 um");
  require(shell.thickness_um >= 0.01 * radius_um && shell.thickness_um <= 0.95 * radius_um,
          "the thickness must be 0.01 to 0.95 of the outer radius");
  require(shell.mouth_radius_um > 0.0 && shell.mouth_radius_um <= 0.6 * radius_um,
          "the mouth's radius must be above 0 and at most 0.6 of the cell's");
  require(shell.lip_width_um > 0.0 && shell.mouth_radius_um + shell.lip_width_um <= 0.9 * radius_um,
          "mouth and lip together must be narrower than 0.9 of the cell's radius");
}

double lip_angle_rad(const AspiratedShell& shell) {
  return std::asin(shell.mouth_radius_um / shell.outer_radius_um);
}

/// Meshes the shell with an element's corner at the lip.
AxisymmetricMesh aspirated_mesh(const AspiratedShell& shell, double edge_length_ratio, int& lip_corner) {
  const double mid_um = shell.outer_radius_um - 0.5 * shell.thickness_um, lip_rad = lip_angle_rad(shell);
  const auto length_um = [&](double angle_rad) {
    const double away_um = std::abs(angle_rad - lip_rad) * mid_um;
    const double fine_um = std::min(kLipEdge * shell.mouth_radius_um, kThicknessEdge * shell.thickness_um);
    return edge_length_ratio * std::min(fine_um + kGrowth * away_um, 0.15 * mid_um);
  };
  // How many elements lie on either side, made whole numbers by a factor on their lengths.
  const auto count_between = [&](double from_rad, double to_rad) {
    constexpr int kParts = 4000;
    double count = 0.0;
    for (int k = 0; k < kParts; ++k) {
      count += mid_um * (to_rad - from_rad) / kParts / length_um(from_rad + (to_rad - from_rad) * (k + 0.5) / kParts);
    }
    return count;
  };
  const double inside = count_between(0.0, lip_rad), outside = count_between(lip_rad, std::numbers::pi);
  const double whole_inside = std::max(4.0, std::round(inside)), whole_outside = std::max(4.0, std::round(outside));
  lip_corner = static_cast<int>(whole_inside);
  const int across =
      std::clamp(static_cast<int>(std::lround(kAcrossPerRadius * shell.thickness_um / shell.mouth_radius_um)), 2, 10);
  return make_axisymmetric_mesh(
      mid_um, shell.thickness_um,
      [&](double angle_rad) {
        return length_um(angle_rad) * (angle_rad < lip_rad ? inside / whole_inside : outside / whole_outside);
      },
      across);
}

/// The bond's density, integrated over the lip with a hat function at each node of the outer surface.
Eigen::VectorXd lip_weights(const AxisymmetricMesh& mesh, const AspiratedShell& shell, int lip_corner) {
  constexpr int kParts = 20;
  const double density = kModulus * kLipBond / shell.mouth_radius_um;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(mesh.points_um.cols());
  for (auto k = static_cast<std::size_t>(2 * lip_corner); k + 1 < mesh.outer.size(); ++k) {
    const Eigen::Vector3d a = mesh.points_um.col(mesh.outer[k]), b = mesh.points_um.col(mesh.outer[k + 1]);
    for (int part = 0; part < kParts; ++part) {
      const double share = (part + 0.5) / kParts;
      const Eigen::Vector3d p = (1.0 - share) * a + share * b;
      if (p.z() < 0.0 || p.x() > shell.mouth_radius_um + shell.lip_width_um) continue;
      const double amount = density * 2.0 * std::numbers::pi * p.x() * (b - a).norm() / kParts;
      weights[mesh.outer[k]] += (1.0 - share) * amount;
      weights[mesh.outer[k + 1]] += share * amount;
    }
  }
  return weights;
}

std::vector<int> first_nodes(const std::vector<int>& nodes, int count) {
  return {nodes.begin(), nodes.begin() + count};
}

}  // namespace

class AspirationReference::Impl {
 public:
  Impl(const AspiratedShell& shell, double edge_length_ratio)
      : shell_(shell),
        mesh_(aspirated_mesh(shell, edge_length_ratio, lip_corner_)),
        solid_(mesh_, kModulus / 3.0, kSolidLambda * kModulus / 3.0),
        liquid_(mesh_.points_um, mesh_.inner, kLiquidRatio * kModulus),
        axis_(static_cast<int>(mesh_.points_um.cols()), mesh_.axis, kKeptAxis * kModulus * shell.thickness_um),
        lip_(mesh_.points_um, lip_weights(mesh_, shell, lip_corner_)),
        suction_(first_nodes(mesh_.outer, 2 * lip_corner_ + 1)),
        energy_(static_cast<int>(mesh_.points_um.cols()), kModulus * shell.thickness_um) {
    for (EnergyTerm* term : std::initializer_list<EnergyTerm*>{&solid_, &liquid_, &axis_, &lip_, &suction_}) {
      energy_.add_term(*term);
    }
    solver_ = std::make_unique<EquilibriumSolver>(energy_);
    mouth_z_um_ = mesh_.points_um(2, mesh_.outer[static_cast<std::size_t>(2 * lip_corner_)]);
  }

  double tongue_um(const Eigen::Matrix3Xd& x_um) const { return x_um(2, mesh_.outer.front()) - mouth_z_um_; }
  double rest_tongue_um() const { return tongue_um(mesh_.points_um); }

  AspirationCurve run(double wanted_um, double greatest_ratio) {
    require(wanted_um > rest_tongue_um(),
            "the tongue must be longer than the cap of the cell at rest, " + std::to_string(rest_tongue_um()) + " um");
    AspirationCurve curve;
    Eigen::Matrix3Xd x = mesh_.points_um, before = x;
    AspirationStep at{0.0, rest_tongue_um()}, last = at;
    curve.steps.push_back(at);
    const double aimed_um = kTongueStep * shell_.mouth_radius_um;
    double step = 0.02;
    while (at.tongue_um < wanted_um - 1e-4 * shell_.mouth_radius_um) {
      const double slope = curve.steps.size() > 1 && at.tongue_um > last.tongue_um
                               ? (at.suction_ratio - last.suction_ratio) / (at.tongue_um - last.tongue_um)
                               : 0.0;
      if (slope > 0.0) step = std::min(2.0 * step, slope * std::min(aimed_um, wanted_um - at.tongue_um));
      if (at.suction_ratio >= greatest_ratio) break;
      std::optional<Eigen::Matrix3Xd> next;
      for (; !next; step *= 0.5) {
        if (step < kLeastStep_ratio * std::max(at.suction_ratio, 0.01)) {
          curve.outcome = CurveOutcome::kNotConverged;
          return curve;
        }
        const double along =
            at.suction_ratio > last.suction_ratio ? step / (at.suction_ratio - last.suction_ratio) : 0.0;
        next = solve_at(at.suction_ratio + step, x + along * (x - before));
        if (!next && along > 0.0) next = solve_at(at.suction_ratio + step, x);
        if (next && tongue_um(*next) > wanted_um + 1e-4 * shell_.mouth_radius_um &&
            tongue_um(*next) - at.tongue_um > 2e-4 * shell_.mouth_radius_um) {
          // Beyond: back to it along the chord.
          step *= (wanted_um - at.tongue_um) / (tongue_um(*next) - at.tongue_um);
          next = solve_at(at.suction_ratio + step, x);
        }
        if (next) break;
      }
      before = x;
      x = *next;
      last = at;
      at = {at.suction_ratio + step, tongue_um(x)};
      curve.steps.push_back(at);
    }
    return curve;
  }

 private:
  std::optional<Eigen::Matrix3Xd> solve_at(double ratio, Eigen::Matrix3Xd x_um) {
    suction_.set_pressure(ratio * kModulus);
    SolveOptions options;
    options.max_step_um = 0.2 * shell_.mouth_radius_um;
    if (solver_->solve(x_um, options).status != SolveStatus::kConverged) return std::nullopt;
    return x_um;
  }

  AspiratedShell shell_;
  int lip_corner_ = 0;
  AxisymmetricMesh mesh_;
  SolidTerm solid_;
  RevolvedLiquidTerm liquid_;
  AxisTerm axis_;
  AttachmentTerm lip_;
  SuctionTerm suction_;
  EnergySum energy_;
  std::unique_ptr<EquilibriumSolver> solver_;
  double mouth_z_um_ = 0.0;
};

AspirationReference::AspirationReference(const AspiratedShell& shell, double edge_length_ratio) {
  check_shell(shell);
  require(edge_length_ratio >= 0.3 && edge_length_ratio <= 3.0, "the ratio of edge lengths must be 0.3 to 3");
  impl_ = std::make_unique<Impl>(shell, edge_length_ratio);
}
AspirationReference::~AspirationReference() = default;

double AspirationReference::rest_tongue_um() const noexcept {
  return impl_->rest_tongue_um();
}

AspirationCurve AspirationReference::run(double tongue_um, double greatest_suction_ratio) {
  return impl_->run(tongue_um, greatest_suction_ratio);
}

double half_space_suction_ratio(double tongue_um, double mouth_radius_um) noexcept {
  return 2.0 * std::numbers::pi * tongue_um / (3.0 * kPhi * mouth_radius_um);
}

}  // namespace pellucida
