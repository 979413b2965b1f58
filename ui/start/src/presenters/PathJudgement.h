#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace pellucida {

/// What a path chosen or dropped turned out to be.
enum class PathKind { kSession, kRecording, kNeither };

/// A path as the start page takes it.
struct PathJudgement {
  PathKind kind = PathKind::kNeither;
  std::filesystem::path path;  ///< the session's folder, or what is to be opened as a recording
  std::string caption;  ///< of a recording: "728 × 486 px · 0.825 µm/px · 30 frames/s", as far as it is known
  std::optional<double> pixel_size_um;  ///< of a recording, where its files state it
  std::optional<double> frame_rate_hz;  ///< likewise
  std::string problem;                  ///< of neither: why, and what to do
};

/// Opens `path` to see what it is: the folder of a session or one of its files, a video, a folder of images, a stack,
/// an image; of a folder with one video, that video. May take a second: not for the window's thread. Never throws for
/// what the disk holds.
PathJudgement judge_path(const std::filesystem::path& path);

}  // namespace pellucida
