#pragma once
#include <memory>
#include <string>

class QTranslator;

namespace pellucida {

/// The texts of the windows in one language, for as long as it lives; one at a time. English needs no texts.
class Translation {
 public:
  /// `language`: en or de; empty: the system's, English where that is neither. Throws DeviceError when this build was
  /// made without the texts of the language that is named.
  explicit Translation(const std::string& language);
  ~Translation();

  /// What the windows speak: en or de.
  const std::string& language() const noexcept { return language_; }

 private:
  std::string language_;
  std::unique_ptr<QTranslator> program_;
  std::unique_ptr<QTranslator> toolkit_;  // buttons of Qt's own dialogs
};

}  // namespace pellucida
