#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// `pellucida check SESSION [--repair]`: verifies a session and mends it after a crash. The report goes to stdout.
void add_check_command(CLI::App& app);

}  // namespace pellucida
