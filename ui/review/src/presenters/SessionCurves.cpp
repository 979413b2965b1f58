#include "presenters/SessionCurves.h"

#include <cmath>
#include <optional>

#include "pellucida/visualization/Readout.h"
#include "pellucida/visualization/TraceHistory.h"

namespace pellucida {
namespace {

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

}  // namespace

CurveChartData force_over_time(const RecordedSession& session) {
  CurveChartData data;
  data.x_title = "Time (s)";
  data.y_title = "Force (µN)";
  data.x_begin = session.begin_s();
  data.x_end = session.end_s();
  data.empty_text = "No force in this session";
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
    }
    data.curve.add(session.times_s[i], row.contact_force_uN, row.contact_force_lower_uN, row.contact_force_upper_uN);
  }
  return data;
}

std::size_t touch_of(const RecordedSession& session, std::size_t step) {
  TouchCounter touches;
  for (std::size_t i = 0; i <= step && i < session.step_count(); ++i) touches.take(session.rows[i]);
  return touches.count();
}

CurveChartData force_over_indentation(const RecordedSession& session, std::size_t step) {
  CurveChartData data;
  data.x_title = "Indentation (µm)";
  data.y_title = "Force (µN)";
  data.empty_text = "No force in this session";
  const std::size_t present = touch_of(session, step);
  TouchCounter touches;
  std::size_t drawn = 0;
  for (const Measurement& row : session.rows) {
    touches.take(row);
    if (row.state != CellState::kContact || !std::isfinite(row.contact_force_uN) ||
        !std::isfinite(row.indentation_um)) {
      continue;
    }
    Curve& curve = touches.count() == present ? data.curve : data.faint;
    if (touches.count() != drawn) curve.add_gap();
    drawn = touches.count();
    curve.add(row.indentation_um, row.contact_force_uN, row.contact_force_lower_uN, row.contact_force_upper_uN);
  }
  return data;
}

}  // namespace pellucida
