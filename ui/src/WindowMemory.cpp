#include "WindowMemory.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QSettings>
#include <QSplitter>
#include <QVariant>
#include <QWidget>

#include "SettingsFile.h"
#include "pellucida/ui/WindowOptions.h"

namespace pellucida {
namespace {

constexpr const char* kKey = "keptAs";
constexpr int kLook_ms = 3000;
constexpr int kMostParts = 20;

QVariant value_of(const QObject& control) {
  if (const auto* button = qobject_cast<const QAbstractButton*>(&control)) return button->isChecked();
  if (const auto* action = qobject_cast<const QAction*>(&control)) return action->isChecked();
  if (const auto* slider = qobject_cast<const QAbstractSlider*>(&control)) return slider->value();
  if (const auto* list = qobject_cast<const QComboBox*>(&control)) return list->currentIndex();
  return {};
}

// As a person would set it, so that whoever listens hears of it.
void set_value(QObject& control, const QVariant& value) {
  if (value_of(control) == value) return;
  if (auto* button = qobject_cast<QAbstractButton*>(&control)) button->click();
  // The other entries of a choice go off by themselves.
  if (auto* action = qobject_cast<QAction*>(&control); action && (value.toBool() || !action->actionGroup()))
    action->trigger();
  if (auto* slider = qobject_cast<QAbstractSlider*>(&control)) slider->setValue(value.toInt());
  auto* list = qobject_cast<QComboBox*>(&control);
  if (list && value.toInt() >= 0 && value.toInt() < list->count()) list->setCurrentIndex(value.toInt());
}

// Settings files hold texts.
QVariant as_kind_of(const QVariant& now, QVariant text) {
  return text.convert(static_cast<int>(now.type())) ? text : QVariant();
}

template <class Act>
void for_each_kept(const QWidget& window, Act act) {
  for (QObject* control : window.findChildren<QObject*>()) {
    const QString key = control->property(kKey).toString();
    if (!key.isEmpty()) act(*control, key);
  }
}

QString key_of_splitter(int index) {
  return QString("splitter_%1").arg(index);
}

}  // namespace

void keep_as(QObject& control, const QString& key) {
  control.setProperty(kKey, key);
}

WindowMemory::WindowMemory(QWidget& window, const char* mode, const WindowOptions& options)
    : window_(window), mode_(mode), active_(options.screenshot.empty() && options.figures.empty()) {
  if (!active_) return;
  const QSettings settings(settings_file("windows"), QSettings::IniFormat);
  if (settings.status() == QSettings::NoError && options.remembered_size) {
    window_.restoreGeometry(settings.value(mode_ + "/geometry").toByteArray());
  }
  window_.installEventFilter(this);
  connect(&timer_, &QTimer::timeout, this, [this] { keep(); });
}

WindowMemory::~WindowMemory() = default;

bool WindowMemory::eventFilter(QObject* target, QEvent* event) {
  if (target != &window_) return false;
  // The rest once the window has its size, which moves splitters too.
  if (event->type() == QEvent::Show && !timer_.isActive()) {
    QTimer::singleShot(0, this, [this] { restore(); });
    timer_.start(kLook_ms);
  }
  if (event->type() == QEvent::Close) keep();
  return false;
}

QVariantMap WindowMemory::state() const {
  QVariantMap state;
  state["geometry"] = window_.saveGeometry();
  int index = 0;
  for (const QSplitter* splitter : window_.findChildren<QSplitter*>()) {
    QStringList sizes;
    for (const int size : splitter->sizes()) sizes << QString::number(size);
    state[key_of_splitter(index++)] = sizes;
  }
  for_each_kept(window_, [&](const QObject& control, const QString& key) { state[key] = value_of(control); });
  return state;
}

void WindowMemory::restore() {
  QSettings settings(settings_file("windows"), QSettings::IniFormat);
  if (settings.status() == QSettings::NoError) {
    settings.beginGroup(mode_);
    int index = 0;
    for (QSplitter* splitter : window_.findChildren<QSplitter*>()) {
      const QStringList texts = settings.value(key_of_splitter(index++)).toStringList();
      if (texts.size() != splitter->count() || texts.size() > kMostParts) continue;
      QList<int> sizes;
      int sum = 0;
      for (const QString& text : texts) sizes << qBound(0, text.toInt(), 10000);
      for (const int size : sizes) sum += size;
      if (sum > 0) splitter->setSizes(sizes);
    }
    for_each_kept(window_, [&](QObject& control, const QString& key) {
      const QVariant value = as_kind_of(value_of(control), settings.value(key));
      if (value.isValid() && !value.isNull()) set_value(control, value);
    });
  }
  restored_ = true;
  kept_ = state();
}

void WindowMemory::keep() {
  if (!restored_) return;
  const QVariantMap now = state();
  if (now == kept_) return;
  const QString file = settings_file("windows");
  make_writable(file);
  QSettings settings(file, QSettings::IniFormat);
  settings.beginGroup(mode_);
  for (auto entry = now.begin(); entry != now.end(); ++entry) settings.setValue(entry.key(), entry.value());
  kept_ = now;
}

}  // namespace pellucida
