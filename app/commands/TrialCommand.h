#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// `pellucida trial --simulated`: injections by a simulated operator under four modalities, as a table, files and a
/// chart.
void add_trial_command(CLI::App& app);

}  // namespace pellucida
