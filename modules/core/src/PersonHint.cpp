#include "pellucida/core/PersonHint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

#include "pellucida/core/Error.h"
#include "pellucida/core/Words.h"

namespace pellucida {
namespace {

using Kind = PersonHint::Kind;

// As they are printed; what is read ends at the first number.
constexpr std::array kHintFormats{std::pair{Kind::kCell, PELLUCIDA_WORDS("cell at %.3f %.3f um")},
                                  std::pair{Kind::kNeedleTip, PELLUCIDA_WORDS("needle tip at %.3f %.3f um")},
                                  std::pair{Kind::kNoCell, PELLUCIDA_WORDS("no cell at %.3f %.3f um")},
                                  std::pair{Kind::kHolder, PELLUCIDA_WORDS("holding pipette at %.3f %.3f um")}};
constexpr const char* kOutlineFormat = PELLUCIDA_WORDS("cell outlined by %u places");
constexpr const char* kCornersEnd = " um";
constexpr const char* kTakenBack = PELLUCIDA_WORDS("taken back");
constexpr double kDigit_um = 1e-3;
constexpr std::size_t kLeastOutlinePlaces = 3;

using Place_um = PersonHint::Place_um;

double rounded(double place_um) {
  return kDigit_um * std::round(place_um / kDigit_um);
}

template <class... Numbers>
std::string printed(const char* format, Numbers... numbers) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), format, numbers...);
  return text.data();
}

void put_in_the_middle(PersonHint& hint) {
  hint.x_um = hint.y_um = 0.0;
  for (const Place_um& place : hint.outline_um) {
    hint.x_um += place[0] / static_cast<double>(hint.outline_um.size());
    hint.y_um += place[1] / static_cast<double>(hint.outline_um.size());
  }
}

// Where the corners of an outline begin in an event's detail, and how many it says they are; 0: it is no outline.
std::size_t corners_of(const std::string& detail, unsigned& count) {
  int end = 0;
  const std::string format = std::string(kOutlineFormat) + ":%n";
  return std::sscanf(detail.c_str(), format.c_str(), &count, &end) == 1 ? static_cast<std::size_t>(end) : 0;
}

// "101.250 88.300 ... um" behind the words of an outline; nothing where it is not as many as it says, or too few.
std::optional<PersonHint> read_outline(const std::string& detail) {
  unsigned count = 0;
  const std::size_t end = corners_of(detail, count);
  if (end == 0) return std::nullopt;
  if (count < kLeastOutlinePlaces || count > kMostOutlinePlaces) return std::nullopt;
  PersonHint hint{.kind = Kind::kCellOutline};
  const char* numbers = detail.c_str() + end;
  for (unsigned k = 0; k < count; ++k) {
    Place_um place{};
    int used = 0;
    if (std::sscanf(numbers, "%lf %lf%n", &place[0], &place[1], &used) != 2) return std::nullopt;
    if (!std::isfinite(place[0]) || !std::isfinite(place[1])) return std::nullopt;
    hint.outline_um.push_back(place);
    numbers += used;
  }
  put_in_the_middle(hint);
  return hint;
}

}  // namespace

std::optional<PersonHint> outline_hint(std::span<const Place_um> drawn_um) {
  const auto is_finite = [](const Place_um& place) { return std::isfinite(place[0]) && std::isfinite(place[1]); };
  if (drawn_um.size() < kLeastOutlinePlaces || !std::all_of(drawn_um.begin(), drawn_um.end(), is_finite)) return {};
  PersonHint hint{.kind = Kind::kCellOutline};
  const std::size_t count = std::min(drawn_um.size(), kMostOutlinePlaces);
  for (std::size_t k = 0; k < count; ++k) hint.outline_um.push_back(drawn_um[k * drawn_um.size() / count]);
  return as_stored(hint);
}

std::string describe(const PersonHint& hint) {
  for (const auto& [kind, format] : kHintFormats) {
    if (kind == hint.kind) return printed(format, hint.x_um, hint.y_um);
  }
  if (hint.kind != Kind::kCellOutline) return kTakenBack;
  std::string text = printed(kOutlineFormat, static_cast<unsigned>(hint.outline_um.size())) + ':';
  for (const Place_um& place : hint.outline_um) text += printed(" %.3f %.3f", place[0], place[1]);
  return text + kCornersEnd;
}

std::string without_corners(const std::string& detail) {
  unsigned count = 0;
  const std::size_t from = corners_of(detail, count);
  const std::size_t to = from > 0 ? detail.find(kCornersEnd, from) : std::string::npos;
  if (to == std::string::npos) return detail;
  return detail.substr(0, from - 1) + detail.substr(to + std::strlen(kCornersEnd));
}

std::optional<PersonHint> hint_of(const Event& event) {
  if (event.kind != event_kind::kHint) return std::nullopt;
  PersonHint hint;
  hint.since_s = event.time_s;
  if (event.detail.starts_with(kTakenBack)) {
    hint.kind = Kind::kTakeBack;
    return hint;
  }
  if (std::optional<PersonHint> outline = read_outline(event.detail)) {
    outline->since_s = event.time_s;
    return outline;
  }
  for (const auto& [kind, format] : kHintFormats) {
    const std::string_view words(format, std::strcspn(format, "%"));
    if (!event.detail.starts_with(words)) continue;
    hint.kind = kind;
    const char* numbers = event.detail.c_str() + words.size();
    if (std::sscanf(numbers, "%lf %lf um", &hint.x_um, &hint.y_um) != 2) return std::nullopt;
    if (!std::isfinite(hint.x_um) || !std::isfinite(hint.y_um)) return std::nullopt;
    return hint;
  }
  return std::nullopt;
}

std::span<const HintOption> hint_options() noexcept {
  static constexpr std::array kOptions{
      HintOption{"--cell-at", Kind::kCell,
                 "X,Y in um: a point inside the cell, in the first frame; X,Y@S: in the first from S seconds on"},
      HintOption{"--needle-tip", Kind::kNeedleTip, "X,Y or X,Y@S: the needle's tip, likewise"},
      HintOption{"--no-cell-at", Kind::kNoCell, "X,Y or X,Y@S: what is there is no cell, from then on"},
      HintOption{"--holder-at", Kind::kHolder, "X,Y or X,Y@S: a point on the holding pipette, near the cell"},
      HintOption{"--cell-outline", Kind::kCellOutline,
                 "X,Y/X,Y/X,Y and so on, or with @S behind: the cell's outline, 3 to 32 corners"}};
  return kOptions;
}

PersonHint parse_hint(const HintOption& option, const std::string& text) {
  const bool is_outline = option.kind == Kind::kCellOutline;
  const auto refuse = [&] {
    throw UsageError(std::string(option.name) + ' ' + text +
                     (is_outline ? ": give 3 to 32 corners in um, such as 80,60/140,60/110,120, or with @S behind"
                                 : ": give X,Y in um, such as 120.5,88, or X,Y@S"));
  };
  PersonHint hint{.kind = option.kind};
  const char* left = text.c_str();
  // Reads numbers, and goes on behind them.
  const auto take = [&](const char* format, auto*... numbers) {
    int used = 0;
    if (std::sscanf(left, format, numbers..., &used) != sizeof...(numbers) || used == 0) refuse();
    if (!(std::isfinite(*numbers) && ...)) refuse();
    left += used;
  };
  take("%lf,%lf%n", &hint.x_um, &hint.y_um);
  if (is_outline) {
    hint.outline_um.push_back({hint.x_um, hint.y_um});
    while (*left == '/') {
      Place_um& place = hint.outline_um.emplace_back();
      take("/%lf,%lf%n", place.data(), place.data() + 1);
    }
    const std::size_t count = hint.outline_um.size();
    if (count < kLeastOutlinePlaces || count > kMostOutlinePlaces) refuse();
  }
  if (*left == '@') take("@%lf%n", &hint.since_s);
  if (*left != 0) refuse();
  return as_stored(hint);
}

void add_hints(std::vector<PersonHint>& hints, const HintOption& option, std::span<const std::string> texts) {
  for (const std::string& text : texts) add_in_time(hints, parse_hint(option, text));
}

void add_in_time(std::vector<PersonHint>& hints, const PersonHint& hint) {
  const auto later = std::upper_bound(hints.begin(), hints.end(), hint.since_s,
                                      [](double time_s, const PersonHint& other) { return time_s < other.since_s; });
  hints.insert(later, hint);
}

PersonHint as_stored(PersonHint hint) {
  if (hint.kind == Kind::kTakeBack) hint.x_um = hint.y_um = 0.0;
  hint.x_um = rounded(hint.x_um);
  hint.y_um = rounded(hint.y_um);
  for (Place_um& place : hint.outline_um) place = {rounded(place[0]), rounded(place[1])};
  return hint_of({hint.since_s, event_kind::kHint, describe(hint)}).value_or(hint);
}

}  // namespace pellucida
