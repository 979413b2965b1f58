#include "GuideMemory.h"

#include <QSettings>

#include "SettingsFile.h"

namespace pellucida {
namespace {

constexpr const char* kRecordingsKey = "recordings";

}  // namespace

std::filesystem::path remembered_recordings() {
  const QSettings settings(settings_file("guide"), QSettings::IniFormat);
  if (settings.status() != QSettings::NoError) return {};
  return settings.value(kRecordingsKey).toString().toStdString();
}

void remember_recordings(const std::filesystem::path& folder) {
  make_writable(settings_file("guide"));
  QSettings(settings_file("guide"), QSettings::IniFormat)
      .setValue(kRecordingsKey, QString::fromStdString(folder.string()));
}

}  // namespace pellucida
