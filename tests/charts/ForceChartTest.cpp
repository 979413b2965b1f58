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

TEST_F(Views, TheTrueForceIsACurveOnDemand) {
  for (const ForceChartKind kind : {ForceChartKind::kForceIndentation, ForceChartKind::kForceTime}) {
    ForceChart chart(kind);
    chart.add_to(window);
    const auto green = [&] { return count_near(shot(), current_theme().good, 0.05); };
    for (const Measurement& m : test::synthetic_rows(100, 30.0)) chart.append(m, 0.5 * m.contact_force_uN);
    EXPECT_LT(green(), 5);
    chart.show_truth(true);
    EXPECT_GT(green(), 100);
    chart.show_truth(false);
    EXPECT_LT(green(), 5);
    window->Finalize();
  }
}

// An hour at 30 frames/s holds as much as is drawn of it: no more than of minutes.
TEST(ForceChartLength, AnHourHoldsNoMoreThanMinutesDo) {
  TraceHistory history;
  Measurement m;
  m.state = CellState::kContact;
  m.contact_force_uN = 1.0;
  for (long frame = 0; frame < 108000; ++frame) {
    m.frame = frame;
    m.time_s = static_cast<double>(frame) / 30.0;
    m.indentation_um = 10.0;
    history.append(m);
  }
  EXPECT_LE(history.over_time().size(), TraceHistory::kMostPoints);
  EXPECT_LE(history.current_touch().size(), TraceHistory::kMostPoints);
  EXPECT_DOUBLE_EQ(history.over_time().back().time_s, m.time_s);
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
