#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// `pellucida force`: the model's force-indentation curve in one of the four configurations, no video.
void add_force_command(CLI::App& app);

}  // namespace pellucida
