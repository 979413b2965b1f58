#include "widgets/EventPanel.h"

#include <QAction>
#include <QEvent>
#include <QHeaderView>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>

#include "Theme.h"
#include "Words.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/MessageBook.h"

namespace pellucida {
namespace {

enum EventColumn { kTimeColumn, kKindColumn, kTextColumn, kEventColumnCount };

}  // namespace

EventPanel::EventPanel(std::function<void(double)> seek, QWidget* parent)
    : EventPanel(std::move(seek), new QTreeWidget, parent) {}

EventPanel::EventPanel(std::function<void(double)> seek, QTreeWidget* list, QWidget* parent)
    : Panel(words("Events and doubts"), list, parent), seek_(std::move(seek)), list_(list) {
  list_->setObjectName("events");
  list_->setColumnCount(kEventColumnCount);
  list_->setHeaderLabels({words("Time"), words("Kind"), words("Text")});
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setAllColumnsShowFocus(true);
  list_->setFocusPolicy(Qt::TabFocus);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setColumnWidth(kTimeColumn, 72);
  list_->setColumnWidth(kKindColumn, 88);
  list_->header()->setStretchLastSection(true);
  list_->headerItem()->setTextAlignment(kTimeColumn, Qt::AlignRight | Qt::AlignVCenter);
  list_->setMinimumHeight(80);
  connect(list_, &QTreeWidget::itemClicked, this,
          [this](QTreeWidgetItem* item) { seek_(item->data(kTimeColumn, Qt::UserRole).toDouble()); });
  filter_ = add_button({}, words("Which kinds are listed"));
  filter_->setObjectName("eventFilter");
  filter_->setPopupMode(QToolButton::InstantPopup);
  kinds_menu_ = new QMenu(filter_);
  filter_->setMenu(kinds_menu_);
  show_count();
}

void EventPanel::set_events(std::vector<ReviewEvent> events) {
  events_ = std::move(events);
  hidden_.clear();
  fill_menu();
  fill();
}

void EventPanel::fill_menu() {
  kinds_menu_->clear();
  for (const std::string& kind : kinds_of(events_)) {
    const auto count = std::count_if(events_.begin(), events_.end(), [&](const auto& one) { return one.kind == kind; });
    QAction* action =
        kinds_menu_->addAction(QString("%1 (%2)").arg(QString::fromStdString(say_event_kind(kind))).arg(count));
    action->setCheckable(true);
    action->setChecked(true);
    action->setData(QString::fromStdString(kind));
    connect(action, &QAction::toggled, this, [this, kind](bool on) {
      if (on) {
        hidden_.erase(kind);
      } else {
        hidden_.insert(kind);
      }
      fill();
    });
  }
}

void EventPanel::show_kind(const std::string& kind, bool shown) {
  for (QAction* action : kinds_menu_->actions()) {
    if (action->data().toString().toStdString() == kind) action->setChecked(shown);
  }
}

// The theme has changed, and with it the colours of the kinds.
void EventPanel::changeEvent(QEvent* event) {
  Panel::changeEvent(event);
  if (event->type() == QEvent::StyleChange && list_ && filter_) fill();
}

void EventPanel::fill() {
  list_->clear();
  shown_s_.clear();
  QList<QTreeWidgetItem*> items;
  for (const ReviewEvent& event : events_) {
    if (hidden_.contains(event.kind)) continue;
    const QString text = QString::fromStdString(event.text);
    auto* item = new QTreeWidgetItem({QString::fromStdString(readout::time(event.time_s)),
                                      QString::fromStdString(say_event_kind(event.kind)), text});
    item->setData(kTimeColumn, Qt::UserRole, event.time_s);
    item->setTextAlignment(kTimeColumn, Qt::AlignRight | Qt::AlignVCenter);
    item->setForeground(kKindColumn, to_qt(event_color(event)));
    // Text of a session is never taken for markup.
    item->setToolTip(kTextColumn, text.isEmpty() ? QString() : "<p>" + text.toHtmlEscaped() + "</p>");
    items.push_back(item);
    shown_s_.push_back(event.time_s);
  }
  list_->addTopLevelItems(items);
  show_count();
}

void EventPanel::show_count() {
  const QString arrow = QString::fromUtf8(" \u25BE");
  filter_->setText(
      (hidden_.empty() ? words("All kinds") : words("%1 of %2").arg(list_->topLevelItemCount()).arg(events_.size())) +
      arrow);
}

void EventPanel::set_position_s(double time_s) {
  // A time read back from a table has nine digits.
  const auto later = std::upper_bound(shown_s_.begin(), shown_s_.end(), time_s + 1e-6);
  QTreeWidgetItem* newest =
      later == shown_s_.begin() ? nullptr : list_->topLevelItem(static_cast<int>(later - shown_s_.begin()) - 1);
  if (newest == list_->currentItem()) return;
  const QSignalBlocker quiet(list_);
  list_->setCurrentItem(newest);
  if (newest) list_->scrollToItem(newest);
}

}  // namespace pellucida
