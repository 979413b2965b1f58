#include "presenters/ReadoutPresenter.h"

#include <cmath>
#include <string_view>

#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr double kWeakConfidence = 0.5;

Phrase value(std::string text, double number) {
  return {std::move(text), std::isfinite(number) ? current_theme().text : current_theme().text_dim};
}

Phrase note_of(const Scene& scene) {
  const Measurement& m = scene.measurement;
  if (!scene.remarks.reason.empty()) return {say("no force, see below"), current_theme().warning};
  if (!std::isfinite(m.contact_force_uN)) return {};
  const std::string interval = readout::force_interval(m);
  return {interval.empty() ? say("no interval") : "95 %: " + interval,
          scene.remarks.warning.empty() ? current_theme().text_dim : current_theme().warning};
}

// For a narrow window.
std::string shortened(std::string parts) {
  for (const std::string& word : {say("picture "), std::string("this "), std::string(" of cell")}) {
    if (const auto at = parts.find(word); at != std::string::npos) parts.erase(at, word.size());
  }
  return parts;
}

std::string tip_of(const Scene& scene) {
  const ForceRemarks& remarks = scene.remarks;
  std::string tip =
      say("Force of the needle on the cell, along the needle, with its 95 % interval: the whole.\n"
          "Picture: what depth, sizes and model leave open (standard deviation); it is all there is between two forces "
          "on "
          "one cell.\n") +
      std::string(
          force_spread(scene.measurement).is_own_scale
              ? say("This cell: what is left of its unknown stiffness after its scale was measured.")
              : say("Kind of cell: how single cells of this kind differ in stiffness, one factor on all forces of "
                    "this cell. Measuring its scale reduces it."));
  if (!remarks.reason.empty()) tip += say("\nNo force: ") + say_message(remarks.reason) + ".";
  if (!remarks.warning.empty()) tip += say("\nWarning: ") + say_message(remarks.warning) + ".";
  const bool formula = std::isfinite(remarks.point_load_uN), table = std::isfinite(remarks.table_uN);
  if (!formula && !table) return tip;
  tip += say("\nOther models of the same push, no part of the interval:");
  if (formula) tip.append(say(" point-load formula ")).append(readout::number(remarks.point_load_uN, 2)).append(" µN");
  if (formula && table) tip.append(",");
  if (table) tip.append(say(" finite-element table ")).append(readout::number(remarks.table_uN, 2)).append(" µN");
  return tip + say(" (spread ") + readout::number(scene.measurement.model_spread_percent, 0) +
         say(" %). The formula takes the zona for a flat, clamped membrane: tens of per cent are usual.");
}

}  // namespace

ReadoutTexts readout_texts(const Scene* scene, const CellProfile& profile) {
  const Measurement m = scene ? scene->measurement : Measurement{};
  ReadoutTexts texts;
  texts.state = {scene ? readout::state(m.state) : say("Waiting"), state_color(m.state)};
  texts.indentation = value(readout::indentation(m), m.indentation_um);
  texts.force = value(readout::force(m), m.contact_force_uN);
  texts.pressure = value(readout::pressure(m), m.pressure_Pa);
  texts.confidence = {scene ? readout::confidence(m) : "\u2013", current_theme().text_dim};
  if (scene) {
    texts.force_note = note_of(*scene);
    texts.force_parts = {readout::force_parts(m), current_theme().text_dim};
    texts.force_parts_short = shortened(texts.force_parts.text);
    texts.force_tip = tip_of(*scene);
    texts.confidence.color = m.confidence < kWeakConfidence ? current_theme().warning : current_theme().text;
  }
  texts.profile = {profile.name, current_theme().text};
  texts.profile_tip = say_message(profile.description) +
                      say(": all forces are scaled to cells of this kind.\nThe picture can't tell one "
                          "kind from another of the same size: choose the profile with --profile.");
  return texts;
}

Phrase force_notice(const Scene& scene) {
  if (!scene.remarks.reason.empty())
    return {say("No force: ") + say_message(scene.remarks.reason), current_theme().warning};
  if (!scene.remarks.warning.empty())
    return {say("Force in doubt: ") + say_message(scene.remarks.warning), current_theme().warning};
  return {};
}

}  // namespace pellucida
