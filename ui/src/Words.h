#pragma once
#include <QString>
#include <exception>
#include <string>

#include "pellucida/core/Words.h"

namespace pellucida {

/// A text in the language of the windows, for widgets and for what takes UTF-8.
class Words : public QString {
 public:
  explicit Words(const char* english) : QString(QString::fromStdString(say(english))) {}
  operator std::string() const { return toStdString(); }
};

/// An error's sentence in the language of the windows.
inline QString words_of(const std::exception& error) {
  return QString::fromStdString(say_message(error.what()));
}

/// As `say`.
inline Words words(const char* english) {
  return Words(english);
}

}  // namespace pellucida
