// The views as they looked when a person last judged them: a fixed scene at two sizes in both themes against pictures
// in the repository. After an intended change: PELLUCIDA_WRITE_GOLDEN=1 golden_test, and look at what it wrote.
#include <gtest/gtest.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "golden/Golden.h"
#include "pellucida/charts_vtk/CurveChart.h"
#include "pellucida/charts_vtk/ForceChart.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "visualization/Views.h"

namespace pellucida {
namespace {

using test::difference_of, test::golden_picture, test::GoldenDifference;

struct GoldenSize {
  int width_px, height_px;
};
constexpr GoldenSize kGoldenSizes[] = {{560, 400}, {760, 520}};
constexpr double kGoldenDepth_um = 20.0;

class GoldenTest : public test::Views {
 protected:
  GoldenTest() { source->SetScene(test::synthetic_scene(kGoldenDepth_um)); }
  ~GoldenTest() override {
    window->Finalize();
    set_current_theme(dark_theme());
  }

  vtkSmartPointer<vtkImageData> picture_of(const GoldenSize& size) {
    window->SetSize(size.width_px, size.height_px);
    // Charts are laid out by the second drawing.
    shot();
    return shot();
  }

  // A view made by `make` at each size in each theme against NAME-SIZE-THEME.
  void check(const std::string& name, const std::function<std::unique_ptr<View>()>& make) {
    for (const ThemeColors* theme : {&dark_theme(), &light_theme()}) {
      set_current_theme(*theme);
      const auto view = make();
      view->add_to(window);
      for (const GoldenSize& size : kGoldenSizes) {
        const std::string file = name + '-' + std::to_string(size.width_px) + (theme->is_light ? "-light" : "-dark");
        const auto seen = picture_of(size);
        if (test::writes_golden()) {
          test::write_golden(seen, file);
          continue;
        }
        const auto golden = golden_picture(file);
        ASSERT_TRUE(golden) << file << ": no such picture; write it with PELLUCIDA_WRITE_GOLDEN=1";
        const GoldenDifference difference = difference_of(seen, golden);
        EXPECT_TRUE(difference.is_small()) << file << ' ' << difference.text();
      }
      for (vtkRenderer* renderer : renderers()) window->RemoveRenderer(renderer);
    }
  }
  std::vector<vtkRenderer*> renderers() {
    std::vector<vtkRenderer*> all;
    window->GetRenderers()->InitTraversal();
    while (vtkRenderer* one = window->GetRenderers()->GetNextItem()) all.push_back(one);
    return all;
  }

  static std::unique_ptr<View> feed(StageSource* source) {
    auto view = std::make_unique<FeedView>(source);
    PlanMarks plan;
    plan.approach_um = {390.0, 200.0};
    plan.entry_um = {338.0, 200.0};
    plan.target_um = {296.0, 200.0};
    plan.depth_stop_um = {304.0, 200.0};
    plan.corridor_um = 3.0;
    view->set_plan(plan);
    return view;
  }
  static std::unique_ptr<View> membrane(StageSource* source) {
    auto view = std::make_unique<MembraneView>(source);
    view->refresh();
    view->reset_camera();
    return view;
  }
  static std::unique_ptr<View> force_chart(ForceChartKind kind) {
    auto view = std::make_unique<ForceChart>(kind);
    for (const Measurement& row : test::synthetic_rows(120, kGoldenDepth_um)) view->append(row);
    return view;
  }
  static CurveChartData two_curves() {
    CurveChartData data;
    data.x_title = "Time (s)";
    data.y_title = "Force (µN)";
    data.curve_name = "This one";
    data.other_name = "The other";
    for (int i = 0; i <= 100; ++i) {
      const double t = 0.1 * i;
      data.curve.add(t, 0.05 * i, 0.045 * i, 0.055 * i);
      data.other.add(t, 0.0006 * i * i, 0.0005 * i * i, 0.0007 * i * i);
      data.faint.add(t, 0.03 * i);
    }
    data.marks.push_back({5.0, "Contact", palette::kAccent});
    return data;
  }
  static std::unique_ptr<View> curve_chart(const CurveChartData& data) {
    auto view = std::make_unique<CurveChart>();
    view->set_data(data);
    view->set_cursor(7.0, 3.5, true);
    return view;
  }
};

TEST_F(GoldenTest, Feed) {
  check("feed", [this] { return feed(source); });
}
TEST_F(GoldenTest, Membrane) {
  check("membrane", [this] { return membrane(source); });
}
TEST_F(GoldenTest, ForceOverDepth) {
  check("force-depth", [] { return force_chart(ForceChartKind::kForceIndentation); });
}
TEST_F(GoldenTest, ForceOverTime) {
  check("force-time", [] { return force_chart(ForceChartKind::kForceTime); });
}
TEST_F(GoldenTest, Curves) {
  check("curves", [] { return curve_chart(two_curves()); });
}

// What the comparison is for: each element that is left out is seen, at both sizes.
class MissingElement : public GoldenTest {
 protected:
  // `one` changed by `leave_out` against itself.
  template <class AnyView>
  void expect_seen(std::unique_ptr<View> view, const char* element, const std::function<void(AnyView&)>& leave_out) {
    if (test::writes_golden()) GTEST_SKIP() << "pictures are being written";
    view->add_to(window);
    std::vector<vtkSmartPointer<vtkImageData>> whole;
    for (const GoldenSize& size : kGoldenSizes) {
      whole.push_back(vtkSmartPointer<vtkImageData>::New());
      whole.back()->DeepCopy(picture_of(size));
      // Drawn again it is the same.
      EXPECT_EQ(difference_of(picture_of(size), whole.back()).worst_tile, 0.0) << element;
    }
    leave_out(static_cast<AnyView&>(*view));
    for (std::size_t k = 0; k < whole.size(); ++k) {
      const GoldenDifference difference = difference_of(picture_of(kGoldenSizes[k]), whole[k]);
      EXPECT_FALSE(difference.is_small())
          << element << " at " << kGoldenSizes[k].width_px << " px: " << difference.text();
    }
    for (vtkRenderer* renderer : renderers()) window->RemoveRenderer(renderer);
  }
};

TEST_F(MissingElement, OfTheFeed) {
  expect_seen<FeedView>(feed(source), "legend", [](FeedView& view) { view.show_legend(false); });
  // Each line by itself: the legend that names it would be missed alone.
  const auto unnamed = [this] {
    auto view = feed(source);
    static_cast<FeedView&>(*view).show_legend(false);
    return view;
  };
  expect_seen<FeedView>(unnamed(), "contours", [](FeedView& view) { view.show_contours(false); });
  expect_seen<FeedView>(unnamed(), "model section", [](FeedView& view) { view.show_model_section(false); });
  expect_seen<FeedView>(unnamed(), "tools", [](FeedView& view) { view.show_tools(false); });
  expect_seen<FeedView>(unnamed(), "plan", [](FeedView& view) { view.set_plan(std::nullopt); });
}

TEST_F(MissingElement, OfTheMembrane) {
  expect_seen<MembraneView>(membrane(source), "arrows", [](MembraneView& view) { view.show_arrows(false); });
  expect_seen<MembraneView>(membrane(source), "tools", [](MembraneView& view) { view.show_tools(false); });
  expect_seen<MembraneView>(membrane(source), "colours",
                            [](MembraneView& view) { view.set_coloring(SurfaceColoring::kTension); });
}

TEST_F(MissingElement, OfTheCharts) {
  const auto without = [](const std::function<void(CurveChartData&)>& leave_out) {
    return [leave_out](CurveChart& view) {
      CurveChartData data = two_curves();
      leave_out(data);
      view.set_data(data);
    };
  };
  expect_seen<CurveChart>(curve_chart(two_curves()), "other curve", without([](auto& data) { data.other = {}; }));
  expect_seen<CurveChart>(curve_chart(two_curves()), "grey curve", without([](auto& data) { data.faint = {}; }));
  expect_seen<CurveChart>(curve_chart(two_curves()), "mark", without([](auto& data) { data.marks.clear(); }));
  expect_seen<CurveChart>(curve_chart(two_curves()), "title", without([](auto& data) { data.x_title.clear(); }));
  expect_seen<CurveChart>(curve_chart(two_curves()), "cursor",
                          [](CurveChart& view) { view.set_cursor(CurveChart::kNowhere, CurveChart::kNowhere, true); });
  expect_seen<ForceChart>(force_chart(ForceChartKind::kForceIndentation), "curve",
                          [](ForceChart& view) { view.clear(); });
}

// What another renderer does to a picture: softer edges, single pixels off by a little.
TEST_F(GoldenTest, AnotherRenderersEdgesAreNoDifference) {
  if (test::writes_golden()) GTEST_SKIP() << "pictures are being written";
  for (const char* name : {"feed-560-dark", "membrane-560-light", "curves-760-dark"}) {
    const auto golden = golden_picture(name);
    ASSERT_TRUE(golden) << name;
    vtkNew<vtkImageData> soft;
    soft->DeepCopy(golden);
    int size[3];
    golden->GetDimensions(size);
    for (int y = 0; y < size[1]; ++y) {
      for (int x = 1; x < size[0]; ++x) {
        for (int k = 0; k < 3; ++k) {
          const double here = golden->GetScalarComponentAsDouble(x, y, 0, k);
          const double left = golden->GetScalarComponentAsDouble(x - 1, y, 0, k);
          const double noise = (x * 7 + y * 13 + k) % 9 - 4;
          soft->SetScalarComponentFromDouble(x, y, 0, k, std::clamp(0.75 * here + 0.25 * left + noise, 0.0, 255.0));
        }
      }
    }
    const GoldenDifference difference = difference_of(soft, golden);
    EXPECT_TRUE(difference.is_small()) << name << ' ' << difference.text();
  }
}

}  // namespace
}  // namespace pellucida
