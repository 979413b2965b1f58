#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>

#include "commands/CommandLine.h"
#include "commands/Commands.h"
#include "commands/Interrupt.h"
#include "commands/Manual.h"
#include "commands/Versions.h"
#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/VtkThreads.h"

namespace {

// Every error ends here: one line on stderr, and the exit code that scripts rely on.
int report(pellucida::ExitCode code, const char* text) {
  std::cerr << "pellucida: " << text << '\n';
  return static_cast<int>(code);
}

// What could not be printed is an output that could not be written.
int finish() {
  std::cout.flush();
  if (std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return 0;
  return report(pellucida::ExitCode::kOutputUnwritable,
                "stdout can't be written; check the disk or program it goes to");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Pellucida: see a living cell's membrane in 3-D, and the force on it, from the microscope image alone",
               "pellucida");
  app.set_version_flag("--version", pellucida::version_text, "Version of the program and of its libraries, and exit");
  app.require_subcommand(0, 1);
  std::string path;
  app.add_option("path", path, "A session, or a recording, to open in the window")->check([](const std::string& text) {
    return std::filesystem::exists(text) ? std::string() : text + " is no command, and there is no such file or folder";
  });
  pellucida::add_workstation_command(app);
  pellucida::add_simulate_command(app);
  pellucida::add_inject_command(app);
  pellucida::add_analyze_command(app);
  pellucida::add_replay_command(app);
  pellucida::add_identify_command(app);
  pellucida::add_force_command(app);
  pellucida::add_check_command(app);
  pellucida::add_convert_command(app);
  pellucida::add_export_command(app);
  pellucida::add_report_command(app);
  pellucida::add_trial_command(app);
  pellucida::add_bench_command(app);
  pellucida::add_devices_command(app);
  pellucida::add_profiles_command(app);
  // Hidden, for the build: the commands as the man page lists them.
  app.add_flag_callback("--manual-of-commands",
                        [&app] { throw CLI::CallForVersion(pellucida::manual_of_commands(app), 0); })
      ->group("");
  pellucida::keep_command_line(argc, argv);
  pellucida::install_signals();
  pellucida::keep_vtk_loops_on_their_thread();
  try {
    app.parse(argc, argv);
    // Without a subcommand: the workstation on the virtual microscope.
    if (app.get_subcommands().empty()) {
      std::vector<std::string> words{"workstation"};
      if (!path.empty()) words.insert(words.begin(), path);  // in CLI11's order, the last first
      app.parse(words);
    }
  } catch (const CLI::Success& asked) {
    // Help, version, manual.
    const int code = app.exit(asked);
    return code == 0 ? finish() : code;
  } catch (const CLI::ParseError& error) {
    const std::string text = std::string(error.what()) + "; see pellucida --help";
    return report(pellucida::ExitCode::kWrongUsage, text.c_str());
  } catch (const pellucida::Error& error) {
    return report(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return report(pellucida::ExitCode::kOurFault, "there is not enough memory for this");
  } catch (const std::exception& error) {
    return report(pellucida::ExitCode::kOurFault, error.what());
  }
  const int code = finish();
  pellucida::end_if_interrupted();
  return code;
}
