#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "pellucida/core/OutputFile.h"

namespace pellucida {

/// A file of a session is no larger: an hour of rows is 40 MB.
inline constexpr std::uint64_t kMostFileBytes = std::uint64_t{1} << 31U;

/// The content of a file that may come from a stranger: a regular file, no link, of at most `most_bytes`. Throws
/// InputError with the reason, and without reading anything of what it refuses.
std::string read_whole_file(const std::filesystem::path& file, std::uint64_t most_bytes = kMostFileBytes);

/// Whether anything has this name, be it a link that leads nowhere.
bool is_present(const std::filesystem::path& file);
/// Whether this is a file itself: no link, folder, pipe or device.
bool is_plain_file(const std::filesystem::path& file);

/// Calls `use` for each entry of a folder with its name and whether it is a file itself (no link, folder, pipe or
/// device); in no order. A folder that can't be read has none.
void for_each_entry(const std::filesystem::path& folder, const std::function<void(const char*, bool)>& use);

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
  /// Takes back the end of the table, from `byte_count` on, as well as the system allows.
  void shrink_to(std::uint64_t byte_count) noexcept;
  /// Holds the session's lock until the file is closed or `unlock` (SessionLock.h).
  void lock() noexcept;
  void unlock() noexcept;
  std::uint64_t byte_count() const noexcept { return byte_count_; }

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t byte_count_ = 0;
};

}  // namespace pellucida
