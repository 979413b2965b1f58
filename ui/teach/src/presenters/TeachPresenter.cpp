#include "presenters/TeachPresenter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pellucida/core/Html.h"
#include "pellucida/core/Words.h"
#include "presenters/ParameterScale.h"

namespace pellucida {
namespace {

// A cell that has caught up with its clock to this share runs in time.
constexpr double kInTime_ratio = 0.95;

std::string reason_of(const BlowUp& end) {
  switch (end.kind) {
    case BlowUpKind::kNotFinite:
      return say("a number grew beyond all bounds");
    case BlowUpKind::kEnergyRanAway:
      return say("the nodes move with ") + short_number(end.kinetic_energy_pJ) + say(" pJ, the needle put in ") +
             short_number(end.supplied_energy_pJ) + " pJ";
    case BlowUpKind::kNoSolution:
      return say("the equations of an implicit step were not solved");
  }
  return "";
}

std::string blow_up_text(const BlowUp& end, const std::string& integrator) {
  const std::string step = duration_text(1e6 * end.time_step_s);
  std::string text = say("Blown up after ") + duration_text(1e6 * end.time_s) + ": " + reason_of(end) + ". ";
  if (end.is_beyond_limit()) {
    const std::string limit = duration_text(1e6 * end.stable_step_s);
    return text + say("The time step, ") + step + say(", is above the stability limit of ") + integrator + ", " +
           limit + say(". Choose a shorter step or a larger mass, then start again (Home).");
  }
  if (std::isfinite(end.stable_step_s)) {
    return text + say("The time step, ") + step + say(", is below the limit of linear vibration, ") +
           duration_text(1e6 * end.stable_step_s) +
           say(": the shape left the range where that holds. Push more slowly or take a shorter step, then start again "
               "(Home).");
  }
  return text + say("Take a shorter step than ") + step + say(" or push more slowly, then start again (Home).");
}

}  // namespace

double force_at_uN(const std::vector<double>& depth_um, const std::vector<double>& force_uN, double at_um) {
  const auto above = std::lower_bound(depth_um.begin(), depth_um.end(), at_um);
  if (above == depth_um.end() || (above == depth_um.begin() && at_um < *above)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto k = static_cast<std::size_t>(above - depth_um.begin());
  if (k == 0) return force_uN[0];
  const double part = (at_um - depth_um[k - 1]) / (depth_um[k] - depth_um[k - 1]);
  return force_uN[k - 1] + part * (force_uN[k] - force_uN[k - 1]);
}

TeachTexts teach_texts(const CellSnapshot& s, double quasi_static_uN, const ThemeColors& theme) {
  TeachTexts texts;
  const auto plain = [&](std::string text) { return Phrase{std::move(text), theme.text}; };
  if (s.blow_up) {
    texts.state = {say("Blown up"), theme.record};
    texts.blow_up = blow_up_text(*s.blow_up, s.parameters.integrator);
  } else if (s.depth_um > 0.0) {
    texts.state = {say("In contact"), theme.warning};
  } else {
    texts.state = {say("Free"), theme.good};
  }
  texts.depth = plain(fixed_number(s.depth_um, 1) + " µm");
  texts.force = plain(fixed_number(s.force_uN, 2) + " µN");
  texts.force_note = {std::isfinite(quasi_static_uN) ? say("at rest: ") + fixed_number(quasi_static_uN, 2) + " µN" : "",
                      theme.text_dim};
  texts.volume = plain(fixed_number(100.0 * s.volume_change_ratio, 2) + " %");
  texts.energy = plain(short_number(s.potential_energy_pJ + s.kinetic_energy_pJ) + " pJ");
  texts.speed =
      plain(s.largest_speed_um_per_s < 1e5 ? fixed_number(s.largest_speed_um_per_s, 0) + " µm/s" : "> 0.1 m/s");
  const bool late = !s.blow_up && s.pace_ratio > 0.0 && s.pace_ratio < kInTime_ratio * s.parameters.pace_ratio;
  texts.rate = {fixed_number(s.steps_per_s, 0) + " /s, " + fixed_number(s.pace_ratio, 2) + "\u00d7",
                late ? theme.warning : theme.text};
  return texts;
}

std::vector<ForceRow> force_rows(const NodeForces& forces) {
  std::vector<ForceRow> rows;
  for (std::size_t k = 0; k < kForceTermCount; ++k) {
    rows.push_back({std::string(to_string(static_cast<ForceTerm>(k))), forces.force_uN[k], false});
  }
  rows.push_back({say("Sum: residual"), forces.residual_uN(), true});
  return rows;
}

Measurement chart_row(const CurvePoint& point, long index) {
  Measurement row;
  row.time_s = point.time_s;
  row.frame = index;
  row.state = point.depth_um > 0.0 ? CellState::kContact : CellState::kFree;
  row.indentation_um = point.depth_um;
  row.contact_force_uN = point.force_uN;
  return row;
}

}  // namespace pellucida
