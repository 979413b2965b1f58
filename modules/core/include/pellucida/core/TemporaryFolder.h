#pragma once
#include <filesystem>
#include <string>

namespace pellucida {

/// An empty folder in the system's temporary place (TMPDIR) that goes away, with all in it, with its owner.
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
