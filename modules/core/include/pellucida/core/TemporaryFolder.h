#pragma once
#include <filesystem>
#include <string>

namespace pellucida {

/// An empty folder in the system's temporary directory (TMPDIR), removed with its contents when its owner is destroyed.
class TemporaryFolder {
 public:
  /// Throws OutputError when no folder can be made there.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace pellucida
