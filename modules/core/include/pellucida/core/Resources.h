#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pellucida {

/// The folder `resources` of the running program: the environment variable PELLUCIDA_RESOURCES if set, else
/// `../share/pellucida` beside the executable, else the source tree the program was built from.
/// Throws InputError when none of them is there.
std::filesystem::path resource_folder();

/// The file `folder/name.extension` of the resources, or `name` itself when it names an existing file.
/// Throws InputError that lists the names known in that folder.
std::filesystem::path find_resource(std::string_view folder, std::string_view name, std::string_view extension);

/// Names (without extension) of the resources in a folder, sorted.
std::vector<std::string> list_resources(std::string_view folder, std::string_view extension);

}  // namespace pellucida
