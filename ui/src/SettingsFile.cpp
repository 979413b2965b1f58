#include "SettingsFile.h"

#include <QFile>
#include <QSettings>

namespace pellucida {

QString settings_file(const char* name) {
  return QSettings(QSettings::IniFormat, QSettings::UserScope, "Pellucida", name).fileName();
}

void make_writable(const QString& file) {
  if (QSettings(file, QSettings::IniFormat).status() == QSettings::FormatError) QFile::remove(file);
}

}  // namespace pellucida
