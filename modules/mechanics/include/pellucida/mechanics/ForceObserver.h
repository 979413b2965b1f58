#pragma once
#include <Eigen/Core>
#include <limits>
#include <memory>
#include <string>

#include "pellucida/core/Observation.h"
#include "pellucida/mechanics/CellProfile.h"

namespace pellucida {

/// What the model says of one frame. Numbers that could not be had are NaN; the arrays are empty when there is no model
/// shape (no cell seen). No other number is ever NaN.
struct ForceEstimate {
  static constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

  /// Force of the needle on the cell along the push, uN: 0 when free or punctured. This is the force of a
  /// force-indentation curve; a needle beside the holder's axis feels a lateral reaction besides, see `tip_force_uN`.
  double contact_force_uN = kNotMeasured;
  double contact_force_lower_uN =
      kNotMeasured;  ///< 95 % interval: depth noise, fit error of the model, scale of the profile
  double contact_force_upper_uN = kNotMeasured;
  Eigen::Vector3d tip_force_uN = Eigen::Vector3d::Zero();  ///< whole force of the needle on the cell, frame W
  double pressure_Pa = kNotMeasured;                       ///< excess pressure in the cell
  double volume_um3 = kNotMeasured;           ///< enclosed by the zona's outer surface, as the model has it
  double stiffness_uN_per_um = kNotMeasured;  ///< tangent stiffness felt along the push
  double depth_um = kNotMeasured;             ///< filtered indentation
  double depth_sigma_um = kNotMeasured;       ///< its standard deviation, edge bias included

  bool converged = false;          ///< the model is in equilibrium at `depth_um`
  int iterations = 0;              ///< Newton iterations spent
  std::string reason;              ///< one line when not converged or not measured; empty otherwise
  bool holder_assumed = false;     ///< no holder seen so far: taken to lie opposite the needle
  bool thickness_assumed = false;  ///< the inner membrane was not seen at rest: the profile's thickness

  /// The cell frame C in W: z towards the needle, y along W's z, origin at the cell's centre.
  Eigen::Matrix3d rotation_WC = Eigen::Matrix3d::Identity();
  Eigen::Vector3d center_um = Eigen::Vector3d::Zero();
  Eigen::Matrix3Xd rest_um;    ///< (3 x n) nodes at rest, frame W: the middle surface of the zona
  Eigen::Matrix3Xd solved_um;  ///< (3 x n) nodes in equilibrium, frame W
  Eigen::Matrix3Xi triangles;  ///< (3 x m), outward

  /// (3 x n) uN, frame W: resultant of the membrane's own elastic forces on each node, i.e. of the springs of eq. (1)
  /// and the hinges. In equilibrium it balances what acts on the node from outside: the pressure everywhere, the needle
  /// under the tip, the holder on its ring. Summed over the nodes under the tip it points at the needle, with the
  /// contact force less the pressure's part; single nodes there differ, since the bonded tip bears on the rim of its
  /// patch and pulls at its middle. All nodes together sum to zero, since the outer forces do.
  Eigen::Matrix3Xd force_uN;
  Eigen::VectorXd force_sigma_uN;     ///< (n) standard deviation of its magnitude
  Eigen::VectorXd tension_uN_per_um;  ///< (n) mean membrane tension, see SpringTerm
};

/// Force from the tracked shape. Each frame: the cell's frame from centre and needle axis, the holder where it was
/// tracked, the filtered indentation at the apex, taken as the needle's depth; then the mass-spring-damper membrane in
/// equilibrium with the needle that deep, started from the last frame's shape; then the exact read-out of the tip's
/// bond. One thread at a time; not real-time safe (allocates).
class ForceObserver {
 public:
  explicit ForceObserver(CellProfile profile);
  ~ForceObserver();
  ForceObserver(ForceObserver&&) noexcept;
  ForceObserver& operator=(ForceObserver&&) noexcept;

  const CellProfile& profile() const noexcept;

  /// States `free` and `punctured` give a force of 0 and the shape at rest; `no_cell` and `lost` give nothing;
  /// `contact` gives the force at the observed indentation, or nothing with the reason when needle or numbers are
  /// missing.
  ForceEstimate process(const Observation& observation);

  /// Forgets the cell.
  void reset();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
