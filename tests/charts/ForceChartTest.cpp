#include "pellucida/charts_vtk/ForceChart.h"

#include <gtest/gtest.h>

#include "visualization/Views.h"

namespace pellucida {
namespace {

using test::Views;

TEST_F(Views, ChartDrawsItsCurveAndSaysWhenThereIsNone) {
  ForceChart chart(ForceChartKind::kForceIndentation);
  chart.add_to(window);
  EXPECT_GT(count_near(shot(), palette::kTextDim), 50);
  EXPECT_LT(count_near(shot(), palette::kCurve, 0.05), 5);
  for (const Measurement& m : test::synthetic_rows(100, 30.0)) chart.append(m);
  EXPECT_GT(count_near(shot(), palette::kCurve, 0.05), 300);
  chart.clear();
  EXPECT_LT(count_near(shot(), palette::kCurve, 0.05), 5);
  window->Finalize();
}

class ChartGap : public Views {
 protected:
  // A run in which frames 120 to 209 were not measured; from column `begin_px` to `end_px` the picture shows these
  // alone.
  void expect_gap(ForceChartKind kind, int begin_px, int end_px) {
    const Color& line = palette::kCurve;
    // Of the whole interval, where the narrower one doesn't cover it.
    const auto veil = [](double over, double under) { return 0.14 * over + 0.86 * under; };
    const Color band{veil(line.red, palette::kPanel.red), veil(line.green, palette::kPanel.green),
                     veil(line.blue, palette::kPanel.blue)};
    // Nearer than the grid's grey is to the band's.
    const auto drawn = [&](const Color& c) { return count_near(shot(), c, 0.015, begin_px, end_px); };
    const auto rows = test::synthetic_rows(300, 30.0);

    ForceChart chart(kind);
    chart.add_to(window);
    for (const Measurement& m : rows) chart.append(m);
    EXPECT_GT(drawn(line), 50);
    EXPECT_GT(drawn(band), 50);
    chart.clear();
    for (const Measurement& m : rows) {
      if (m.frame < 120 || m.frame >= 210) chart.append(m);
    }
    EXPECT_EQ(drawn(line), 0);
    EXPECT_EQ(drawn(band), 0);
    EXPECT_GT(count_near(shot(), line, 0.03), 100);
    window->Finalize();
  }
};

TEST_F(ChartGap, ShowsOverTime) {
  expect_gap(ForceChartKind::kForceTime, 310, 420);
}

TEST_F(ChartGap, ShowsOverIndentation) {
  expect_gap(ForceChartKind::kForceIndentation, 195, 300);
}

}  // namespace
}  // namespace pellucida
