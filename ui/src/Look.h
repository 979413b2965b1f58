#pragma once
#include <string>

namespace pellucida {

/// How the windows look, as a person chose it: the same for all modes.
struct Look {
  std::string theme = "dark";  ///< dark or light
  std::string language;        ///< en or de; empty: the system's
};

/// The look chosen last, kept in `Pellucida/look.ini` in the user's settings; the defaults for whatever is missing,
/// damaged or unknown there.
Look remembered_look();
/// Keeps `look` for the next window; settings that can't be written stay as they are.
void remember_look(const Look& look);

}  // namespace pellucida
