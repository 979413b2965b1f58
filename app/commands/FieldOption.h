#pragma once
#include <optional>
#include <string>

namespace CLI {
class App;
class Option;
class Validator;
}  // namespace CLI

namespace pellucida {

struct FieldPlace;
struct FieldRange;

/// Seeds are whole numbers from 0 on that a double holds exactly.
inline constexpr double kMostSeed = 9007199254740992.0;

/// A check of an option's number, which must be finite and in `range`.
CLI::Validator number_in(const FieldRange& range);

/// An option that sets a field: help text (meaning, unit, default) and range check are the field's; `default_words`
/// where the default isn't the field's value. `value` must live as long as the command. Only for a field that is a
/// number.
CLI::Option* add_field_option(CLI::App& command, const std::string& option, const FieldPlace& field,
                              std::optional<double>& value, const std::string& default_words = "");

}  // namespace pellucida
