#pragma once
#include <filesystem>
#include <span>

#include "pellucida/evaluation/Trial.h"

namespace pellucida {

/// Six charts of simulated trials by modality: every trial as a point, the mean with its 95 % interval; the share of
/// successes with Wilson's. Errors as render_charts.
void draw_trials(std::span<const TrialOutcome> outcomes, const std::filesystem::path& png);

}  // namespace pellucida
