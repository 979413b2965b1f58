#pragma once
#include <filesystem>
#include <vector>

namespace pellucida {

/// Before any work is done: throws UsageError for the first of `files` that is there. Empty names and devices
/// (`/dev/stdout`) are left out.
void require_new(const std::vector<std::filesystem::path>& files);

}  // namespace pellucida
