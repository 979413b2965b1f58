#pragma once
#include <optional>
#include <string>

namespace pellucida {

/// The window that a person chose on the start page.
enum class StartMode { kGuide, kReview, kTeach };
/// As `--mode` takes it.
constexpr const char* name_of(StartMode mode) noexcept {
  return mode == StartMode::kTeach ? "teach" : mode == StartMode::kReview ? "review" : "guide";
}

/// What a person chose on the start page. Every member is as the command line takes it.
struct StartChoice {
  StartMode mode = StartMode::kGuide;

  // Guide mode.
  std::string source;                   ///< as `--source` takes it: virtual:SCENARIO, a file, a folder, v4l2:N
  std::string profile;                  ///< name of a shipped profile; empty: the program's default
  std::optional<double> pixel_size_um;  ///< 0.001..100; nothing: the file's own
  std::optional<double> frame_rate_hz;  ///< 0.001..100000; nothing: the file's own
  std::string hand;                     ///< of a virtual source: demonstration, mouse or none; else empty

  // Review mode.
  std::string session;  ///< folder of the session to open

  // Teach mode.
  std::string lesson;  ///< name of a shipped lesson
  bool large_letters = false;
};

}  // namespace pellucida
