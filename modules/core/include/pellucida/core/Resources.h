#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pellucida {

/// The folder with what the running program reads (profiles, scenarios, reference, devices): the one that the
/// environment variable PELLUCIDA_RESOURCES names if it is set, else `../share/pellucida` beside the executable's own
/// folder. In a build tree that is a link to the source tree's `resources`. Throws InputError when the folder isn't
/// there: where it was looked for, and how to mend it.
std::filesystem::path resource_folder();

/// The same rule for any value of the variable (nullptr or empty: not set) and any executable (absolute path; empty: unknown).
std::filesystem::path resource_folder(const char* named, const std::filesystem::path& program);

/// The file `folder/name.extension` of the resources, or `name` itself when it names an existing file.
/// Throws InputError that lists the names known in that folder.
std::filesystem::path find_resource(std::string_view folder, std::string_view name, std::string_view extension);

/// Names (without extension) of the resources in a folder, sorted.
std::vector<std::string> list_resources(std::string_view folder, std::string_view extension);

}  // namespace pellucida
