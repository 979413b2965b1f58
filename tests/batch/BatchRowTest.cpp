#include "pellucida/batch/BatchRow.h"

#include <gtest/gtest.h>

#include <sstream>

#include "TestSessions.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/TemporaryFolder.h"

namespace pellucida {
namespace {

const Recording kCell{"cell, 1", "in/cell, 1.avi", "in"};

TEST(BatchRow, TheResultFollowsFromExitCodeAndSession) {
  const TemporaryFolder folder;
  test::write_session(folder / kCell.name, {0.0, 1.0, 2.0});
  const auto result = [&](int exit_code, const std::string& session) {
    RecordingRecord record;
    record.exit_code = exit_code;
    record.session_sha256 = session;
    record.wall_time_s = 0.4;
    return make_row(kCell, record, folder.path());
  };
  EXPECT_EQ(make_row(kCell, std::nullopt, folder.path()).result, batch_result::kWaiting);
  EXPECT_EQ(result(3, "").result, batch_result::kFailed);
  EXPECT_EQ(result(3, "").session, "");
  EXPECT_EQ(result(3, "x").result, batch_result::kDamaged);
  EXPECT_EQ(result(4, "x").result, batch_result::kNothing);
  const BatchRow row = result(0, "x");
  EXPECT_EQ(row.result, batch_result::kMeasured);
  EXPECT_EQ(row.session, kCell.name);
  EXPECT_EQ(row.numbers.frame_count, 3);
  EXPECT_NEAR(row.speed_ratio, 0.2 / 0.4, 1e-12);
}

TEST(BatchRow, TheTableHasACellForEachColumn) {
  BatchRow row;
  row.name = kCell.name;
  row.error = "it \"broke\", so";
  row.numbers.peak_force_uN = 1.5;
  const std::string csv = summary_csv(std::vector<BatchRow>{row, BatchRow{}});
  std::istringstream lines(csv);
  std::string header, first, second, none;
  std::getline(lines, header);
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_FALSE(std::getline(lines, none));
  const auto names = split_csv(header), cells = split_csv(first);
  ASSERT_EQ(names.size(), cells.size());
  EXPECT_EQ(names.size(), split_csv(second).size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == "name") {
      EXPECT_EQ(cells[i], row.name);
    }
    if (names[i] == "error") {
      EXPECT_EQ(cells[i], row.error);
    }
    if (names[i] == "peak_force_uN") {
      EXPECT_EQ(cells[i], "1.5");
    }
    if (names[i] == "puncture_force_uN") {
      EXPECT_EQ(cells[i], "");
    }
  }
}

}  // namespace
}  // namespace pellucida
