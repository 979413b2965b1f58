#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "SyntheticRows.h"
#include "pellucida/core/Table.h"
#include "pellucida/report/PassportReport.h"
#include "support/DocsPage.h"

namespace pellucida {
namespace {

using test::linear;
using test::SyntheticRows;

using Rows = std::vector<std::map<std::string, std::string>>;

// A table by the names of its columns.
Rows read(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const auto names = split_csv(line);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size()) << "a name twice";
  Rows rows;
  while (std::getline(lines, line)) {
    const auto cells = split_csv(line);
    EXPECT_EQ(cells.size(), names.size()) << line;
    rows.emplace_back();
    for (std::size_t i = 0; i < std::min(cells.size(), names.size()); ++i) rows.back()[names[i]] = cells[i];
  }
  return rows;
}

SyntheticRows two_cells() {
  SyntheticRows rows;
  rows.approach();
  rows.push(0.5, 20.0, linear);
  rows.push(19.5, 0.5, linear);
  rows.approach(3);
  rows.push(0.5, 10.0, linear);
  rows.approach(3);
  rows.add(CellState::kNoCell);
  rows.approach(3);
  return rows;
}

TEST(PassportTables, ARowForEachCellAndEachContact) {
  const auto cells = two_cells().passports();
  const auto by_cell = read(cells_csv(cells)), by_contact = read(contacts_csv(cells));
  ASSERT_EQ(by_cell.size(), 2U);
  EXPECT_EQ(by_cell[0].at("session"), "a session");
  EXPECT_EQ(by_cell[0].at("contacts"), "2");
  EXPECT_EQ(by_cell[0].at("outcome"), "retracted");
  EXPECT_EQ(by_cell[0].at("peak_force_uN"), "2");
  EXPECT_EQ(by_cell[0].at("peak_force_upper_uN"), "2.2");
  EXPECT_EQ(by_cell[1].at("outcome"), "untouched");
  ASSERT_EQ(by_contact.size(), 2U);
  EXPECT_EQ(by_contact[1].at("cell"), "1");
  EXPECT_EQ(by_contact[1].at("contact"), "2");
  EXPECT_EQ(by_contact[1].at("peak_force_uN"), "1");
}

// Not reached, not recorded: an empty cell, in no case a 0 or the word nan.
TEST(PassportTables, WhatIsMissingIsEmpty) {
  const auto rows = read(cells_csv(two_cells().passports()));
  for (const char* name : {"puncture_s", "puncture_force_uN", "drop_uN", "stiffness_30um_uN_per_um", "deposit_s",
                           "largest_area_strain_percent"}) {
    EXPECT_EQ(rows[0].at(name), "") << name;
  }
  for (const auto& [name, cell] : rows[1]) {
    EXPECT_EQ(cell.find("nan"), std::string::npos) << name;
    if (name == "peak_force_uN" || name == "dwell_s" || name == "work_pJ") {
      EXPECT_EQ(cell, "") << name;
    }
  }
}

TEST(PassportTables, WordsWithCommasAreQuoted) {
  const SyntheticRows rows = two_cells();
  PassportInput input = rows.input();
  input.session = "dish 2, \"left\"";
  EXPECT_EQ(read(cells_csv(cell_passports(input)))[0].at("session"), input.session);
}

template <class S>
std::string as_page(std::span<const PassportField<S>> fields) {
  std::string rows;
  for (const auto& [field, label, heading] : fields) {
    rows +=
        "| `" + std::string(field.name) + "` | " + std::string(field.unit) + " | " + std::string(field.doc) + " |\n";
  }
  return rows;
}

// The page has both tables of fields word by word.
TEST(PassportTables, FileFormatPageHasTheColumnsInTheirOrder) {
  const std::string section = docs_section("file-format.md", "## cells.csv and contacts.csv");
  EXPECT_NE(section.find(as_page(cell_fields())), std::string::npos) << as_page(cell_fields());
  EXPECT_NE(section.find(as_page(contact_fields())), std::string::npos) << as_page(contact_fields());
}

// An interval's ends come right behind their number, which alone has a name for people.
TEST(PassportTables, IntervalsStandTogether) {
  const auto fields = contact_fields();
  int intervals = 0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool is_lower = fields[i].field.name.find("_lower") != std::string_view::npos;
    const bool is_upper = fields[i].field.name.find("_upper") != std::string_view::npos;
    EXPECT_EQ(fields[i].label.empty(), is_lower || is_upper) << fields[i].field.name;
    if (!is_lower) continue;
    ++intervals;
    ASSERT_GT(i, 0U);
    ASSERT_LT(i + 1, fields.size());
    EXPECT_FALSE(fields[i - 1].label.empty());
    EXPECT_NE(fields[i + 1].field.name.find("_upper"), std::string_view::npos);
    std::string name(fields[i].field.name);
    name.erase(name.find("_lower"), 6);
    EXPECT_EQ(name, fields[i - 1].field.name);
  }
  EXPECT_EQ(intervals, 12);
}

}  // namespace
}  // namespace pellucida
