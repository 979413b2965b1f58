#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// Adds the subcommand `workstation`; its callback does the work and throws pellucida::Error.
void add_workstation_command(CLI::App& app);

}  // namespace pellucida
