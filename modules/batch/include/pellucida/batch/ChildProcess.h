#pragma once
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pellucida {

/// How a child process ended.
struct ChildEnd {
  int exit_code = 0;         ///< 128 + the signal's number where one ended it
  int signal = 0;            ///< that ended it; 0 for none
  std::string error_output;  ///< what it wrote to standard error, the last 64 KiB
  double wall_time_s = 0.0;
};

/// A program run beside this one: without input, its standard output dropped, its standard error kept. It has a process
/// group of its own, so that Ctrl+C in a terminal reaches the parent alone, and the system kills it when the thread
/// that started it ends.
class ChildProcess {
 public:
  /// Throws OutputError where no process, or no room for its words, can be had.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  /// Kills it, if it still runs, and waits for its end.
  ~ChildProcess();
  ChildProcess(ChildProcess&&) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;

  /// Its end, once; nothing while it runs.
  std::optional<ChildEnd> end();
  void send(int signal) const noexcept;
  /// A descriptor that can be read once the process has ended (`poll`).
  int end_descriptor() const noexcept { return end_descriptor_; }

 private:
  std::string error_output() const;

  int pid_ = -1;
  int end_descriptor_ = -1;
  int error_descriptor_ = -1;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace pellucida
