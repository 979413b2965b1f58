#include "WindowProgram.h"

#include <vtkOpenGLRenderWindow.h>

#include <QIcon>
#include <QMutex>
#include <QSet>
#include <QSocketNotifier>
#include <QThread>
#include <QWidget>
#include <cstdio>

#include "BlockWatch.h"
#include "Closing.h"
#include "Look.h"
#include "Theme.h"
#include "Translation.h"
#include "pellucida/core/Error.h"
#include "pellucida/visualization/Palette.h"
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

// Measures how long each event keeps the windows' thread.
class WatchedApplication final : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override {
    // Events of objects on other threads come here too.
    if (QThread::currentThread() != thread()) return QApplication::notify(receiver, event);
    const BlockWatch::Event watched(window_blocks(), thread()->loopLevel());
    return QApplication::notify(receiver, event);
  }
};

}  // namespace

WindowProgram::WindowProgram(const WindowOptions& options) {
  MessageLog::install();
  qInstallMessageHandler(take_qt_message);
  if (!display_answers()) {
    throw DeviceError("no window can be opened: the display does not answer; set DISPLAY to a running X server");
  }
  // Multisampling belongs to the views that ask for it.
  vtkOpenGLRenderWindow::SetGlobalMaximumNumberOfMultiSamples(0);
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
  application_ = std::make_unique<WatchedApplication>(argument_count_, arguments_);
  QApplication::setApplicationName("Pellucida");
  // The desktop entry and the icon of an installed program.
  QApplication::setDesktopFileName("pellucida");
  QApplication::setWindowIcon(QIcon::fromTheme("pellucida"));
  Look look = remembered_look();
  if (!options.theme.empty()) look.theme = options.theme;
  if (!options.language.empty()) look.language = options.language;
  translation_ = std::make_unique<Translation>(look.language);
  apply_theme(*application_, look.theme == "light" ? light_theme() : dark_theme());
}

WindowProgram::~WindowProgram() = default;

int WindowProgram::show(QWidget& window, const WindowOptions& options) {
  std::unique_ptr<QSocketNotifier> stop;
  if (options.stop_descriptor >= 0) {
    stop = std::make_unique<QSocketNotifier>(options.stop_descriptor, QSocketNotifier::Read);
    QObject::connect(stop.get(), &QSocketNotifier::activated, [&stop, &window] {
      // It stays readable: once is enough.
      stop->setEnabled(false);
      close_now(window);
      // The loops of dialogs, too.
      QApplication::exit(0);
    });
  }
  window.show();
  window_blocks().begin();
  const int status = QApplication::exec();
  return status == 0 && leads_to_start_page(window) ? kToStartPage : status;
}

}  // namespace pellucida
