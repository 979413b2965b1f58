#pragma once
#include <string>

#include "pellucida/core/ImageView.h"
#include "pellucida/core/Observation.h"

namespace pellucida::test {

/// What is wrong with an observation whatever the image showed: a number that is not finite or out of its range, arrays
/// that do not belong together, a contour that crosses itself or lies far outside the picture. "" when nothing is.
std::string violation_of(const Observation& seen, const ImageView& image);

}  // namespace pellucida::test
