#include "BoxPlot.h"

#include <gtest/gtest.h>

#include <regex>

#include "Html.h"

namespace pellucida {
namespace {

TEST(BoxPlot, TicksAreRoundAndHoldTheRange) {
  EXPECT_EQ(round_ticks(0.0, 10.0, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(round_ticks(0.3, 7.2, 5), (std::vector<double>{0, 2, 4, 6, 8}));
  EXPECT_EQ(round_ticks(95.0, 105.0, 5), (std::vector<double>{94, 96, 98, 100, 102, 104, 106}));
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const auto ticks = round_ticks(-1.37 * scale, 2.91 * scale, 5);
    EXPECT_LE(ticks.front(), -1.37 * scale);
    EXPECT_GE(ticks.back(), 2.91 * scale);
    EXPECT_LE(ticks.size(), 9U);
  }
}

// The axis goes from 0 to 10 over 180 units: a value v lies at 30 + 18 (10 - v).
TEST(BoxPlot, TheBoxLiesAtItsQuartiles) {
  const std::string svg = box_plot_svg("force", std::vector<BoxSample>{{"a", {0, 2, 4, 6, 10}}});
  EXPECT_NE(svg.find(R"(y="102.0" width="34.0" height="72.0")"), std::string::npos) << svg;
  static const std::regex kDot("<circle[^>]* cy=\"([0-9.]+)\"");
  std::vector<double> dots;
  for (std::sregex_iterator i(svg.begin(), svg.end(), kDot), end; i != end; ++i) dots.push_back(std::stod((*i)[1]));
  EXPECT_EQ(dots, (std::vector<double>{210, 174, 138, 102, 30}));
}

TEST(BoxPlot, DrawsWhateverThereIs) {
  EXPECT_EQ(box_plot_svg("none", {}), "");
  EXPECT_EQ(box_plot_svg("none", std::vector<BoxSample>{{"a", {}}}), "");
  EXPECT_EQ(box_plot_svg("same", std::vector<BoxSample>{{"a", {1, 1}}, {"b", {1}}}), "");
  for (const double value : {0.0, 7.5, -3.0}) {
    const std::string svg = box_plot_svg("two", std::vector<BoxSample>{{"a", {value}}, {"b", {value + 1}}, {"c", {}}});
    EXPECT_EQ(svg.find("nan"), std::string::npos) << svg;
    EXPECT_EQ(svg.find("inf"), std::string::npos) << svg;
  }
  const std::string svg =
      box_plot_svg("names", std::vector<BoxSample>{{"<script>&", {1, 2}}, {"äöüäöüäöüäöüäöü", {1}}});
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_NE(svg.find("äöüäöü…"), std::string::npos) << svg;
}

TEST(Html, TextCanBeAnything) {
  EXPECT_EQ(html_text("<a href=\"x\">&'\n"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39; ");
  EXPECT_EQ(html_link("day 1/ä%#?.avi"), "day%201/%C3%A4%25%23%3F.avi");
  EXPECT_EQ(html_number(1.25, 1), "1.2");
  EXPECT_EQ(html_number(std::numeric_limits<double>::quiet_NaN(), 1), "–");
}

}  // namespace
}  // namespace pellucida
