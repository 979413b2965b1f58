#include "pellucida/batch/OverviewPage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace pellucida {
namespace {

BatchRow measured(const std::string& name, const std::string& group, double peak_uN) {
  BatchRow row;
  row.name = row.session = name;
  row.group = group;
  row.result = batch_result::kMeasured;
  row.numbers.frame_count = 20;
  row.numbers.duration_s = 2.0;
  row.numbers.peak_force_uN = peak_uN;
  row.wall_time_s = 1.0;
  row.speed_ratio = 2.0;
  return row;
}

TEST(OverviewPage, ShowsEveryRecordingAndWhatWentWrong) {
  std::vector<BatchRow> rows{measured("a <1>", "control", 3.0), measured("b", "treated", 4.0)};
  rows.push_back({.name = "c",
                  .group = "control",
                  .input = "c.avi",
                  .result = batch_result::kFailed,
                  .exit_code = 3,
                  .error = "c.avi: empty file <0 bytes>"});
  const std::string page = overview_page("Day 1 & 2", rows, compare_groups(rows, groups_of(rows)));
  EXPECT_NE(page.find("<title>Day 1 &amp; 2</title>"), std::string::npos);
  EXPECT_NE(page.find(R"(<a href="a%20%3C1%3E/">a &lt;1&gt;</a>)"), std::string::npos);
  EXPECT_NE(page.find("c.avi: empty file &lt;0 bytes&gt;"), std::string::npos);
  EXPECT_NE(page.find("<b>2</b>measured to the end"), std::string::npos);
  EXPECT_NE(page.find("<b>1</b>failed"), std::string::npos);
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_EQ(page.find("nan"), std::string::npos);
  // Nothing is fetched from elsewhere, and nothing runs.
  EXPECT_FALSE(std::regex_search(page, std::regex("(src=|<script|https?:|url\\()")));
  // Every element that has content is closed.
  for (const char* tag : {"table", "tr", "td", "th", "svg", "div", "a", "ul", "li", "p", "h2", "span", "g", "text"}) {
    const std::regex open(std::string("<") + tag + "[ >]"), close(std::string("</") + tag + ">");
    const auto count = [&](const std::regex& what) {
      return std::distance(std::sregex_iterator(page.begin(), page.end(), what), std::sregex_iterator());
    };
    EXPECT_EQ(count(open), count(close)) << tag;
  }
}

TEST(OverviewPage, LeavesOutWhatThereIsNot) {
  const std::vector<BatchRow> rows{measured("a", "x", 3.0)};
  const std::string page = overview_page("One", rows, {});
  EXPECT_EQ(page.find("What went wrong"), std::string::npos);
  EXPECT_EQ(page.find("<h2>Groups"), std::string::npos);
  EXPECT_NE(page.find("1 recording, 2 s of film"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
