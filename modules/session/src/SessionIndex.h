#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pellucida/core/Event.h"
#include "pellucida/core/Measurement.h"
#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// A line of a table that can't be used.
struct BadLine {
  std::size_t number = 0;  ///< counted from 1, the header included
  std::string text;
  std::string reason;
};

/// A table as it was found.
template <class Row>
struct SessionTable {
  bool present = false;
  bool header_right = false;
  std::vector<Row> rows;           ///< the lines that could be read
  std::vector<std::string> lines;  ///< their text, without line end
  std::vector<BadLine> bad;
};

SessionTable<Measurement> read_measurements(const std::filesystem::path& file);
/// In the order of time, whatever the order of the lines.
SessionTable<Event> read_events(const std::filesystem::path& file);
/// Puts the lines of a whole table of events into the order of time. Throws OutputError.
void sort_events(const std::filesystem::path& file);

/// How many frames lost their image in an event: 0 for all kinds but `dropped`; of that the number its detail begins
/// with, or 1.
std::uint64_t dropped_frame_count(const Event& event);

/// What the folders of a session hold, by name only.
struct SessionFiles {
  std::array<std::vector<long>, kSessionPartCount> frames;  ///< frame indices by SessionPart, ascending
  std::vector<long> hand_blocks;                            ///< of the recording of the hand, ascending
  std::vector<std::filesystem::path> temporary;             ///< files that were never finished
};
SessionFiles list_files(const std::filesystem::path& session);

/// One step a row, with the parts that are on the disk.
std::vector<SessionStep> make_steps(const std::vector<Measurement>& rows, const SessionFiles& files);

}  // namespace pellucida
