#pragma once
#include <array>
#include <optional>
#include <string_view>

#include "pellucida/core/Words.h"
#include "pellucida/simulation/OperatorOptions.h"

namespace pellucida {

/// The modalities of section IV of the paper, from the poorest to the richest.
inline constexpr std::array kModalities{Modality::kFlatImage, Modality::kSpace, Modality::kSpaceAndHaptics,
                                        Modality::kSpaceAndFixture};

/// "2-D image", "3-D view", "3-D + haptics", "3-D + haptics + guide": in tables, events and the window.
constexpr const char* name_of(Modality modality) noexcept {
  switch (modality) {
    case Modality::kFlatImage:
      return PELLUCIDA_WORDS("2-D image");
    case Modality::kSpace:
      return PELLUCIDA_WORDS("3-D view");
    case Modality::kSpaceAndHaptics:
      return PELLUCIDA_WORDS("3-D + haptics");
    case Modality::kSpaceAndFixture:
      return PELLUCIDA_WORDS("3-D + haptics + guide");
  }
  return "";
}

/// On the command line: "2d", "3d", "haptics", "guide".
constexpr const char* option_of(Modality modality) noexcept {
  constexpr std::array kOptions{"2d", "3d", "haptics", "guide"};
  return kOptions[static_cast<std::size_t>(modality)];
}

/// The inverse of `option_of`; nothing for another text.
constexpr std::optional<Modality> modality_of(std::string_view option) noexcept {
  for (const Modality modality : kModalities) {
    if (option == option_of(modality)) return modality;
  }
  return std::nullopt;
}

}  // namespace pellucida
