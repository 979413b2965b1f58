#include "widgets/TopBar.h"

#include <QHBoxLayout>
#include <QKeySequence>
#include <QLabel>
#include <QPushButton>

#include "widgets/ButtonKey.h"
#include "widgets/Icons.h"

namespace pellucida {

TopBar::TopBar(const QString& source, const QString& source_tip, Actions actions, QWidget* parent) : QWidget(parent) {
  setObjectName("topBar");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(46);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 0, 16, 0);
  row->setSpacing(8);
  auto* mark = new QLabel(this);
  mark->setPixmap(make_icon(Pictogram::kProgram).pixmap(22, 22));
  row->addWidget(mark);
  auto* brand = new QLabel("Pellucida", this);
  brand->setObjectName("brand");
  row->addWidget(brand);
  row->addSpacing(18);

  record_ = add_button(row, "Record", Qt::Key_R, "Write frames, shapes and forces to a session folder",
                       std::move(actions.record));
  record_->setObjectName("record");
  record_->setCheckable(true);
  pause_ = add_button(row, "Pause", Qt::Key_Space, "Keep the newest frame on screen", std::move(actions.pause));
  if (actions.restart) {
    add_button(row, "Restart", Qt::Key_Home, "Start the source again from its first frame", std::move(actions.restart))
        ->setIcon(make_icon(Pictogram::kRestart));
  }
  add_button(row, "Note", Qt::Key_N, "Add a remark to the session's events", std::move(actions.note))
      ->setIcon(make_icon(Pictogram::kNote));
  add_button(row, "Screenshot", QKeySequence::Save, "Save the window as a picture", std::move(actions.picture))
      ->setIcon(make_icon(Pictogram::kCamera));

  row->addStretch(1);
  auto* name = new QLabel(source, this);
  name->setObjectName("sourceName");
  name->setToolTip(source_tip);
  row->addWidget(name);
  show_state(false, false);
}

QPushButton* TopBar::add_button(QHBoxLayout* row, const QString& text, const QKeySequence& key, const QString& tip,
                                std::function<void()> action) {
  auto* button = new QPushButton(text, this);
  button->setFixedHeight(30);
  button->setFocusPolicy(Qt::TabFocus);
  bind_key(*button, key, tip);
  connect(button, &QPushButton::clicked, this, std::move(action));
  row->addWidget(button);
  return button;
}

void TopBar::show_state(bool recording, bool paused) {
  record_->setChecked(recording);
  record_->setText(recording ? "End recording" : "Record");
  record_->setIcon(make_icon(recording ? Pictogram::kStop : Pictogram::kRecord));
  pause_->setText(paused ? "Resume" : "Pause");
  pause_->setIcon(make_icon(paused ? Pictogram::kPlay : Pictogram::kPause));
}

}  // namespace pellucida
