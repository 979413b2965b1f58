#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// `pellucida inject`: a guided injection by the simulated operator, into a session.
void add_inject_command(CLI::App& app);

}  // namespace pellucida
