#pragma once
#include <QSize>
#include <QString>
#include <filesystem>

#include "presenters/StartForm.h"

namespace pellucida {

/// What the start page remembers from one time to the next, in a settings file of Qt's INI format.
class StartMemory {
 public:
  /// `file`: empty for `Pellucida/start.ini` in the user's settings.
  explicit StartMemory(const std::filesystem::path& file);

  /// The form as it was left. What is missing, damaged or out of range is the default; values of lists that are no
  /// longer there are the list's affair.
  StartForm form() const;
  /// Size of the window; invalid where none, or none that a window may have, is remembered.
  QSize size() const;
  /// The paths of recordings are not kept. A file that can't be written changes nothing.
  void keep(const StartForm& form, QSize size) const;

 private:
  QString file_;
};

}  // namespace pellucida
