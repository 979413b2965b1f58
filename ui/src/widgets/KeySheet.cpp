#include "widgets/KeySheet.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QShortcut>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "Words.h"
#include "widgets/ButtonKey.h"

namespace pellucida {
namespace {

constexpr const char* kGroupProperty = "keyGroup";
constexpr const char* kGestureProperty = "gestures";
constexpr const char* kPlaceProperty = "keySheetPlace";
constexpr const char* kSheetName = "keySheet";
constexpr int kColumn_px = 300, kMargin_px = 12, kTopBar_px = 46;

QString group_of(const QObject* part) {
  for (; part; part = part->parent()) {
    const QVariant name = part->property(kGroupProperty);
    if (name.isValid()) return name.toString();
  }
  return words("Window");
}

// The entries in the order in which the window was built.
class KeyCollector {
 public:
  void take(const QObject& object) {
    if (const auto* shortcut = qobject_cast<const QShortcut*>(&object)) {
      const auto* button = qobject_cast<const QAbstractButton*>(shortcut->parent());
      add(object, shortcut->key(), button ? meaning_of(*button) : shortcut->whatsThis());
    } else if (const auto* action = qobject_cast<const QAction*>(&object)) {
      add(object, action->shortcut(), action->text());
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(&object)) {
      add(object, QKeySequence(named_key(*button)), meaning_of(*button));
    }
    const QStringList gestures = object.property(kGestureProperty).toStringList();
    for (int k = 0; k + 1 < gestures.size(); k += 2)
      entries_.push_back({group_of(&object), gestures[k], gestures[k + 1]});
  }

  std::vector<KeyEntry> entries() && { return std::move(entries_); }

 private:
  static const QRegularExpression& tip_form() {
    static const QRegularExpression form(R"(^(.*) \(([^()]+)\)$)", QRegularExpression::DotMatchesEverythingOption);
    return form;
  }
  // "Text (key)", as `tip_with_key` has it.
  static QString named_key(const QAbstractButton& button) { return tip_form().match(button.toolTip()).captured(2); }
  static QString meaning_of(const QAbstractButton& button) {
    const auto match = tip_form().match(button.toolTip());
    return match.hasMatch() ? match.captured(1) : button.toolTip();
  }

  void add(const QObject& owner, const QKeySequence& key, const QString& meaning) {
    const QString name = key.toString(QKeySequence::PortableText);
    if (name.isEmpty() || key[0] == Qt::Key_unknown) return;
    const auto known = [&](const KeyEntry& entry) { return entry.keys == name; };
    if (std::any_of(entries_.begin(), entries_.end(), known)) return;
    entries_.push_back({group_of(&owner), name, meaning});
  }

  std::vector<KeyEntry> entries_;
};

// Entries of a group stand together, groups in the order of their first entry.
void put_groups_together(std::vector<KeyEntry>& entries) {
  QStringList groups;
  for (const KeyEntry& entry : entries) {
    if (!groups.contains(entry.group)) groups << entry.group;
  }
  std::stable_sort(entries.begin(), entries.end(), [&](const KeyEntry& a, const KeyEntry& b) {
    return groups.indexOf(a.group) < groups.indexOf(b.group);
  });
}

QLabel* make_label(const QString& text, const char* style) {
  auto* label = new QLabel(text);
  label->setTextFormat(Qt::PlainText);
  label->setProperty(style, true);
  return label;
}

}  // namespace

std::vector<KeyEntry> keys_of_window(const QWidget& window) {
  KeyCollector collector;
  for (const auto* object : window.findChildren<QObject*>()) collector.take(*object);
  std::vector<KeyEntry> entries = std::move(collector).entries();
  put_groups_together(entries);
  return entries;
}

void set_key_group(QWidget& part, const QString& name) {
  part.setProperty(kGroupProperty, name);
}

void explain_gesture(QWidget& place, const QString& gesture, const QString& meaning) {
  place.setProperty(kGestureProperty, place.property(kGestureProperty).toStringList() << gesture << meaning);
}

void set_sheet_place(QWidget& place) {
  place.setProperty(kPlaceProperty, true);
}

void KeySheet::toggle(QWidget& window) {
  if (auto* shown = window.findChild<QFrame*>(kSheetName)) {
    delete shown;
  } else {
    new KeySheet(window);
  }
}

KeySheet::KeySheet(QWidget& window) : QFrame(&window), entries_(keys_of_window(window)) {
  setObjectName(kSheetName);
  setAccessibleName(words("Keys of this window"));
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 10, 10, 10);
  column->setSpacing(6);
  auto* head = new QHBoxLayout;
  head->addWidget(make_label(words("Keys of this window"), "sheetTitle"));
  head->addStretch(1);
  const bool esc_stops = window.findChild<QWidget*>("emergencyStop") != nullptr;
  head->addWidget(make_label(esc_stops ? words("F1 closes the sheet. Esc does too, and stops the needle.")
                                       : words("F1 or Esc closes the sheet."),
                             "figureNote"));
  auto* close = new QPushButton(QString::fromUtf8("\u2715"), this);
  close->setProperty("narrow", true);
  close->setFixedSize(28, 28);
  close->setToolTip(words("Close the sheet"));
  close->setAccessibleName(words("Close the sheet"));
  close->setFocusPolicy(Qt::TabFocus);
  connect(close, &QPushButton::clicked, this, &QObject::deleteLater);
  head->addWidget(close);
  column->addLayout(head);
  scroll_ = new QScrollArea(this);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(scroll_, 1);
  place();
  show();
  raise();
  qApp->installEventFilter(this);
}

// The rows in columns of equal length, no heading at the foot of one.
void KeySheet::fill() {
  const int column_count = std::max(1, (width() - 2 * kMargin_px) / kColumn_px);
  std::size_t row_count = entries_.size();
  for (std::size_t k = 0; k < entries_.size(); ++k) row_count += k == 0 || entries_[k].group != entries_[k - 1].group;
  const int most = static_cast<int>((row_count + static_cast<std::size_t>(column_count) - 1) /
                                    static_cast<std::size_t>(column_count));
  auto* page = new QWidget;
  page->setObjectName("page");
  auto* columns = new QHBoxLayout(page);
  columns->setContentsMargins(0, 0, 6, 0);
  columns->setSpacing(22);
  QGridLayout* grid = nullptr;
  int row = most;
  QString group;
  for (const KeyEntry& entry : entries_) {
    const bool begins = entry.group != group;
    if (row + (begins ? 1 : 0) >= most && columns->count() < column_count) {
      auto* one = new QVBoxLayout;
      columns->addLayout(one, 1);
      one->addLayout(grid = new QGridLayout);
      one->addStretch(1);
      grid->setColumnStretch(1, 1);
      grid->setHorizontalSpacing(10);
      grid->setVerticalSpacing(4);
      row = 0;
    }
    if (begins) {
      grid->addWidget(make_label(entry.group, "sheetGroup"), row++, 0, 1, 2);
      group = entry.group;
    }
    grid->addWidget(make_label(entry.keys, "keyCap"), row, 0, Qt::AlignLeft | Qt::AlignTop);
    auto* meaning = make_label(entry.meaning, "keyMeaning");
    meaning->setWordWrap(true);
    grid->addWidget(meaning, row++, 1);
  }
  scroll_->setWidget(page);
}

void KeySheet::place() {
  QWidget* window = parentWidget();
  QRect room = window->rect().adjusted(0, kTopBar_px, 0, 0);
  for (const auto* part : window->findChildren<QWidget*>()) {
    if (part->property(kPlaceProperty).toBool()) room = QRect(part->mapTo(window, QPoint(0, 0)), part->size());
  }
  room.adjust(kMargin_px, kMargin_px, -kMargin_px, -kMargin_px);
  resize(room.size());
  fill();
  // No higher than what is on it.
  layout()->activate();
  QWidget* page = scroll_->widget();
  const int page_px =
      page->hasHeightForWidth() ? page->heightForWidth(scroll_->viewport()->width()) : page->sizeHint().height();
  const int needed_px = page_px + height() - scroll_->viewport()->height();
  setGeometry(room.x(), room.y(), room.width(), std::min(room.height(), needed_px));
}

bool KeySheet::eventFilter(QObject* target, QEvent* event) {
  // Once the window's parts have their places.
  if (target == parentWidget() && event->type() == QEvent::Resize) QTimer::singleShot(0, this, [this] { place(); });
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
  auto& key = static_cast<QKeyEvent&>(*event);
  if (key.key() != Qt::Key_Escape || key.modifiers() != Qt::NoModifier) return false;
  // The stop comes first: it gets the key too.
  const bool is_stop = parentWidget()->findChild<QWidget*>("emergencyStop") != nullptr;
  if (event->type() == QEvent::KeyPress) {
    deleteLater();
    return !is_stop;
  }
  // No shortcut of the window: the key is this sheet's.
  if (is_stop) return false;
  key.accept();
  return true;
}

QPushButton* make_keys_button(QWidget* parent) {
  auto* button = new QPushButton("?", parent);
  button->setObjectName("keys");
  button->setProperty("narrow", true);
  button->setFixedSize(30, 30);
  button->setFocusPolicy(Qt::TabFocus);
  button->setAccessibleName(words("Keys"));
  bind_key(*button, Qt::Key_F1, words("All keys of this window"));
  QObject::connect(button, &QPushButton::clicked, button, [button] { KeySheet::toggle(*button->window()); });
  return button;
}

}  // namespace pellucida
