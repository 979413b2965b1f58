#pragma once
#include <span>
#include <string>
#include <vector>

#include "pellucida/report/CellPassport.h"

namespace pellucida {

/// A cell of the run, for a line of the window's list. UTF-8; a dash for what there is not.
struct CellRow {
  std::string name;     ///< as it was given, else its number in the run
  std::string outcome;  ///< how its main contact ended
  std::string force;    ///< "7.27": at the puncture, else the largest; uN
  std::string depth;    ///< at that force; um
  std::string work;     ///< up to the puncture, else to the largest depth; pJ
  std::string time;     ///< of the puncture, else of the largest force; s
  bool is_punctured = false;

  bool operator==(const CellRow&) const = default;
};
CellRow cell_row(const CellPassport& cell);

/// The name that follows: "A-1" to "A-2", "oocyte 09" to "oocyte 10"; a name without a number gets one; "A-1" first.
std::string next_cell_name(const std::string& name);

/// The cells of a run, as a report of its recording would have them: by `cell_passports`, from the rows and events so
/// far. Cells that another one followed are settled, and their rows forgotten. One thread; `evaluate` may be called on
/// another.
class CellLog {
 public:
  /// Rows and events of cells that are not settled yet.
  struct Pending {
    std::string profile;
    std::vector<Measurement> rows;
    std::vector<Event> events;
    std::vector<long> run_starts;
  };

  explicit CellLog(std::string profile) { pending_.profile = std::move(profile); }

  /// The next rows and events, in order. True when the list has something new to say: another cell, contact or name.
  bool take(std::span<const Measurement> rows, std::span<const Event> events);
  /// The source began anew with this frame.
  void begin_anew(long frame);
  const Pending& pending() const noexcept { return pending_; }
  /// The cells in these rows. Takes some milliseconds for a minute of rows.
  static std::vector<CellPassport> evaluate(Pending pending);
  /// What became of the rows so far, or an earlier state of them.
  void settle(std::vector<CellPassport> cells);

  /// All, in the order of time, numbered from 1; the last one may not be at its end.
  const std::vector<CellPassport>& cells() const noexcept { return cells_; }
  /// Of the cell in view; empty: it has none yet.
  const std::string& name() const noexcept { return name_; }
  /// For the cell in view, or the next.
  std::string suggested_name() const { return next_cell_name(last_name_); }

 private:
  Pending pending_;
  std::vector<CellPassport> cells_;
  std::size_t settled_count_ = 0;
  std::string name_, last_name_;
};

}  // namespace pellucida
