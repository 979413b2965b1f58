#include "commands/TrialPicture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "pellucida/charts_vtk/ChartPicture.h"
#include "pellucida/core/RoundNumbers.h"
#include "pellucida/evaluation/TrialSummary.h"

namespace pellucida {
namespace {

constexpr std::array<Color, 4> kColors{Color::from_hex(0x8A93A0), Color::from_hex(0x0B5FA5), Color::from_hex(0xC8541A),
                                       Color::from_hex(0x1B7F4D)};
constexpr const char* kModalities = "1: 2-D   2: 3-D   3: 3-D + haptics   4: + guide";

double place_of(Modality modality) {
  return 1.0 + static_cast<double>(modality);
}

ChartPanel panel_of(const char* title, const char* unit) {
  ChartPanel panel{title, kModalities, unit};
  panel.x_begin = 0.0;
  panel.x_end = 5.0;
  return panel;
}

/// A mean as a point with a bar from `lower` to `upper`.
void add_mean(ChartPanel& panel, double x, double mean, double lower, double upper) {
  const Color ink = Color::from_hex(0x1B1F24);
  panel.series.push_back({"", ChartStyle::kLine, {x, x}, {lower, upper}, {}, ink, 1.0, 4.0});
  panel.series.push_back({"", ChartStyle::kPoints, {x}, {mean}, {}, ink, 1.0, 9.0});
}

ChartPanel metric_panel(std::span<const TrialOutcome> outcomes, std::span<const ModalitySummary> summaries,
                        const char* title, const char* unit, double TrialOutcome::*value) {
  ChartPanel panel = panel_of(title, unit);
  double largest = 1e-6;
  for (const ModalitySummary& summary : summaries) {
    const double middle = place_of(summary.modality);
    std::vector<double> x, y, all;
    for (const TrialOutcome& outcome : outcomes) {
      if (outcome.modality != summary.modality || std::isnan(outcome.*value)) continue;
      // Side by side, for the eye alone.
      constexpr int kColumns = 21;
      const int column = static_cast<int>(8 * y.size() % kColumns);
      x.push_back(middle + 0.6 * (static_cast<double>(column) / (kColumns - 1) - 0.5));
      y.push_back(outcome.*value);
      largest = std::max(largest, outcome.*value);
    }
    const Color color = kColors[static_cast<std::size_t>(summary.modality)];
    panel.series.push_back({"", ChartStyle::kPoints, x, y, {}, color, 1.0, 4.0});
    const Estimate mean = estimate(y);
    if (mean.count > 0) add_mean(panel, middle, mean.mean, mean.lower, mean.upper);
  }
  const double step = nice_ceiling(0.2 * largest, 1e-9);
  panel.y_end = step * std::ceil(1.02 * largest / step);
  return panel;
}

ChartPanel success_panel(std::span<const ModalitySummary> summaries) {
  ChartPanel panel = panel_of("SIMULATED operator: success", "Trials (%)");
  panel.y_end = 110.0;
  for (const ModalitySummary& summary : summaries) {
    const Share& share = summary.success;
    add_mean(panel, place_of(summary.modality), 100 * share.value, 100 * share.lower, 100 * share.upper);
  }
  return panel;
}

}  // namespace

void draw_trials(std::span<const TrialOutcome> outcomes, const std::filesystem::path& png) {
  const auto summaries = summarize(outcomes);
  const auto metric = [&](const char* title, const char* unit, double TrialOutcome::*value) {
    return metric_panel(outcomes, summaries, title, unit, value);
  };
  const std::vector<ChartPanel> panels{
      metric("SIMULATED operator: lateral RMS error", "Error (µm)", &TrialOutcome::lateral_rms_um),
      metric("SIMULATED operator: insertion to deposit", "Time (s)", &TrialOutcome::insertion_s),
      success_panel(summaries),
      metric("SIMULATED operator: peak approach speed", "Speed (µm/s)", &TrialOutcome::peak_approach_um_per_s),
      metric("SIMULATED operator: peak after puncture", "Speed (µm/s)", &TrialOutcome::peak_after_puncture_um_per_s),
      metric("SIMULATED operator: overshoot", "Past target (µm)", &TrialOutcome::overshoot_um)};
  render_charts(panels, 3, png, {.width_px = 1950, .height_px = 1100});
}

}  // namespace pellucida
