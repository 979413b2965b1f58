#include "TimedScreenshot.h"

#include <QPixmap>
#include <QTimer>
#include <QWidget>

#include "Closing.h"
#include "pellucida/core/Error.h"

namespace pellucida {

TimedScreenshot::TimedScreenshot(QWidget& window, const WindowOptions& options, std::function<void()> refresh) {
  if (options.screenshot.empty() && options.figures.empty()) return;
  const auto take = [this, &window, file = options.screenshot, refresh = std::move(refresh)] {
    refresh();
    if (!file.empty() && !window.grab().save(QString::fromStdString(file), "PNG")) {
      fault_ = std::make_exception_ptr(
          OutputError("can't write the screenshot " + file + ": choose a folder that exists and may be written"));
    }
    close_now(window);
  };
  QTimer::singleShot(static_cast<int>(1000.0 * options.screenshot_after_s), &window, take);
}

}  // namespace pellucida
