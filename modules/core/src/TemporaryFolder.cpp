#include "pellucida/core/TemporaryFolder.h"

#include <cstdlib>
#include <system_error>

#include "pellucida/core/Error.h"

namespace pellucida {

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "pellucida-").string() + std::string(6, 'X');
  if (!mkdtemp(pattern.data())) {
    throw OutputError(pattern + ": no temporary folder can be made there; check TMPDIR and the space on the disk");
  }
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace pellucida
