#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "pellucida/teleoperation/DeviceSearch.h"
#include "pellucida/teleoperation/EppendorfLine.h"

namespace pellucida {
namespace {

std::vector<DeviceReport> search_all() {
  std::vector<DeviceReport> reports = search_cameras();
  reports.push_back({"camera", "virtual", true, "the virtual microscope"});
  for (const auto& part : {search_hand_devices(), search_manipulators()}) {
    reports.insert(reports.end(), part.begin(), part.end());
  }
  return reports;
}

void print(const std::vector<DeviceReport>& reports) {
  std::size_t name_width = 0;
  for (const auto& report : reports) name_width = std::max(name_width, report.name.size());
  for (const auto& report : reports) {
    std::cout << (report.usable ? "yes  " : "no   ") << std::left << std::setw(13) << report.kind
              << std::setw(static_cast<int>(name_width) + 2) << report.name << report.detail << '\n';
  }
}

void print_json(const std::vector<DeviceReport>& reports) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& report : reports) {
    list.push_back(
        {{"kind", report.kind}, {"name", report.name}, {"usable", report.usable}, {"detail", report.detail}});
  }
  // A device may name itself in bytes that are no text.
  std::cout << nlohmann::json{{"devices", list}}.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

void print_position(const char* unit, const EppendorfPosition& position) {
  std::cout << "position";
  for (const long coordinate : position.coordinates) std::cout << ' ' << coordinate;
  std::cout << ' ' << unit << (position.limit_switches != 0 ? ", at a limit switch" : "") << '\n';
}

void print_identity(const EppendorfIdentity& identity) {
  std::cout << "version " << identity.version << '\n';
  print_position("um", identity.micrometres);
  print_position("microsteps", identity.microsteps);
  if (identity.microsteps_per_um > 0.0) {
    std::cout << identity.microsteps_per_um << " microsteps per um\n";
  } else {
    std::cout << "microsteps per um: drive it 100 um or more away from zero, and ask again\n";
  }
}

}  // namespace

void add_devices_command(CLI::App& app) {
  auto json = std::make_shared<bool>(false);
  auto port = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "devices",
      "cameras, input devices, serial ports, manipulators: which are usable, and exactly why others are not");
  command->add_flag("--json", *json, "the same as JSON: kind, name, usable, detail");
  command->add_option("--ask", *port,
                      "ask the Eppendorf manipulator at this serial port for version and position; moves nothing");
  command->callback([json, port] {
    if (!port->empty()) {
      print_identity(ask_identity(*port));
    } else if (*json) {
      print_json(search_all());
    } else {
      print(search_all());
    }
  });
}

}  // namespace pellucida
