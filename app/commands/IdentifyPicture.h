#pragma once
#include <filesystem>

#include "pellucida/identification/Identification.h"

namespace pellucida {

/// The picture of an identification, like the paper's figures 5(d) and 6: finite elements and model in the four
/// configurations; their difference; configuration 1 with the measured points and what an error of 3 % or 10 % in the
/// modulus, and in the depth, makes of it. Errors as render_charts.
void draw_identification(const Identification& identification, const MeasuredCurve& measured,
                         const std::filesystem::path& png);

}  // namespace pellucida
