#include "commands/CommandLine.h"

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>

namespace pellucida {
namespace {

std::string& kept() {
  static std::string line;
  return line;
}

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value;
}

}  // namespace

const std::string& command_line() {
  return kept();
}

void keep_command_line(int argc, char** argv) {
  std::string line = "pellucida";
  for (int i = 1; i < argc; ++i) line += std::string(" ") + argv[i];
  kept() = line;
}

bool has_display() {
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

std::string default_session_folder() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char stamp[32];
  std::strftime(stamp, sizeof stamp, "%Y-%m-%dT%H-%M-%SZ", &utc);
  const char* home = std::getenv("HOME");
  const std::filesystem::path base = home && *home ? home : ".";
  return (base / "Pellucida" / stamp).string();
}

}  // namespace pellucida
