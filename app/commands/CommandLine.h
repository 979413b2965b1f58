#pragma once
#include <string>

namespace pellucida {

/// The words the program was started with, as they are recorded in a session.
const std::string& command_line();
void keep_command_line(int argc, char** argv);

/// True when windows can be opened: an X or Wayland display is named in the environment.
bool has_display();

/// A new session folder for a run whose user named none: `Pellucida/<UTC time>` in the home folder.
std::string default_session_folder();

}  // namespace pellucida
