#include "presenters/ComparisonPresenter.h"

#include <cmath>

#include "pellucida/core/Html.h"
#include "pellucida/core/Words.h"

namespace pellucida {
namespace {

// Closer than this a force is as good as one can ask for: the interval of a real one is wider.
constexpr double kClose_ratio = 0.05;

constexpr NumberScale kReadoutScales[kReadoutSliderCount] = {
    {PELLUCIDA_WORDS("Depth"), PELLUCIDA_WORDS("Of the needle"), 1.0, 44.0, false, 1.0 / 43.0, false,
     [](double depth_um) { return fixed_number(depth_um, 1) + " µm"; }},
    {PELLUCIDA_WORDS("Noise of the contour"), PELLUCIDA_WORDS("Of each of its points, along its normal"), 0.0, 1.0,
     false, 0.02, false, [](double noise_um) { return fixed_number(noise_um, 2) + " µm"; }},
    {PELLUCIDA_WORDS("Mesh"),
     PELLUCIDA_WORDS("Nodes of the network; the profile's constants hold for its own mesh of 812"), 2.0, 9.0, false,
     1.0 / 7.0, true, [](double f) { return fixed_number(10.0 * f * f + 2.0, 0) + say(" nodes"); }}};

double error_ratio(double force_uN, double true_uN) {
  return true_uN > 0.0 ? force_uN / true_uN - 1.0 : std::nan("");
}

Phrase error_text(double ratio, const ThemeColors& theme) {
  const std::string sign = ratio >= 0.0 ? "+" : "";
  return {sign + fixed_number(100.0 * ratio, 0) + " %", std::abs(ratio) > kClose_ratio ? theme.record : theme.good};
}

}  // namespace

NumberScale readout_scale(ReadoutSlider which) {
  return kReadoutScales[static_cast<int>(which)];
}

ComparisonTexts comparison_texts(const ReadoutPair& pair, const ThemeColors& theme) {
  ComparisonTexts texts;
  const auto force = [&](double force_uN) { return Phrase{fixed_number(force_uN, 2) + " µN", theme.text}; };
  const double off = error_ratio(pair.prescribed.force_uN, pair.true_force_uN);
  texts.state = std::abs(off) > kClose_ratio ? Phrase{say("Prescribed: wrong"), theme.record}
                                             : Phrase{say("Prescribed: close"), theme.good};
  texts.figures = {force(pair.true_force_uN),
                   force(pair.equilibrium.force_uN),
                   force(pair.prescribed.force_uN),
                   {fixed_number(pair.seen_depth_um, 2) + " µm", theme.text}};
  texts.equilibrium_note = error_text(error_ratio(pair.equilibrium.force_uN, pair.true_force_uN), theme);
  texts.prescribed_note = error_text(off, theme);
  return texts;
}

}  // namespace pellucida
