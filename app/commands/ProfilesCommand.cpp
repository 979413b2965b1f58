#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

#include "pellucida/core/Resources.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {
namespace {

std::string number(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

/// One line of the list, in columns.
void print_row(const std::string& name, const std::string& radius, const std::string& zona, const std::string& table,
               const std::string& effective, const std::string& puncture, const std::string& what) {
  std::cout << std::left << std::setw(14) << name << std::right << std::setw(9) << radius << std::setw(9) << zona
            << std::setw(11) << table << std::setw(14) << effective << std::setw(18) << puncture << "  " << what
            << '\n';
}

void list_profiles() {
  print_row("name", "R um", "zona um", "Table kPa", "effective kPa", "puncture", "what");
  for (const auto& name : list_resources("profiles", ".json")) {
    const CellProfile p = load_profile(name);
    print_row(p.name, number(p.mid_radius_um, 1), number(p.thickness_um, 1), number(p.young_modulus_kPa, 1),
              number(p.effective_young_modulus_kPa, 1),
              number(p.puncture_force_uN, 1) + " uN at " + number(p.puncture_indentation_um, 0) + " um", p.description);
  }
  std::cout
      << "R: middle of the zona. Table: Young modulus as published or inferred; effective: the scale that meets the "
         "puncture point,\n"
         "which is measured or computed. All of a profile, with its sources: pellucida profiles NAME\n";
}

}  // namespace

void add_profiles_command(CLI::App& app) {
  auto name = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("profiles", "the cell profiles known; with a name, that profile as JSON");
  command->add_option("name", *name, "a profile's name, or its file");
  command->callback([name] {
    if (name->empty()) {
      list_profiles();
    } else {
      std::cout << to_json(load_profile(*name)) << '\n';
    }
  });
}

}  // namespace pellucida
