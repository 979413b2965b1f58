#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pellucida {

/// By which a change of an input is recognised.
struct InputStamp {
  std::string path;              ///< absolute
  std::uint64_t byte_count = 0;  ///< of a folder: of all its files
  std::int64_t modified_ns = 0;  ///< last change, since the file system's epoch; of a folder: the latest of its files
  std::string sha256;            ///< of a file's content, where it was read to its end; empty: not known
};

/// As the input is now, without reading it: `sha256` stays empty. All zero where there is no such file.
InputStamp stamp_of(const std::string& input);

/// Whether both are the same content. Path, size and time decide where they agree; otherwise a file's content does,
/// which is then read.
bool same_content(const InputStamp& then, const InputStamp& now);

/// What a result is made from, beside its input.
struct Recipe {
  std::vector<std::string> options;  ///< as on the command line, without inputs, output and those of the batch
  std::string profile_sha256;        ///< of the cell profile's content; empty: the recording's own
  std::string version;               ///< of the program

  bool operator==(const Recipe&) const = default;
};

/// How one recording ended: the file `records/NAME.json`.
struct RecordingRecord {
  InputStamp input;
  Recipe recipe;
  int exit_code = 0;           ///< of the program; 128 + the signal's number where one ended it
  std::string error;           ///< one line; empty for none
  double wall_time_s = 0.0;    ///< that it took
  std::string session_sha256;  ///< of the session's `session.json`; empty where there is no closed session
};

/// Reads and writes a record. Reading gives nothing where there is none, or none of this kind. Throws OutputError.
std::optional<RecordingRecord> read_record(const std::filesystem::path& file);
void write_record(const std::filesystem::path& file, const RecordingRecord& record);

/// Whether `session` is the closed session that the record is about.
bool holds_result(const std::filesystem::path& session, const RecordingRecord& record);

}  // namespace pellucida
