#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>

#include "pellucida/teaching/CellMesh.h"
#include "pellucida/teaching/NodeForces.h"
#include "pellucida/teaching/PokedCell.h"
#include "pellucida/teaching/StabilityLimit.h"
#include "pellucida/teaching/TeachingParameters.h"

namespace pellucida {

/// A poked cell at one moment, never written again. Frame C (MembraneModel.h).
struct CellSnapshot {
  std::shared_ptr<const CellMesh> mesh;
  TeachingParameters parameters;
  std::uint64_t run = 0;  ///< counts the starts from rest: a new one begins a new curve

  Eigen::Matrix3Xd x_um;           ///< (3 x n)
  Eigen::VectorXd spring_pull_uN;  ///< tension of each connector
  Eigen::Vector3d tip_um;          ///< the needle's displacement from where it touches the cell at rest
  double hand_along_um = 0.0;
  double hand_across_um = 0.0;
  std::optional<NodeForces> node_forces;  ///< of the node asked for
  Eigen::Matrix3Xd field_uN;              ///< (3 x n) a force on every node to be shown; empty: none

  double time_s = 0.0;
  double depth_um = 0.0;
  double force_uN = 0.0;  ///< of the needle along its push
  double potential_energy_pJ = 0.0;
  double kinetic_energy_pJ = 0.0;
  double volume_change_ratio = 0.0;
  double pressure_Pa = 0.0;
  double largest_speed_um_per_s = 0.0;
  double young_modulus_kPa = 0.0;  ///< in use
  double steps_per_s = 0.0;        ///< computed a second of the clock
  double pace_ratio = 0.0;         ///< simulated seconds a second of the clock
  StabilityLimit stability;
  std::optional<BlowUp> blow_up;
};

/// Force and depth at one moment of a run, for curves.
struct CurvePoint {
  std::uint64_t run = 0;
  double time_s = 0.0;
  double depth_um = 0.0;
  double force_uN = 0.0;
};

/// All but rates and run.
CellSnapshot snapshot_of(const PokedCell& cell, std::optional<int> node);

}  // namespace pellucida
