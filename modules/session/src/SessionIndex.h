#pragma once
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "Checksum.h"
#include "SessionFolder.h"
#include "pellucida/core/Event.h"
#include "pellucida/core/Measurement.h"
#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// A line of a table that can't be used.
struct BadLine {
  std::size_t number = 0;  ///< counted from 1, the header included
  std::string_view text;   ///< in the table's text
  std::string reason;
};

/// A table as it was found.
template <class Row>
struct SessionTable {
  bool present = false;
  bool header_right = false;
  bool checked = false;                     ///< its rows end with their checksums
  std::string header;                       ///< without the checksum's column; empty where it isn't right
  std::vector<Row> rows;                    ///< the lines that could be read
  std::vector<std::string_view> lines;      ///< their text, without checksum and line end
  std::vector<BadLine> bad;                 ///< the others, the first line too where it is neither header nor row
  std::shared_ptr<const std::string> text;  ///< what `lines` and `bad` look at

  /// Keeps the rows alone.
  void forget_text() {
    lines = {};
    bad = {};
    text.reset();
  }
};

/// What `checksums.csv` says of a data file.
struct FileChecksum {
  DataName name;
  std::uint64_t byte_count = 0;
  std::uint32_t crc32 = 0;
};

/// Each throws InputError for a table that can't be read as a whole: a link, a pipe, a file too large, or one that has
/// more unreadable lines than any session (another program's). `checked`: its rows must have their checksums whatever
/// the header says.
SessionTable<Measurement> read_measurements(const std::filesystem::path& file, bool checked = false);
/// In the order of time, whatever the order of the lines.
SessionTable<Event> read_events(const std::filesystem::path& file, bool checked = false);
/// In the order of the names.
SessionTable<FileChecksum> read_checksums(const std::filesystem::path& file);
/// What is known of a file; null where it has no row.
const FileChecksum* find_checksum(const SessionTable<FileChecksum>& table, const DataName& name);
/// A row of `checksums.csv`, without its own checksum.
std::string to_csv(const FileChecksum& file);

/// The header line a table should have: its own where it is right, else `header`; with the checksum's column where it
/// has one.
template <class Row>
std::string table_header(const SessionTable<Row>& table, std::string_view header) {
  return (table.header_right ? table.header : std::string(header)) +
         (table.checked ? std::string(",") + kRowChecksum : std::string());
}

/// The text of a table with its whole rows, checksums added where the table has them.
template <class Row>
std::string table_text(const SessionTable<Row>& table, std::string_view header) {
  std::string text = table_header(table, header) + '\n';
  for (const std::string_view line : table.lines) {
    text += table.checked ? signed_row(line) : std::string(line);
    text += '\n';
  }
  return text;
}

/// The size of that text.
template <class Row>
std::uint64_t table_bytes(const SessionTable<Row>& table, std::string_view header) {
  std::uint64_t count = table_header(table, header).size() + 1;
  for (const std::string_view line : table.lines) count += line.size() + 1 + (table.checked ? kRowChecksumBytes : 0);
  return count;
}

/// Whether the lines are in the order in which they were found.
template <class Row>
bool in_order(const SessionTable<Row>& table) {
  return std::is_sorted(table.lines.begin(), table.lines.end(),
                        [](std::string_view a, std::string_view b) { return a.data() < b.data(); });
}

/// Puts the lines of a whole table of events into the order of time. Throws OutputError.
void sort_events(const std::filesystem::path& file);

/// Adds the frames that an event says were written without their image (`dropped`) or surface (`thinned`): the number
/// that its detail begins with, or 1.
void count_left_out(const Event& event, SessionCounts& counts);

/// What the folders of a session hold, by name and kind only. Links are never followed.
struct SessionFiles {
  std::array<std::vector<long>, kSessionPartCount> frames;  ///< frame indices by SessionPart, ascending
  std::vector<long> hand_blocks;                            ///< of the recording of the hand, ascending
  std::vector<std::filesystem::path> temporary;             ///< own files that were never finished
  std::vector<std::string> strange;                         ///< data files that are links, folders, pipes or devices
  std::vector<std::string> links;                           ///< tables and folders that are

  bool has_data() const noexcept;
};
SessionFiles list_files(const std::filesystem::path& session);

/// One step a row, with the parts that are on the disk.
std::vector<SessionStep> make_steps(const std::vector<Measurement>& rows, const SessionFiles& files);

}  // namespace pellucida
