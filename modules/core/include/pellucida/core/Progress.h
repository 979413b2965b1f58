#pragma once
#include <chrono>
#include <optional>
#include <string>

namespace pellucida {

/// A line on the terminal that says how far a long job is; nothing at all when stderr is no terminal.
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// At most ten times a second; `all` where it is known.
  void update(long done, std::optional<long> all);
  /// The same with words of its own.
  void say(const std::string& line);
  /// A message that stays, on a line of its own, also where stderr is no terminal.
  void note(const std::string& text);

 private:
  bool is_due();

  std::string what_;
  bool on_terminal_;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace pellucida
