// The window shows one scene at a time: readouts, 3-D label and charts say the same number in each moment.
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "GuideWindow.h"
#include "pellucida/charts_vtk/ForceChart.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/visualization/Readout.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "ui/DisplayTest.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

// The virtual microscope with pixels said to be 0.4 times as large as they are.
class SmallPixels final : public FrameSource {
 public:
  explicit SmallPixels(const Scenario& scenario) : microscope_(scenario), info_(microscope_.info()) {
    info_.pixel_size_um *= kRatio;
  }
  const SourceInfo& info() const noexcept override { return info_; }
  std::optional<Frame> next() override {
    auto frame = microscope_.next();
    if (!frame) return frame;
    auto image = frame->image.shallow_copy();
    image->SetSpacing(info_.pixel_size_um, info_.pixel_size_um, 1.0);
    frame->image = Frozen<vtkImageData>(image);
    return frame;
  }

 private:
  static constexpr double kRatio = 0.4;
  VirtualMicroscope microscope_;
  SourceInfo info_;
};

class OneScene : public test::DisplayTest {
 protected:
  void open(std::unique_ptr<FrameSource> source, const PipelineOptions& pipeline) {
    auto run = std::make_unique<LiveRun>(std::move(source), pipeline);
    GuideOptions options;
    options.width_px = 1000;
    options.height_px = 640;
    options.repeat = true;
    window_ = std::make_unique<GuideWindow>(std::move(run), nullptr, options);
    window_->show();
  }

  // The views of one kind in the window.
  template <class V>
  std::vector<V*> views() const {
    std::vector<V*> found;
    for (ViewWidget* widget : ViewWidget::all_in(*window_)) {
      if (auto* one = dynamic_cast<V*>(&widget->view())) found.push_back(one);
    }
    return found;
  }

  std::string text(const char* label) const {
    const auto* found = window_->findChild<QLabel*>(label);
    return found ? found->text().toStdString() : std::string("no label ") + label;
  }

  // Calls `look` between the window's events until it says so, or five minutes have gone.
  template <class Look>
  static bool watch(Look look) {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 300000) {
      QApplication::processEvents(QEventLoop::AllEvents, 5);
      if (look()) return true;
    }
    return false;
  }

  std::unique_ptr<GuideWindow> window_;
};

TEST_F(OneScene, ReadoutLabelAndChartsSayTheSameForce) {
  Scenario scenario = load_scenario("default");
  scenario.motion.approach_speed_um_per_s = 100.0;
  open(std::make_unique<VirtualMicroscope>(scenario), {});
  std::set<std::string> seen;
  const bool done = watch([&] {
    const std::string label = views<MembraneView>().front()->contact_label();
    if (label.empty()) return false;
    EXPECT_EQ(text("force"), label);
    for (const ForceChart* chart : views<ForceChart>()) {
      const auto newest = chart->newest();
      EXPECT_TRUE(newest);
      if (newest) {
        EXPECT_EQ(readout::number(newest->force_uN, 2) + " µN", label);
      }
    }
    seen.insert(label);
    return seen.size() >= 12 || HasFailure();
  });
  EXPECT_TRUE(done) << seen.size() << " different forces seen";
}

TEST_F(OneScene, TheProfileAndTheReasonForNoForceAreShown) {
  open(std::make_unique<SmallPixels>(load_scenario("default")), {.profile = "mouse-embryo"});
  EXPECT_TRUE(watch([&] { return text("notice").find("check the pixel size") != std::string::npos; }))
      << text("notice");
  EXPECT_EQ(text("profile"), "mouse-embryo");
  EXPECT_EQ(text("force"), "\u2013");
  EXPECT_EQ(text("forceNote"), "no force, see below");
}

// The needle's arrows add up to the force that the window shows, and everything that acts on the membrane to nothing.
TEST_F(OneScene, TheArrowsAddUpToTheForceShown) {
  Scenario scenario = load_scenario("default");
  scenario.motion.approach_speed_um_per_s = 100.0;
  open(std::make_unique<VirtualMicroscope>(scenario), {});
  MembraneView& view = *views<MembraneView>().front();
  int seen = 0;
  const bool done = watch([&] {
    if (view.contact_label().empty()) return false;
    const Scene& scene = view.scene();
    const auto surface = scene.surface.shallow_copy();
    if (!surface) return false;
    Eigen::Vector3d needle = Eigen::Vector3d::Zero(), all = needle;
    for (const char* name : {array_name::kForce, array_name::kNeedleForce, array_name::kHolderForce}) {
      vtkDataArray* array = surface->GetPointData()->GetArray(name);
      EXPECT_TRUE(array) << name;
      if (!array) return true;
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
        Eigen::Vector3d one;
        array->GetTuple(i, one.data());
        if (name == array_name::kNeedleForce) needle += one;
        all += one;
      }
    }
    const double shown_uN = scene.measurement.contact_force_uN;
    EXPECT_NEAR(needle.norm(), std::hypot(shown_uN, scene.measurement.lateral_force_uN), 2e-3 * shown_uN);
    EXPECT_LT(all.norm(), 1e-2 * shown_uN);
    return ++seen >= 3 || HasFailure();
  });
  EXPECT_TRUE(done) << seen;
  EXPECT_FALSE(view.lacks_node_force());
  // Each kind, and the model's mesh, in the running window.
  for (const NodeForceKind kind : kNodeForceKinds) {
    window_->findChild<QAction*>("nextNodeForce")->trigger();
    EXPECT_NE(view.node_force(), kind);
  }
  auto* model = window_->findChild<QAction*>("modelSurface");
  ASSERT_TRUE(model->isEnabled());
  model->trigger();
  window_->findChild<QAbstractButton*>("errorBars")->click();
  QApplication::processEvents(QEventLoop::AllEvents, 200);
}

}  // namespace
}  // namespace pellucida
