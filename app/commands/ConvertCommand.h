#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// `pellucida convert SESSION --output DIR`: a session of any version written once more, as small as this one writes.
void add_convert_command(CLI::App& app);

}  // namespace pellucida
