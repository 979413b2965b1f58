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
inline constexpr const char* kDamaged = "damaged";
/// An empty data file: listed in `session.pvd` for parts a step lacks, so that all steps have the same blocks.
inline constexpr const char* kEmpty = "empty.vtp";
inline constexpr const char* kEventsHeader = "time_s,kind,detail";
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

/// The text of `session.pvd`. With `frames`, the images are listed too. Every step lists the same parts: `empty.vtp`
/// stands for a missing one.
std::string make_pvd(const std::vector<SessionStep>& steps, bool frames);

}  // namespace pellucida
