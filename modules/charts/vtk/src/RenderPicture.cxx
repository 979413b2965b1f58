#include "pellucida/charts_vtk/RenderPicture.h"

#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "pellucida/charts_vtk/ForceChart.h"
#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/visualization/Readout.h"
#include "pellucida/visualization/VirtualDisplay.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "pellucida/visualization_vtk/MessageLog.h"

namespace pellucida {
namespace {

// The line of figures on top.
class HeaderView : public View {
 public:
  explicit HeaderView(const Measurement& m) : m_(m) {
    main_->SetUseFXAA(false);
    main_->SetBackground(palette::kPanel.data());
  }

 protected:
  void draw_hud(HudCanvas& hud, double width_px, double height_px) override {
    const double middle = 0.5 * height_px;
    hud.text(20.0, middle, "Pellucida", {.size_pt = 20, .color = palette::kText, .bold = true});
    double x = 150.0;

    // The state as a pill.
    const std::string state = readout::state(m_.state);
    const HudText pill{.size_pt = font_size::kTitle, .color = palette::kWindow, .bold = true};
    const double pill_width = hud.text_width_px(state, pill) + 26.0;
    hud.rounded(x, middle - 14.0, pill_width, 28.0, 14.0, state_color(m_.state));
    hud.text(x + 13.0, middle, state, pill);
    x += pill_width + 36.0;

    const auto figure = [&](const std::string& name, const std::string& value, const std::string& after) {
      const HudText dim{.size_pt = font_size::kTitle, .color = palette::kTextDim};
      const HudText bold{.size_pt = 18, .color = palette::kText, .bold = true};
      hud.text(x, middle, name, dim);
      x += hud.text_width_px(name, dim) + 10.0;
      hud.text(x, middle, value, bold);
      x += hud.text_width_px(value, bold) + 10.0;
      if (!after.empty()) {
        hud.text(x, middle, after, dim);
        x += hud.text_width_px(after, dim) + 10.0;
      }
      x += 28.0;
    };
    const std::string interval = readout::force_interval(m_);
    figure("Indentation", readout::indentation(m_), "");
    figure("Force", readout::force(m_), interval.empty() ? "" : "95 %: " + interval);
    figure("Pressure", readout::pressure(m_), "");
    figure("Confidence", readout::confidence(m_), "");
    hud.text(width_px - 20.0, middle, "t = " + readout::time(m_.time_s),
             {.size_pt = font_size::kTitle, .color = palette::kTextDim, .align = HudAlign::kRight});
  }

 private:
  Measurement m_;
};

// Bytes to a file beside the wanted one, then renamed over it: half a picture is never visible.
void write_whole(const std::filesystem::path& file, const char* bytes, std::size_t count) {
  const auto fail = [&](const std::string& why) {
    throw OutputError("can't write the picture " + file.string() + ": " + why +
                      "; choose a folder that exists and may be written");
  };
  std::filesystem::path beside = file;
  beside += ".part";
  std::error_code error;
  {
    std::ofstream out(beside, std::ios::binary);
    out.write(bytes, static_cast<std::streamsize>(count));
    out.close();
    if (!out) {
      std::filesystem::remove(beside, error);
      fail("the file can't be opened or the disk is full");
    }
  }
  std::filesystem::rename(beside, file, error);
  if (error) {
    const std::string why = error.message();
    std::filesystem::remove(beside, error);
    fail(why);
  }
}

}  // namespace

void check_picture_size(const PictureSize& size) {
  if (size.width_px >= 400 && size.height_px >= 300 && size.width_px <= 8000 && size.height_px <= 8000) return;
  throw UsageError("a picture of " + std::to_string(size.width_px) + " x " + std::to_string(size.height_px) +
                   " px can't be drawn: choose 400 x 300 to 8000 x 8000");
}

void save_window(vtkRenderWindow* window, const std::filesystem::path& png) {
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->SetInputBufferTypeToRGB();
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  write_whole(png, reinterpret_cast<const char*>(bytes->GetPointer(0)),
              static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

void render_picture(const Scene& scene, std::span<const Measurement> rows, const std::filesystem::path& png,
                    const PictureSize& size) {
  check_picture_size(size);
  MessageLog::install();
  VirtualDisplay display;

  vtkNew<StageSource> source;
  source->SetScene(scene);
  FeedView feed(source);
  MembraneView membranes(source);
  ForceChart force_indentation(ForceChartKind::kForceIndentation);
  ForceChart force_time(ForceChartKind::kForceTime);
  HeaderView header(scene.measurement);
  for (const Measurement& row : rows) {
    force_indentation.append(row);
    force_time.append(row);
  }

  // Parts in fractions of the window, with thin gaps that show the window's ground.
  const double header_px = 56.0;
  const double gap_x = 4.0 / size.width_px;
  const double gap_y = 4.0 / size.height_px;
  const double top = 1.0 - header_px / size.height_px;
  const double charts = 0.34;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(size.width_px, size.height_px);
  // One picture may take its time: smooth edges everywhere.
  window->SetMultiSamples(4);
  vtkNew<vtkRenderer> ground;
  ground->SetBackground(palette::kWindow.data());
  window->AddRenderer(ground);
  header.add_to(window, {0.0, top, 1.0, 1.0});
  feed.add_to(window, {0.0, charts + gap_y, 0.5 - gap_x, top - gap_y});
  membranes.add_to(window, {0.5, charts + gap_y, 1.0, top - gap_y});
  force_indentation.add_to(window, {0.0, 0.0, 0.5 - gap_x, charts});
  force_time.add_to(window, {0.5, 0.0, 1.0, charts});
  window->Render();
  save_window(window, png);
}

}  // namespace pellucida
