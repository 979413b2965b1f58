#include "pellucida/core/Resources.h"

#include <algorithm>
#include <cstdlib>

#include "pellucida/core/Error.h"

namespace pellucida {

namespace fs = std::filesystem;

namespace {

constexpr const char* kVariable = "PELLUCIDA_RESOURCES";
constexpr const char* kContents = "cell profiles, scenarios, reference curves and devices";

}  // namespace

fs::path resource_folder(const char* named, const fs::path& program) {
  std::error_code code;
  if (named && *named) {
    if (fs::is_directory(named, code)) return named;
    throw InputError(std::string(kVariable) + " names " + named +
                     ", which is not a folder; set it to the folder of the " + kContents + ", or unset it");
  }
  if (program.empty()) {
    throw InputError(std::string("the program's own path cannot be read from /proc; set ") + kVariable +
                     " to the folder of the " + kContents);
  }
  const fs::path beside = program.parent_path().parent_path() / "share" / "pellucida";
  if (fs::is_directory(beside, code)) return beside;
  throw InputError("the program's " + std::string(kContents) + " are not at " + beside.string() +
                   "; install Pellucida again, or set " + kVariable + " to the folder that holds them");
}

fs::path resource_folder() {
  std::error_code code;
  return resource_folder(std::getenv(kVariable), fs::read_symlink("/proc/self/exe", code));
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
  const std::string text =
      std::string(name) + ": neither a file nor one of the known " + std::string(folder) + " (" + known + ")";
  if (name.find_first_of("./") == std::string_view::npos) throw UsageError(text);
  throw InputError(text);
}

}  // namespace pellucida
