#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "pellucida/membrane/EquilibriumSolver.h"
#include "pellucida/membrane/MembraneGeometry.h"
#include "pellucida/membrane/MembraneModel.h"
#include "pellucida/membrane/NormalObservationTerm.h"

namespace pellucida {

/// The membrane's equilibrium at one depth of the needle. Frame C.
struct IndentationState {
  double depth_um = 0.0;
  Eigen::Vector3d tip_force_uN = Eigen::Vector3d::Zero();     ///< of the needle on the cell
  Eigen::Vector3d holder_force_uN = Eigen::Vector3d::Zero();  ///< of the holder on the cell
  double push_force_uN = 0.0;        ///< the tip force's part along the push: the force of a force-indentation curve
  double stiffness_uN_per_um = 0.0;  ///< d push_force / d depth
  double pressure_Pa = 0.0;
  double volume_um3 = 0.0;  ///< enclosed by the model's facets
  SolveReport report;
};

/// What the springs of a model bear at one shape; without the factor of its geometry.
struct ToolForces {
  Eigen::Vector3d tip_uN = Eigen::Vector3d::Zero();     ///< of the needle on the cell
  Eigen::Vector3d holder_uN = Eigen::Vector3d::Zero();  ///< of the holder on the cell
  double push_uN = 0.0;                                 ///< the tip's along the push
  double pressure_Pa = 0.0;
  double volume_um3 = 0.0;
};

/// An equilibrium, to be taken over by a model of the same cell under another modulus: the modulus scales every force
/// and no shape.
struct SolvedShape {
  double depth_um = 0.0;
  Eigen::Matrix3Xd positions_um;   ///< (3 x n), frame C
  Eigen::Matrix3Xd depth_tangent;  ///< (3 x n), motion of the nodes per micrometre of depth
  /// (3 x n), change of the membrane's elastic force on the nodes per micrometre of depth
  Eigen::Matrix3Xd elastic_slope_uN_per_um;
  Eigen::Matrix3Xd elastic_force_uN;  ///< (3 x n), the membrane's elastic force on the nodes; empty: not computed yet
  ToolForces forces;
  double stiffness_uN_per_um = 0.0;    ///< d push / d depth
  double force_scale_uN_per_um = 0.0;  ///< of the model it was solved in
  SolveReport report;
};

class SolidForce;

/// Pushes the needle into the model quasi-statically and keeps the solution from one depth to the next (warm start
/// along the tangent and its curvature; long distances in steps).
class Indenter {
 public:
  /// The springs alone, without `geometry_factor`, of the profile's own geometry: thickness and radius aside, which
  /// `setup` gives, its tools, its regions, its mesh. What is measured has the factor: the constructor below.
  Indenter(const CellProfile& profile, const MembraneSetup& setup);
  /// A cell of the profile's kind and of `geometry`, pushed and held as given: forces carry the factor of that geometry
  /// and of the depth (`geometry_factor`), also at the profile's own.
  Indenter(const CellProfile& profile, const MembraneGeometry& geometry, const Eigen::Vector3d& push,
           const Eigen::Vector3d& holder);

  const MembraneModel& model() const noexcept { return model_; }
  /// Present positions of the nodes, um (3 x n), frame C.
  const Eigen::Matrix3Xd& positions_um() const noexcept { return x_um_; }
  /// What the forces of springs and hinges are multiplied by at the present depth; states have it in them.
  double force_ratio() const noexcept { return factor().ratio; }
  /// How much of the force's logarithm is the solid's (`IndentedSolid`) as the needle and the holder lie: 0, none,
  /// to 1.
  double solid_share() const noexcept;
  /// The same ratio for the liquid's pressure.
  double pressure_ratio() const noexcept;
  /// Motion of the nodes per micrometre of depth (3 x n).
  const Eigen::Matrix3Xd& depth_tangent() const noexcept { return tangent_; }

  /// Back to rest.
  void reset();
  void set_holder(const Eigen::Vector3d& direction) { model_.set_holder(direction); }
  void set_options(const SolveOptions& options) { options_ = options; }

  /// Equilibrium with the needle `depth_um` deep (>= 0). When a step fails, the state is the last one reached, and its
  /// report says so.
  IndentationState advance_to(double depth_um);

  /// The present state, with the report of the solution that led to it.
  SolvedShape shape(const SolveReport& report) const;
  /// Takes over a solution instead of solving. Precondition: it was solved in a model of the same mesh, setup and
  /// constants, the modulus aside, which scales its forces.
  IndentationState adopt(const SolvedShape& solved);
  /// The same, but checked: where a node's residual force is above `tolerance_um` times E h, the solver starts from
  /// that shape.
  IndentationState adopt_checked(const SolvedShape& solved, double tolerance_um);

  /// What the forces of the present equilibrium change by per micrometre of depth.
  ToolForces force_slopes();

  /// The membrane's own elastic force on each node at present, uN (3 x n), and its change per micrometre of depth;
  /// without the factor of the geometry.
  const Eigen::Matrix3Xd& elastic_force_uN() const;
  const Eigen::Matrix3Xd& elastic_slope_uN_per_um() const;

  /// Sets weak observations on the nodes (frame C); they remain until others are given, or `reset`. None: the model
  /// alone. They pull from the next `advance_to` on, also one to the depth that is reached already.
  void observe(std::vector<NormalObservationTerm::Observed> observed);

 private:
  SolveReport step_to(double depth_um);
  ToolForces forces_at(const Eigen::Matrix3Xd& x_um) const;
  void forget_elastic();
  IndentationState read_out(const SolveReport& report) const;
  GeometryFactor factor() const noexcept;

  std::optional<CellProfile> kind_;  // of a cell of another geometry, and that geometry
  MembraneGeometry geometry_;
  std::shared_ptr<const SolidForce> solid_;
  MembraneModel model_;
  NormalObservationTerm observation_;
  bool observes_ = false;
  EquilibriumSolver solver_;
  SolveOptions options_;
  Eigen::Matrix3Xd x_um_;
  Eigen::Matrix3Xd tangent_;      // dx/dd
  Eigen::Matrix3Xd bend_per_um_;  // d2x/dd2, by differences
  Eigen::Matrix3Xd before_um_;
  Eigen::Matrix3Xd load_uN_per_um_;                                // w_i push
  mutable Eigen::Matrix3Xd elastic_uN_, elastic_slope_uN_per_um_;  // empty until somebody asks
  ToolForces forces_;
  double stiffness_uN_per_um_ = 0.0;
  bool has_tangent_ = false;
  bool has_bend_ = false;
  double depth_um_ = 0.0;
};

/// A force-indentation curve, no video: depths 0, step, 2 step, ... max. Throws UsageError for a step or depth that
/// isn't above 0 (or a depth that would pass through the cell).
std::vector<IndentationState> force_curve(const CellProfile& profile, const MembraneSetup& setup,
                                          double max_indentation_um, double step_um);
/// The same for a cell of the profile's kind and of `geometry`.
std::vector<IndentationState> force_curve(const CellProfile& profile, const MembraneGeometry& geometry,
                                          const MembraneSetup& setup, double max_indentation_um, double step_um);
/// The same in one of the paper's configurations. Throws UsageError also for a number outside 1..4.
std::vector<IndentationState> force_curve(const CellProfile& profile, int configuration, double max_indentation_um,
                                          double step_um);

}  // namespace pellucida
