#include "StartMemory.h"

#include <QSettings>
#include <QString>
#include <algorithm>
#include <array>

#include "SettingsFile.h"

namespace pellucida {
namespace {

constexpr int kLongestText = 200;
constexpr QSize kSmallestWindow(1000, 640), kLargestWindow(8000, 8000);

struct TextEntry {
  const char* key;
  std::string StartForm::*member;
};
constexpr std::array<TextEntry, 12> kTexts{{{"virtual/scenario", &StartForm::scenario},
                                            {"virtual/stiffness", &StartForm::stiffness},
                                            {"virtual/hand", &StartForm::hand},
                                            {"recording/profile", &StartForm::recording_profile},
                                            {"recording/pixel_um", &StartForm::recording_pixel_um},
                                            {"recording/frame_rate_hz", &StartForm::frame_rate_hz},
                                            {"camera/camera", &StartForm::camera},
                                            {"camera/profile", &StartForm::camera_profile},
                                            {"camera/objective", &StartForm::objective},
                                            {"camera/camera_pixel_um", &StartForm::camera_pixel_um},
                                            {"camera/specimen_pixel_um", &StartForm::specimen_pixel_um},
                                            {"lesson/lesson", &StartForm::lesson}}};

// Text that a person can have typed; anything else is no setting of ours.
bool is_plausible(const QString& text) {
  return text.size() <= kLongestText && std::all_of(text.begin(), text.end(), [](QChar c) { return c.isPrint(); });
}

}  // namespace

StartMemory::StartMemory(const std::filesystem::path& file) : file_(QString::fromStdString(file.string())) {
  if (file_.isEmpty()) file_ = settings_file("start");
}

StartForm StartMemory::form() const {
  StartForm form;
  const QSettings settings(file_, QSettings::IniFormat);
  if (settings.status() != QSettings::NoError) return form;
  for (const auto& [key, member] : kTexts) {
    if (!settings.contains(key)) continue;
    const QString text = settings.value(key).toString();
    if (is_plausible(text)) form.*member = text.toStdString();
  }
  const int card = settings.value("card", 0).toInt();
  if (card >= 0 && card < kStartCardCount) form.card = static_cast<StartCardId>(card);
  form.large_letters = settings.value("lesson/large_letters", false).toBool();
  return form;
}

QSize StartMemory::size() const {
  const QSettings settings(file_, QSettings::IniFormat);
  const QSize size(settings.value("window/width_px", 0).toInt(), settings.value("window/height_px", 0).toInt());
  const bool fits = size == size.expandedTo(kSmallestWindow).boundedTo(kLargestWindow);
  return settings.status() == QSettings::NoError && fits ? size : QSize();
}

void StartMemory::keep(const StartForm& form, QSize size) const {
  make_writable(file_);
  QSettings settings(file_, QSettings::IniFormat);
  for (const auto& [key, member] : kTexts) settings.setValue(key, QString::fromStdString(form.*member));
  settings.setValue("card", static_cast<int>(form.card));
  settings.setValue("lesson/large_letters", form.large_letters);
  settings.setValue("window/width_px", size.width());
  settings.setValue("window/height_px", size.height());
}

}  // namespace pellucida
