#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// `pellucida report SESSION [--output FOLDER|FILE.html]`: the dose passport of a session's cells.
void add_report_command(CLI::App& app);

}  // namespace pellucida
