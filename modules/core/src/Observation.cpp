#include "pellucida/core/Observation.h"

#include <array>
#include <utility>

#include "pellucida/core/Words.h"

namespace pellucida {
namespace {

constexpr std::array<std::pair<CellState, std::string_view>, 5> kStateNames{{
    {CellState::kNoCell, PELLUCIDA_WORDS("no_cell")},
    {CellState::kFree, PELLUCIDA_WORDS("free")},
    {CellState::kContact, PELLUCIDA_WORDS("contact")},
    {CellState::kPunctured, PELLUCIDA_WORDS("punctured")},
    {CellState::kLost, PELLUCIDA_WORDS("lost")},
}};

}  // namespace

std::string_view to_string(CellState state) noexcept {
  for (const auto& [value, name] : kStateNames) {
    if (value == state) return name;
  }
  return "unknown";
}

std::optional<CellState> cell_state_from_string(std::string_view name) noexcept {
  for (const auto& [value, text] : kStateNames) {
    if (text == name) return value;
  }
  return std::nullopt;
}

std::string to_string(NeedleEvidence evidence) {
  constexpr std::array<std::pair<NeedleEvidence, std::string_view>, 5> kNames{{{kShaftEdges, "shaft"},
                                                                               {kTipEnd, "tip"},
                                                                               {kKnownCone, "cone"},
                                                                               {kCommandedMotion, "commanded"},
                                                                               {kDimple, "dimple"}}};
  std::string text;
  for (const auto& [bit, name] : kNames) {
    if ((evidence & bit) == 0U) continue;
    if (!text.empty()) text += '+';
    text += name;
  }
  return text.empty() ? "none" : text;
}

}  // namespace pellucida
