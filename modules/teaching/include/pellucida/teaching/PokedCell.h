#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "pellucida/dynamics/Integrator.h"
#include "pellucida/membrane/MembraneModel.h"
#include "pellucida/teaching/CellMesh.h"
#include "pellucida/teaching/NodeForces.h"
#include "pellucida/teaching/StabilityLimit.h"
#include "pellucida/teaching/TeachingParameters.h"

namespace pellucida {

/// What ended a motion.
enum class BlowUpKind {
  kNotFinite,      ///< a number overflowed
  kEnergyRanAway,  ///< the nodes move with more energy than all tools have put in
  kNoSolution,     ///< the implicit step's equations were not solved
};

/// A motion that ended, with the limit that was broken, if one was.
struct BlowUp {
  BlowUpKind kind = BlowUpKind::kNotFinite;
  double time_s = 0.0;
  double time_step_s = 0.0;
  double stable_step_s = 0.0;  ///< of the theory, at the last shape whose numbers were sound; infinity: none
  double kinetic_energy_pJ = 0.0;
  double supplied_energy_pJ = 0.0;  ///< what the cell had and the needle added

  /// Whether the step was above the theory's limit.
  bool is_beyond_limit() const noexcept { return time_step_s > stable_step_s; }
};

/// A cell on its holding pipette, stepped through time, with a needle that a hand moves along and across its axis. The
/// tip stays behind the hand by the force on it times `hand_give_um_per_uN`, and moves no faster than 150 um/s: force
/// that is seen instead of felt. The needle is bonded to the membrane (docs/method.md, 3.1); out of the cell the bond
/// rests. Physics: MembraneModel and the integrators of `dynamics`, nothing of its own.
///
///     PokedCell cell(parameters);
///     cell.set_hand(20.0, 0.0);
///     while (cell.step() && cell.time_s() < 1.0) {
///     }
///     cell.push_force_uN();
///
/// No threads, no clock. One thread at a time.
class PokedCell {
 public:
  /// Throws UsageError for parameters that are not valid.
  explicit PokedCell(const TeachingParameters& parameters);
  ~PokedCell();
  PokedCell(const PokedCell&) = delete;
  PokedCell& operator=(const PokedCell&) = delete;

  /// The motion goes on with the new numbers; on another mesh, or as another cell, from rest. A motion that has ended
  /// stays so until `restart`. Throws UsageError and changes nothing for parameters that are not valid.
  void set_parameters(const TeachingParameters& parameters);
  const TeachingParameters& parameters() const noexcept { return parameters_; }

  /// Where the hand is: um along the push from where the tip touches, negative outside (to -50), and across the axis
  /// (frame C's x). Held within what the needle can reach: the cell's radius deep, across no farther than deep and no
  /// farther than 12 um.
  void set_hand(double along_um, double across_um);
  double hand_along_um() const noexcept { return hand_along_um_; }
  double hand_across_um() const noexcept { return hand_across_um_; }

  /// One time step. False, without a motion, once it has ended.
  bool step();
  /// From rest, the needle where the cell is touched; the hand stays.
  void restart();

  const std::optional<BlowUp>& blow_up() const noexcept { return blow_up_; }
  const StabilityLimit& stability() const noexcept { return stability_; }
  /// Follows the shape with the stability limit: ten products with the Hessian.
  void renew_stability();

  double time_s() const noexcept { return time_s_; }
  std::uint64_t step_count() const noexcept { return step_count_; }
  const MotionState& state() const noexcept { return state_; }
  /// Mean acceleration over the last step, um/s^2 (3 x n).
  const Eigen::Matrix3Xd& acceleration_um_per_s2() const noexcept { return acceleration_um_per_s2_; }
  const MembraneModel& model() const noexcept { return *model_; }
  const Dynamics& dynamics() const noexcept { return *dynamics_; }
  const std::shared_ptr<const CellMesh>& mesh() const noexcept { return mesh_; }

  Eigen::Vector3d tip_displacement_um() const { return model_->tip().displacement_um(); }
  /// How deep the tip is along the push; negative outside the cell.
  double depth_um() const noexcept;
  double push_force_uN() const;
  double potential_energy_pJ() const;
  double kinetic_energy_pJ() const;
  /// (V - V0) / V0.
  double volume_change_ratio() const;
  double pressure_Pa() const;
  double largest_speed_um_per_s() const;
  /// In use: the parameters', or the profile's.
  double young_modulus_kPa() const noexcept { return profile_.effective_young_modulus_kPa; }
  /// Each term's force on a node. Throws UsageError for a node that the mesh doesn't have.
  NodeForces forces_on(int node) const;

 private:
  void build();
  void rest();
  void make_integrator();
  void move_tip(double dt_s);
  void check_energy();
  void end_motion(BlowUpKind kind);

  TeachingParameters parameters_;
  IntegratorKind kind_ = IntegratorKind::kImplicitEuler;
  CellProfile profile_;
  std::unique_ptr<MembraneModel> model_;
  std::optional<Dynamics> dynamics_;
  std::unique_ptr<Integrator> integrator_;
  std::shared_ptr<const CellMesh> mesh_;
  StabilitySolver stability_solver_;
  StabilityLimit stability_;
  MotionState state_, before_;
  Eigen::Matrix3Xd acceleration_um_per_s2_;
  double hand_along_um_ = -10.0;
  double hand_across_um_ = 0.0;
  double tip_along_um_ = -10.0;
  double tip_across_um_ = 0.0;
  double supplied_pJ_ = 0.0;
  double time_s_ = 0.0;
  std::uint64_t step_count_ = 0;
  std::optional<BlowUp> blow_up_;
};

}  // namespace pellucida
