#include "widgets/LookMenu.h"

#include <QActionGroup>
#include <QApplication>
#include <QKeySequence>
#include <QMenu>
#include <QPushButton>
#include <utility>

#include "Look.h"
#include "Theme.h"
#include "Words.h"
#include "pellucida/visualization/Palette.h"

namespace pellucida {
namespace {

void choose_theme(bool light) {
  apply_theme(*qApp, light ? light_theme() : dark_theme(), applied_type_scale());
  Look look = remembered_look();
  look.theme = light ? "light" : "dark";
  remember_look(look);
}

void choose_language(const char* language) {
  Look look = remembered_look();
  look.language = language;
  remember_look(look);
}

}  // namespace

QPushButton* make_look_button(const QKeySequence& light_key, QWidget* parent) {
  auto* button = new QPushButton(words("Look \u25BE"), parent);
  button->setObjectName("look");
  button->setFixedHeight(30);
  button->setFocusPolicy(Qt::TabFocus);
  button->setToolTip(words("Theme and language"));
  auto* menu = new QMenu(button);
  QAction* light = menu->addAction(words("Light theme"));
  light->setObjectName("lightTheme");
  light->setCheckable(true);
  light->setChecked(current_theme().is_light);
  light->setShortcut(light_key);
  QObject::connect(light, &QAction::toggled, button, &choose_theme);
  menu->addSeparator();
  auto* languages = new QActionGroup(menu);
  const std::string chosen = remembered_look().language;
  const std::pair<const char*, QString> entries[] = {
      {"", words("Language of the system")}, {"en", "English"}, {"de", "Deutsch"}};
  for (const auto& [language, name] : entries) {
    QAction* action = menu->addAction(name);
    action->setObjectName(QString("language_") + language);
    action->setCheckable(true);
    action->setChecked(chosen == language);
    languages->addAction(action);
    QObject::connect(action, &QAction::triggered, button, [language = language] { choose_language(language); });
  }
  menu->addAction(words("The next window has it"))->setEnabled(false);
  // The key of a menu that isn't open acts too.
  button->addAction(light);
  button->setMenu(menu);
  return button;
}

}  // namespace pellucida
