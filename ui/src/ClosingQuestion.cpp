#include "ClosingQuestion.h"

#include <QMessageBox>
#include <QPushButton>

#include "Closing.h"
#include "Words.h"

namespace pellucida {

ClosingQuestion::ClosingQuestion(QWidget& window, std::function<void()> end_recording)
    : window_(window), end_recording_(std::move(end_recording)) {}

bool ClosingQuestion::may_close(bool recording) {
  if (!recording || closes_now(window_)) return true;
  ask();
  return false;
}

void ClosingQuestion::ask() {
  // One that was answered is deleted a moment later.
  if (box_ && box_->isVisible()) {
    box_->raise();
    box_->activateWindow();
    return;
  }
  box_ = new QMessageBox(QMessageBox::Question, words("Recording"),
                         words("A recording is running. Everything recorded so far is kept."), QMessageBox::NoButton,
                         &window_);
  box_->setObjectName("closingQuestion");
  box_->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* end = box_->addButton(words("End it and close"), QMessageBox::AcceptRole);
  end->setObjectName("endAndClose");
  QPushButton* go_on = box_->addButton(words("Go on recording"), QMessageBox::RejectRole);
  go_on->setObjectName("goOn");
  box_->setDefaultButton(go_on);
  box_->setEscapeButton(go_on);
  QObject::connect(end, &QPushButton::clicked, &window_, [this] {
    end_recording_();
    window_.close();
  });
  QObject::connect(go_on, &QPushButton::clicked, &window_, [this] { forget_start_page(window_); });
  // No dialog blocks a live cell.
  box_->setModal(false);
  box_->show();
}

}  // namespace pellucida
