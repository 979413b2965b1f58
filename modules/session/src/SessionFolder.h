#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// Names inside a session folder.
namespace session_name {
inline constexpr const char* kJson = "session.json";
inline constexpr const char* kPvd = "session.pvd";
inline constexpr const char* kMeasurements = "measurements.csv";
inline constexpr const char* kEvents = "events.csv";
inline constexpr const char* kHaptics = "haptics";
inline constexpr const char* kChecksums = "checksums.csv";
inline constexpr const char* kDamaged = "damaged";
inline constexpr const char* kDamagedLines = "lines.txt";  ///< in `damaged/`
/// An empty data file: listed in `session.pvd` for parts a step lacks, so that all steps have the same blocks.
inline constexpr const char* kEmpty = "empty.vtp";
inline constexpr const char* kEventsHeader = "time_s,kind,detail";
inline constexpr const char* kChecksumsHeader = "file,bytes,crc32";
}  // namespace session_name

/// How the files of one part are named.
struct PartNames {
  SessionPart part;
  const char* folder;     ///< below the session
  const char* stem;       ///< of its files: `stem_00000012.vtp`
  const char* extension;  ///< with its dot
};

/// In the order of SessionPart.
inline constexpr std::array<PartNames, kSessionPartCount> kParts{
    {{SessionPart::kSurface, "surface", "surface", ".vtp"},
     {SessionPart::kMembranes, "membranes", "membranes", ".vtp"},
     {SessionPart::kTools, "tools", "tools", ".vtp"},
     {SessionPart::kFrame, "frames", "frame", ".vti"}}};

inline const PartNames& names_of(SessionPart part) {
  return kParts[static_cast<std::size_t>(part)];
}

/// `surface/surface_00000012.vtp`: relative to the session, digits enough for ten years of video.
std::string part_file(SessionPart part, long frame_index);

/// The frame index in a file's name (without folder); nothing when it isn't a name of this part.
std::optional<long> frame_index_of(SessionPart part, std::string_view file_name);

/// `haptics/haptics_00000003.vtp`, and the block's number back from the file's name (without folder).
std::string hand_file(long block);
std::optional<long> hand_block_of(std::string_view file_name);

/// A data file by its kind and number.
struct DataName {
  int kind = 0;  ///< a SessionPart, or kHandKind
  long number = 0;

  auto operator<=>(const DataName&) const = default;
};
inline constexpr int kHandKind = static_cast<int>(kSessionPartCount);
inline DataName data_name(SessionPart part, long frame_index) {
  return {static_cast<int>(part), frame_index};
}
/// Relative to the session, and back; nothing for a name that is not exactly one of a session's data files.
std::string data_file(const DataName& name);
std::optional<DataName> data_name_of(std::string_view relative_file);

/// The files of a session beside its data files.
inline constexpr std::array<const char*, 6> kOwnFiles{session_name::kJson,         session_name::kPvd,
                                                      session_name::kMeasurements, session_name::kEvents,
                                                      session_name::kChecksums,    session_name::kEmpty};
/// Whether `relative_file` is what a session's own file is called while it is being written.
bool is_own_temporary(std::string_view relative_file);

/// The text of `session.pvd` before its entries, the entries of one step, and the text behind them. With `frames`, the
/// images are listed too. Every step lists the same parts: `empty.vtp` takes the place of a missing one.
extern const char* const kPvdStart;
extern const char* const kPvdEnd;
void append_pvd(const SessionStep& step, bool frames, std::string& text);
/// All of it.
std::string make_pvd(const std::vector<SessionStep>& steps, bool frames);

}  // namespace pellucida
