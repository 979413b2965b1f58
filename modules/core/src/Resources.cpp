#include "pellucida/core/Resources.h"

#include <algorithm>
#include <cstdlib>

#include "pellucida/core/Error.h"

namespace pellucida {

namespace fs = std::filesystem;

fs::path resource_folder() {
  std::vector<fs::path> candidates;
  if (const char* named = std::getenv("PELLUCIDA_RESOURCES")) candidates.emplace_back(named);
  std::error_code code;
  const fs::path program = fs::read_symlink("/proc/self/exe", code);
  if (!code) candidates.push_back(program.parent_path().parent_path() / "share" / "pellucida");
  candidates.emplace_back(PELLUCIDA_SOURCE_RESOURCES);
  for (const auto& candidate : candidates) {
    if (fs::is_directory(candidate, code)) return candidate;
  }
  throw InputError("the program's resources were not found; set PELLUCIDA_RESOURCES to the folder `resources`");
}

std::vector<std::string> list_resources(std::string_view folder, std::string_view extension) {
  std::vector<std::string> names;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(resource_folder() / folder, code)) {
    if (entry.path().extension() == extension) names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find_resource(std::string_view folder, std::string_view name, std::string_view extension) {
  std::error_code code;
  const fs::path shipped = resource_folder() / folder / (std::string(name) + std::string(extension));
  if (fs::is_regular_file(shipped, code)) return shipped;
  if (fs::is_regular_file(fs::path(name), code)) return fs::path(name);

  std::string known;
  for (const auto& one : list_resources(folder, extension)) known += (known.empty() ? "" : ", ") + one;
  throw InputError(std::string(name) + ": neither a file nor one of the known " + std::string(folder) + " (" + known +
                   ")");
}

}  // namespace pellucida
