#include "pellucida/core/Table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

std::filesystem::path write_file(const std::string& name, const std::string& text) {
  const auto file = std::filesystem::path(testing::TempDir()) / name;
  std::ofstream(file) << text;
  return file;
}

TEST(Table, ReadsColumnsByName) {
  const auto table = Table::read(write_file("good.csv", "depth_um,force_uN\r\n0,0\n10,0.129\n\n20,\n"));
  EXPECT_EQ(table.rows(), 3);
  EXPECT_DOUBLE_EQ(table.column("force_uN")[1], 0.129);
  EXPECT_TRUE(std::isnan(table.column("force_uN")[2]));
  EXPECT_TRUE(table.has("depth_um"));
  EXPECT_THROW(table.column("pressure_Pa"), InputError);
}

TEST(Table, ExcelsByteOrderMarkIsNoPartOfAName) {
  const auto table = Table::read(write_file("mark.csv",
                                            "\xEF\xBB\xBF"
                                            "depth_um,force_uN\n1,2\n"));
  EXPECT_DOUBLE_EQ(table.column("depth_um")[0], 1.0);
}

TEST(Table, ErrorsNameFileAndLine) {
  EXPECT_THROW(Table::read("/nowhere/at/all.csv"), InputError);
  EXPECT_THROW(Table::read(write_file("empty.csv", "")), InputError);
  for (const char* text : {"a,b\n1,2\n3\n", "a,b\n1,2\n3,x\n"}) {
    try {
      Table::read(write_file("bad.csv", text));
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("bad.csv:3"), std::string::npos) << error.what();
    }
  }
}

TEST(Csv, CellsWithCommasAndQuotesRoundTrip) {
  const std::string detail = "limit \"force\" acted, 8 uN";
  const auto cells = split_csv("1.5," + csv_cell(detail) + ",x");
  ASSERT_EQ(cells.size(), 3U);
  EXPECT_EQ(cells[1], detail);
  EXPECT_EQ(csv_cell("plain"), "plain");
  EXPECT_EQ(csv_number(std::nan("")), "");
  EXPECT_EQ(csv_number(0.1 + 0.2), "0.3");
}

// The same cells, whether they are views of the line or had to be unquoted.
TEST(CsvCells, AreThoseOfSplitCsv) {
  CsvCells cells;
  for (const std::string line : {"", ",", "1,2.5,,x", "a", ",,b", "\"a, b\",\"say \"\"so\"\"\",c", "1,2\r", "3,4"}) {
    const auto split = cells.split(line);
    EXPECT_EQ(std::vector<std::string>(split.begin(), split.end()), split_csv(line)) << line;
  }
}

}  // namespace
}  // namespace pellucida
