#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <filesystem>

#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/guide/Guide.h"
#include "pellucida/operation/VirtualInjectionSetup.h"
#include "pellucida/visualization/Palette.h"
#include "pellucida/visualization/VirtualDisplay.h"
#include "pellucida/visualization_vtk/MessageLog.h"
#include "visualization/SyntheticScene.h"

namespace pellucida {
namespace {

// One synthetic picture again and again; may break at a given frame.
class RepeatedFrame final : public FrameSource {
 public:
  explicit RepeatedFrame(long break_at = -1) : break_at_(break_at) {
    const auto scene = test::synthetic_scene(12.0);
    image_ = scene.frame;
    info_.name = "synthetic";
    info_.width_px = 728;
    info_.height_px = 486;
    info_.pixel_size_um = 0.825;
    info_.pixel_size_origin = "scenario";
    info_.frame_rate_hz = 30.0;
    info_.frame_rate_origin = "scenario";
  }

  const SourceInfo& info() const noexcept override { return info_; }

  std::optional<Frame> next() override {
    if (index_ == break_at_) throw InputError("synthetic: frame " + std::to_string(index_) + " is cut off");
    Frame frame{.image = {}, .time_s = static_cast<double>(index_) / info_.frame_rate_hz, .frame_index = index_};
    auto image = image_.shallow_copy();
    auto own = vtkSmartPointer<vtkImageData>::New();
    own->DeepCopy(image);
    stamp(own, frame.time_s, frame.frame_index);
    frame.image = Frozen<vtkImageData>(own);
    ++index_;
    return frame;
  }

 private:
  SourceInfo info_;
  Frozen<vtkImageData> image_;
  long index_ = 0;
  long break_at_;
};

class Window : public testing::Test {
 protected:
  Window() : log_(MessageLog::install()), problems_(log_->problem_count()) {}
  ~Window() override { EXPECT_EQ(log_->problem_count(), problems_) << log_->last_problem(); }

  static vtkSmartPointer<vtkImageData> shot(std::unique_ptr<FrameSource> source, int width_px, int height_px) {
    const auto file =
        std::filesystem::path(testing::TempDir()) / ("pellucida_window_" + std::to_string(width_px) + ".png");
    GuideOptions options;
    options.screenshot = file.string();
    options.screenshot_after_s = 2.5;
    options.width_px = width_px;
    options.height_px = height_px;
    EXPECT_EQ(run_guide(std::make_unique<LiveRun>(std::move(source), PipelineOptions{}), nullptr, options), 0);
    vtkNew<vtkPNGReader> reader;
    EXPECT_TRUE(reader->CanReadFile(file.c_str()));
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetOutput();
  }

  // Share of the pixels in a box (fractions, origin at the bottom left) that are brighter than the dark ground.
  static double lit_share(vtkImageData* image, double x0, double y0, double x1, double y1) {
    const int* size = image->GetDimensions();
    int lit = 0;
    int all = 0;
    for (int y = static_cast<int>(y0 * size[1]); y < static_cast<int>(y1 * size[1]); ++y) {
      for (int x = static_cast<int>(x0 * size[0]); x < static_cast<int>(x1 * size[0]); ++x) {
        lit += image->GetScalarComponentAsDouble(x, y, 0, 1) > 80.0;
        ++all;
      }
    }
    return static_cast<double>(lit) / all;
  }

  VirtualDisplay display_;

 private:
  MessageLog* log_;
  std::uint64_t problems_;
};

TEST_F(Window, ShowsTheFeedAndSavesItself) {
  const auto image = shot(std::make_unique<RepeatedFrame>(), 1400, 900);
  ASSERT_EQ(image->GetDimensions()[0], 1400);
  ASSERT_EQ(image->GetDimensions()[1], 900);
  // The grey picture fills the left view.
  EXPECT_GT(lit_share(image, 0.15, 0.40, 0.45, 0.70), 0.7);
}

TEST_F(Window, HasTheHandsBarWithItsStopWhenThereIsAHand) {
  const auto file = std::filesystem::path(testing::TempDir()) / "pellucida_window_hand.png";
  VirtualInjectionSetup setup("injection");
  auto run = std::make_unique<LiveRun>(setup.make_microscope(Pace::kWallClock), PipelineOptions{});
  auto console = std::make_unique<OperatorConsole>(*run, setup.injector(), &setup.needle());
  GuideOptions options;
  options.screenshot = file.string();
  options.screenshot_after_s = 2.5;
  options.width_px = 1000;
  options.height_px = 640;
  options.hand = console->find_hand("Demonstration").value();
  EXPECT_EQ(run_guide(std::move(run), std::move(console), options), 0);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  // The stop at the right end of the bar, in the smallest window too.
  int red = 0;
  for (int y = 640 - 262; y < 640 - 202; ++y) {
    for (int x = 850; x < 1000; ++x) {
      red += reader->GetOutput()->GetScalarComponentAsDouble(x, y, 0, 0) > 200 &&
             reader->GetOutput()->GetScalarComponentAsDouble(x, y, 0, 1) < 130;
    }
  }
  EXPECT_GT(red, 4000);
}

TEST_F(Window, ASourceThatBreaksLeavesTheWindowOpenWithItsReason) {
  const auto image = shot(std::make_unique<RepeatedFrame>(3), 1200, 800);
  // The reason is in the status line in the colour of problems.
  int red = 0;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 1200; ++x) {
      red += image->GetScalarComponentAsDouble(x, y, 0, 0) > 200 && image->GetScalarComponentAsDouble(x, y, 0, 1) < 130;
    }
  }
  EXPECT_GT(red, 100);
}

TEST_F(Window, AScreenshotThatCannotBeWrittenIsAnError) {
  GuideOptions options;
  options.screenshot = (std::filesystem::path(testing::TempDir()) / "no_such_folder" / "shot.png").string();
  options.screenshot_after_s = 0.5;
  EXPECT_THROW(
      run_guide(std::make_unique<LiveRun>(std::make_unique<RepeatedFrame>(), PipelineOptions{}), nullptr, options),
      OutputError);
}

}  // namespace
}  // namespace pellucida
