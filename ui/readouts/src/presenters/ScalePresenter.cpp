#include "presenters/ScalePresenter.h"

#include <cmath>

#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

std::string percent(double ratio) {
  return "±" + readout::number(100.0 * ratio, 0) + " %";
}

}  // namespace

ScaleTexts scale_texts(const Scene* scene, const CellProfile& profile) {
  ScaleTexts texts;
  texts.kind_sigma = scale_before(profile).relative_sigma;
  texts.sigma = texts.kind_sigma;
  if (scene && scene->remarks.has_own_scale) {
    texts.is_own = true;
    texts.ratio = scene->remarks.scale_ratio;
    texts.sigma = scene->remarks.scale_sigma_ratio;
  }
  texts.text = {percent(texts.sigma), texts.is_own ? current_theme().text : current_theme().text_dim};
  texts.tip = texts.is_own
                  ? say("This cell is ") + readout::number(texts.ratio, 2) + say(" times as stiff as its kind, ") +
                        percent(texts.sigma) + say(" (standard deviation); measured on it.")
                  : say("Kind of cell ") + percent(texts.sigma) +
                        say(" (standard deviation): so much single cells of this kind differ in stiffness. Scale, in "
                            "the top row, measures this one: a push of known force, a fibre, or a tongue in the "
                            "holding pipette.");
  texts.tip +=
      say("\nThe bar goes from a quarter of the kind's stiffness (profile ") + profile.name + say(") to four times.");
  return texts;
}

const std::vector<ScaleForm>& scale_forms() {
  static const std::vector<ScaleForm> forms{
      {PELLUCIDA_WORDS("Push"),
       PELLUCIDA_WORDS("The needle pushes this cell, and another instrument gives the force (or leave it 0 and give "
                       "the stiffness, the "
                       "rise of the force with depth)."),
       {{"known_force_uN", PELLUCIDA_WORDS("Force")},
        {"known_stiffness_uN_per_um", PELLUCIDA_WORDS("or stiffness")},
        {"known_force_sigma_percent", PELLUCIDA_WORDS("σ of that")},
        {"at_indentation_um", PELLUCIDA_WORDS("Indentation of the cell")},
        {"at_indentation_sigma_um", PELLUCIDA_WORDS("σ of that")}}},
      {PELLUCIDA_WORDS("Fibre"),
       PELLUCIDA_WORDS("A bending microfibre or calibrated pipette pushes this cell. Its stiffness times its "
                       "deflection is the force."),
       {{"fibre_stiffness_uN_per_um", PELLUCIDA_WORDS("Stiffness of the fibre")},
        {"known_force_sigma_percent", PELLUCIDA_WORDS("σ of that")},
        {"fibre_deflection_um", PELLUCIDA_WORDS("Deflection")},
        {"fibre_deflection_sigma_um", PELLUCIDA_WORDS("σ of that")},
        {"at_indentation_um", PELLUCIDA_WORDS("Indentation of the cell")},
        {"at_indentation_sigma_um", PELLUCIDA_WORDS("σ of that")}}},
      {PELLUCIDA_WORDS("Aspiration"),
       PELLUCIDA_WORDS("The holding pipette draws a tongue of the zona into its mouth under a known suction. Finite "
                       "elements of the "
                       "aspirated shell give its modulus; that takes some seconds."),
       {{"suction_kPa", PELLUCIDA_WORDS("Suction")},
        {"suction_sigma_percent", PELLUCIDA_WORDS("σ of that")},
        {"tongue_um", PELLUCIDA_WORDS("Tongue, mouth to apex")},
        {"tongue_sigma_um", PELLUCIDA_WORDS("σ of that")},
        {"mouth_radius_um", PELLUCIDA_WORDS("Inner radius of the mouth")},
        {"mouth_radius_sigma_um", PELLUCIDA_WORDS("σ of that")},
        {"zona_thickness_um", PELLUCIDA_WORDS("Thickness of the zona")},
        {"zona_thickness_sigma_um", PELLUCIDA_WORDS("σ of that")}}},
  };
  return forms;
}

ScaleMeasurement seen_for_scale(const Scene* scene) {
  ScaleMeasurement seen;
  if (!scene || !scene->observation) return seen;
  const Observation& o = *scene->observation;
  if (o.state == CellState::kContact && o.indentation_um > 0.0) {
    seen.at_indentation_um = o.indentation_um;
    if (o.indentation_sigma_um > 0.0) seen.at_indentation_sigma_um = o.indentation_sigma_um;
  }
  const double thickness_um = o.rest_outer_radius_um - o.rest_inner_radius_um;
  if (o.rest_inner_radius_um > 0.0 && thickness_um > 0.0) seen.zona_thickness_um = thickness_um;
  return seen;
}

}  // namespace pellucida
