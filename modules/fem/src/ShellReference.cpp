#include "pellucida/fem/ShellReference.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "pellucida/core/Error.h"
#include "pellucida/fem/GradedSphereMesh.h"
#include "pellucida/fem/NeoHookeanTerm.h"
#include "pellucida/mechanics/AttachmentTerm.h"
#include "pellucida/mechanics/HingeTerm.h"
#include "pellucida/mechanics/VolumeTerm.h"

namespace pellucida {
namespace {

constexpr double kPi = std::numbers::pi;

/// No solution goes farther, in terms of the radius; a step that fails is halved down to the shortest.
constexpr double kLongestStep = 0.04;
constexpr double kShortestStep = 0.0005;
/// The tip may go so many radii.
constexpr double kDeepest = 1.4;

void require(bool holds, const std::string& message) {
  if (!holds) throw UsageError("shell reference: " + message);
}

void check(const ShellSpecimen& specimen, const ShellContact& contact, const ShellOptions& options) {
  const double radius = specimen.mid_radius_um, outer = radius + 0.5 * specimen.thickness_um;
  require(radius > 0.0, "the radius must be above 0 um");
  require(specimen.thickness_um >= 0.01 * radius && specimen.thickness_um <= 0.4 * radius,
          "the thickness must be between 0.01 and 0.4 of the radius");
  require(specimen.young_modulus_kPa > 0.0, "Young's modulus must be above 0 kPa");
  require(specimen.poisson_ratio > 0.0 && specimen.poisson_ratio <= 0.5, "Poisson's ratio must be above 0, up to 0.5");
  require(specimen.bulk_modulus_ratio > 0.0, "the liquid's bulk modulus must be above 0");
  require(contact.tip_radius_um > 0.0 && contact.tip_radius_um < 0.5 * radius,
          "the tip's radius must be above 0 and below half the cell's");
  require(contact.tip_bond_per_um > 0.0 && contact.holder_bond_per_um > 0.0, "both bonds must be above 0");
  require(contact.holder_half_width_um > 0.0 && contact.holder_ring_um >= 0.0, "the holder's ring must have a width");
  require(contact.holder_ring_um + contact.holder_half_width_um < outer, "the holder's ring must fit on the cell");
  require(contact.holder_angle_rad >= 0.0 && contact.holder_angle_rad <= 0.5 * kPi,
          "the holder's angle must be between 0 and 90 degrees");
  require(options.edge_length_ratio >= 0.2 && options.edge_length_ratio <= 3.0,
          "the edge length ratio must be between 0.2 and 3");
  require(options.max_iterations > 0, "an equilibrium takes at least one iteration");

  // Tool against tool, along the sphere.
  require(std::abs(contact.lateral_offset_um) < 0.8 * outer, "the needle must meet the cell: offset below 0.8 radii");
  const double tip_angle = std::asin(contact.lateral_offset_um / outer);
  const double between = kPi - contact.holder_angle_rad - tip_angle;
  const double reach = std::asin((contact.holder_ring_um + contact.holder_half_width_um) / outer) +
                       2.0 * std::asin(std::min(1.0, 0.5 * contact.tip_radius_um / outer));
  require(std::min(between, 2.0 * kPi - between) > reach,
          "tip and holder bear on the same place; turn the holder away");
}

/// A radius on the outer surface, brought to the middle surface along the normal; areas shrink by the ratio's square.
double mid_over_outer(const ShellSpecimen& specimen) {
  return specimen.mid_radius_um / (specimen.mid_radius_um + 0.5 * specimen.thickness_um);
}

Eigen::Vector3d contact_direction(const ShellSpecimen& specimen, const ShellContact& contact) {
  const double sine = contact.lateral_offset_um / (specimen.mid_radius_um + 0.5 * specimen.thickness_um);
  return {sine, 0.0, std::sqrt(1.0 - sine * sine)};
}

Eigen::Vector3d holder_direction(const ShellContact& contact) {
  return {std::sin(contact.holder_angle_rad), 0.0, -std::cos(contact.holder_angle_rad)};
}

double young_modulus_uN_per_um2(const ShellSpecimen& specimen) {
  return 1e-3 * specimen.young_modulus_kPa;
}

/// Fine under the tip and at the holder's ring, growing by 13 % of the way from there; elsewhere short against the
/// shell's bending length sqrt(R h).
GradedSphere make_mesh(const ShellSpecimen& specimen, const ShellContact& contact, const ShellOptions& options) {
  constexpr double kGrowth = 0.131;
  const double radius = specimen.mid_radius_um, ratio = mid_over_outer(specimen);
  const Eigen::Vector3d tip = contact_direction(specimen, contact), holder = holder_direction(contact);
  const double tip_reach = ratio * contact.tip_radius_um, tip_edge = 0.275 * tip_reach;
  const double ring_reach =
      radius * std::asin(ratio * (contact.holder_ring_um + contact.holder_half_width_um) / radius);
  const double ring_edge = 0.72 * ratio * contact.holder_half_width_um;
  const double body_edge = std::min(0.45 * std::sqrt(radius * specimen.thickness_um), 0.2 * radius);
  const auto arc = [radius](const Eigen::Vector3d& p, const Eigen::Vector3d& direction) {
    return radius * std::atan2(p.cross(direction).norm(), p.dot(direction));
  };
  const auto edge_length = [&](const Eigen::Vector3d& p) {
    const double near_tip = tip_edge + kGrowth * std::max(0.0, arc(p, tip) - tip_reach);
    const double near_ring = ring_edge + kGrowth * std::max(0.0, arc(p, holder) - ring_reach);
    return options.edge_length_ratio * std::min({body_edge, near_tip, near_ring});
  };
  return make_graded_sphere_mesh(radius, std::atan2(tip.x(), tip.z()), edge_length);
}

}  // namespace

ShellContact contact_for_configuration(int configuration, double offset_um) {
  ShellContact contact;
  switch (configuration) {
    case 1:
      return contact;
    case 2:
      contact.holder_angle_rad = 0.25 * kPi;
      return contact;
    case 3:
      contact.holder_angle_rad = 0.5 * kPi;
      return contact;
    case 4:
      contact.lateral_offset_um = offset_um;
      return contact;
    default:
      throw UsageError("configuration " + std::to_string(configuration) + ": give 1, 2, 3 or 4");
  }
}

std::string_view to_string(ShellOutcome outcome) noexcept {
  switch (outcome) {
    case ShellOutcome::kComplete:
      return "complete";
    case ShellOutcome::kCancelled:
      return "cancelled";
    case ShellOutcome::kNotConverged:
      return "not converged";
  }
  return "unknown";
}

class ShellReference::Impl {
 public:
  Impl(const ShellSpecimen& specimen, const ShellContact& contact, const ShellOptions& options)
      : specimen_(specimen),
        contact_(contact),
        sphere_(make_mesh(specimen, contact, options)),
        membrane_(sphere_.mesh, young_modulus_uN_per_um2(specimen), specimen.poisson_ratio, specimen.thickness_um),
        hinges_(sphere_.mesh, triangle_pairs(sphere_.mesh.triangles), rigidity()),
        volume_(sphere_.mesh, young_modulus_uN_per_um2(specimen) * specimen.bulk_modulus_ratio),
        tip_(sphere_.mesh.points_um, tip_weights()),
        holder_(sphere_.mesh.points_um, holder_weights()),
        energy_(static_cast<int>(sphere_.mesh.points_um.cols()),
                young_modulus_uN_per_um2(specimen) * specimen.thickness_um) {
    options_.max_iterations = options.max_iterations;
    energy_.add_term(membrane_);
    energy_.add_term(hinges_);
    energy_.add_term(volume_);
    energy_.add_term(tip_);
    energy_.add_term(holder_);
    solver_ = std::make_unique<EquilibriumSolver>(energy_);

    // How the gradient changes with the tip's way: through its bond alone.
    pull_ = Eigen::Matrix3Xd::Zero(3, sphere_.mesh.points_um.cols());
    for (std::size_t k = 0; k < tip_.nodes().size(); ++k) pull_(2, tip_.nodes()[k]) = -tip_.weights_uN_per_um()[k];
  }

  const ShellSpecimen& specimen() const noexcept { return specimen_; }
  const ShellContact& contact() const noexcept { return contact_; }
  const GradedSphere& sphere() const noexcept { return sphere_; }

  ShellCurve run(double max_um, double step_um, const std::function<void(const ShellStep&, double)>& progress,
                 const std::stop_token& cancel) {
    require(step_um > 0.0 && step_um <= max_um, "the step must be above 0 um and at most the largest indentation");
    require(max_um <= kDeepest * specimen_.mid_radius_um,
            "the indentation may be at most 1.4 radii, " + std::to_string(kDeepest * specimen_.mid_radius_um) + " um");
    x_um_ = sphere_.mesh.points_um;
    tangent_ = Eigen::Matrix3Xd::Zero(3, x_um_.cols());
    depth_um_ = 0.0;
    tip_.set_displacement(Eigen::Vector3d::Zero());

    // 0, step, 2 step, ... and what is left of the way.
    ShellCurve curve;
    std::vector<double> depths;
    for (int k = 0; k * step_um < max_um - 1e-9 * step_um; ++k) depths.push_back(k * step_um);
    depths.push_back(max_um);
    for (const double depth : depths) {
      SolveReport report;
      curve.outcome = advance_to(depth, cancel, report);
      if (curve.outcome != ShellOutcome::kComplete) {
        if (curve.outcome == ShellOutcome::kNotConverged) curve.failed_indentation_um = depth;
        curve.failure = report;
        return curve;
      }
      curve.steps.push_back(read_out(report));
      if (progress) progress(curve.steps.back(), depth / max_um);
    }
    return curve;
  }

 private:
  Eigen::VectorXd rigidity() const {
    const double nu = specimen_.poisson_ratio;
    const double d =
        young_modulus_uN_per_um2(specimen_) * std::pow(specimen_.thickness_um, 3) / (12.0 * (1.0 - nu * nu));
    return Eigen::VectorXd::Constant(sphere_.mesh.points_um.cols(), d);
  }

  Eigen::VectorXd tip_weights() const {
    const double ratio = mid_over_outer(specimen_);
    return tip_weights_uN_per_um(sphere_.mesh, contact_direction(specimen_, contact_), ratio * contact_.tip_radius_um,
                                 young_modulus_uN_per_um2(specimen_) * contact_.tip_bond_per_um / (ratio * ratio));
  }

  Eigen::VectorXd holder_weights() const {
    const double ratio = mid_over_outer(specimen_);
    return holder_weights_uN_per_um(
        sphere_.mesh, holder_direction(contact_), ratio * contact_.holder_ring_um,
        ratio * contact_.holder_half_width_um,
        young_modulus_uN_per_um2(specimen_) * contact_.holder_bond_per_um / (ratio * ratio));
  }

  /// Goes to a depth in steps that converge. The shape is the last equilibrium found, whatever the outcome.
  ShellOutcome advance_to(double depth_um, const std::stop_token& cancel, SolveReport& total) {
    double longest = kLongestStep * specimen_.mid_radius_um;
    do {
      if (cancel.stop_requested()) return ShellOutcome::kCancelled;
      const double way = std::min(longest, depth_um - depth_um_);
      const double next = way < depth_um - depth_um_ ? depth_um_ + way : depth_um;
      Eigen::Matrix3Xd x = x_um_ + (next - depth_um_) * tangent_;
      tip_.set_displacement({0.0, 0.0, -next});
      const SolveReport report = solver_->solve(x, options_);
      total.status = report.status;
      total.iterations += report.iterations;
      total.factorizations += report.factorizations;
      total.shifts += report.shifts;
      total.residual_uN = report.residual_uN;
      if (report.status == SolveStatus::kConverged) {
        x_um_ = x;
        depth_um_ = next;
        tangent_ = solver_->apply_inverse_hessian(x_um_, pull_, tangent_);
      } else {
        tip_.set_displacement({0.0, 0.0, -depth_um_});
        longest = 0.5 * way;
        if (longest < kShortestStep * specimen_.mid_radius_um) return ShellOutcome::kNotConverged;
      }
    } while (depth_um_ < depth_um);
    return ShellOutcome::kComplete;
  }

  ShellStep read_out(const SolveReport& report) const {
    ShellStep step;
    step.indentation_um = depth_um_;
    step.tip_force_uN = tip_.force_uN(x_um_);
    step.holder_force_uN = holder_.force_uN(x_um_);
    step.axial_force_uN = -step.tip_force_uN.z() + 0.0;  // no -0
    step.lateral_force_uN = step.tip_force_uN.x();
    step.pressure_kPa = 1e3 * volume_.pressure_uN_per_um2(x_um_) + 0.0;
    step.volume_change_ratio = volume_.volume_um3(x_um_) / volume_.rest_volume_um3() - 1.0;
    step.energy_uN_um = energy_.add(x_um_, nullptr, nullptr);
    step.largest_stretch = membrane_.principal_stretches(x_um_).row(0).maxCoeff();
    step.nodes_um = x_um_;
    step.report = report;
    return step;
  }

  ShellSpecimen specimen_;
  ShellContact contact_;
  GradedSphere sphere_;
  NeoHookeanTerm membrane_;
  HingeTerm hinges_;
  VolumeTerm volume_;
  AttachmentTerm tip_, holder_;
  EnergySum energy_;
  std::unique_ptr<EquilibriumSolver> solver_;
  SolveOptions options_;
  Eigen::Matrix3Xd pull_, x_um_, tangent_;
  double depth_um_ = 0.0;
};

ShellReference::ShellReference(const ShellSpecimen& specimen, const ShellContact& contact,
                               const ShellOptions& options) {
  check(specimen, contact, options);
  impl_ = std::make_unique<Impl>(specimen, contact, options);
}
ShellReference::~ShellReference() = default;
ShellReference::ShellReference(ShellReference&&) noexcept = default;
ShellReference& ShellReference::operator=(ShellReference&&) noexcept = default;

const ShellSpecimen& ShellReference::specimen() const noexcept {
  return impl_->specimen();
}
const ShellContact& ShellReference::contact() const noexcept {
  return impl_->contact();
}
const TriangleMesh& ShellReference::rest() const noexcept {
  return impl_->sphere().mesh;
}

ShellCurve ShellReference::run(double max_indentation_um, double step_um,
                               const std::function<void(const ShellStep&, double)>& progress,
                               const std::stop_token& cancel) {
  return impl_->run(max_indentation_um, step_um, progress, cancel);
}

ShellSection ShellReference::section(const ShellStep& step) const {
  // The section's nodes run from the contact point round through +x; the output starts just after -z, with the angle.
  const int count = impl_->sphere().meridian_count;
  const Eigen::Matrix3Xd& rest = impl_->sphere().mesh.points_um;
  std::vector<std::pair<double, int>> order;
  for (int n = 0; n < count; ++n) order.emplace_back(std::atan2(rest(0, n), rest(2, n)), n);
  for (auto& [angle, node] : order) {
    if (angle >= kPi) angle -= 2.0 * kPi;
  }
  std::sort(order.begin(), order.end());

  ShellSection section;
  section.rest_angle_rad.resize(count);
  section.mid_um.resize(2, count);
  for (int k = 0; k < count; ++k) {
    const auto& [angle, node] = order[static_cast<std::size_t>(k)];
    section.rest_angle_rad[k] = angle;
    section.mid_um.col(k) << step.nodes_um(0, node), step.nodes_um(2, node);
  }
  section.outer_um.resize(2, count);
  section.inner_um.resize(2, count);
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector2d tangent = section.mid_um.col((k + 1) % count) - section.mid_um.col((k + count - 1) % count);
    const Eigen::Vector2d outward = Eigen::Vector2d(-tangent.y(), tangent.x()).normalized();
    section.outer_um.col(k) = section.mid_um.col(k) + 0.5 * impl_->specimen().thickness_um * outward;
    section.inner_um.col(k) = section.mid_um.col(k) - 0.5 * impl_->specimen().thickness_um * outward;
  }
  return section;
}

}  // namespace pellucida
