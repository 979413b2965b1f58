#pragma once
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "pellucida/core/CellNameNote.h"
#include "pellucida/core/NewCellNote.h"
#include "pellucida/report/CellPassport.h"

namespace pellucida::test {

/// Rows as a session has them, 30 a second, of a cell of radius 50 um at (100, 80) um with the needle at its right.
/// Forces have an interval of +- 10 %.
class SyntheticRows {
 public:
  static constexpr double kPeriod_s = 1.0 / 30.0;
  static constexpr double kStep_um = 0.5;  ///< of the needle, from frame to frame: 15 um/s

  using Curve = std::function<double(double depth_um)>;

  Measurement& add(std::optional<CellState> state) {
    Measurement m;
    m.frame = static_cast<long>(rows_.size());
    m.time_s = time_s_;
    m.state = state;
    time_s_ += kPeriod_s;
    rows_.push_back(m);
    return rows_.back();
  }

  /// The needle `away_um` before the membrane (negative: past it), the membrane at `depth_um`.
  Measurement& seen(CellState state, double away_um, double depth_um, double force_uN) {
    Measurement& m = add(state);
    m.confidence = 0.9;
    m.cell_x_um = cell_x_um;
    m.cell_y_um = 80.0;
    m.axis_deg = 0.0;
    m.tip_x_um = cell_x_um + radius_um + away_um;
    m.tip_y_um = 80.0;
    m.indentation_um = depth_um;
    m.volume_um3 = 4.0 / 3.0 * M_PI * std::pow(radius_um, 3);
    m.contact_force_uN = force_uN;
    m.contact_force_lower_uN = 0.9 * force_uN;
    m.contact_force_upper_uN = 1.1 * force_uN;
    return m;
  }

  /// Untouched frames, the needle coming nearer.
  void approach(int count = 30) {
    for (int i = count - 1; i >= 0; --i) seen(CellState::kFree, kStep_um * i, 0.0, 0.0);
  }
  /// In contact from one depth to another, both included.
  void push(double from_um, double to_um, const Curve& force_uN) {
    const int count = static_cast<int>(std::lround(std::abs(to_um - from_um) / kStep_um));
    for (int i = 0; i <= count; ++i) {
      const double depth_um = from_um + (to_um > from_um ? 1.0 : -1.0) * kStep_um * i;
      seen(CellState::kContact, -depth_um, depth_um, force_uN(depth_um));
    }
  }
  void punctured(int count, double tip_depth_um, double depth_um = 1.0) {
    for (int i = 0; i < count; ++i) seen(CellState::kPunctured, -tip_depth_um, depth_um, 0.0);
  }
  void lost(int count) {
    for (int i = 0; i < count; ++i) add(CellState::kLost);
  }
  void event(const char* kind, const std::string& detail) { events_.push_back({time_s_, kind, detail}); }

  /// Two cells, the first named A-1, of a camera so late that no row lies between that and the note of the second.
  static SyntheticRows named_without_a_row() {
    constexpr double kLate_s = 0.3;
    SyntheticRows rows;
    rows.approach(5);
    for (const std::string& note : {std::string(kCellNameNote) + "A-1", std::string(kNewCellNote)}) {
      rows.time_s_ += kLate_s;
      rows.event(event_kind::kNote, note);
    }
    rows.time_s_ += kLate_s;
    rows.approach(5);
    return rows;
  }

  std::size_t size() const { return rows_.size(); }
  Measurement& row(std::size_t i) { return rows_[i]; }
  double now_s() const { return time_s_; }
  const std::vector<Measurement>& rows() const { return rows_; }
  const std::vector<Event>& events() const { return events_; }

  /// Belongs to this.
  PassportInput input() const {
    PassportInput input;
    input.session = "a session";
    input.profile = "mouse-oocyte";
    input.rows = rows_;
    input.events = events_;
    return input;
  }
  std::vector<CellPassport> passports() const { return cell_passports(input()); }

  double cell_x_um = 100.0;
  double radius_um = 50.0;

 private:
  std::vector<Measurement> rows_;
  std::vector<Event> events_;
  double time_s_ = 0.0;
};

inline double linear(double depth_um) {
  return 0.1 * depth_um;
}
inline double square(double depth_um) {
  return 0.004 * depth_um * depth_um;
}

inline bool mentions(const std::vector<std::string>& sentences, const std::string& part) {
  for (const std::string& sentence : sentences)
    if (sentence.find(part) != std::string::npos) return true;
  return false;
}

}  // namespace pellucida::test
