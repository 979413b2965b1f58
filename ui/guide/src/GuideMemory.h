#pragma once
#include <filesystem>

namespace pellucida {

/// The folder of recordings that a person chose last, kept in `Pellucida/guide.ini` in the user's settings; empty: none
/// was chosen, or the settings are damaged.
std::filesystem::path remembered_recordings();
/// Settings that can't be written stay as they are.
void remember_recordings(const std::filesystem::path& folder);

}  // namespace pellucida
