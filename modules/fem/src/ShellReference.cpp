#include "pellucida/fem/ShellReference.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "GradedSphereMesh.h"
#include "IndentationPath.h"
#include "NeoHookeanTerm.h"
#include "SpecimenGeometry.h"
#include "pellucida/membrane/AttachmentTerm.h"
#include "pellucida/membrane/HingeTerm.h"
#include "pellucida/membrane/VolumeTerm.h"

namespace pellucida {
namespace {

GradedSphere make_mesh(const ShellSpecimen& specimen, const ShellContact& contact, double edge_length_ratio) {
  const Eigen::Vector3d tip = contact_direction(specimen, contact), holder = holder_direction(contact);
  const auto angle = [](const Eigen::Vector3d& p, const Eigen::Vector3d& direction) {
    return std::atan2(p.cross(direction).norm(), p.dot(direction));
  };
  const auto edge_length = [&](const Eigen::Vector3d& p) {
    return edge_length_ratio * edge_length_um(specimen, contact, angle(p, tip), angle(p, holder));
  };
  return make_graded_sphere_mesh(specimen.mid_radius_um, std::atan2(tip.x(), tip.z()), edge_length);
}

/// A radius on the outer surface, brought to the middle surface along the normal; areas shrink by the ratio's square.
double mid_over_outer(const ShellSpecimen& specimen) {
  return specimen.mid_radius_um / outer_radius_um(specimen);
}

}  // namespace

class ShellReference::Impl {
 public:
  Impl(const ShellSpecimen& specimen, const ShellContact& contact, const ShellOptions& options)
      : specimen_(specimen),
        contact_(contact),
        sphere_(make_mesh(specimen, contact, options.edge_length_ratio)),
        membrane_(sphere_.mesh, young_modulus_uN_per_um2(specimen), specimen.poisson_ratio, specimen.thickness_um),
        hinges_(sphere_.mesh, triangle_pairs(sphere_.mesh.triangles), rigidity()),
        volume_(sphere_.mesh, young_modulus_uN_per_um2(specimen) * specimen.bulk_modulus_ratio),
        tip_(sphere_.mesh.points_um, tip_weights()),
        holder_(sphere_.mesh.points_um, holder_weights()),
        energy_(static_cast<int>(sphere_.mesh.points_um.cols()),
                young_modulus_uN_per_um2(specimen) * specimen.thickness_um) {
    energy_.add_term(membrane_);
    energy_.add_term(hinges_);
    energy_.add_term(volume_);
    energy_.add_term(tip_);
    energy_.add_term(holder_);
    path_ = std::make_unique<IndentationPath>(energy_, tip_, sphere_.mesh.points_um, specimen.mid_radius_um,
                                              options.max_iterations);
  }

  const ShellSpecimen& specimen() const noexcept { return specimen_; }
  const ShellContact& contact() const noexcept { return contact_; }
  const GradedSphere& sphere() const noexcept { return sphere_; }

  ShellCurve run(double max_um, double step_um, const std::function<void(const ShellStep&, double)>& progress,
                 const std::stop_token& cancel) {
    ShellCurve curve;
    const auto arrived = [&](double depth_um, const Eigen::Matrix3Xd& x_um, const SolveReport& report) {
      curve.steps.push_back(read_out(depth_um, x_um, report));
      if (progress) progress(curve.steps.back(), depth_um / max_um);
    };
    const IndentationPath::End end = path_->run(max_um, step_um, arrived, cancel);
    curve.outcome = end.outcome;
    curve.failed_indentation_um = end.failed_indentation_um;
    curve.failure = end.failure;
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

  ShellStep read_out(double depth_um, const Eigen::Matrix3Xd& x_um, const SolveReport& report) const {
    ShellStep step;
    step.indentation_um = depth_um;
    step.tip_force_uN = tip_.force_uN(x_um);
    step.holder_force_uN = holder_.force_uN(x_um);
    step.axial_force_uN = -step.tip_force_uN.z() + 0.0;  // no -0
    step.lateral_force_uN = step.tip_force_uN.x();
    step.pressure_kPa = 1e3 * volume_.pressure_uN_per_um2(x_um) + 0.0;
    step.volume_change_ratio = volume_.volume_um3(x_um) / volume_.rest_volume_um3() - 1.0;
    step.energy_uN_um = energy_.add(x_um, nullptr, nullptr);
    step.largest_stretch = membrane_.principal_stretches(x_um).row(0).maxCoeff();
    step.nodes_um = x_um;
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
  std::unique_ptr<IndentationPath> path_;
};

ShellReference::ShellReference(const ShellSpecimen& specimen, const ShellContact& contact,
                               const ShellOptions& options) {
  check_geometry(specimen, contact);
  check_options(options.edge_length_ratio, options.max_iterations);
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
    if (angle >= std::numbers::pi) angle -= 2.0 * std::numbers::pi;
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
