#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "pellucida/core/FieldTable.h"

namespace pellucida {

enum class UnknownKeys { kRefused, kIgnored };

/// Sets the fields that `json` has; their keys' groups are objects in it. Returns what is wrong, beginning with the
/// key: a wrong type, a required key that is missing, an unknown one (the text lists those known). Ranges are not
/// checked.
std::optional<std::string> read_fields(const nlohmann::ordered_json& json, const FieldList& fields,
                                       UnknownKeys unknown = UnknownKeys::kRefused);

/// Adds the fields to the object `json`, in their order, groups as objects.
void write_fields(const FieldList& fields, nlohmann::ordered_json& json);

/// Sets keys of the object `json` as a person writes them behind its name: "cell.stiffness_ratio=2,seed=3"; what is no
/// JSON value is a text. Returns what is wrong with them.
std::optional<std::string> replace_keys(nlohmann::ordered_json& json, std::string_view settings);

/// The JSON object in a text; comments are allowed. Throws InputError where it holds none; `what` begins its text.
nlohmann::ordered_json parse_json_object(std::string_view text, const std::string& what);

/// The same in a file. Throws InputError also where the file can't be read.
nlohmann::ordered_json read_json_object(const std::filesystem::path& file);

}  // namespace pellucida
