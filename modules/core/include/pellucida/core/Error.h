#pragma once
#include <stdexcept>
#include <string>

namespace pellucida {

/// Exit codes of the command line (a contract: scripts outside the project rely on them).
enum class ExitCode : int {
  kDone = 0,
  kOurFault = 1,
  kWrongUsage = 2,
  kInputUnreadable = 3,
  kNothingMeasured = 4,
  kOutputUnwritable = 5,
  kDeviceMissing = 6,
  kSomeFailed = 7,
};

/// Base of every exception thrown on purpose. The text is one line: what, where, how to correct it.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& text) : std::runtime_error(text), code_(code) {}
  ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

/// A wrong argument, option or configuration value; carries the value and the limit.
class UsageError : public Error {
 public:
  explicit UsageError(const std::string& text) : Error(ExitCode::kWrongUsage, text) {}
};

/// An input that is missing, empty, of another format, or broken.
class InputError : public Error {
 public:
  explicit InputError(const std::string& text) : Error(ExitCode::kInputUnreadable, text) {}
};

/// The input was read, but no frame could be measured.
class NothingMeasuredError : public Error {
 public:
  explicit NothingMeasuredError(const std::string& text) : Error(ExitCode::kNothingMeasured, text) {}
};

/// An output that can't be written (disk full, no permission). Everything written before remains valid.
class OutputError : public Error {
 public:
  explicit OutputError(const std::string& text) : Error(ExitCode::kOutputUnwritable, text) {}
};

/// A camera, manipulator, haptic device or display that is missing.
class DeviceError : public Error {
 public:
  explicit DeviceError(const std::string& text) : Error(ExitCode::kDeviceMissing, text) {}
};

/// Of several recordings some weren't measured to their end; the others are whole.
class SomeFailedError : public Error {
 public:
  explicit SomeFailedError(const std::string& text) : Error(ExitCode::kSomeFailed, text) {}
};

}  // namespace pellucida
