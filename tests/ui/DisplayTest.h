#pragma once
#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QPixmap>
#include <QWidget>
#include <functional>

#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/visualization/VirtualDisplay.h"

namespace pellucida::test {

/// Tests of shown windows: a Qt application, on a display of its own where there is none. One for the whole program,
/// which reads and leaves nothing in the settings of the person who runs it or of a test beside it.
class DisplayTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    static const TemporaryFolder settings;
    qputenv("XDG_CONFIG_HOME", settings.path().c_str());
    static VirtualDisplay display;
    static int argc = 1;
    static char name[] = "test";
    static char* argv[] = {name, nullptr};
    if (!qApp) new QApplication(argc, argv);
  }

  /// For a person's judgement: the window as it is, as NAME.png in the folder that PELLUCIDA_PICTURES names; nothing
  /// without.
  static void keep_picture(QWidget& window, const char* name) {
    const QByteArray folder = qgetenv("PELLUCIDA_PICTURES");
    if (!folder.isEmpty()) window.grab().save(QString("%1/%2.png").arg(QString::fromLocal8Bit(folder), name));
  }

  /// The window's events for a time, or until a condition holds: false when it doesn't within five minutes, however
  /// busy the machine is.
  static void pass(int time_ms) {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < time_ms) QApplication::processEvents(QEventLoop::AllEvents, 10);
  }
  static bool pass_until(const std::function<bool()>& condition) {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 300000) {
      if (condition()) return true;
      pass(10);
    }
    return false;
  }

  /// Shows a window and gives it the keyboard; false when it doesn't get it. Asks again and again: without a window
  /// manager an X server ignores a request whose time is older than that of the last one it followed.
  static bool activate(QWidget& window) {
    window.show();
    return pass_until([&] {
      if (window.isActiveWindow() && qApp->applicationState() == Qt::ApplicationActive) return true;
      window.activateWindow();
      pass(50);
      return false;
    });
  }
};

}  // namespace pellucida::test
