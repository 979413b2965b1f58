#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// Adds the subcommand `bench`; its callback does the work and throws pellucida::Error.
void add_bench_command(CLI::App& app);

}  // namespace pellucida
