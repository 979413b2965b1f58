#pragma once
#include <filesystem>
#include <optional>

#include "pellucida/identification/Identification.h"
#include "pellucida/identification/RelaxationFit.h"

namespace pellucida {

/// A ramp-and-hold record and two fits of it. None may be null.
struct RelaxationPicture {
  const RelaxationRecord* record = nullptr;
  const RelaxationFit* two = nullptr;  ///< with two arms
  const RelaxationFit* one = nullptr;  ///< with one
};

/// The picture of an identification, like the paper's figures 5(d) and 6: finite elements and model in the four
/// configurations; their difference; configuration 1, model and finite elements, with the measured points and what an
/// error of 3 % or 10 % in the modulus, and in the depth, makes of it; and the relaxation, where one was fitted. Errors
/// as render_charts.
void draw_identification(const Identification& identification, const MeasuredCurve& measured,
                         const std::optional<RelaxationPicture>& relaxation, const std::filesystem::path& png);

}  // namespace pellucida
