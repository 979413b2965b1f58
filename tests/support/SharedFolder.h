#pragma once
#include <filesystem>

namespace pellucida::test {

/// A folder beside the checkout with real recordings and further references; tests that read it are skipped without it.
inline std::filesystem::path shared_folder() {
  return std::filesystem::path(PELLUCIDA_SOURCE_DIR) / ".." / "shared";
}

}  // namespace pellucida::test
