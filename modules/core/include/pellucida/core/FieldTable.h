#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pellucida {

/// What a number may be: `low` to `high`, both included unless `low_excluded`. Never NaN.
struct FieldRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_excluded = false;

  bool holds(double value) const noexcept {
    return (low_excluded ? value > low : value >= low) && value <= high;  // false for NaN too
  }
};
constexpr FieldRange above(double low, double high = std::numeric_limits<double>::infinity()) noexcept {
  return {low, high, true};
}

enum class FieldNeed : std::uint8_t { kOptional, kRequired };

/// One member of the struct S, described once: reader, writer, range check, help text and the page in `docs` follow
/// from a table of these. The default of an optional field is what `S{}` holds.
template <class S>
struct Field {
  std::string_view name;
  std::string_view unit;  ///< "" for none
  std::variant<double S::*, int S::*, std::uint64_t S::*, bool S::*, std::string S::*> member;
  FieldRange range;
  std::string_view doc;  ///< one line
  FieldNeed need = FieldNeed::kOptional;
};

/// A field of one object. `key` is the name with its groups before it: "image.width_px".
struct FieldPlace {
  std::string key;
  std::string_view unit;
  FieldRange range;
  std::string_view doc;
  FieldNeed need;
  std::variant<double*, int*, std::uint64_t*, bool*, std::string*> value;

  std::string group() const;  ///< "image"; "" at the top
  std::string name() const;   ///< "width_px"
  /// The value as text: 9 significant digits, "true", or the string itself.
  std::string value_text() const;
};

/// The fields of one object, which must outlive the list, and of what is in it.
class FieldList {
 public:
  /// Adds the fields of `owner` below `group` ("" for the top, else "a" or "a.b").
  template <class S, std::size_t kCount>
  FieldList& add(const std::string& group, const Field<S> (&table)[kCount], S& owner) {
    for (const Field<S>& field : table) {
      places_.push_back({group.empty() ? std::string(field.name) : group + '.' + std::string(field.name),
                         field.unit,
                         field.range,
                         field.doc,
                         field.need,
                         {}});
      std::visit([&](auto member) { places_.back().value = &(owner.*member); }, field.member);
    }
    return *this;
  }

  /// The field of that key; null when there is none.
  const FieldPlace* find(std::string_view key) const noexcept;
  /// The names in a group, each once, comma separated: "image, cell, tools".
  std::string names_in(std::string_view group) const;

  auto begin() const noexcept { return places_.begin(); }
  auto end() const noexcept { return places_.end(); }

 private:
  std::vector<FieldPlace> places_;
};

/// "0.05 to 5", "above 0, up to 50", "0 or more", "any number".
std::string to_string(const FieldRange& range);

/// "KEY is VALUE; allowed: RANGE" when the value is outside the range.
std::optional<std::string> range_fault(std::string_view key, double value, const FieldRange& range);
/// The first number outside its range.
std::optional<std::string> range_fault(const FieldList& fields);

/// The fields as tables of Markdown, one a group: name, unit, allowed, default (the value now), meaning.
std::string markdown(const FieldList& fields);

}  // namespace pellucida
