#include "Look.h"

#include <QSettings>
#include <QString>
#include <algorithm>
#include <initializer_list>

#include "SettingsFile.h"

namespace pellucida {
namespace {

QString look_file() {
  return settings_file("look");
}

// One of `known`, or else the first of them.
std::string known_one(const QString& text, std::initializer_list<const char*> known) {
  const auto found = std::find_if(known.begin(), known.end(), [&](const char* one) { return text == one; });
  return found == known.end() ? *known.begin() : *found;
}

}  // namespace

Look remembered_look() {
  const QSettings settings(look_file(), QSettings::IniFormat);
  if (settings.status() != QSettings::NoError) return {};
  return {.theme = known_one(settings.value("theme").toString(), {"dark", "light"}),
          .language = known_one(settings.value("language").toString(), {"", "en", "de"})};
}

void remember_look(const Look& look) {
  make_writable(look_file());
  QSettings settings(look_file(), QSettings::IniFormat);
  settings.setValue("theme", QString::fromStdString(look.theme));
  settings.setValue("language", QString::fromStdString(look.language));
}

}  // namespace pellucida
