#include <gtest/gtest.h>

#include <algorithm>

#include "pellucida/batch/BatchRow.h"
#include "pellucida/batch/Groups.h"
#include "support/DocsPage.h"

// docs/file-format.md against the tables of columns.

namespace pellucida {
namespace {

template <class S>
std::string page_rows(std::span<const Field<S>> columns) {
  std::string rows;
  for (const Field<S>& column : columns) {
    const std::string unit = column.unit.empty() ? "" : std::string(column.unit) + ' ';
    rows += "| `" + std::string(column.name) + "` | " + unit + "| " + std::string(column.doc) + " |\n";
  }
  return rows;
}

void expect_table(const std::string& heading, const std::string& rows) {
  const std::string section = docs_section("file-format.md", heading);
  EXPECT_NE(section.find("|---|---|---|\n" + rows + "\n"), std::string::npos)
      << "docs/file-format.md, \"" << heading << "\", needs this table, and nothing more in it:\n"
      << rows;
}

TEST(BatchDocs, TheColumnsAreThoseOfThePage) {
  expect_table("## summary.csv", page_rows(batch_row_head_columns()) + page_rows(recording_summary_columns()) +
                                     page_rows(batch_row_tail_columns()));
  expect_table("## groups.csv", page_rows(group_columns()));
}

TEST(BatchDocs, TheQuantitiesAndResultsAreOnThePage) {
  const std::string groups = docs_section("file-format.md", "## groups.csv");
  for (const GroupQuantity& quantity : group_quantities()) {
    EXPECT_NE(groups.find('`' + std::string(quantity.name) + '`'), std::string::npos) << quantity.name;
  }
  const std::string summary = docs_section("file-format.md", "## summary.csv");
  for (const char* result : {batch_result::kMeasured, batch_result::kDamaged, batch_result::kNothing,
                             batch_result::kFailed, batch_result::kWaiting}) {
    EXPECT_NE(summary.find('`' + std::string(result) + '`'), std::string::npos) << result;
  }
  const std::string batch = docs_section("file-format.md", "## A batch");
  for (const char* name : {batch_name::kRecords, batch_name::kSummary, batch_name::kGroups, batch_name::kOverview,
                           batch_name::kReport, batch_name::kUnfinished}) {
    EXPECT_NE(batch.find(name), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace pellucida
