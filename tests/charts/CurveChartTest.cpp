#include "pellucida/charts_vtk/CurveChart.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkRenderWindow.h>

#include "pellucida/charts_vtk/ChartPicture.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/visualization/VirtualDisplay.h"
#include "pellucida/visualization_vtk/MessageLog.h"
#include "support/Files.h"

namespace pellucida {
namespace {

// An off-screen window on a display of its own where there is none. Fails on any VTK error or warning.
class CurveChartTest : public testing::Test {
 protected:
  CurveChartTest() : log_(MessageLog::install()), problems_(log_->problem_count()) {
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(0);
    window_->SetSize(640, 300);
  }
  ~CurveChartTest() override { EXPECT_EQ(log_->problem_count(), problems_) << log_->last_problem(); }

  static CurveChartData rise() {
    CurveChartData data;
    data.x_title = "Time (s)";
    data.y_title = "Force (uN)";
    data.x_begin = 2.0;
    data.x_end = 12.0;
    for (int i = 0; i <= 100; ++i) data.curve.add(2.0 + 0.1 * i, 0.05 * i, 0.04 * i, 0.06 * i);
    data.marks.push_back({5.0, "Contact", palette::kAccent});
    return data;
  }

  static ChartPanel panel() {
    ChartPanel panel;
    panel.title = "Force over time";
    panel.x_title = "Time (s)";
    panel.y_title = "Force (uN)";
    panel.series.push_back({.name = "force", .x = {0.0, 0.5, 1.0}, .y = {0.0, 0.9, 0.2}});
    return panel;
  }

  VirtualDisplay display_;
  vtkNew<vtkRenderWindow> window_;
  TemporaryFolder folder_;

 private:
  MessageLog* log_;
  std::uint64_t problems_;
};

TEST_F(CurveChartTest, APlaceOfTheWidgetIsAValueOfTheAxis) {
  CurveChart chart;
  EXPECT_FALSE(chart.x_at(100.0));
  chart.set_data(rise());
  chart.set_cursor(7.0, 2.5, true);
  chart.add_to(window_);
  window_->Render();
  ASSERT_TRUE(chart.x_at(0.0));
  EXPECT_DOUBLE_EQ(*chart.x_at(0.0), 2.0);
  EXPECT_DOUBLE_EQ(*chart.x_at(640.0), 12.0);
  const double middle = *chart.x_at(340.0);
  EXPECT_GT(middle, 6.0);
  EXPECT_LT(middle, 8.0);
}

TEST_F(CurveChartTest, AnyDataAreDrawnWithoutAWarning) {
  CurveChart chart;
  chart.add_to(window_);
  window_->Render();
  CurveChartData data = rise();
  data.curve.add_gap();
  data.faint.add(1.0, -3.0);
  data.faint.add(4.0, 3.0);
  data.x_begin = data.x_end = 0.0;
  chart.set_data(data);
  chart.set_cursor(1e9, 1.0, true);
  window_->Render();
  chart.set_cursor(CurveChart::kNowhere, CurveChart::kNowhere, false);
  chart.set_data({});
  window_->Render();
}

TEST_F(CurveChartTest, AChartIsWrittenAsADrawingOrAPage) {
  const auto svg = folder_ / "chart.svg", pdf = folder_ / "chart.pdf", png = folder_ / "chart.png";
  for (const auto& file : {svg, pdf, png}) render_charts({{panel()}}, 1, file, {.width_px = 800, .height_px = 600});
  const std::string drawing = test::text_of(svg);
  EXPECT_NE(drawing.find("<svg"), std::string::npos);
  EXPECT_NE(drawing.find("</svg>"), std::string::npos);
  // The curve is a line, not a picture of one.
  EXPECT_NE(drawing.find("<poly"), std::string::npos);
  EXPECT_EQ(test::text_of(pdf).rfind("%PDF-", 0), 0U);
  vtkNew<vtkPNGReader> reader;
  EXPECT_TRUE(reader->CanReadFile(png.c_str()));
}

TEST_F(CurveChartTest, WhatCannotBeWrittenIsAnError) {
  EXPECT_THROW(render_charts({{panel()}}, 1, folder_ / "chart.doc"), UsageError);
  EXPECT_THROW(render_charts({{panel()}}, 1, folder_.path() / "none" / "chart.svg"), OutputError);
}

}  // namespace
}  // namespace pellucida
