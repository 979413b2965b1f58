#pragma once
#include <Eigen/Core>

#include "pellucida/fem/ShellSpecimen.h"

namespace pellucida {

/// Throws UsageError, naming the number, when specimen or contact is outside its range, or tip and holder would bear on
/// the same place.
void check_geometry(const ShellSpecimen& specimen, const ShellContact& contact);

/// Throws UsageError unless 0.2 <= ratio <= 3 and the iterations are above 0.
void check_options(double edge_length_ratio, int max_iterations);

double outer_radius_um(const ShellSpecimen& specimen);
double young_modulus_uN_per_um2(const ShellSpecimen& specimen);
/// Unit, from the centre to where the needle meets the shell, and to the holder.
Eigen::Vector3d contact_direction(const ShellSpecimen& specimen, const ShellContact& contact);
Eigen::Vector3d holder_direction(const ShellContact& contact);

/// Edge lengths of the shell's mesh, um on the middle surface, at an angle (rad) from the tip's middle and from the
/// holder's axis: fine under the tip and at the holder's ring, growing by 13 % of the way from there; elsewhere short
/// against the shell's bending length sqrt(R h).
double edge_length_um(const ShellSpecimen& specimen, const ShellContact& contact, double from_tip_rad,
                      double from_holder_rad);

}  // namespace pellucida
