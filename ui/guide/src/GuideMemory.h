#pragma once
#include <filesystem>

namespace pellucida {

/// What Guide keeps from one start to the next, in `Pellucida/guide.ini` in the user's settings. What is missing or
/// damaged there counts as not chosen; settings that can't be written stay as they are.
namespace guide_memory {
/// The folder of recordings; empty: none was chosen.
std::filesystem::path recordings();
void keep_recordings(const std::filesystem::path& folder);
/// Sounds at contact, puncture and alarms: off until they were chosen.
bool sounds();
void keep_sounds(bool on);
}  // namespace guide_memory

}  // namespace pellucida
