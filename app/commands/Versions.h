#pragma once
#include <map>
#include <string>

namespace pellucida {

/// What `pellucida --version` prints: name and version, then one line per library with the version in use (for a
/// library that does not report it at run time: the version compiled against), and which devices this build lacks.
std::string version_text();

/// The libraries' versions by name, as they are recorded in a session.
std::map<std::string, std::string> library_versions();

}  // namespace pellucida
