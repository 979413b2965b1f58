#include "pellucida/ui/Workstation.h"

#include <vtkOpenGLRenderWindow.h>

#include <QVTKOpenGLNativeWidget.h>
#include <QApplication>
#include <QIcon>
#include <QMutex>
#include <QSet>
#include <QSurfaceFormat>
#include <cstdio>

#include "MainWindow.h"
#include "Theme.h"
#include "pellucida/core/Error.h"
#include "pellucida/visualization/VirtualDisplay.h"
#include "pellucida/visualization_vtk/MessageLog.h"

namespace pellucida {
namespace {

// Qt's warnings, each once; not its remark that a session without a login manager lacks a runtime folder.
void take_qt_message(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type == QtDebugMsg || type == QtInfoMsg || text.startsWith("QStandardPaths: XDG_RUNTIME_DIR")) return;
  static QMutex mutex;
  static QSet<QString> seen;
  const QMutexLocker lock(&mutex);
  if (seen.contains(text)) return;
  seen.insert(text);
  std::fprintf(stderr, "qt: %s\n", qPrintable(text));
}

}  // namespace

int run_workstation(std::unique_ptr<LiveRun> run, const WindowOptions& options) {
  return run_workstation(std::move(run), nullptr, options);
}

int run_workstation(std::unique_ptr<LiveRun> run, std::unique_ptr<OperatorConsole> console,
                    const WindowOptions& options) {
  MessageLog::install();
  qInstallMessageHandler(take_qt_message);
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
  // The desktop entry and the icon of an installed program.
  QApplication::setDesktopFileName("pellucida");
  QApplication::setWindowIcon(QIcon::fromTheme("pellucida"));
  apply_theme(app);
  MainWindow window(std::move(run), std::move(console), options);
  window.show();
  const int status = QApplication::exec();
  if (window.screenshot_fault()) std::rethrow_exception(window.screenshot_fault());
  return status;
}

}  // namespace pellucida
