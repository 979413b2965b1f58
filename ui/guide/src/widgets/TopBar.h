#pragma once
#include <QList>
#include <functional>

#include "widgets/TitleBar.h"

namespace pellucida {

/// The line at the window's top: name, the run's buttons, the source.
class TopBar : public TitleBar {
 public:
  struct Actions {
    std::function<void()> record;
    std::function<void()> pause;
    std::function<void()> restart;  ///< empty: the source can't, and there is no button
    std::function<void()> note;
    std::function<void()> scale;
    std::function<void()> picture;
    std::function<void(bool)> cells;  ///< shows or hides their list
  };

  TopBar(const QString& source, const QString& source_tip, Actions actions, QWidget* parent);

  void show_state(bool recording, bool paused);
  void show_cells(bool shown);
  /// Where the menu of what is shown, felt and heard hangs.
  QPushButton& display() noexcept { return *display_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();

  QPushButton* record_;
  QPushButton* pause_;
  QPushButton* cells_;
  QPushButton* display_;
  QList<QPushButton*> shrinking_;
  bool is_recording_ = false, is_paused_ = false;
};

}  // namespace pellucida
