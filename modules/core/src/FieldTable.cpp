#include "pellucida/core/FieldTable.h"

#include <cmath>
#include <set>
#include <type_traits>

#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

template <class T>
constexpr bool kIsNumber = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;

std::string number_text(double value) {
  if (std::isnan(value)) return "not a number";
  return std::isinf(value) ? (value > 0 ? "infinite" : "minus infinite") : csv_number(value);
}

bool is_number(const FieldPlace& field) {
  return std::visit([](auto* value) { return kIsNumber<std::remove_pointer_t<decltype(value)>>; }, field.value);
}

}  // namespace

std::string FieldPlace::group() const {
  const auto dot = key.rfind('.');
  return dot == std::string::npos ? "" : key.substr(0, dot);
}

std::string FieldPlace::name() const {
  return key.substr(key.rfind('.') + 1);  // npos + 1 is 0
}

std::string FieldPlace::value_text() const {
  return std::visit(
      [](auto* place) -> std::string {
        using T = std::remove_pointer_t<decltype(place)>;
        if constexpr (std::is_same_v<T, std::string>) return *place;
        if constexpr (std::is_same_v<T, bool>) return *place ? "true" : "false";
        if constexpr (std::is_same_v<T, double>) return number_text(*place);
        if constexpr (std::is_integral_v<T>) return std::to_string(*place);
      },
      value);
}

const FieldPlace* FieldList::find(std::string_view key) const noexcept {
  for (const FieldPlace& place : places_)
    if (place.key == key) return &place;
  return nullptr;
}

std::string FieldList::names_in(std::string_view group) const {
  const std::string prefix = group.empty() ? "" : std::string(group) + '.';
  std::string list;
  std::set<std::string> listed;
  for (const FieldPlace& place : places_) {
    if (!place.key.starts_with(prefix)) continue;
    const std::string name = place.key.substr(prefix.size(), place.key.find('.', prefix.size()) - prefix.size());
    if (listed.insert(name).second) list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}

std::string to_string(const FieldRange& range) {
  const bool below = std::isfinite(range.low), over = std::isfinite(range.high);
  if (!below && !over) return "any number";
  if (!below) return "up to " + csv_number(range.high);
  const std::string low = csv_number(range.low);
  if (!over) return range.low_excluded ? "above " + low : low + " or more";
  return range.low_excluded ? "above " + low + ", up to " + csv_number(range.high)
                            : low + " to " + csv_number(range.high);
}

std::optional<std::string> range_fault(std::string_view key, double value, const FieldRange& range) {
  if (range.holds(value)) return std::nullopt;
  return std::string(key) + " is " + number_text(value) + "; allowed: " + to_string(range);
}

std::optional<std::string> range_fault(const FieldList& fields) {
  for (const FieldPlace& field : fields) {
    const auto fault = std::visit(
        [&](auto* value) -> std::optional<std::string> {
          if constexpr (kIsNumber<std::remove_pointer_t<decltype(value)>>)
            return range_fault(field.key, static_cast<double>(*value), field.range);
          return std::nullopt;
        },
        field.value);
    if (fault) return fault;
  }
  return std::nullopt;
}

std::string markdown(const FieldList& fields) {
  std::string text, group = "*";
  for (const FieldPlace& field : fields) {
    if (field.group() != group) {
      group = field.group();
      if (!text.empty()) text += '\n';
      if (!group.empty()) text += "### " + group + "\n\n";
      text += "| key | unit | allowed | default | meaning |\n|---|---|---|---|---|\n";
    }
    const bool required = field.need == FieldNeed::kRequired;
    const std::string value = field.value_text();
    text += "| `" + field.name() + "` | " + std::string(field.unit) + " | " +
            (is_number(field) ? to_string(field.range)
                              : (std::holds_alternative<bool*>(field.value) ? "true or false" : "text")) +
            " | " +
            (required        ? "required"
             : value.empty() ? "empty"
                             : value) +
            " | " + std::string(field.doc) + " |\n";
  }
  return text;
}

}  // namespace pellucida
