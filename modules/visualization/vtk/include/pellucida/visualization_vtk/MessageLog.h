#pragma once
#include <vtkOutputWindow.h>

#include <cstdint>
#include <map>
#include <string>

namespace pellucida {

/// Where VTK's errors and warnings go: each distinct message is printed once on stderr, as one line, and the rest are
/// counted, so that a fault repeated with every frame cannot flood a terminal.
class MessageLog : public vtkOutputWindow {
 public:
  static MessageLog* New();
  vtkTypeMacro(MessageLog, vtkOutputWindow);
  MessageLog(const MessageLog&) = delete;
  void operator=(const MessageLog&) = delete;

  /// Makes a log of this kind VTK's output from now on, and returns it; returns the one already in place, if there is
  /// one.
  static MessageLog* install();

  /// Errors and warnings so far, repeated ones included.
  std::uint64_t problem_count() const noexcept { return problem_count_; }
  /// The newest problem, one line; empty before the first.
  const std::string& last_problem() const noexcept { return last_problem_; }

  void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayDebugText(const char*) override {}

 protected:
  MessageLog() = default;
  ~MessageLog() override = default;

 private:
  void take(const char* kind, const char* text);

  std::map<std::string, std::uint64_t> seen_;
  std::uint64_t problem_count_ = 0;
  std::string last_problem_;
};

}  // namespace pellucida
