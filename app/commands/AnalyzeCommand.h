#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// Adds the subcommand `analyze`; its callback does the work and throws pellucida::Error.
void add_analyze_command(CLI::App& app);

}  // namespace pellucida
