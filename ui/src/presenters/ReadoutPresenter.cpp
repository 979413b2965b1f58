#include "presenters/ReadoutPresenter.h"

#include <cmath>

#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr double kWeakConfidence = 0.5;

Phrase value(std::string text, double number) {
  return {std::move(text), std::isfinite(number) ? palette::kText : palette::kTextDim};
}

Phrase note_of(const Scene& scene) {
  const Measurement& m = scene.measurement;
  if (!scene.remarks.reason.empty()) return {"no force, see below", palette::kWarning};
  if (!std::isfinite(m.contact_force_uN)) return {};
  const std::string interval = readout::force_interval(m);
  return {interval.empty() ? "no interval" : "95 %: " + interval,
          scene.remarks.warning.empty() ? palette::kTextDim : palette::kWarning};
}

std::string tip_of(const Scene& scene) {
  const ForceRemarks& remarks = scene.remarks;
  std::string tip = "Force of the needle on the cell, along the needle, with its 95 % interval.";
  if (!remarks.reason.empty()) tip += "\nNo force: " + remarks.reason + ".";
  if (!remarks.warning.empty()) tip += "\nWarning: " + remarks.warning + ".";
  const bool formula = std::isfinite(remarks.point_load_uN), table = std::isfinite(remarks.table_uN);
  if (!formula && !table) return tip;
  tip += "\nOther models of the same push, no part of the interval:";
  if (formula) tip.append(" point-load formula ").append(readout::number(remarks.point_load_uN, 2)).append(" µN");
  if (formula && table) tip.append(",");
  if (table) tip.append(" finite-element table ").append(readout::number(remarks.table_uN, 2)).append(" µN");
  return tip + " (spread " + readout::number(scene.measurement.model_spread_percent, 0) +
         " %). The formula takes the zona for a flat, clamped membrane: tens of per cent are usual.";
}

}  // namespace

ReadoutTexts readout_texts(const Scene* scene, const CellProfile& profile) {
  const Measurement m = scene ? scene->measurement : Measurement{};
  ReadoutTexts texts;
  texts.state = {scene ? readout::state(m.state) : "Waiting", state_color(m.state)};
  texts.indentation = value(readout::indentation(m), m.indentation_um);
  texts.force = value(readout::force(m), m.contact_force_uN);
  texts.pressure = value(readout::pressure(m), m.pressure_Pa);
  texts.confidence = {scene ? readout::confidence(m) : "\u2013", palette::kTextDim};
  if (scene) {
    texts.force_note = note_of(*scene);
    texts.force_tip = tip_of(*scene);
    texts.confidence.color = m.confidence < kWeakConfidence ? palette::kWarning : palette::kText;
  }
  texts.profile = {profile.name, palette::kText};
  texts.profile_tip = profile.description +
                      ": all forces are scaled to cells of this kind.\nThe picture can't tell one "
                      "kind from another of the same size: choose the profile with --profile.";
  return texts;
}

Phrase force_notice(const Scene& scene) {
  if (!scene.remarks.reason.empty()) return {"No force: " + scene.remarks.reason, palette::kWarning};
  if (!scene.remarks.warning.empty()) return {"Force in doubt: " + scene.remarks.warning, palette::kWarning};
  return {};
}

}  // namespace pellucida
