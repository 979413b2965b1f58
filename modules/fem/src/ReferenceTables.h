#pragma once
#include <filesystem>
#include <string>

#include "pellucida/fem/ShellReference.h"
#include "pellucida/fem/SolidReference.h"

namespace pellucida {

/// Writes a curve in the form of `resources/reference`, from which the virtual specimen is made:
///
///     <stem>-force.csv    indentation_um, force_uN (along the push), lateral_force_uN, pressure_kPa
///     <stem>-profile.csv  indentation_um, theta0_rad, x_mid_um, z_mid_um, of the section through needle and holder
///
/// in frame N, angles from the needle's direction at rest. Overwrites; creates the folder. Throws OutputError, with the
/// file's name, when a file can't be written.
void write_reference_tables(const ShellReference& reference, const ShellCurve& curve,
                            const std::filesystem::path& folder, const std::string& stem);

/// The same of a solid, force in line with the needle; the profile holds half-sections of both faces:
/// indentation_um, theta0_rad, outer_r_um, outer_z_um, inner_r_um, inner_z_um.
void write_reference_tables(const SolidReference& reference, const SolidCurve& curve,
                            const std::filesystem::path& folder, const std::string& stem);

}  // namespace pellucida
