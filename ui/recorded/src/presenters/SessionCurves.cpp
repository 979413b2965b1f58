#include "presenters/SessionCurves.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "pellucida/charts/TraceHistory.h"
#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr double kLeastWayBack_um = 2.0;

bool worth_a_mark(CellState state) {
  return state == CellState::kContact || state == CellState::kPunctured || state == CellState::kLost;
}

// Counts touches row by row.
class TouchCounter {
 public:
  void take(const Measurement& row) {
    if (!row.state) return;
    if (row.state == CellState::kContact && last_ != CellState::kContact && last_ != CellState::kLost) ++count_;
    last_ = row.state;
  }
  std::size_t count() const noexcept { return count_; }

 private:
  std::optional<CellState> last_;
  std::size_t count_ = 0;
};

// The force with its whole interval, and with what the picture leaves open.
void add_force(double x, const Measurement& row, Curve& curve, Curve& inner) {
  curve.add(x, row.contact_force_uN, row.contact_force_lower_uN, row.contact_force_upper_uN);
  inner.add(x, row.contact_force_uN, row.contact_force_picture_lower_uN, row.contact_force_picture_upper_uN);
}

bool has_point(const Measurement& row) {
  return row.state == CellState::kContact && std::isfinite(row.contact_force_uN) && std::isfinite(row.indentation_um);
}

// Sessions of earlier versions know one interval.
CurveChartData without_empty_band(CurveChartData data) {
  bool has_band = false;
  for (std::size_t i = 0; i < data.inner.size(); ++i) has_band |= data.inner.lower[i] < data.inner.upper[i];
  if (!has_band) data.inner = {};
  return data;
}

}  // namespace

CurveChartData force_over_time(const RecordedSession& session) {
  CurveChartData data;
  data.x_title = say("Time (s)");
  data.y_title = say("Force (µN)");
  data.x_begin = session.begin_s();
  data.x_end = session.end_s();
  data.empty_text = say("No force in this session");
  std::optional<CellState> last;
  for (std::size_t i = 0; i < session.step_count(); ++i) {
    const Measurement& row = session.rows[i];
    if (row.state && row.state != last && worth_a_mark(*row.state) && data.marks.size() < TraceHistory::kMostMarks) {
      data.marks.push_back({session.times_s[i], readout::state(row.state), state_color(row.state)});
    }
    if (row.state) last = row.state;
    if (!std::isfinite(row.contact_force_uN)) continue;
    if (!data.curve.empty() && session.times_s[i] - data.curve.x.back() > TraceHistory::kBridged_s) {
      data.curve.add_gap();
      data.inner.add_gap();
    }
    add_force(session.times_s[i], row, data.curve, data.inner);
  }
  return without_empty_band(std::move(data));
}

std::vector<std::size_t> touches_of(const RecordedSession& session) {
  TouchCounter touches;
  std::vector<std::size_t> numbers;
  numbers.reserve(session.step_count());
  for (const Measurement& row : session.rows) {
    touches.take(row);
    numbers.push_back(touches.count());
  }
  return numbers;
}

std::size_t touch_of(const RecordedSession& session, std::size_t step) {
  TouchCounter touches;
  for (std::size_t i = 0; i <= step && i < session.step_count(); ++i) touches.take(session.rows[i]);
  return touches.count();
}

std::size_t turning_step(const RecordedSession& session, std::size_t touch) {
  TouchCounter touches;
  std::vector<std::size_t> steps;
  for (std::size_t i = 0; i < session.step_count(); ++i) {
    touches.take(session.rows[i]);
    if (touches.count() == touch && has_point(session.rows[i])) steps.push_back(i);
  }
  const auto depth_um = [&](std::size_t step) { return session.rows[step].indentation_um; };
  const auto less = [&](std::size_t a, std::size_t b) { return depth_um(a) < depth_um(b); };
  const auto deepest = std::max_element(steps.begin(), steps.end(), less);
  if (deepest == steps.end()) return session.step_count();
  // A needle that is held still is not withdrawn.
  const double back_um = depth_um(*deepest) - depth_um(*std::min_element(deepest, steps.end(), less));
  return back_um > kLeastWayBack_um ? *deepest : session.step_count();
}

CurveChartData force_over_indentation(const RecordedSession& session, std::size_t step) {
  CurveChartData data;
  data.x_title = say("Indentation (µm)");
  data.y_title = say("Force (µN)");
  data.empty_text = say("No force in this session");
  const std::size_t present = touch_of(session, step);
  const std::size_t turn = turning_step(session, present);
  TouchCounter touches;
  std::size_t drawn = 0;
  Curve unseen;  // the other touches have no band
  Curve back;
  for (std::size_t i = 0; i < session.step_count(); ++i) {
    const Measurement& row = session.rows[i];
    touches.take(row);
    if (!has_point(row)) continue;
    const bool is_present = touches.count() == present;
    if (is_present && i >= turn) back.add(row.indentation_um, row.contact_force_uN);
    if (is_present && i > turn) continue;
    Curve& curve = is_present ? data.curve : data.faint;
    Curve& inner = is_present ? data.inner : unseen;
    if (touches.count() != drawn) {
      curve.add_gap();
      inner.add_gap();
    }
    drawn = touches.count();
    add_force(row.indentation_um, row, curve, inner);
  }
  data.curve_name = say("Measured");
  if (back.size() > 1) {
    data.curve_name = say("Loading");
    data.named.push_back({say("Unloading"), std::move(back), CurveRole::kBack});
  }
  return without_empty_band(std::move(data));
}

}  // namespace pellucida
