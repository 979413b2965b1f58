#pragma once
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "pellucida/batch/Groups.h"
#include "pellucida/report/CellPassport.h"

namespace pellucida {

/// A session whose cells are to be in the table, and its group: the folder that holds it.
struct GroupedSession {
  std::filesystem::path folder;
  std::string group;
};

/// The sessions that a folder means: itself, or all below it, grouped as `analyze --group-by folder` groups them.
/// Throws InputError where there is none.
std::vector<GroupedSession> sessions_in(const std::filesystem::path& folder);

/// One cell of one session.
struct SessionCell {
  GroupedSession session;
  CellPassport passport;
};

/// The cells of a session, as the report has them. `progress` counts the surfaces read. Throws InputError for a session
/// that can't be read.
std::vector<SessionCell> cells_of(const GroupedSession& session, const SessionProgress& progress = {});

/// Cells of several sessions, a row each, in the order in which they were added; the numbers are those of each cell's
/// main contact (`CellPassport::main_contact`), as in `cells.csv`. Columns count from 0.
class CellTable {
 public:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  /// What a cell of the table says, and what it is sorted by; NaN: by its text.
  struct Entry {
    std::string text;
    double number = kNone;
  };

  /// The column of the peak force.
  static constexpr std::size_t kPeakForce = 4;
  static std::size_t column_count() noexcept;
  /// "Puncture force (µN)".
  static std::string column_title(std::size_t column);
  /// Whether a column holds numbers that groups can be compared by.
  static bool is_quantity(std::size_t column) noexcept;

  /// Cells of a session that is in the table already take the place of the former ones.
  void add(const std::vector<SessionCell>& cells);
  void remove(std::size_t row);
  void clear() noexcept { rows_.clear(); }
  const std::vector<SessionCell>& rows() const noexcept { return rows_; }
  /// A dash where the number was not reached or not recorded.
  Entry entry(std::size_t row, std::size_t column) const;

  /// The groups in the order of the rows, and one quantity in each, compared with the first group. Empty for a column
  /// that is none.
  std::vector<GroupRow> groups(std::size_t column) const;

  /// `group`, then the columns of `cells.csv`; a row a cell. Throws OutputError.
  void write(const std::filesystem::path& file) const;

 private:
  std::vector<SessionCell> rows_;
};

/// "2.31 (1.98 to 2.60), 5 cells": median, quartiles and number of a group; "no number" for none.
std::string group_words(const GroupRow& group);

}  // namespace pellucida
