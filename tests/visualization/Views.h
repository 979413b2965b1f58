#pragma once
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>

#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/visualization/Palette.h"
#include "pellucida/visualization/VirtualDisplay.h"
#include "pellucida/visualization_vtk/MessageLog.h"
#include "visualization/SyntheticScene.h"

namespace pellucida::test {

inline constexpr int kWidth_px = 640;
inline constexpr int kHeight_px = 480;

// An off-screen window on a display of its own where there is none. Fails on any VTK error or warning.
class Views : public testing::Test {
 protected:
  Views() : log_(MessageLog::install()), problems_(log_->problem_count()) {
    source->SetScene(synthetic_scene(25.0));
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(kWidth_px, kHeight_px);
  }
  ~Views() override { EXPECT_EQ(log_->problem_count(), problems_) << log_->last_problem(); }

  vtkSmartPointer<vtkImageData> shot() {
    window->Render();
    vtkNew<vtkWindowToImageFilter> picture;
    picture->SetInput(window);
    picture->ReadFrontBufferOff();
    picture->ShouldRerenderOff();
    picture->Update();
    return picture->GetOutput();
  }

  // Pixels within `tolerance` of a colour (each part, 0..1), from column `begin_px` to before `end_px`.
  static int count_near(vtkImageData* image, const Color& c, double tolerance = 0.12, int begin_px = 0,
                        int end_px = kWidth_px) {
    int count = 0;
    for (int y = 0; y < kHeight_px; ++y) {
      for (int x = begin_px; x < end_px; ++x) {
        const auto part = [&](int k) { return image->GetScalarComponentAsDouble(x, y, 0, k) / 255.0; };
        if (std::abs(part(0) - c.red) < tolerance && std::abs(part(1) - c.green) < tolerance &&
            std::abs(part(2) - c.blue) < tolerance) {
          ++count;
        }
      }
    }
    return count;
  }

  VirtualDisplay display;
  vtkNew<StageSource> source;
  vtkNew<vtkRenderWindow> window;

 private:
  MessageLog* log_;
  std::uint64_t problems_;
};

}  // namespace pellucida::test
