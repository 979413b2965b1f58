#include "pellucida/fem/SolidReference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "AxisymmetricMesh.h"
#include "IndentationPath.h"
#include "SolidTerms.h"
#include "SpecimenGeometry.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

/// Lame's lambda in terms of mu that counts as incompressible: volumes change by a thousandth of a strain.
constexpr double kIncompressible = 2000.0;
constexpr double kMostStiffening = 2.0, kLeastAspect_ratio = 0.7, kMostAspect_ratio = 1.4;
/// Elements are so much shorter than the shell's triangles.
constexpr double kEdgeRatio = 0.7;
/// Of the springs that keep the axis, in terms of E h.
constexpr double kAxisStiffness = 1e4;

double shear_modulus(const ShellSpecimen& specimen) {
  return young_modulus_uN_per_um2(specimen) / (2.0 * (1.0 + specimen.poisson_ratio));
}

double lame_lambda(const ShellSpecimen& specimen) {
  const double nu = specimen.poisson_ratio;
  const double ratio = nu < 0.5 ? 2.0 * nu / (1.0 - 2.0 * nu) : kIncompressible;
  return shear_modulus(specimen) * std::min(ratio, kIncompressible);
}

/// Integral of density(rho) 2 pi rho ds over the outer surface, on one hemisphere, times a hat function at each node.
Eigen::VectorXd bond_weights(const AxisymmetricMesh& mesh, bool tip_side,
                             const std::function<double(double)>& density) {
  constexpr int kParts = 50;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(mesh.points_um.cols());
  for (std::size_t k = 0; k + 1 < mesh.outer.size(); ++k) {
    const Eigen::Vector3d a = mesh.points_um.col(mesh.outer[k]), b = mesh.points_um.col(mesh.outer[k + 1]);
    for (int part = 0; part < kParts; ++part) {
      const double share = (part + 0.5) / kParts;
      const Eigen::Vector3d p = (1.0 - share) * a + share * b;
      if ((p.z() > 0.0) != tip_side) continue;
      const double amount = std::max(0.0, density(p.x())) * 2.0 * std::numbers::pi * p.x() * (b - a).norm() / kParts;
      weights[mesh.outer[k]] += (1.0 - share) * amount;
      weights[mesh.outer[k + 1]] += share * amount;
    }
  }
  return weights;
}

Eigen::VectorXd tip_weights(const AxisymmetricMesh& mesh, const ShellSpecimen& specimen, const ShellContact& contact) {
  const double density = young_modulus_uN_per_um2(specimen) * contact.tip_bond_per_um;
  return bond_weights(mesh, true, [&](double rho) {
    return density * (1.0 - rho * rho / (contact.tip_radius_um * contact.tip_radius_um));
  });
}

Eigen::VectorXd holder_weights(const AxisymmetricMesh& mesh, const ShellSpecimen& specimen,
                               const ShellContact& contact) {
  const double density = young_modulus_uN_per_um2(specimen) * contact.holder_bond_per_um;
  return bond_weights(mesh, false, [&](double rho) {
    const double offset = (rho - contact.holder_ring_um) / contact.holder_half_width_um;
    return density * (1.0 - offset * offset);
  });
}

Eigen::Matrix2Xd half_section(const Eigen::Matrix3Xd& x_um, const std::vector<int>& nodes) {
  Eigen::Matrix2Xd section(2, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    section.col(static_cast<Eigen::Index>(k)) << x_um(0, nodes[k]), x_um(2, nodes[k]);
  }
  return section;
}

}  // namespace

class SolidReference::Impl {
 public:
  Impl(const ShellSpecimen& specimen, const ShellContact& contact, const SolidOptions& options)
      : mesh_(make_axisymmetric_mesh(
            specimen.mid_radius_um, specimen.thickness_um,
            [&](double angle) {
              return kEdgeRatio * options.edge_length_ratio *
                     edge_length_um(specimen, contact, angle, std::numbers::pi - angle);
            },
            options.across, options.aspect_ratio)),
        solid_(mesh_, shear_modulus(specimen), lame_lambda(specimen), options.stiffening),
        liquid_(mesh_.points_um, mesh_.inner, young_modulus_uN_per_um2(specimen) * specimen.bulk_modulus_ratio),
        axis_(static_cast<int>(mesh_.points_um.cols()), mesh_.axis,
              kAxisStiffness * young_modulus_uN_per_um2(specimen) * specimen.thickness_um),
        tip_(mesh_.points_um, tip_weights(mesh_, specimen, contact)),
        holder_(mesh_.points_um, holder_weights(mesh_, specimen, contact)),
        energy_(static_cast<int>(mesh_.points_um.cols()), young_modulus_uN_per_um2(specimen) * specimen.thickness_um) {
    energy_.add_term(solid_);
    energy_.add_term(liquid_);
    energy_.add_term(axis_);
    energy_.add_term(tip_);
    energy_.add_term(holder_);
    path_ = std::make_unique<IndentationPath>(energy_, tip_, mesh_.points_um, specimen.mid_radius_um,
                                              options.max_iterations);
    rest_angle_rad_.resize(static_cast<Eigen::Index>(mesh_.outer.size()));
    for (std::size_t k = 0; k < mesh_.outer.size(); ++k) {
      rest_angle_rad_[static_cast<Eigen::Index>(k)] =
          std::atan2(mesh_.points_um(0, mesh_.outer[k]), mesh_.points_um(2, mesh_.outer[k]));
    }
  }

  const Eigen::VectorXd& rest_angle_rad() const noexcept { return rest_angle_rad_; }

  SolidCurve run(double max_um, double step_um, const std::function<void(const SolidStep&, double)>& progress,
                 const std::stop_token& cancel) {
    SolidCurve curve;
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
  SolidStep read_out(double depth_um, const Eigen::Matrix3Xd& x_um, const SolveReport& report) const {
    SolidStep step;
    step.indentation_um = depth_um;
    step.force_uN = -tip_.force_uN(x_um).z() + 0.0;  // no -0
    step.holder_force_uN = holder_.force_uN(x_um).z();
    step.pressure_kPa = 1e3 * liquid_.pressure_uN_per_um2(x_um) + 0.0;
    step.volume_change_ratio = liquid_.volume_um3(x_um) / liquid_.rest_volume_um3() - 1.0;
    step.solid_volume_change_ratio = solid_.largest_volume_change(x_um);
    step.energy_uN_um = energy_.add(x_um, nullptr, nullptr);
    step.inner_um = half_section(x_um, mesh_.inner);
    step.mid_um = half_section(x_um, mesh_.middle);
    step.outer_um = half_section(x_um, mesh_.outer);
    step.report = report;
    return step;
  }

  AxisymmetricMesh mesh_;
  SolidTerm solid_;
  RevolvedLiquidTerm liquid_;
  AxisTerm axis_;
  AttachmentTerm tip_, holder_;
  EnergySum energy_;
  std::unique_ptr<IndentationPath> path_;
  Eigen::VectorXd rest_angle_rad_;
};

SolidReference::SolidReference(const ShellSpecimen& specimen, const ShellContact& contact,
                               const SolidOptions& options) {
  check_geometry(specimen, contact);
  check_options(options.edge_length_ratio, options.max_iterations);
  if (options.across < 1 || options.across > 10) {
    throw UsageError("finite elements: give 1 to 10 elements through the thickness");
  }
  if (!(options.stiffening >= 0.0 && options.stiffening <= kMostStiffening)) {
    throw UsageError("finite elements: give a stiffening of 0 to 2");
  }
  if (!(options.aspect_ratio >= kLeastAspect_ratio && options.aspect_ratio <= kMostAspect_ratio)) {
    throw UsageError("finite elements: give a length over width of 0.7 to 1.4");
  }
  if (contact.holder_angle_rad != 0.0 || contact.lateral_offset_um != 0.0) {
    throw UsageError("finite elements: the solid of revolution has its needle in line with the holder; use the shell");
  }
  impl_ = std::make_unique<Impl>(specimen, contact, options);
}
SolidReference::~SolidReference() = default;
SolidReference::SolidReference(SolidReference&&) noexcept = default;
SolidReference& SolidReference::operator=(SolidReference&&) noexcept = default;

const Eigen::VectorXd& SolidReference::rest_angle_rad() const noexcept {
  return impl_->rest_angle_rad();
}

SolidCurve SolidReference::run(double max_indentation_um, double step_um,
                               const std::function<void(const SolidStep&, double)>& progress,
                               const std::stop_token& cancel) {
  return impl_->run(max_indentation_um, step_um, progress, cancel);
}

}  // namespace pellucida
