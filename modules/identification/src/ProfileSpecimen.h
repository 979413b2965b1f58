#pragma once
#include "pellucida/fem/ShellSpecimen.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// The cell of a profile for finite elements, with the profile's effective modulus.
inline ShellSpecimen specimen_of(const CellProfile& profile) {
  ShellSpecimen specimen;
  specimen.mid_radius_um = profile.mid_radius_um;
  specimen.thickness_um = profile.thickness_um;
  specimen.young_modulus_kPa = profile.effective_young_modulus_kPa;
  specimen.poisson_ratio = profile.poisson_ratio;
  specimen.bulk_modulus_ratio = profile.volume_stiffness_ratio;
  return specimen;
}

/// Needle and holding pipette of a profile.
inline ShellContact contact_of(const CellProfile& profile, double holder_angle_rad = 0.0, double offset_um = 0.0) {
  ShellContact contact;
  contact.holder_angle_rad = holder_angle_rad;
  contact.lateral_offset_um = offset_um;
  contact.tip_radius_um = profile.tip_radius_um;
  contact.tip_bond_per_um = profile.tip_bond_per_um;
  contact.holder_ring_um = profile.holder_ring_um;
  contact.holder_half_width_um = profile.holder_half_width_um;
  contact.holder_bond_per_um = profile.holder_bond_per_um;
  return contact;
}

}  // namespace pellucida
