#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// `pellucida identify`: the constants of a cell's profile from finite elements, its force scale from a measurement.
void add_identify_command(CLI::App& app);

}  // namespace pellucida
