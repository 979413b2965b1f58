#pragma once
#include <string_view>

namespace pellucida {

/// How a force-indentation curve ended.
enum class CurveOutcome {
  kComplete,
  kCancelled,     ///< on request: the steps up to there are valid
  kNotConverged,  ///< no equilibrium was found at the next depth: the steps up to there are valid
};
std::string_view to_string(CurveOutcome outcome) noexcept;

}  // namespace pellucida
