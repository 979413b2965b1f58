#include "pellucida/batch/Groups.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/TemporaryFolder.h"
#include "support/Files.h"

namespace pellucida {
namespace {

BatchRow row(const std::string& group, double peak_uN, bool measured = true) {
  BatchRow result;
  result.group = group;
  result.result = measured ? batch_result::kMeasured : batch_result::kDamaged;
  result.numbers.peak_force_uN = peak_uN;
  return result;
}

const GroupRow& find(const std::vector<GroupRow>& rows, const std::string& group, const std::string& quantity) {
  for (const GroupRow& one : rows) {
    if (one.group == group && one.quantity == quantity) return one;
  }
  throw std::runtime_error("no such row");
}

TEST(Groups, EachIsComparedWithTheFirst) {
  std::vector<BatchRow> rows;
  for (const double value : {1, 2, 3, 4, 5}) rows.push_back(row("control", value));
  for (const double value : {3, 4, 5, 6, 7}) rows.push_back(row("treated", value));
  rows.push_back(row("treated", std::nan("")));
  rows.push_back(row("treated", 1000.0, false));
  rows.push_back(row("", 1000.0));
  const auto names = groups_of(rows);
  ASSERT_EQ(names, (std::vector<std::string>{"control", "treated"}));
  const auto groups = compare_groups(rows, names);
  EXPECT_EQ(groups.size(), 2 * group_quantities().size());

  const GroupRow& control = find(groups, "control", "peak_force_uN");
  EXPECT_EQ(control.count, 5);
  EXPECT_EQ(control.median, 3.0);
  EXPECT_EQ(control.lower_quartile, 2.0);
  EXPECT_EQ(control.upper_quartile, 4.0);
  EXPECT_TRUE(std::isnan(control.hedges_g));
  const GroupRow& treated = find(groups, "treated", "peak_force_uN");
  EXPECT_EQ(treated.count, 5);
  EXPECT_EQ(treated.median, 5.0);
  EXPECT_NEAR(treated.hedges_g, 1.1418, 1e-4);
  EXPECT_LT(treated.hedges_g_lower, treated.hedges_g);
  EXPECT_NEAR(treated.cliffs_delta, 0.64, 1e-12);
  EXPECT_LE(treated.cliffs_delta_upper, 1.0);
  // No puncture in any: rows without numbers.
  EXPECT_EQ(find(groups, "treated", "puncture_force_uN").count, 0);
  EXPECT_TRUE(std::isnan(find(groups, "treated", "puncture_force_uN").median));

  const std::string csv = groups_csv(groups);
  EXPECT_TRUE(csv.starts_with("group,quantity,n,median,"));
  EXPECT_EQ(split_csv(csv.substr(0, csv.find('\n'))).size(), group_columns().size());
}

TEST(Groups, AQuantityIsAColumnOfTheSummary) {
  for (const GroupQuantity& quantity : group_quantities()) {
    const auto columns = recording_summary_columns();
    EXPECT_TRUE(std::any_of(columns.begin(), columns.end(), [&](const auto& c) { return c.name == quantity.name; }))
        << quantity.name;
  }
}

class ConditionsTest : public testing::Test {
 protected:
  Conditions take(const std::string& text) {
    test::put(folder_ / "c.csv", text);
    return take_conditions(folder_ / "c.csv", recordings_);
  }

  TemporaryFolder folder_;
  std::vector<Recording> recordings_{
      {"a", "/data/a.avi", "data"}, {"day1_b", "/data/day1/b.avi", "day1"}, {"day2_b", "/data/day2/b.avi", "day2"}};
};

TEST_F(ConditionsTest, RecordingsAreNamedInSeveralWays) {
  const Conditions conditions =
      take("\xEF\xBB\xBFgroup,recording\r\ntreated,a.avi\r\n\r\ncontrol,/data/day1/b.avi\r\n\"late, cold\",day2_b\r\n");
  EXPECT_EQ(conditions.groups, (std::vector<std::string>{"treated", "control", "late, cold"}));
  EXPECT_TRUE(conditions.notes.empty());
  EXPECT_EQ(recordings_[0].group, "treated");
  EXPECT_EQ(recordings_[1].group, "control");
  EXPECT_EQ(recordings_[2].group, "late, cold");
}

TEST_F(ConditionsTest, WhatDoesNotFitIsSaid) {
  const Conditions conditions = take("recording,group\nb,control\nnowhere,control\n");
  EXPECT_EQ(recordings_[0].group, "");
  EXPECT_EQ(recordings_[1].group, "control");
  EXPECT_EQ(recordings_[2].group, "control");
  ASSERT_EQ(conditions.notes.size(), 2U);
  EXPECT_NE(conditions.notes[0].find("c.csv:3: no recording is called nowhere"), std::string::npos);
  EXPECT_NE(conditions.notes[1].find("1 recording in no group"), std::string::npos);

  EXPECT_THROW(take("recording,condition\na,control\n"), InputError);
  EXPECT_THROW(take("recording,group\na\n"), InputError);
  EXPECT_THROW(take("recording,group\na,control\na.avi,treated\n"), InputError);
  EXPECT_THROW(take(""), InputError);
  EXPECT_THROW(take_conditions(folder_ / "gone.csv", recordings_), InputError);
}

}  // namespace
}  // namespace pellucida
