#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "pellucida/core/Error.h"

namespace pellucida {

/// The error for `path` that couldn't be written: the system's reason (an errno), and what helps against it.
OutputError disk_error(const std::filesystem::path& path, int reason);

/// What a file under construction is called until it is whole: its name with this behind it, or with a number before
/// it (`name.1.tmp`) where that name is taken.
inline constexpr const char* kTemporarySuffix = ".tmp";

/// Makes a folder with its parents. Throws OutputError with the system's reason.
void make_folder(const std::filesystem::path& folder);

/// A file written in one go: under its name it is whole or not there, and an older file of that name stays until then.
/// What is under construction has a name of its own, takes no other file's place and follows no link.
class OutputFile {
 public:
  /// What a link under the file's name means.
  enum class Link {
    kFollow,   ///< the file that it leads to is replaced; a device or a pipe (`/dev/stdout`) is written directly
    kReplace,  ///< the link itself is replaced: for folders whose content may come from strangers
  };
  /// Throws OutputError when it can't be made.
  explicit OutputFile(const std::filesystem::path& file, Link link = Link::kFollow);
  /// Without a `finish` before it, nothing is left behind.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Adds `text`. Throws OutputError with the system's reason.
  void write(std::string_view text);
  /// Adds `line` and a line end.
  void add(std::string_view line);
  /// Puts the file under its name. Throws OutputError when any of it couldn't be written. `flushed`: only once it is on
  /// the disk, so that a power cut leaves the older one or this one.
  void finish(bool flushed = true);

  /// Where the content is until `finish`: for a library that writes to a name. It must not remove the file.
  const std::filesystem::path& temporary() const noexcept { return temporary_; }

 private:
  void flush_buffer();

  std::filesystem::path file_;       ///< as named in errors
  std::filesystem::path target_;     ///< what is replaced
  std::filesystem::path temporary_;  ///< empty where written directly
  int descriptor_ = -1;
  std::string buffer_;
};

/// Writes `content` as an OutputFile that replaces a link, left to the system to flush.
void replace_file(const std::filesystem::path& file, std::string_view content);

/// Throws UsageError, naming `option`, when `output` is the same file as `input`, by whatever names. An empty name or
/// one of no file is never the same.
void require_apart(const std::filesystem::path& output, const std::filesystem::path& input, const std::string& option);

}  // namespace pellucida
