#include "pellucida/teaching/TeachingParameters.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

using P = TeachingParameters;
constexpr FieldRange kAnyText;
constexpr Field<P> kParameters[] = {
    {"profile", "", &P::profile, kAnyText, "the cell, a profile's name or file"},
    {"integrator", "", &P::integrator, kAnyText, "`symplectic-euler`, `implicit-euler` or `linear-acceleration`"},
    {"time_step_us", "us", &P::time_step_us, {1, 50000}, "of the integrator"},
    {"node_mass_kg", "kg", &P::node_mass_kg, {1e-12, 1e-5}, "of every node"},
    {"damping_ratio", "", &P::damping_ratio, {0, 2}, "dampers of the connectors; 1 damps the stiffest one critically"},
    {"young_modulus_kPa", "kPa", &P::young_modulus_kPa, {0, 2000}, "of the zona; 0: the profile's effective one"},
    {"keeps_volume", "", &P::keeps_volume, kAnyText, "false: the liquid leaves freely, without pressure"},
    {"mesh_frequency",
     "",
     &P::mesh_frequency,
     {2, 9},
     "each edge of an icosahedron in so many parts: 10 f^2 + 2 nodes"},
    {"hand_give_um_per_uN",
     "um/uN",
     &P::hand_give_um_per_uN,
     {0, 5},
     "how far the tip stays behind the hand for each uN"},
    {"pace_ratio", "", &P::pace_ratio, {1e-3, 1}, "simulated seconds a second, at most"},
};

constexpr std::array<std::pair<std::string_view, IntegratorKind>, 3> kIntegrators = {
    {{"symplectic-euler", IntegratorKind::kSymplecticEuler},
     {"implicit-euler", IntegratorKind::kImplicitEuler},
     {"linear-acceleration", IntegratorKind::kLinearAcceleration}}};

}  // namespace

FieldList fields_of(TeachingParameters& parameters) {
  FieldList list;
  list.add("", kParameters, parameters);
  return list;
}

IntegratorKind integrator_kind(const std::string& name) {
  std::string known;
  for (const auto& [text, kind] : kIntegrators) {
    if (text == name) return kind;
    known += (known.empty() ? "" : ", ") + std::string(text);
  }
  throw UsageError("integrator " + name + ": not known; known are " + known);
}

void require_valid(const TeachingParameters& parameters) {
  TeachingParameters copy = parameters;
  if (const auto fault = range_fault(fields_of(copy))) throw UsageError(*fault);
  integrator_kind(parameters.integrator);
  profile_of(parameters);
}

CellProfile profile_of(const TeachingParameters& parameters) {
  CellProfile profile = load_profile(parameters.profile);
  profile.mesh_frequency = parameters.mesh_frequency;
  if (parameters.young_modulus_kPa > 0.0) profile.effective_young_modulus_kPa = parameters.young_modulus_kPa;
  return profile;
}

MembraneSetup setup_of(const CellProfile& profile, const TeachingParameters& parameters) {
  MembraneSetup setup = setup_for_configuration(profile, 1);
  setup.keeps_volume = parameters.keeps_volume;
  return setup;
}

double critical_damping_uN_s_per_um(const SpringTerm& springs, double node_mass_kg) {
  return 2.0 * std::sqrt(0.5 * springs.stiffest_uN_per_um() * node_mass_kg);
}

double deepest_um(const CellProfile& profile) noexcept {
  return profile.mid_radius_um;
}

}  // namespace pellucida
