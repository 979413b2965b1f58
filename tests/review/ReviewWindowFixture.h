#pragma once
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ReviewWindow.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/session/SessionWriter.h"
#include "ui/DisplayTest.h"
#include "ui/XInput.h"
#include "visualization/SyntheticScene.h"
#include "widgets/TimelineBar.h"

namespace pellucida::test {

inline constexpr long kFrames = 30;
inline constexpr double kStep_s = 0.1;

inline double indentation_of(long frame) {
  return frame < 5 ? 0.0 : 0.8 * static_cast<double>(frame - 4);
}

/// Thirty frames, ten a second: five free, then a touch that goes deeper.
inline void write_touch(const std::filesystem::path& folder, bool close = true) {
  SessionInfo info;
  info.source.name = "synthetic";
  info.source.width_px = 728;
  info.source.height_px = 486;
  info.source.pixel_size_um = 0.825;
  info.source.pixel_size_origin = "scenario";
  info.source.frame_rate_hz = 1.0 / kStep_s;
  info.source.frame_rate_origin = "scenario";
  info.profile_name = "mouse-oocyte";
  SessionWriter writer(folder, info);
  for (long frame = 0; frame < kFrames; ++frame) {
    Scene scene = synthetic_scene(indentation_of(frame), frame);
    scene.measurement.frame = frame;
    scene.measurement.time_s = kStep_s * static_cast<double>(frame);
    scene.measurement.state = frame < 5 ? CellState::kFree : CellState::kContact;
    for (auto* part : {&scene.membranes, &scene.tools, &scene.surface}) {
      auto own = vtkSmartPointer<vtkPolyData>::New();
      own->DeepCopy(part->shallow_copy());
      stamp(own, scene.measurement.time_s, frame);
      *part = Frozen<vtkPolyData>(own);
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->DeepCopy(scene.frame.shallow_copy());
    stamp(image, scene.measurement.time_s, frame);
    scene.frame = Frozen<vtkImageData>(image);
    writer.write(scene);
  }
  writer.event({0.5, "contact", "first touch"});
  writer.event({2.0, "note", "<b>bold</b>"});
  if (close) writer.close();
}

/// The window in Review mode with that session at hand, a clock that the test sets, and a person's answers by the test.
class ReviewWindowTest : public DisplayTest {
 protected:
  static void SetUpTestSuite() {
    DisplayTest::SetUpTestSuite();
    folder_ = std::make_unique<TemporaryFolder>();
    write_touch(*folder_ / "S");
  }
  static void TearDownTestSuite() { folder_.reset(); }

  ReviewWindowTest() {
    FileChoice choice;
    choice.file_to_write = [this](const QString&, const std::filesystem::path& proposal, const QString&) {
      proposals_.push_back(proposal);
      return answer_;
    };
    choice.folder_to_write = [this](const QString&, const std::filesystem::path&) { return answer_; };
    choice.session = [this] { return answer_; };
    choice.may_replace = [this](const std::vector<std::filesystem::path>&) {
      ++questions_;
      return replace_;
    };
    choice.show_page = [this](const std::filesystem::path& page) { pages_.push_back(page); };
    window_ = std::make_unique<ReviewWindow>(ReviewOptions{}, clock_, choice);
    window_->show();
    window_->activateWindow();
  }

  bool shows(std::size_t step) {
    return pass_until([&] { return window_->shown_step() == step; });
  }
  void open() {
    window_->open(*folder_ / "S");
    ASSERT_TRUE(pass_until([&] { return window_->shown_step() == 0U; })) << text("problem");
    ASSERT_TRUE(pass_until([] { return qApp->applicationState() == Qt::ApplicationActive; }));
    pass(100);
  }
  std::string text(const char* label) const {
    const auto* found = window_->findChild<QLabel*>(label);
    return found ? found->text().toStdString() : std::string("no label ") + label;
  }
  void trigger(const char* action) { window_->findChild<QAction*>(action)->trigger(); }

  // A press of the left button at a place of a widget, and its release `by` pixels on.
  void click(QWidget& widget, QPoint place, QPoint by = {}) {
    const QPoint from = widget.mapToGlobal(place), to = widget.mapToGlobal(place + by);
    input_.move(from.x(), from.y());
    pass(50);
    input_.left_button(true);
    pass(50);
    input_.move(to.x(), to.y());
    pass(50);
    input_.left_button(false);
    pass(50);
  }
  TimelineBar& timeline() { return *dynamic_cast<TimelineBar*>(window_->findChild<QWidget*>("timeline")); }
  double recorded_uN(std::size_t step) const { return window_->session()->rows[step].contact_force_uN; }

  inline static std::unique_ptr<TemporaryFolder> folder_;
  XInput input_;
  std::shared_ptr<ManualClock> clock_ = std::make_shared<ManualClock>();
  std::filesystem::path answer_;
  std::vector<std::filesystem::path> proposals_, pages_;
  int questions_ = 0;
  bool replace_ = false;
  std::unique_ptr<ReviewWindow> window_;
};

}  // namespace pellucida::test
