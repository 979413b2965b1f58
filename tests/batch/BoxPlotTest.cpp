#include "BoxPlot.h"

#include <gtest/gtest.h>

#include <regex>

namespace pellucida {
namespace {

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

}  // namespace
}  // namespace pellucida
