#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// `pellucida replay`.
void add_replay_command(CLI::App& app);

}  // namespace pellucida
