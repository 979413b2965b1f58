#pragma once

namespace CLI {
class App;
}

namespace pellucida {

/// Each adds its subcommand to the program; the callback does the work and throws pellucida::Error.
void add_analyze_command(CLI::App& app);
void add_bench_command(CLI::App& app);
void add_check_command(CLI::App& app);
void add_convert_command(CLI::App& app);
void add_devices_command(CLI::App& app);
void add_export_command(CLI::App& app);
void add_force_command(CLI::App& app);
void add_identify_command(CLI::App& app);
void add_inject_command(CLI::App& app);
void add_profiles_command(CLI::App& app);
void add_replay_command(CLI::App& app);
void add_report_command(CLI::App& app);
void add_simulate_command(CLI::App& app);
void add_trial_command(CLI::App& app);
void add_workstation_command(CLI::App& app);

}  // namespace pellucida
