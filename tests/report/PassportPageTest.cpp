#include <gtest/gtest.h>

#include <regex>

#include "RecordedSession.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/report/PassportReport.h"

namespace pellucida {
namespace {

using test::linear;
using test::SyntheticRows;

SyntheticRows punctured_cell() {
  SyntheticRows rows;
  rows.approach();
  rows.push(0.5, 44.0, linear);
  rows.event(event_kind::kNote, "<img src=x onerror=alert(1)>");
  rows.punctured(30, 50.0);
  rows.approach(3);
  return rows;
}

std::string page_of(const SyntheticRows& rows) {
  const TemporaryFolder folder;
  test::write_session(folder / "s<1>", rows);
  const SessionReader session(folder / "s<1>");
  const PassportInput input = passport_input(session);
  return passport_page(session, input, cell_passports(input));
}

// The tags in their nesting; what is open at the end, or closed out of turn.
std::string fault_of_nesting(const std::string& html) {
  static const std::regex kTag(R"(<(/?)([a-zA-Z0-9]+)[^<>]*?(/?)>)");
  std::vector<std::string> open;
  for (std::sregex_iterator i(html.begin(), html.end(), kTag), end; i != end; ++i) {
    const std::string name = (*i)[2];
    if (name == "meta" || (*i)[3].length() > 0) continue;
    if ((*i)[1].length() == 0) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return "</" + name + "> inside <" + (open.empty() ? "nothing" : open.back()) + ">";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> stays open";
}

TEST(PassportPage, EveryTagIsClosedInTurn) {
  EXPECT_EQ(fault_of_nesting(page_of(punctured_cell())), "");
  EXPECT_EQ(fault_of_nesting(page_of(SyntheticRows())), "");
}

TEST(PassportPage, TextFromTheSessionIsEscaped) {
  const std::string page = page_of(punctured_cell());
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_NE(page.find("dish &lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; &amp; co.avi"), std::string::npos);
  EXPECT_NE(page.find("&lt;img src=x onerror=alert(1)&gt;"), std::string::npos);
  EXPECT_NE(page.find("<h1>s&lt;1&gt;</h1>"), std::string::npos);
}

// Nothing is fetched, nothing runs.
TEST(PassportPage, NeedsNothingElse) {
  const std::string page = page_of(punctured_cell());
  EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)=\"(?!#)")));
  EXPECT_EQ(page.find("http://"), std::string::npos);
  EXPECT_EQ(page.find("https://"), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

TEST(PassportPage, HasNumbersWithIntervalsCurvesAndProvenance) {
  const std::string page = page_of(punctured_cell());
  EXPECT_NE(page.find("4.40 \xC2\xB5N"), std::string::npos);
  EXPECT_NE(page.find("3.96 to 4.84"), std::string::npos);
  EXPECT_NE(page.find("96.8 pJ"), std::string::npos);
  std::size_t charts = 0;
  for (auto at = page.find("<svg"); at != std::string::npos; at = page.find("<svg", at + 1)) ++charts;
  EXPECT_EQ(charts, 4U);
  EXPECT_NE(page.find("Area strain of the outer membrane"), std::string::npos);
  EXPECT_NE(page.find("4.04 %"), std::string::npos);  // 1.02^2
  EXPECT_NE(page.find("0.8250 \xC2\xB5m (from: option)"), std::string::npos);
  EXPECT_NE(page.find("VTK 9.1.0"), std::string::npos);
  EXPECT_NE(page.find("profile 00ff"), std::string::npos);
}

TEST(PassportPage, WhatIsMissingIsSaidAndNeverNought) {
  const std::string page = page_of(punctured_cell());
  EXPECT_NE(page.find("no removal"), std::string::npos);
  EXPECT_NE(page.find("not recorded"), std::string::npos);
  for (const char* word : {">nan", ">inf", "\"nan", "-nan"}) EXPECT_EQ(page.find(word), std::string::npos) << word;
  SyntheticRows shallow;
  shallow.approach();
  shallow.push(0.5, 12.0, linear);
  shallow.push(11.5, 0.5, linear);
  shallow.approach(2);
  const std::string other = page_of(shallow);
  EXPECT_NE(other.find("not reached"), std::string::npos);
  EXPECT_NE(other.find("no puncture"), std::string::npos);
}

// A session may hold any number: no time, and forces beyond all reason.
TEST(PassportPage, StrangeNumbersAreNeverDrawn) {
  SyntheticRows rows = punctured_cell();
  rows.row(50).time_s = std::nan("");
  rows.row(60).contact_force_uN = 1e308;
  rows.row(61).contact_force_uN = -1e308;
  rows.row(70).indentation_um = 1e300;
  const std::string page = page_of(rows);
  EXPECT_EQ(fault_of_nesting(page), "");
  std::smatch found;
  EXPECT_FALSE(std::regex_search(page, found, std::regex("[\"> ,-](nan|inf)[\"< ,].{0,60}"))) << found[0];
}

TEST(PassportPage, SeveralCellsHaveASummaryAndNoCellASentence) {
  SyntheticRows rows = punctured_cell();
  rows.add(CellState::kNoCell);
  rows.approach(3);
  const std::string page = page_of(rows);
  EXPECT_NE(page.find("href=\"#cell-2\""), std::string::npos);
  EXPECT_NE(page.find("id=\"cell-2\""), std::string::npos);
  EXPECT_NE(page.find("not touched"), std::string::npos);
  EXPECT_NE(page_of(SyntheticRows()).find("No cell was found in this session."), std::string::npos);
}

}  // namespace
}  // namespace pellucida
