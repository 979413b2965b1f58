#pragma once
#include "pellucida/core_vtk/FrameSource.h"

namespace pellucida {

/// From here on INT, TERM and HUP say in one line what ended the program. A signal that is ignored at the start (nohup)
/// stays ignored; a write beyond a limit on file sizes fails like any other instead of ending the program.
void install_signals();

/// While one lives, the first INT, TERM or HUP is kept instead of ending the program, so that what was done can be
/// completed; a second one ends it.
class InterruptScope {
 public:
  InterruptScope() noexcept;
  /// Leaves a signal that came to `end_if_interrupted`.
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;
};

/// The number of the signal that was kept; 0 for none.
int interrupted() noexcept;
/// A descriptor that can be read once a signal was kept, for event loops; -1 where the system gives none. Never read
/// from it: it stays so for all that wait.
int interrupt_descriptor() noexcept;
/// "SIGINT", "SIGTERM" or "SIGHUP".
const char* signal_name(int number) noexcept;
/// Ends the program by the signal that was kept, as if it had not been: a shell sees that it was interrupted.
void end_if_interrupted();

/// A source that ends with the first signal.
class InterruptibleSource final : public FrameSource {
 public:
  /// `source` must outlive it.
  explicit InterruptibleSource(FrameSource& source) : source_(source) {}

  const SourceInfo& info() const noexcept override { return source_.info(); }
  std::optional<Frame> next() override { return interrupted() != 0 ? std::nullopt : source_.next(); }
  bool restart() override { return source_.restart(); }

 private:
  FrameSource& source_;
};

}  // namespace pellucida
