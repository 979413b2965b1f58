#include "GuideMemory.h"

#include <QSettings>
#include <QString>

namespace pellucida::guide_memory {
namespace {

constexpr const char* kRecordingsKey = "recordings";
constexpr const char* kSoundsKey = "sounds";

// QSettings is an object that is neither copied nor moved.
struct GuideSettings : QSettings {
  GuideSettings() : QSettings(QSettings::IniFormat, QSettings::UserScope, "Pellucida", "guide") {}
};

}  // namespace

std::filesystem::path recordings() {
  return GuideSettings().value(kRecordingsKey).toString().toStdString();
}

void keep_recordings(const std::filesystem::path& folder) {
  GuideSettings().setValue(kRecordingsKey, QString::fromStdString(folder.string()));
}

bool sounds() {
  return GuideSettings().value(kSoundsKey).toBool();
}

void keep_sounds(bool on) {
  GuideSettings().setValue(kSoundsKey, on);
}

}  // namespace pellucida::guide_memory
