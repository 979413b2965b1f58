#include "commands/FieldOption.h"

#include <CLI/CLI.hpp>
#include <cmath>

#include "pellucida/core/FieldTable.h"

namespace pellucida {

CLI::Validator number_in(const FieldRange& range) {
  const auto fault = [range](const std::string& text) -> std::string {
    double number = 0.0;
    if (CLI::detail::lexical_cast(text, number) && std::isfinite(number) && range.holds(number)) return "";
    return text + "; allowed: " + to_string(range);
  };
  return CLI::Validator(fault, to_string(range));
}

CLI::Option* add_field_option(CLI::App& command, const std::string& option, const FieldPlace& field,
                              std::optional<double>& value, const std::string& default_words) {
  const std::string unit = field.unit.empty() ? "" : ", " + std::string(field.unit);
  return command
      .add_option(option, value,
                  std::string(field.doc) + unit +
                      " (default: " + (default_words.empty() ? field.value_text() : default_words) + ")")
      ->check(number_in(field.range));
}

}  // namespace pellucida
