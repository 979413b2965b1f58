#pragma once
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "pellucida/batch/BatchRow.h"

namespace pellucida {

/// A row of `groups.csv`: one quantity of `summary.csv` over the recordings of one group. NaN: can't be said.
struct GroupRow {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  std::string group;
  std::string quantity;
  int count = 0;
  double median = kNone;
  double lower_quartile = kNone;
  double upper_quartile = kNone;
  double hedges_g = kNone, hedges_g_lower = kNone, hedges_g_upper = kNone;
  double cliffs_delta = kNone, cliffs_delta_lower = kNone, cliffs_delta_upper = kNone;
};

/// The columns, with their meaning.
std::span<const Field<GroupRow>> group_columns() noexcept;

/// The quantities compared: numbers of `RecordingSummary`, by their names there.
struct GroupQuantity {
  std::string_view name;
  std::string_view title;  ///< on the page
  double RecordingSummary::*value;
};
std::span<const GroupQuantity> group_quantities() noexcept;

/// The groups in the order in which `rows` first name them; rows without a group belong to none.
std::vector<std::string> groups_of(std::span<const BatchRow> rows);
/// The numbers of one quantity in a group, of recordings that were measured to their end (the peak of one broken off is
/// not that of its cell), NaN left out.
std::vector<double> values_in(std::span<const BatchRow> rows, const std::string& group, const GroupQuantity& quantity);

/// Every group and quantity, compared with the first group named.
std::vector<GroupRow> compare_groups(std::span<const BatchRow> rows, std::span<const std::string> groups);
/// One quantity: `values` of each of `groups`, NaN left out.
std::vector<GroupRow> compare_groups(std::string_view quantity, std::span<const std::string> groups,
                                     std::vector<std::vector<double>> values);
std::string groups_csv(std::span<const GroupRow> groups);

/// What a table of conditions holds.
struct Conditions {
  std::vector<std::string> groups;  ///< in the table's order
  std::vector<std::string> notes;   ///< rows that name no recording, recordings in no group; a line each
};

/// Takes the group of each recording from a table with the columns `recording` (its name, its path, or its file's name
/// with or without its ending) and `group`; those it does not name are in none. Throws InputError for a table that
/// can't be read, lacks a column, or puts a recording into two groups.
Conditions take_conditions(const std::filesystem::path& table, std::vector<Recording>& recordings);

}  // namespace pellucida
