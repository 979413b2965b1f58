#pragma once
#include <string>

#include "pellucida/report/CellPassport.h"

namespace pellucida {

/// The drawings of a cell: force over time with its interval, force over indentation of the main contact (insertion
/// and removal), area strain and mean tension over time. Empty for a cell that was not touched.
std::string cell_charts(const PassportInput& input, const CellPassport& cell);

/// Force over indentation of all cells' main contacts in one drawing; empty for fewer than two.
std::string comparison_chart(const PassportInput& input, std::span<const CellPassport> cells);

}  // namespace pellucida
