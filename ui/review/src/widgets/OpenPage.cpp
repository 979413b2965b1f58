#include "widgets/OpenPage.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "Words.h"
#include "presenters/Phrase.h"
#include "widgets/Icons.h"
#include "widgets/PhraseLabel.h"

namespace pellucida {
namespace {

constexpr int kPageWidth_px = 620;

}  // namespace

OpenPage::OpenPage(std::function<void()> open, QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setSpacing(14);
  column->addStretch(2);
  auto* title = new QLabel(words("Review a recorded session"), this);
  title->setObjectName("pageTitle");
  title->setAlignment(Qt::AlignCenter);
  column->addWidget(title);
  text_ = new QLabel(this);
  text_->setObjectName("pageText");
  text_->setTextFormat(Qt::PlainText);
  text_->setAlignment(Qt::AlignCenter);
  column->addWidget(text_);
  open_ = new QPushButton(make_icon(Pictogram::kOpen), words("Open a session"), this);
  open_->setObjectName("openSession");
  open_->setFixedSize(180, 38);
  connect(open_, &QPushButton::clicked, this, std::move(open));
  column->addWidget(open_, 0, Qt::AlignHCenter);
  problem_ = new QLabel(this);
  problem_->setObjectName("problem");
  problem_->setTextFormat(Qt::PlainText);
  problem_->setWordWrap(true);
  problem_->setAlignment(Qt::AlignCenter);
  problem_->setFixedWidth(kPageWidth_px);
  problem_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(problem_, 0, Qt::AlignHCenter);
  column->addStretch(3);
  show_problem({});
}

void OpenPage::show_reading(const QString& folder) {
  text_->setText(words("Opening ") + folder);
  open_->setEnabled(false);
  show_phrase(*problem_, {});
}

void OpenPage::show_problem(const QString& text) {
  text_->setText(words("Choose the folder of a session, or drop it on this window."));
  open_->setEnabled(true);
  show_phrase(*problem_, {text.toStdString(), current_theme().record});
}

}  // namespace pellucida
