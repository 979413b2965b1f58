#pragma once
#include <QString>

namespace pellucida {

/// `Pellucida/NAME.ini` in the user's settings.
QString settings_file(const char* name);

/// Before something is written: Qt does not write over a file that it can't read, so a damaged one is removed.
void make_writable(const QString& file);

}  // namespace pellucida
