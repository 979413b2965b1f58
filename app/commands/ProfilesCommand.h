#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// `pellucida profiles`: the cell profiles known, or one of them whole.
void add_profiles_command(CLI::App& app);

}  // namespace pellucida
