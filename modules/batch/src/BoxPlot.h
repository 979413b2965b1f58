#pragma once
#include <span>
#include <string>
#include <vector>

namespace pellucida {

/// One box: a group's name and its values.
struct BoxSample {
  std::string name;
  std::vector<double> values;  ///< any order, no NaN
};

/// Box plots side by side as inline SVG: quartiles and median, whiskers to the farthest value within 1.5 times the box
/// (Tukey), every value as a dot. Empty where there is nothing to compare: no value, or the same one everywhere.
std::string box_plot_svg(const std::string& title, std::span<const BoxSample> samples);

}  // namespace pellucida
