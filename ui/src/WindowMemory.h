#pragma once
#include <QObject>
#include <QTimer>
#include <QVariantMap>

class QWidget;

namespace pellucida {

struct WindowOptions;

/// The state of `control` is kept from one window to the next of its kind: that of a checkable button or action, of a
/// slider or a list. `key`: a name of its own in the window.
void keep_as(QObject& control, const QString& key);

/// Remembers how a person left a window of one mode, in `Pellucida/windows.ini` in the user's settings: place and size,
/// splitters, the controls that `keep_as` named. Written a few seconds after a change, whole or not at all, so that a
/// program that ends badly loses nothing. What is missing, damaged or no longer there stays as the window was built.
/// A window that only takes a picture or figures of itself neither restores nor keeps anything.
class WindowMemory : public QObject {
 public:
  /// After the window is built, before it is shown. `mode`: "guide", "review", "teach". The window must outlive it.
  WindowMemory(QWidget& window, const char* mode, const WindowOptions& options);
  ~WindowMemory() override;

 protected:
  bool eventFilter(QObject* target, QEvent* event) override;

 private:
  QVariantMap state() const;
  void restore();
  void keep();

  QWidget& window_;
  QString mode_;
  bool active_;
  bool restored_ = false;
  QVariantMap kept_;
  QTimer timer_;
};

}  // namespace pellucida
