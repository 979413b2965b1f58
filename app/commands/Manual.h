#pragma once
#include <string>

namespace CLI {
class App;
}

namespace pellucida {

/// The commands and their options as the section COMMANDS of a man page (troff, macros of man(7)): what `--help` says
/// about them, in the same order. Hidden options and each command's own `--help` are left out.
std::string manual_of_commands(const CLI::App& app);

}  // namespace pellucida
