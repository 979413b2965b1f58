#pragma once

namespace pellucida {

/// The specimen of the finite-element reference: a spherical shell full of liquid, free of stress at rest. The defaults
/// are the mouse oocyte's zona with the modulus of the paper's Table I.
struct ShellSpecimen {
  double mid_radius_um = 50.0;      ///< R, of the middle surface
  double thickness_um = 5.0;        ///< h; 0.01 R to 0.4 R
  double young_modulus_kPa = 17.9;  ///< E, the only scale of force
  double poisson_ratio = 0.5;       ///< 1/2: incompressible neo-Hookean; down to above 0: Blatz and Ko (NeoHookeanTerm)
  double bulk_modulus_ratio = 111.7;  ///< of the liquid, in terms of E: it loses about 1e-4 of its volume
};

/// How the shell is touched. Both tools are bonded elastically, their densities in terms of E, so that all forces scale
/// with E. Radii are measured from the tool's axis on the shell's outer surface, of radius R + h/2.
///
///     tip     kt (1 - (r / a)^2)                       r < a
///     holder  kr (1 - ((rho - ring) / half_width)^2)   where that is above 0
///
/// Frame N: origin at the cell's centre at rest; the needle pushes along -z; the holder lies in the direction
/// (sin phi, 0, -cos phi). With an offset the needle's axis runs through x = offset, parallel to z.
struct ShellContact {
  double holder_angle_rad = 0.0;      ///< phi, 0 to pi/2: 0 opposite the needle
  double lateral_offset_um = 0.0;     ///< where the needle meets the outer surface; towards a turned holder above 0
  double tip_radius_um = 5.0;         ///< a
  double tip_bond_per_um = 11.173;    ///< kt / E; 0.2 uN/um^3 at 17.9 kPa
  double holder_ring_um = 17.5;       ///< mean radius of the holder's mouth
  double holder_half_width_um = 5.0;  ///< of the ring it bears on
  double holder_bond_per_um = 5.587;  ///< kr / E; 0.1 uN/um^3 at 17.9 kPa
};

/// The paper's tested configurations: 1 aligned; 2 holder at 45 degrees; 3 at 90 degrees; 4 parallel to the holder's
/// axis, `offset_um` beside it. Throws UsageError for any other number.
ShellContact contact_for_configuration(int configuration, double offset_um = 10.0);

}  // namespace pellucida
