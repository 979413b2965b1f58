#include "pellucida/ui/Workstation.h"

#include <vtkOpenGLRenderWindow.h>

#include <QVTKOpenGLNativeWidget.h>
#include <QApplication>
#include <QSurfaceFormat>

#include "MainWindow.h"
#include "Theme.h"
#include "pellucida/core/Error.h"
#include "pellucida/visualization/VirtualDisplay.h"
#include "pellucida/visualization_vtk/MessageLog.h"

namespace pellucida {

int run_workstation(std::unique_ptr<LiveRun> run, const WindowOptions& options) {
  MessageLog::install();
  if (!display_answers()) {
    throw DeviceError("no window can be opened: the display does not answer; set DISPLAY to a running X server");
  }
  // Multisampling belongs to the views that ask for it.
  vtkOpenGLRenderWindow::SetGlobalMaximumNumberOfMultiSamples(0);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());

  // Qt keeps references to both.
  int argc = 1;
  char name[] = "pellucida";
  char* argv[] = {name, nullptr};
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
#endif
  QApplication app(argc, argv);
  QApplication::setApplicationName("Pellucida");
  apply_theme(app);
  MainWindow window(std::move(run), options);
  window.show();
  const int status = QApplication::exec();
  if (window.screenshot_fault()) std::rethrow_exception(window.screenshot_fault());
  return status;
}

}  // namespace pellucida
