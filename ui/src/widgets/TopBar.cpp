#include "widgets/TopBar.h"

#include <QKeySequence>
#include <QPushButton>

#include "widgets/Icons.h"

namespace pellucida {

TopBar::TopBar(const QString& source, const QString& source_tip, Actions actions, QWidget* parent) : TitleBar(parent) {
  record_ =
      add_button("Record", Qt::Key_R, "Write frames, shapes and forces to a session folder", std::move(actions.record));
  record_->setObjectName("record");
  record_->setCheckable(true);
  pause_ = add_button("Pause", Qt::Key_Space, "Keep the newest frame on screen", std::move(actions.pause));
  if (actions.restart) {
    add_button("Restart", Qt::Key_Home, "Start the source again from its first frame", std::move(actions.restart))
        ->setIcon(make_icon(Pictogram::kRestart));
  }
  add_button("Note", Qt::Key_N, "Add a remark to the session's events", std::move(actions.note))
      ->setIcon(make_icon(Pictogram::kNote));
  add_button("Screenshot", QKeySequence::Save, "Save the window as a picture", std::move(actions.picture))
      ->setIcon(make_icon(Pictogram::kCamera));
  add_name(source, source_tip);
  show_state(false, false);
}

void TopBar::show_state(bool recording, bool paused) {
  record_->setChecked(recording);
  record_->setText(recording ? "End recording" : "Record");
  record_->setIcon(make_icon(recording ? Pictogram::kStop : Pictogram::kRecord));
  pause_->setText(paused ? "Resume" : "Pause");
  pause_->setIcon(make_icon(paused ? Pictogram::kPlay : Pictogram::kPause));
}

}  // namespace pellucida
