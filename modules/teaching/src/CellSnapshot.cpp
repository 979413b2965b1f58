#include "pellucida/teaching/CellSnapshot.h"

namespace pellucida {

CellSnapshot snapshot_of(const PokedCell& cell, std::optional<int> node) {
  CellSnapshot s;
  s.mesh = cell.mesh();
  s.parameters = cell.parameters();
  s.x_um = cell.state().x_um;
  s.spring_pull_uN = spring_pulls_uN(cell.model().springs(), s.x_um);
  s.depth_um = cell.depth_um();
  // Out of the cell the needle is where it is; in it, where the bond has it.
  s.tip_um = cell.depth_um() < 0.0 ? Eigen::Vector3d(cell.depth_um() * s.mesh->push) : cell.tip_displacement_um();
  s.hand_along_um = cell.hand_along_um();
  s.hand_across_um = cell.hand_across_um();
  if (node && *node < s.x_um.cols()) s.node_forces = cell.forces_on(*node);
  s.time_s = cell.time_s();
  s.force_uN = cell.push_force_uN();
  s.potential_energy_pJ = cell.potential_energy_pJ();
  s.kinetic_energy_pJ = cell.kinetic_energy_pJ();
  s.volume_change_ratio = cell.volume_change_ratio();
  s.pressure_Pa = cell.pressure_Pa();
  s.largest_speed_um_per_s = cell.largest_speed_um_per_s();
  s.young_modulus_kPa = cell.young_modulus_kPa();
  s.stability = cell.stability();
  s.blow_up = cell.blow_up();
  return s;
}

}  // namespace pellucida
