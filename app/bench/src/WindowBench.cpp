#include "pellucida/bench/WindowBench.h"

#include <poll.h>
#include <signal.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <vector>

#include "pellucida/batch/ChildProcess.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/visualization/VirtualDisplay.h"

namespace pellucida {
namespace {

using WindowJson = nlohmann::ordered_json;

constexpr int kTurnCount = 3;
constexpr auto kLongestClosing = std::chrono::seconds(60);

// The settings of the person who runs the bench don't matter: the window finds none.
class OwnSettings {
 public:
  explicit OwnSettings(const std::filesystem::path& folder) {
    if (const char* before = std::getenv("XDG_CONFIG_HOME")) before_ = before;
    setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
  }
  ~OwnSettings() {
    if (before_) {
      setenv("XDG_CONFIG_HOME", before_->c_str(), 1);
    } else {
      unsetenv("XDG_CONFIG_HOME");
    }
  }
  OwnSettings(const OwnSettings&) = delete;
  OwnSettings& operator=(const OwnSettings&) = delete;

 private:
  std::optional<std::string> before_;
};

[[noreturn]] void refuse(const std::filesystem::path& program, const ChildEnd& end) {
  const std::string words = end.error_output.substr(0, end.error_output.find('\n'));
  throw InputError(program.string() + ": its window can't be measured (" +
                   (words.empty() ? "exit code " + std::to_string(end.exit_code) : words) +
                   "); name a pellucida whose `workstation` knows --figures");
}

// The end of a child within a time; nothing when it still runs.
std::optional<ChildEnd> wait_for(ChildProcess& child, std::chrono::milliseconds longest) {
  const auto until = std::chrono::steady_clock::now() + longest;
  while (true) {
    if (auto end = child.end()) return end;
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
    if (left.count() <= 0) return std::nullopt;
    pollfd ended{child.end_descriptor(), POLLIN, 0};
    poll(&ended, 1, static_cast<int>(std::min<long>(left.count(), 200)));
  }
}

WindowJson run_turn(const std::filesystem::path& program, const std::string& source, double seconds) {
  const TemporaryFolder folder;
  const OwnSettings settings(folder.path());
  const auto file = folder / "figures.json";
  ChildProcess child(program,
                     {"workstation", "--source", source, "--theme", "dark", "--language", "en", "--width-px", "1400",
                      "--height-px", "900", "--figures", file.string(), "--after", std::to_string(seconds)});
  // It closes by itself; on a busy computer its start takes a while.
  const auto longest = std::chrono::milliseconds(std::lround(1e3 * seconds)) + kLongestClosing;
  const auto end = wait_for(child, longest);
  if (!end) throw InputError(program.string() + ": its window showed no live frame in time, or did not close");
  if (end->exit_code != 0) refuse(program, *end);
  std::ifstream stream(file);
  const WindowJson figures = WindowJson::parse(stream, nullptr, false);
  if (!figures.is_object() || !figures.contains("drawn_per_s")) refuse(program, *end);
  return figures;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Turns {
  std::filesystem::path program;
  std::vector<WindowJson> turns;
  std::optional<WindowJson> long_turn;

  std::vector<double> all(const char* key) const {
    std::vector<double> values;
    for (const WindowJson& turn : turns) values.push_back(turn.value(key, 0.0));
    return values;
  }
};

std::string line(const char* name, const char* format, auto... values) {
  std::array<char, 200> text{};
  const int begun = std::snprintf(text.data(), text.size(), "%-28s ", name);
  std::snprintf(text.data() + begun, text.size() - static_cast<std::size_t>(begun), format, values...);
  return std::string(text.data()) + '\n';
}

void add(WindowBenchReport& report, WindowJson& list, const Turns& turns) {
  const auto longest = turns.all("longest_block_ms");
  const auto blocks = turns.all("blocks");
  const auto seconds = turns.all("seconds");
  double block_count = 0.0, watched_s = 0.0;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    block_count += blocks[k];
    watched_s += seconds[k];
  }
  report.text += turns.program.string() + '\n';
  report.text += line("  window, 1400 x 900", "%9.1f frames/s drawn", median(turns.all("drawn_per_s")));
  report.text += line("  processor, each frame", "%9.1f ms of the window's thread, %.1f ms of all threads",
                      median(turns.all("window_thread_ms_per_frame")), median(turns.all("processor_ms_per_frame")));
  report.text +=
      line("  blocks", "%9.0f longer than %.0f ms in %.0f s, longest %.0f ms", block_count,
           turns.turns.front().value("block_ms", 0.0), watched_s, *std::max_element(longest.begin(), longest.end()));
  report.text += line("  start to first live frame", "%9.2f s", median(turns.all("start_s")));
  const WindowJson& held = turns.long_turn ? *turns.long_turn : turns.turns.back();
  const auto& memory = held.at("memory_s_MiB");
  report.text +=
      line("  memory", "%9.0f MiB at the first frame, %.0f MiB after %.0f s", memory.front().at(1).get<double>(),
           memory.back().at(1).get<double>(), memory.back().at(0).get<double>());
  WindowJson entry{{"program", turns.program.string()}, {"turns", turns.turns}};
  if (turns.long_turn) entry["long_turn"] = *turns.long_turn;
  list.push_back(std::move(entry));
}

}  // namespace

WindowBenchReport measure_window(const WindowBenchOptions& options) {
  const VirtualDisplay display;
  std::vector<Turns> programs{{options.program, {}, {}}};
  if (!options.against.empty()) programs.push_back({options.against, {}, {}});
  const int turn_count = programs.size() > 1 ? kTurnCount : 1;
  for (int turn = 0; turn < turn_count; ++turn) {
    for (Turns& one : programs) one.turns.push_back(run_turn(one.program, options.source, options.seconds));
  }
  if (options.minutes > 0.0) {
    for (Turns& one : programs) one.long_turn = run_turn(one.program, options.source, 60.0 * options.minutes);
  }
  WindowBenchReport report;
  WindowJson list = WindowJson::array();
  for (const Turns& one : programs) add(report, list, one);
  report.json = list.dump();
  return report;
}

}  // namespace pellucida
