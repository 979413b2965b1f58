#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// `pellucida export SESSION --output DIR [--frames LIST]`: a session as flat files for other tools.
void add_export_command(CLI::App& app);

}  // namespace pellucida
