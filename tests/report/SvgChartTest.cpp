#include "SvgChart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace pellucida {
namespace {

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// The y of each point of the first polyline.
std::vector<double> heights(const std::string& svg) {
  const auto begin = svg.find("points=\"", svg.find("<polyline")) + 8;
  const std::string points = svg.substr(begin, svg.find('"', begin) - begin);
  static const std::regex kPoint(R"(([\d.-]+),([\d.-]+) )");
  std::vector<double> y;
  for (std::sregex_iterator i(points.begin(), points.end(), kPoint), end; i != end; ++i)
    y.push_back(std::stod((*i)[2]));
  return y;
}

Chart chart_of(std::vector<ChartPoint> points) {
  Chart chart;
  chart.title = "Force";
  chart.x_label = "time (s)";
  chart.y_label = "force";
  chart.lines.push_back({std::move(points), "curve", ""});
  return chart;
}

TEST(SvgChart, LargerValuesStandHigherAndTheAxisHoldsZero) {
  const std::string svg = svg_of(chart_of({{0, 1}, {1, 2}, {2, 5}}));
  const auto y = heights(svg);
  ASSERT_EQ(y.size(), 3U);
  EXPECT_GT(y[0], y[1]);
  EXPECT_NEAR((y[0] - y[2]) / (y[0] - y[1]), 4.0, 0.05);
  EXPECT_NE(svg.find(">0</text>"), std::string::npos);
  EXPECT_NE(svg.find(">time (s)</text>"), std::string::npos);
}

TEST(SvgChart, ANumberThatIsMissingBreaksLineAndBand) {
  Chart chart = chart_of({{0, 1}, {1, 2}, {1.5, NAN}, {2, 5}, {3, 4}});
  chart.bands.push_back({{{0, 1, 2}, {1, 1, 2}, {1.5, NAN, NAN}, {2, 1, 2}, {3, 1, 2}}});
  const std::string svg = svg_of(chart);
  EXPECT_EQ(count_of(svg, "<polyline"), 2);
  EXPECT_EQ(count_of(svg, "<polygon"), 2);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(SvgChart, NothingToDrawIsSaid) {
  const std::string text = svg_of(chart_of({{0, NAN}}));
  EXPECT_EQ(text.find("<svg"), std::string::npos);
  EXPECT_NE(text.find("Force: not recorded"), std::string::npos);
}

// A long recording: one peak of a single frame must not be lost.
TEST(SvgChart, ThinningKeepsThePeak) {
  std::vector<ChartPoint> points;
  for (int i = 0; i < 100000; ++i) points.push_back({0.001 * i, i == 54321 ? 9.0 : 1.0});
  const std::string svg = svg_of(chart_of(std::move(points)));
  const auto y = heights(svg);
  EXPECT_LT(y.size(), 1000U);
  EXPECT_LT(*std::min_element(y.begin(), y.end()), y.front() - 100.0);
}

TEST(SvgChart, TextIsEscaped) {
  Chart chart = chart_of({{0, 1}, {1, 2}});
  chart.title = "<b>";
  chart.marks.push_back({0.5, "<i>"});
  const std::string svg = svg_of(chart);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  EXPECT_NE(svg.find("&lt;i&gt;"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
