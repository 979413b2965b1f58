#pragma once
#include <string>

#include "pellucida/core/FieldTable.h"
#include "pellucida/membrane/MembraneModel.h"

namespace pellucida {

/// How the cell is stepped through time (dynamics/Integrator.h).
enum class IntegratorKind { kSymplecticEuler, kImplicitEuler, kLinearAcceleration };

/// What an instructor turns: the cell, and how its motion is computed.
struct TeachingParameters {
  std::string profile = "mouse-oocyte";
  std::string integrator = "implicit-euler";
  double time_step_us = 15000.0;
  double node_mass_kg = 1e-8;
  double damping_ratio = 0.1;      ///< b over that of `critical_damping_uN_s_per_um`
  double young_modulus_kPa = 0.0;  ///< 0: the profile's effective one
  bool keeps_volume = true;
  int mesh_frequency = 9;
  double hand_give_um_per_uN = 1.0;  ///< how far the tip stays behind the hand for each uN
  double pace_ratio = 1.0;           ///< simulated seconds a second, at most
};

/// Keys, units and ranges of the parameters; the sliders and the lessons' files follow from them.
FieldList fields_of(TeachingParameters& parameters);

/// Throws UsageError for a number out of its range or an unknown integrator, with what is allowed, and where the
/// profile isn't known.
void require_valid(const TeachingParameters& parameters);

/// The integrator of that name. Throws UsageError that lists the names.
IntegratorKind integrator_kind(const std::string& name);

/// The profile with the parameters' mesh and modulus.
CellProfile profile_of(const TeachingParameters& parameters);

/// Needle opposite the holder, volume kept or not.
MembraneSetup setup_of(const CellProfile& profile, const TeachingParameters& parameters);

/// The damper that damps the stiffest connector, two nodes of that mass, critically: 2 sqrt(k m / 2).
double critical_damping_uN_s_per_um(const SpringTerm& springs, double node_mass_kg);

/// How deep the hand can push, um: the radius of the middle surface.
double deepest_um(const CellProfile& profile) noexcept;

}  // namespace pellucida
