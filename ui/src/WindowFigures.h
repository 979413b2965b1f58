#pragma once
#include <QObject>
#include <chrono>
#include <string>
#include <vector>

namespace pellucida {

/// How fast a window is: what it drew, how long it blocked, the memory and the processor it took. One thread, the
/// window's.
class WindowFigures {
 public:
  /// `file`: where they are written as JSON; empty: nowhere.
  explicit WindowFigures(std::string file) : file_(std::move(file)) {}

  /// A live frame was rendered: blocks and rates are counted from the first one's appearance on the screen.
  void drew();
  /// Every now and then: looks at the memory every ten seconds.
  void look();
  /// Throws OutputError when the file can't be written.
  void write() const;

 private:
  QObject owner_;  // of what waits: it goes with the window
  struct Memory {
    double time_s;  // since the first frame
    double resident_MiB;
  };
  // Since the process began, s; processor time of the process and of this thread, s.
  struct Moment {
    std::chrono::steady_clock::time_point time;
    double processor_s;
    double thread_s;
  };
  static Moment now();
  void begin();
  double elapsed_s() const;

  std::string file_;
  bool has_drawn_ = false;
  bool has_begun_ = false;
  long drawn_count_ = 0;  // after the first
  double start_s_ = 0.0;  // from the process's start to the first frame
  Moment begin_{};
  std::vector<Memory> memory_;
};

}  // namespace pellucida
