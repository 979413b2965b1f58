#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "pellucida/core/Error.h"
#include "pellucida/core/Progress.h"
#include "pellucida/session/SessionCheck.h"

namespace pellucida {
namespace {

struct CheckArguments {
  std::string session;
  bool repair = false;
};

void print_counts(const SessionCounts& counts) {
  std::cout << counts.step_count << " steps, " << counts.files(SessionPart::kSurface) << " surfaces, "
            << counts.files(SessionPart::kMembranes) << " contours, " << counts.files(SessionPart::kTools) << " tools, "
            << counts.files(SessionPart::kFrame) << " frames, " << counts.event_count << " events; "
            << counts.unmeasured_count << " frames not measured, " << counts.dropped_count << " without their image, "
            << counts.thinned_count << " without their surface\n";
}

void check(const CheckArguments& arguments) {
  SessionReport report;
  {
    Progress progress("checking, files");
    report = check_session(arguments.session, arguments.repair, [&](std::size_t done, std::size_t all) {
      progress.update(static_cast<long>(done), static_cast<long>(all));
    });
  }
  for (const std::string& problem : report.problems) std::cout << "damaged: " << problem << '\n';
  if (report.problem_count > report.problems.size()) {
    std::cout << "damaged: and " << report.problem_count - report.problems.size() << " more\n";
  }
  for (const std::string& note : report.notes) std::cout << "note: " << note << '\n';
  for (const std::string& repair : report.repairs) std::cout << "repaired: " << repair << '\n';
  print_counts(report.counts);

  // Damage that stays is an unreadable input; the way to mend it is in the line.
  if (!report.fine()) {
    throw InputError(arguments.session + ": damaged (" + std::to_string(report.problem_count) +
                     (report.problem_count == 1 ? " problem" : " problems") + "); run pellucida check " +
                     arguments.session + " --repair");
  }
  std::cout << (report.repaired ? "repaired" : "fine") << '\n';
}

}  // namespace

void add_check_command(CLI::App& app) {
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = app.add_subcommand("check", "verify a session; recover it after a crash");
  command->add_option("SESSION", arguments->session, "folder of the session")->required();
  command->add_flag("--repair", arguments->repair,
                    "repair it: torn rows and unreadable files go to damaged/, lists and counts are rebuilt");
  command->callback([arguments] { check(*arguments); });
}

}  // namespace pellucida
