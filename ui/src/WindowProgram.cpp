#include "WindowProgram.h"

#include <vtkOpenGLRenderWindow.h>

#include <QVTKOpenGLNativeWidget.h>
#include <QIcon>
#include <QMutex>
#include <QSet>
#include <QSurfaceFormat>
#include <cstdio>

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

WindowProgram::WindowProgram(const ThemeColors& theme) {
  MessageLog::install();
  qInstallMessageHandler(take_qt_message);
  if (!display_answers()) {
    throw DeviceError("no window can be opened: the display does not answer; set DISPLAY to a running X server");
  }
  // Multisampling belongs to the views that ask for it.
  vtkOpenGLRenderWindow::SetGlobalMaximumNumberOfMultiSamples(0);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
#endif
  application_ = std::make_unique<QApplication>(argument_count_, arguments_);
  QApplication::setApplicationName("Pellucida");
  // The desktop entry and the icon of an installed program.
  QApplication::setDesktopFileName("pellucida");
  QApplication::setWindowIcon(QIcon::fromTheme("pellucida"));
  apply_theme(*application_, theme);
}

int WindowProgram::show(QWidget& window) {
  window.show();
  return QApplication::exec();
}

}  // namespace pellucida
