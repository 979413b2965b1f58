#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// Adds the subcommand `simulate`; its callback does the work and throws pellucida::Error.
void add_simulate_command(CLI::App& app);

}  // namespace pellucida
