#include "widgets/SidePage.h"

#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include "Words.h"
#include "widgets/Choice.h"

namespace pellucida {

SidePage::SidePage(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
  setObjectName("page");
  column_->setContentsMargins(14, 12, 14, 12);
  column_->setSpacing(9);
}

QComboBox* SidePage::add_choice(const QString& name, const char* object_name, const QString& tip) {
  auto* label = new QLabel(name, this);
  label->setObjectName("parameterName");
  auto* choice = new Choice(this);
  choice->setObjectName(object_name);
  choice->setToolTip(tip);
  choice->setAccessibleName(name);
  choice->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  label->setBuddy(choice);
  column_->addWidget(label);
  column_->addWidget(choice);
  return choice;
}

void SidePage::add_note(const QString& text) {
  auto* note = new QLabel(text, this);
  note->setObjectName("parameterNote");
  note->setWordWrap(true);
  column_->addWidget(note);
}

void SidePage::add(QWidget* control) {
  column_->addWidget(control);
}

void SidePage::end() {
  column_->addStretch(1);
}

QWidget* scrolled(QWidget* page) {
  auto* scroll = new QScrollArea;
  scroll->setWidget(page);
  scroll->setWidgetResizable(true);
  // The page's controls are reached by Tab, not the frame round them.
  scroll->setFocusPolicy(Qt::NoFocus);
  return scroll;
}

QTabWidget* make_side_tabs() {
  auto* tabs = new QTabWidget;
  tabs->setDocumentMode(true);
  tabs->tabBar()->setDrawBase(false);
  tabs->tabBar()->setAccessibleName(words("Controls and forces"));
  tabs->setUsesScrollButtons(false);
  return tabs;
}

QWidget* view_over_chart(QWidget* view, QWidget* chart) {
  auto* both = new QSplitter(Qt::Vertical);
  both->setHandleWidth(4);
  both->setChildrenCollapsible(false);
  both->addWidget(view);
  both->addWidget(chart);
  both->setStretchFactor(0, 2);
  both->setStretchFactor(1, 1);
  both->setSizes({520, 240});
  return both;
}

}  // namespace pellucida
