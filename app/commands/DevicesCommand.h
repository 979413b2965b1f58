#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// `pellucida devices`: cameras, devices for the hand, serial ports and manipulators: what is there, what is not and
/// why.
void add_devices_command(CLI::App& app);

}  // namespace pellucida
