#pragma once
#include <string>

namespace pellucida {

/// What a device says whose library was left out of the build, and how to mend it. `option` is CMake's, `package`
/// Debian's.
inline std::string not_in_this_build(const char* device, const char* library, const char* option, const char* package) {
  return std::string("this build has no ") + device + " support (built without " + library + "); build it with -D" +
         option + "=ON and the package " + package;
}

}  // namespace pellucida
