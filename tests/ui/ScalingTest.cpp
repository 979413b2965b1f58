// Letters over the views at display scales of 100, 150 and 200 %: as large as the boxes that are measured for them.
// CTest runs this once for each QT_SCALE_FACTOR.
#include <gtest/gtest.h>

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <QImage>
#include <QMainWindow>
#include <cmath>

#include "Theme.h"
#include "pellucida/visualization/Palette.h"
#include "pellucida/visualization_vtk/View.h"
#include "ui/DisplayTest.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr double kLeft_px = 40.0, kMiddle_px = 60.0;

// One line of white letters on black, and how wide the view takes it to be.
class OneLine : public View {
 public:
  double width_px = 0.0;

  void follow_theme() override { main_->SetBackground(0.0, 0.0, 0.0); }

 protected:
  void draw_hud(HudCanvas& hud, double, double) override {
    const HudText style{.size_pt = font_size::kTitle, .color = Color::from_hex(0xFFFFFF), .bold = true};
    width_px = hud.text_width_px("Holding pipette", style);
    // What is drawn later lies above.
    hud.rectangle(0.0, 0.0, 300.0, 100.0, Color::from_hex(0x000000));
    hud.text(kLeft_px, kMiddle_px, "Holding pipette", style);
  }
};

TEST(Scaling, LettersAreAsWideAsTheirBoxes) {
  static VirtualDisplay display;
  int argc = 1;
  char name[] = "test";
  char* argv[] = {name, nullptr};
  QApplication app(argc, argv);
  const double scale = qEnvironmentVariable("QT_SCALE_FACTOR", "1").toDouble();
  OneLine line;
  line.follow_theme();
  QMainWindow window;
  auto* widget = new ViewWidget(line, 0, nullptr);
  window.setCentralWidget(widget);
  window.resize(400, 200);
  window.show();
  QElapsedTimer clock;
  clock.start();
  while (clock.elapsed() < 1500) QApplication::processEvents(QEventLoop::AllEvents, 10);
  ASSERT_NEAR(widget->devicePixelRatioF(), scale, 1e-6);
  widget->render();
  const QImage image = widget->picture();
  ASSERT_NEAR(image.width(), 400 * scale, 2.0);
  int first = image.width(), last = -1, top = image.height(), bottom = -1;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (qGray(image.pixel(x, y)) < 128) continue;
      first = std::min(first, x);
      last = std::max(last, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  ASSERT_GE(last, first) << "no letter was drawn";
  EXPECT_NEAR((last - first + 1) / scale, line.width_px, 3.0);
  EXPECT_NEAR(first / scale, kLeft_px, 3.0);
  // 15 px letters with their descenders: no higher than the plates of 26 px.
  EXPECT_LT((bottom - top + 1) / scale, 20.0);
  delete window.takeCentralWidget();
}

}  // namespace
}  // namespace pellucida
