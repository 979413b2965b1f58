#pragma once
#include <span>
#include <string>

#include "pellucida/batch/BatchRow.h"
#include "pellucida/batch/Groups.h"

namespace pellucida {

/// A batch as one page of HTML that needs nothing else: how many of what, what failed and why, the groups as box plots
/// and a table, and every recording with its numbers and a link to its session. `title`: in words.
std::string overview_page(const std::string& title, std::span<const BatchRow> rows, std::span<const GroupRow> groups);

}  // namespace pellucida
