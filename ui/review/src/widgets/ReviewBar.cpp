#include "widgets/ReviewBar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

#include "WindowMemory.h"
#include "Words.h"
#include "presenters/Phrase.h"
#include "presenters/RecordedSession.h"
#include "widgets/BlockLabel.h"
#include "widgets/ButtonKey.h"
#include "widgets/ElidedLabel.h"
#include "widgets/Icons.h"
#include "widgets/KeySheet.h"
#include "widgets/LookMenu.h"
#include "widgets/PhraseLabel.h"
#include "widgets/StartButton.h"

namespace pellucida {
namespace {

constexpr int kRoomForBrand_px = 1200;

}  // namespace

ReviewBar::ReviewBar(const Actions& actions, QWidget* parent) : QWidget(parent) {
  setObjectName("topBar");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(46);
  auto* row = row_ = new QHBoxLayout(this);
  row->setContentsMargins(16, 0, 16, 0);
  row->setSpacing(8);
  auto* mark = new QLabel(this);
  mark->setPixmap(make_icon(Pictogram::kProgram).pixmap(22, 22));
  row->addWidget(mark);
  brand_ = new QLabel("Pellucida", this);
  brand_->setObjectName("brand");
  row->addWidget(brand_);
  row->addSpacing(18);
  row->addWidget(make_start_button(this));
  QPushButton* open = add_button(row, words("Open"), QKeySequence::Open, words("Open another session"));
  open->setIcon(make_icon(Pictogram::kOpen));
  connect(open, &QPushButton::clicked, this, actions.open);
  add_export(row, actions);
  compare_ = add_button(row, words("Compare"), Qt::Key_C, words("Compare with another session"));
  compare_->setIcon(make_icon(Pictogram::kCompare));
  compare_->setCheckable(true);
  compare_->setProperty("lit", true);
  connect(compare_, &QPushButton::clicked, this, actions.compare);
  events_ = add_button(row, words("Events"), Qt::Key_E, words("Show the events and doubts beside the views"));
  events_->setIcon(make_icon(Pictogram::kNote));
  events_->setCheckable(true);
  events_->setChecked(true);
  events_->setProperty("lit", true);
  keep_as(*events_, "toggle_E");
  connect(events_, &QPushButton::toggled, this, actions.show_events);
  QPushButton* cells = add_button(row, words("Cells"), Qt::Key_J, words("Cells of several sessions in one table"));
  cells->setObjectName("cellsButton");
  last_ = cells;
  connect(cells, &QPushButton::clicked, this, actions.cells);
  row->addWidget(make_look_button(QKeySequence("Ctrl+L"), this));
  row->addWidget(make_keys_button(this));
  row->addSpacing(8);

  auto* session = new QVBoxLayout;
  session->setSpacing(0);
  session->setContentsMargins(0, 5, 0, 5);
  name_ = new ElidedLabel(Qt::ElideMiddle, this);
  name_->setObjectName("sourceName");
  facts_ = new ElidedLabel(Qt::ElideRight, this);
  facts_->setObjectName("facts");
  for (QLabel* label : {name_, facts_}) {
    // A long line is elided rather than widening the window.
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    session->addWidget(label);
  }
  row->addLayout(session, 1);
  row->addWidget(new BlockLabel(this));
  show_session(nullptr);
}

QPushButton* ReviewBar::add_button(QHBoxLayout* row, const QString& text, const QKeySequence& key, const QString& tip) {
  auto* button = new QPushButton(text, this);
  button->setFixedHeight(30);
  button->setFocusPolicy(Qt::TabFocus);
  bind_key(*button, key, tip);
  row->addWidget(button);
  return button;
}

void ReviewBar::add_export(QHBoxLayout* row, const Actions& actions) {
  export_ = new QPushButton(words("Export \u25BE"), this);
  export_->setObjectName("export");
  export_->setFixedHeight(30);
  export_->setFocusPolicy(Qt::TabFocus);
  export_->setToolTip(words("Pictures, charts, tables and the report of this session"));
  auto* menu = new QMenu(export_);
  const auto add = [&](const QString& text, const char* name, const std::function<void()>& act) {
    QAction* action = menu->addAction(text);
    action->setObjectName(name);
    connect(action, &QAction::triggered, this, act);
    return action;
  };
  const QString dots = QString::fromUtf8("\u2026");
  QAction* window = add(words("Window as PNG") + dots, "exportWindow", actions.export_window);
  window->setShortcut(QKeySequence::Save);
  add(words("Microscope image as PNG") + dots, "exportFeed", actions.export_feed);
  add(words("3-D view as PNG") + dots, "exportView", actions.export_view);
  menu->addSeparator();
  add(words("Force over time as SVG, PDF, PNG or CSV") + dots, "exportTime", actions.export_time);
  add(words("Left chart as SVG, PDF, PNG or CSV") + dots, "exportTouch", actions.export_touch);
  node_ = add(words("Chart of the node as SVG, PDF, PNG or CSV") + dots, "exportNode", actions.export_node);
  menu->addSeparator();
  add(words("Video of the views") + dots, "exportVideo", actions.export_video);
  add(words("This frame and its charts as CSV") + dots, "exportSeen", actions.export_seen);
  add(words("All tables as CSV") + dots, "exportTables", actions.export_tables);
  QAction* report = add(words("Report") + dots, "report", actions.report);
  report->setShortcut(QKeySequence::Print);
  // Keys of a menu that isn't open act too.
  addActions({window, report});
  export_->setMenu(menu);
  row->addWidget(export_);
}

void ReviewBar::show_session(const RecordedSession* session) {
  export_->setEnabled(session != nullptr);
  for (QAction* action : export_->menu()->actions()) action->setEnabled(session != nullptr);
  for (QPushButton* button : {compare_, events_}) button->setEnabled(session != nullptr);
  set_node_chosen(false);
  name_->setText(session ? QString::fromStdString(session_name_of(session->folder)) : QString());
  if (!session) {
    facts_->setText({});
    setToolTip({});
    return;
  }
  const std::string facts = session_facts(*session), caution = session_caution(*session);
  show_phrase(*facts_, {facts, caution.empty() ? current_theme().text_dim : current_theme().warning});
  const QString tip =
      QString::fromStdString(session->folder.string() + "\n" + facts + (caution.empty() ? "" : "\n" + caution));
  // Text of a session is never taken for markup.
  for (QLabel* label : {name_, facts_}) label->setToolTip("<pre>" + tip.toHtmlEscaped() + "</pre>");
}

// In a narrow window the session's name counts for more.
void ReviewBar::resizeEvent(QResizeEvent*) {
  brand_->setVisible(width() >= kRoomForBrand_px);
}

void ReviewBar::add(QPushButton& button) {
  row_->insertWidget(row_->indexOf(last_) + 1, &button);
  setTabOrder(last_, &button);
  last_ = &button;
}

void ReviewBar::show_events(bool shown) {
  events_->setChecked(shown);
}

void ReviewBar::set_comparing(bool comparing) {
  compare_->setChecked(comparing);
}

void ReviewBar::set_node_chosen(bool chosen) {
  node_->setEnabled(chosen);
}

}  // namespace pellucida
