#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "pellucida/core/Event.h"

namespace pellucida {

/// How a note begins that names the cell in view: "cell name: A-1". Of several for one cell the last counts.
inline constexpr std::string_view kCellNameNote = "cell name: ";

/// The name that an event gives; nothing for another event.
inline std::optional<std::string> named_cell(const Event& event) {
  if (event.kind != event_kind::kNote || !event.detail.starts_with(kCellNameNote)) return std::nullopt;
  return event.detail.substr(kCellNameNote.size());
}

}  // namespace pellucida
