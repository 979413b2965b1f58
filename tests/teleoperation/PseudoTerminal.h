#pragma once
#include <atomic>
#include <functional>
#include <string>
#include <string_view>
#include <thread>

namespace pellucida {

/// A serial port without hardware: a pseudo-terminal whose far end this object holds. libserialport takes real ports
/// only (those the system lists, with modem lines); PseudoTerminal.cpp answers its three questions about them in this
/// program.
class PseudoTerminal {
 public:
  PseudoTerminal();
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  const std::string& path() const { return path_; }

  /// To the program at the near end.
  void send(std::string_view bytes);

  /// Answers from now on: each line that comes (without its CR) is handed over, on a thread of its own; what is
  /// returned is sent back.
  void serve(std::function<std::string(const std::string& line)> answer);

  /// Pulls the plug: the near end reads and writes errors from now on.
  void unplug();

 private:
  void run(std::stop_token stop);

  int master_ = -1;
  std::string path_;
  std::function<std::string(const std::string&)> answer_;
  std::jthread thread_;
};

}  // namespace pellucida
