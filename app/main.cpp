#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "pellucida/core/Error.h"
#include "pellucida/core/Version.h"

namespace {

// Every error ends here: one line on stderr, and the exit code that scripts rely on.
int report(pellucida::ExitCode code, const char* text) {
  std::cerr << "pellucida: " << text << '\n';
  return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Pellucida: see a living cell's membrane in 3-D, and the force on it, from the microscope image alone");
  app.set_version_flag("--version", pellucida::kVersion);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(pellucida::ExitCode::kWrongUsage);
  } catch (const pellucida::Error& error) {
    return report(error.code(), error.what());
  } catch (const std::exception& error) {
    return report(pellucida::ExitCode::kOurFault, error.what());
  }
  return 0;
}
