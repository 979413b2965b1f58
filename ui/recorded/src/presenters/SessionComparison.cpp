#include "presenters/SessionComparison.h"

#include <algorithm>
#include <cmath>

#include "pellucida/charts/TraceHistory.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/SessionCurves.h"

namespace pellucida {
namespace {

constexpr const char* kDash = "–";

bool has_force(const Measurement& row) {
  return std::isfinite(row.contact_force_uN);
}

struct Difference {
  double value, lower, upper;
};

// Errors taken as independent: half the widths of both intervals add as their squares do.
Difference force_difference(const Measurement& shown, const Measurement& other) {
  const double value = other.contact_force_uN - shown.contact_force_uN;
  const double below = std::hypot(other.contact_force_uN - other.contact_force_lower_uN,
                                  shown.contact_force_upper_uN - shown.contact_force_uN);
  const double above = std::hypot(other.contact_force_upper_uN - other.contact_force_uN,
                                  shown.contact_force_uN - shown.contact_force_lower_uN);
  return {value, value - below, value + above};
}

std::string with_sign(double value, int decimals, const char* unit) {
  if (!std::isfinite(value)) return {};
  const std::string digits = readout::number(std::abs(value), decimals);
  // A difference of nothing has no sign.
  const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
  return (is_zero ? "" : value < 0.0 ? "−" : "+") + digits + " " + unit;
}

}  // namespace

std::string name_of(Alignment alignment) {
  switch (alignment) {
    case Alignment::kTime:
      return say("same time");
    case Alignment::kContact:
      return say("time since contact");
    case Alignment::kIndentation:
      return say("same indentation");
  }
  return {};
}

SessionComparison::SessionComparison(const RecordedSession& shown, const RecordedSession& other)
    : shown_(shown),
      other_(other),
      shown_track_(track_of(shown)),
      other_track_(track_of(other)),
      half_step_s_(0.5 * std::max(other.usual_step_s(), 1e-6)) {}

SessionComparison::Track SessionComparison::track_of(const RecordedSession& session) {
  Track track;
  track.touch_of_step = touches_of(session);
  for (std::size_t step = 0; step < session.step_count(); ++step) {
    const std::size_t number = track.touch_of_step[step];
    if (number == 0) continue;
    if (number > track.touches.size()) track.touches.push_back({step, step, step, session.times_s[step], {}});
    Touch& touch = track.touches.back();
    // What follows the contact until the next one is no part of it.
    if (session.rows[step].state != CellState::kContact) continue;
    touch.last = step;
    if (session.rows[step].indentation_um > session.rows[touch.deepest].indentation_um) touch.deepest = step;
  }
  for (Touch& touch : track.touches) {
    double reached_um = 0.0;
    for (std::size_t k = touch.first; k <= touch.deepest; ++k) {
      const Measurement& row = session.rows[k];
      // Comparisons with what wasn't measured are false.
      if (row.state == CellState::kContact && row.indentation_um > reached_um) reached_um = row.indentation_um;
      touch.reached_um.push_back(reached_um);
    }
  }
  return track;
}

const SessionComparison::Touch* SessionComparison::touch(const Track& track, std::size_t number) const {
  return number == 0 || number > track.touches.size() ? nullptr : &track.touches[number - 1];
}

std::optional<std::size_t> SessionComparison::partner(std::size_t step, Alignment alignment) const {
  if (step >= shown_.step_count() || other_.step_count() == 0) return std::nullopt;
  if (alignment == Alignment::kIndentation) return as_deep(step);
  double time_s = shown_.times_s[step] - shown_.begin_s() + other_.begin_s();
  if (alignment == Alignment::kContact) {
    // Before the first touch, time runs down to it.
    const std::size_t number = std::max<std::size_t>(shown_track_.touch_of_step[step], 1);
    const Touch *here = touch(shown_track_, number), *there = touch(other_track_, number);
    if (!here || !there) return std::nullopt;
    time_s = shown_.times_s[step] - here->begin_s + there->begin_s;
  }
  // The nearest frame; times of two recordings of one film differ by rounding alone.
  if (time_s < other_.begin_s() - half_step_s_ || time_s > other_.end_s() + half_step_s_) return std::nullopt;
  return other_.step_at(time_s + half_step_s_);
}

std::optional<std::size_t> SessionComparison::as_deep(std::size_t step) const {
  const Measurement& row = shown_.rows[step];
  const std::size_t number = shown_track_.touch_of_step[step];
  const Touch *here = touch(shown_track_, number), *there = touch(other_track_, number);
  if (!here || !there || row.state != CellState::kContact || !std::isfinite(row.indentation_um)) return std::nullopt;
  // Along the way in: the first frame that is as deep. On the way out: the last.
  if (step <= here->deepest) {
    const auto& reached_um = there->reached_um;
    const auto place = std::lower_bound(reached_um.begin(), reached_um.end(), row.indentation_um);
    if (place == reached_um.end()) return std::nullopt;
    return there->first + static_cast<std::size_t>(place - reached_um.begin());
  }
  for (std::size_t k = there->last + 1; k-- > there->deepest;) {
    const Measurement& other = other_.rows[k];
    if (other.state == CellState::kContact && other.indentation_um >= row.indentation_um) return k;
  }
  return std::nullopt;
}

std::vector<ComparisonRow> SessionComparison::rows(std::size_t step, std::optional<std::size_t> partner) const {
  const Measurement& a = shown_.rows[step];
  const Measurement* b = partner ? &other_.rows[*partner] : nullptr;
  const auto of_other = [&](auto text) { return b ? text(*b) : std::string(kDash); };
  const auto difference = [&](double Measurement::*member, double scale, int decimals, const char* unit) {
    return b ? with_sign(scale * (b->*member - a.*member), decimals, unit) : std::string();
  };
  const auto state = [](const Measurement& row) { return readout::state(row.state); };
  std::vector<ComparisonRow> rows;
  rows.push_back({say("State"), state(a), of_other(state), {}});
  rows.push_back({say("Time"),
                  readout::time(shown_.times_s[step]),
                  b ? readout::time(other_.times_s[*partner]) : std::string(kDash),
                  {}});
  rows.push_back({say("Indentation"), readout::indentation(a), of_other(readout::indentation),
                  difference(&Measurement::indentation_um, 1.0, 1, "µm")});
  rows.push_back({say("Force"), readout::force(a), of_other(readout::force),
                  difference(&Measurement::contact_force_uN, 1.0, 2, "µN")});
  if (b && has_force(a) && has_force(*b)) {
    const Difference d = force_difference(a, *b);
    rows.push_back({"95 %", readout::force_interval(a), readout::force_interval(*b),
                    readout::number(d.lower, 2) + " – " + readout::number(d.upper, 2) + " µN"});
  }
  rows.push_back({say("Pressure"), readout::pressure(a), of_other(readout::pressure),
                  difference(&Measurement::pressure_Pa, 1.0, 0, "Pa")});
  rows.push_back({say("Confidence"), readout::confidence(a), of_other(readout::confidence), {}});
  return rows;
}

Curve SessionComparison::other_over_time(Alignment alignment) const {
  Curve curve;
  for (std::size_t k = 0; k < other_.step_count(); ++k) {
    const Measurement& row = other_.rows[k];
    double shift_s = shown_.begin_s() - other_.begin_s();
    if (alignment != Alignment::kTime) {
      const std::size_t number = std::max<std::size_t>(other_track_.touch_of_step[k], 1);
      const Touch *here = touch(shown_track_, number), *there = touch(other_track_, number);
      if (!here || !there) continue;
      shift_s = here->begin_s - there->begin_s;
    }
    const double time_s = other_.times_s[k] + shift_s;
    if (!has_force(row)) continue;
    // Shifted touches may overlap in time: the line is not led back.
    if (!curve.empty() && (time_s - curve.x.back() > TraceHistory::kBridged_s || time_s < curve.x.back()))
      curve.add_gap();
    curve.add(time_s, row.contact_force_uN, row.contact_force_lower_uN, row.contact_force_upper_uN);
  }
  return curve;
}

Curve SessionComparison::other_over_indentation(std::size_t step) const {
  Curve curve;
  const Touch* there = touch(other_track_, std::max<std::size_t>(shown_track_.touch_of_step.at(step), 1));
  if (!there) return curve;
  for (std::size_t k = there->first; k <= there->last; ++k) {
    const Measurement& row = other_.rows[k];
    if (row.state != CellState::kContact || !has_force(row) || !std::isfinite(row.indentation_um)) continue;
    curve.add(row.indentation_um, row.contact_force_uN, row.contact_force_lower_uN, row.contact_force_upper_uN);
  }
  return curve;
}

std::vector<SessionComparison::Pair> SessionComparison::pairs(std::size_t step, Alignment alignment) const {
  std::size_t begin = 0, end = shown_.step_count();
  const bool by_depth = alignment == Alignment::kIndentation;
  if (by_depth) {
    const Touch* here = touch(shown_track_, std::max<std::size_t>(shown_track_.touch_of_step.at(step), 1));
    if (!here) return {};
    begin = here->first;
    end = here->deepest + 1;
  }
  std::vector<Pair> pairs;
  double deepest_um = -1.0;
  for (std::size_t k = begin; k < end; ++k) {
    const Measurement& row = shown_.rows[k];
    const auto other = partner(k, alignment);
    if (!other || !has_force(row) || !has_force(other_.rows[*other])) continue;
    // Noise on the way in goes back by a little now and then.
    if (by_depth && row.indentation_um <= deepest_um) continue;
    if (by_depth) deepest_um = row.indentation_um;
    pairs.push_back({by_depth ? row.indentation_um : shown_.times_s[k], &row, &other_.rows[*other]});
  }
  return pairs;
}

CurveChartData SessionComparison::difference(std::size_t step, Alignment alignment) const {
  CurveChartData data;
  const bool by_depth = alignment == Alignment::kIndentation;
  data.x_title = by_depth ? say("Indentation (µm)") : say("Time (s)");
  data.y_title = say("Difference (µN)");
  data.empty_text = say("No force at the same place in both");
  if (!by_depth) {
    data.x_begin = shown_.begin_s();
    data.x_end = shown_.end_s();
  }
  for (const Pair& pair : pairs(step, alignment)) {
    if (!by_depth && !data.curve.empty() && pair.x - data.curve.x.back() > TraceHistory::kBridged_s)
      data.curve.add_gap();
    const Difference d = force_difference(*pair.shown, *pair.other);
    data.curve.add(pair.x, d.value, d.lower, d.upper);
  }
  return data;
}

void SessionComparison::write_difference(std::size_t step, Alignment alignment,
                                         const std::filesystem::path& file) const {
  OutputFile table(file);
  table.add(std::string(alignment == Alignment::kIndentation ? "indentation_um" : "time_s") +
            ",force_uN,force_lower_uN,force_upper_uN,other_force_uN,other_force_lower_uN,other_force_upper_uN,"
            "difference_uN,difference_lower_uN,difference_upper_uN");
  for (const Pair& pair : pairs(step, alignment)) {
    const Difference d = force_difference(*pair.shown, *pair.other);
    std::string line = csv_number(pair.x);
    for (const Measurement* row : {pair.shown, pair.other}) {
      for (const double value : {row->contact_force_uN, row->contact_force_lower_uN, row->contact_force_upper_uN})
        line += ',' + csv_number(value);
    }
    for (const double value : {d.value, d.lower, d.upper}) line += ',' + csv_number(value);
    table.add(line);
  }
  table.finish();
}

}  // namespace pellucida
