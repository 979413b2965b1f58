#include "widgets/TopBar.h"

#include <QKeySequence>
#include <QLabel>
#include <QLayout>
#include <QPushButton>

#include "WindowMemory.h"
#include "Words.h"
#include "widgets/Icons.h"

namespace pellucida {
namespace {

constexpr int kShortestName_px = 60;

}  // namespace

TopBar::TopBar(const QString& source, const QString& source_tip, Actions actions, QWidget* parent) : TitleBar(parent) {
  add_start_button();
  record_ = add_button(words("Record"), Qt::Key_R, words("Write frames, shapes and forces to a session folder"),
                       std::move(actions.record));
  record_->setObjectName("record");
  record_->setCheckable(true);
  pause_ =
      add_button(words("Pause"), Qt::Key_Space, words("Keep the newest frame on screen"), std::move(actions.pause));
  if (actions.restart) {
    add_button(words("Restart"), Qt::Key_Home, words("Start the source again from its first frame"),
               std::move(actions.restart))
        ->setIcon(make_icon(Pictogram::kRestart));
  }
  const auto add_with_icon = [this](const QString& text, Pictogram icon, const QKeySequence& key, const QString& tip,
                                    std::function<void()> action) {
    QPushButton* button = add_button(text, key, tip, std::move(action));
    button->setIcon(make_icon(icon));
    button->setAccessibleName(text);
    shrinking_ << button;
  };
  add_with_icon(words("Note"), Pictogram::kNote, Qt::Key_N, words("Add a remark to the session's events"),
                std::move(actions.note));
  add_with_icon(words("Scale"), Pictogram::kScale, Qt::Key_S,
                words("Measure how stiff this cell is, so that the forces are its own"), std::move(actions.scale));
  add_with_icon(words("Screenshot"), Pictogram::kCamera, QKeySequence::Save, words("Save the window as a picture"),
                std::move(actions.picture));
  cells_ = add_button(words("Cells"), Qt::Key_E,
                      words("Cells of this run with their outcome, and the recordings' folder"), {});
  cells_->setObjectName("cellList");
  cells_->setCheckable(true);
  cells_->setProperty("lit", true);
  keep_as(*cells_, "cells");
  connect(cells_, &QPushButton::toggled, this, std::move(actions.cells));
  display_ = add_menu_button(words("Display \u25BE"), words("What is shown, felt and heard"));
  display_->setObjectName("display");
  add_look_menu();
  add_name(source, source_tip);
  is_paused_ = true;
  show_state(false, false);
}

void TopBar::show_cells(bool shown) {
  cells_->setChecked(shown);
}

// In a narrow window, and with the longer words of another language, these are their pictograms alone.
void TopBar::fit() {
  auto* name = findChild<QLabel*>("sourceName");
  name->show();
  for (QPushButton* button : shrinking_) button->setText(button->accessibleName());
  layout()->activate();
  for (int k = shrinking_.size() - 1; k >= 0 && layout()->minimumSize().width() > width(); --k) {
    shrinking_[k]->setText({});
    layout()->activate();
  }
  // A few letters of a name say nothing.
  name->setVisible(width() - layout()->minimumSize().width() >= kShortestName_px);
}

void TopBar::resizeEvent(QResizeEvent*) {
  fit();
}

void TopBar::show_state(bool recording, bool paused) {
  if (is_recording_ == recording && is_paused_ == paused && record_->isChecked() == recording) return;
  is_recording_ = recording;
  is_paused_ = paused;
  record_->setChecked(recording);
  record_->setText(recording ? words("End recording") : words("Record"));
  record_->setIcon(make_icon(recording ? Pictogram::kStop : Pictogram::kRecord));
  pause_->setText(paused ? words("Resume") : words("Pause"));
  pause_->setIcon(make_icon(paused ? Pictogram::kPlay : Pictogram::kPause));
  fit();
}

}  // namespace pellucida
