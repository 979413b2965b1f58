#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "pellucida/core/Error.h"

namespace pellucida {

/// The error for `path` that couldn't be written: the system's reason (an errno), and what helps against it.
OutputError disk_error(const std::filesystem::path& path, int reason);

/// What a file under construction is called until it is whole: its name with this behind it.
inline constexpr const char* kTemporarySuffix = ".tmp";

/// Writes `content` beside `file` and renames it into place: under its name a file is whole or not there at all.
/// Throws OutputError with the system's reason; the temporary file is then removed and an older `file` left as it was.
void replace_file(const std::filesystem::path& file, std::string_view content);

/// The whole content of a file. Throws InputError with the system's reason.
std::string read_whole_file(const std::filesystem::path& file);

/// Makes a folder with its parents. Throws OutputError with the system's reason.
void make_folder(const std::filesystem::path& folder);

/// A table that grows at its end, a line at a time, each handed to the system at once.
class AppendFile {
 public:
  /// Creates `file` with one line. Throws OutputError when it is there already or can't be made.
  AppendFile(const std::filesystem::path& file, std::string_view header);
  ~AppendFile();
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;

  /// Adds `line` and a line end. Throws OutputError; what got onto the disk of this line is then taken back.
  void append(std::string_view line);
  std::uint64_t byte_count() const noexcept { return byte_count_; }

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t byte_count_ = 0;
};

}  // namespace pellucida
