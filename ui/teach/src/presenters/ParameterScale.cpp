#include "presenters/ParameterScale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "pellucida/core/Html.h"
#include "pellucida/core/Words.h"

namespace pellucida {
namespace {

std::string mass_text(double mass_kg) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e kg", mass_kg);
  return text;
}
std::string modulus_text(double modulus_kPa) {
  return three_digits(modulus_kPa) + " kPa";
}

constexpr NumberScale kScales[kTeachSliderCount] = {
    {PELLUCIDA_WORDS("Time step"), PELLUCIDA_WORDS("Of the integrator"), 1.0, 50000.0, true, 0.01, false,
     duration_text},
    {PELLUCIDA_WORDS("Mass of a node"), PELLUCIDA_WORDS("The cell's own mass would be 10\u207b\u00b9\u00b2 kg a node"),
     1e-12, 1e-5, true, 0.01, false, mass_text},
    {PELLUCIDA_WORDS("Damping ratio"),
     PELLUCIDA_WORDS("Dampers along the connectors; 1 damps the stiffest one critically"), 0.0, 2.0, false, 0.01, false,
     [](double ratio) { return fixed_number(ratio, 2); }},
    {PELLUCIDA_WORDS("Young's modulus"), PELLUCIDA_WORDS("Of the zona; scales every force and no shape"), 20.0, 1000.0,
     true, 0.01, false, modulus_text},
    {PELLUCIDA_WORDS("Mesh"),
     PELLUCIDA_WORDS("Nodes of the network; the profile's constants hold for its own mesh of 812"), 2.0, 9.0, false,
     1.0 / 7.0, true, [](double f) { return fixed_number(10.0 * f * f + 2.0, 0) + say(" nodes"); }},
    {PELLUCIDA_WORDS("Give of the hand"), PELLUCIDA_WORDS("How far the tip stays behind the hand for each \u00b5N"),
     0.0, 5.0, false, 0.02, false, [](double give) { return fixed_number(give, 1) + " µm/µN"; }},
    {PELLUCIDA_WORDS("Pace"), PELLUCIDA_WORDS("Simulated seconds a second, at most: slow motion"), 1e-3, 1.0, true,
     0.01, false, [](double pace) { return fixed_number(pace, 3) + "\u00d7"; }}};

}  // namespace

ParameterScale::ParameterScale(TeachSlider which) : NumberScale(kScales[static_cast<int>(which)]), which_(which) {}

double ParameterScale::value_in(const TeachingParameters& p) const noexcept {
  switch (which_) {
    case TeachSlider::kTimeStep:
      return p.time_step_us;
    case TeachSlider::kNodeMass:
      return p.node_mass_kg;
    case TeachSlider::kDamping:
      return p.damping_ratio;
    case TeachSlider::kModulus:
      return p.young_modulus_kPa;
    case TeachSlider::kMesh:
      return p.mesh_frequency;
    case TeachSlider::kGive:
      return p.hand_give_um_per_uN;
    case TeachSlider::kPace:
      return p.pace_ratio;
  }
  return 0.0;
}

void ParameterScale::set(TeachingParameters& p, double value) const noexcept {
  switch (which_) {
    case TeachSlider::kTimeStep:
      p.time_step_us = value;
      break;
    case TeachSlider::kNodeMass:
      p.node_mass_kg = value;
      break;
    case TeachSlider::kDamping:
      p.damping_ratio = value;
      break;
    case TeachSlider::kModulus:
      p.young_modulus_kPa = value;
      break;
    case TeachSlider::kMesh:
      p.mesh_frequency = static_cast<int>(std::lround(value));
      break;
    case TeachSlider::kGive:
      p.hand_give_um_per_uN = value;
      break;
    case TeachSlider::kPace:
      p.pace_ratio = value;
      break;
  }
}

// The limit goes with sqrt(m / E) at a given mesh and damping ratio (StabilityTest).
StablePart stable_part(TeachSlider which, const CellSnapshot& s) {
  const ParameterScale scale(which);
  const double limit_us = 1e6 * s.stability.stable_step_s;
  StablePart part;
  if (!std::isfinite(limit_us)) {
    if (which == TeachSlider::kTimeStep) part.text = say("stable at any step");
    return part;
  }
  const double over = s.parameters.time_step_us / limit_us;
  switch (which) {
    case TeachSlider::kTimeStep:
      part.to = scale.place_of(limit_us);
      part.text = say("stable below ") + duration_text(limit_us);
      break;
    case TeachSlider::kNodeMass: {
      const double least_kg = s.parameters.node_mass_kg * over * over;
      part.from = scale.place_of(least_kg);
      part.text = say("stable above ") + mass_text(least_kg);
      break;
    }
    case TeachSlider::kModulus: {
      const double most_kPa = s.young_modulus_kPa / (over * over);
      part.to = scale.place_of(most_kPa);
      part.text = say("stable below ") + scale.text(most_kPa);
      break;
    }
    default:
      break;
  }
  return part;
}

}  // namespace pellucida
