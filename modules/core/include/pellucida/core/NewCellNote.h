#pragma once
#include <string_view>

#include "pellucida/core/Event.h"

namespace pellucida {

/// How a note begins that says: from now on this is another cell. The window's "New cell" makes one; a person may, too.
inline constexpr std::string_view kNewCellNote = PELLUCIDA_WORDS("new cell");

inline bool begins_new_cell(const Event& event) noexcept {
  return event.kind == event_kind::kNote && event.detail.starts_with(kNewCellNote);
}

}  // namespace pellucida
