#include "presenters/PixelMeasure.h"

#include <algorithm>
#include <cmath>

#include "pellucida/visualization/Readout.h"
#include "presenters/NumberField.h"

namespace pellucida {
namespace {

constexpr double kShortest_px = 20.0;
constexpr double kEnd_px = 1.0;

PixelMeasure no_measure(std::string why) {
  return {0.0, 0.0, std::move(why), {}};
}

}  // namespace

double DrawnLine::length_px() const noexcept {
  return std::hypot(x1_px - x0_px, y1_px - y0_px);
}

PixelMeasure measure_pixel(const DrawnLine& line, std::string_view length) {
  constexpr NumberKind kLength{PELLUCIDA_WORDS("length"), "µm", {0.1, 100000.0}, "100"};
  const double length_px = line.length_px();
  if (length_px < kShortest_px) return no_measure(say("Draw a line of at least 20 px; the longer, the more exact."));
  const TypedNumber typed = read_number(length, kLength);
  if (!typed.value)
    return no_measure(typed.problem.empty() ? say("Type the length of the line in µm.") : typed.problem);
  PixelMeasure measure;
  measure.pixel_size_um = *typed.value / length_px;
  if (measure.pixel_size_um < kPixelSizeNumber.range.lower || measure.pixel_size_um > kPixelSizeNumber.range.upper) {
    return no_measure(say("That would be ") + readout::plain(measure.pixel_size_um) +
                      say(" µm per px, which no microscope has: check the length and its unit."));
  }
  measure.uncertainty_um = measure.pixel_size_um * std::sqrt(2.0) * kEnd_px / length_px;
  // One digit beyond the first of the uncertainty.
  const int digits = std::clamp(1 - static_cast<int>(std::floor(std::log10(measure.uncertainty_um))), 0, 9);
  measure.typed = readout::number(measure.pixel_size_um, digits);
  measure.text = measure.typed + " ± " + readout::number(measure.uncertainty_um, digits) + say(" µm per px");
  return measure;
}

}  // namespace pellucida
