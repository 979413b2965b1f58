#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pellucida {

/// The folder of the files the running program reads (profiles, scenarios, reference, devices): the value of the
/// environment variable PELLUCIDA_RESOURCES if it is set, otherwise `../share/pellucida` relative to the executable's
/// folder. In a build tree that is a link to the source tree's `resources`. Throws InputError when there is no such
/// folder: which one was expected, and how to correct it.
std::filesystem::path resource_folder();

/// The same rule for any value of the variable (nullptr or empty: not set) and any executable (absolute path; empty:
/// unknown).
std::filesystem::path resource_folder(const char* named, const std::filesystem::path& program);

/// The file `folder/name.extension` of the resources, or `name` itself when it names an existing file.
/// Otherwise throws an error that lists the names known in that folder: UsageError for a bare name, InputError for a
/// file (anything with a dot or a slash) that isn't there.
std::filesystem::path find_resource(std::string_view folder, std::string_view name, std::string_view extension);

/// Names (without extension) of the resources in a folder, sorted.
std::vector<std::string> list_resources(std::string_view folder, std::string_view extension);

}  // namespace pellucida
