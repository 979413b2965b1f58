#include "commands/IdentifyPicture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "pellucida/mechanics/Indenter.h"
#include "pellucida/visualization/Scaling.h"
#include "pellucida/visualization_vtk/ChartPicture.h"

namespace pellucida {
namespace {

/// Colours that stay apart in print and for colour-blind eyes, one a configuration.
constexpr std::array<Color, 4> kConfigurationColors{Color::from_hex(0x0B5FA5), Color::from_hex(0xC8541A),
                                                    Color::from_hex(0x1B7F4D), Color::from_hex(0x7A3E9D)};
constexpr std::array<const char*, 4> kConfigurationNames{"1 aligned", "2 at 45°", "3 at 90°", "4 beside the axis"};
constexpr Color kModel = Color::from_hex(0x0B5FA5);
constexpr Color kMeasured = Color::from_hex(0xB3001E);
constexpr Color kSmallError = Color::from_hex(0x1B7F4D);
constexpr Color kLargeError = Color::from_hex(0xE08A1E);
constexpr double kStep_um = 0.5;

std::vector<double> to_vector(const Eigen::VectorXd& values) {
  return {values.data(), values.data() + values.size()};
}

/// The end of an axis above a value, on a fifth of a round number.
double axis_end(double value) {
  const double step = nice_ceiling(0.2 * value, 1e-9);
  return step * std::ceil(value / step - 1e-9);
}

ChartPanel comparison(const Identification& identification, double end_um) {
  ChartPanel panel{"Finite elements and model, four configurations", "Indentation (µm)", "Force (µN)"};
  panel.x_end = axis_end(end_um);
  double peak_uN = 0.0;
  for (std::size_t k = 0; k < identification.curves.size(); ++k) {
    const IdentifiedCurve& curve = identification.curves[k];
    const Color color = kConfigurationColors[k % kConfigurationColors.size()];
    const Eigen::Index count = curve.model_force_uN.size();
    panel.series.push_back({std::string(kConfigurationNames[k % 4]) + ", model",
                            ChartStyle::kLine,
                            to_vector(curve.reference.depth_um.head(count)),
                            to_vector(curve.model_force_uN),
                            {},
                            color});
    panel.series.push_back({k == 0 ? "points: finite elements" : "",
                            ChartStyle::kPoints,
                            to_vector(curve.reference.depth_um),
                            to_vector(curve.reference.force_uN),
                            {},
                            color,
                            1.0,
                            7.0});
    peak_uN = std::max(peak_uN, curve.reference.force_uN.maxCoeff());
  }
  panel.y_end = axis_end(1.02 * peak_uN);
  return panel;
}

ChartPanel differences(const Identification& identification, double end_um) {
  ChartPanel panel{"Model less finite elements, of the force there", "Indentation (µm)", "Difference (%)"};
  panel.x_end = axis_end(end_um);
  double largest = 5.0;
  panel.series.push_back({"5 % either way",
                          ChartStyle::kBand,
                          {0.0, 0.5 * panel.x_end, panel.x_end},
                          {-5.0, -5.0, -5.0},
                          {5.0, 5.0, 5.0},
                          Color::from_hex(0x8A93A0),
                          0.25});
  for (std::size_t k = 0; k < identification.curves.size(); ++k) {
    const IdentifiedCurve& curve = identification.curves[k];
    std::vector<double> x, y;
    for (Eigen::Index n = 0; n < curve.model_force_uN.size(); ++n) {
      if (curve.reference.depth_um[n] < curve.error.from_um) continue;
      x.push_back(curve.reference.depth_um[n]);
      y.push_back(100.0 * (curve.model_force_uN[n] / curve.reference.force_uN[n] - 1.0));
      largest = std::max(largest, std::abs(y.back()));
    }
    panel.series.push_back({kConfigurationNames[k % 4],
                            ChartStyle::kLine,
                            x,
                            y,
                            {},
                            kConfigurationColors[k % kConfigurationColors.size()]});
  }
  panel.y_end = axis_end(1.6 * largest);
  panel.y_begin = -panel.y_end;
  return panel;
}

/// Configuration 1 in small steps, its force anywhere between.
struct FineCurve {
  std::vector<double> depth_um, force_uN;

  double at(double depth) const {
    const double place = std::clamp(depth / kStep_um, 0.0, static_cast<double>(force_uN.size() - 1));
    const auto before = std::min(static_cast<std::size_t>(place), force_uN.size() - 2);
    const double part = place - static_cast<double>(before);
    return (1.0 - part) * force_uN[before] + part * force_uN[before + 1];
  }
};

FineCurve fine_curve(const CellProfile& profile, double to_um) {
  FineCurve fine;
  for (const auto& state : force_curve(profile, 1, kStep_um * std::ceil(to_um / kStep_um), kStep_um)) {
    if (state.report.status != SolveStatus::kConverged) break;
    fine.depth_um.push_back(state.depth_um);
    fine.force_uN.push_back(state.push_force_uN);
  }
  return fine;
}

/// The curve with a band of what it becomes with an error e of 3 % and 10 %: `changed(depth, 1 + e)`.
template <typename Changed>
ChartPanel sensitivity(const FineCurve& fine, const MeasuredCurve& measured, double end_um, const std::string& title,
                       const Changed& changed) {
  ChartPanel panel{title, "Indentation (µm)", "Force (µN)"};
  panel.x_end = axis_end(end_um);
  std::vector<double> x, middle;
  for (std::size_t n = 0; n < fine.depth_um.size() && fine.depth_um[n] <= end_um + 1e-9; ++n) {
    x.push_back(fine.depth_um[n]);
    middle.push_back(fine.force_uN[n]);
  }
  double largest_uN = measured.force_uN.size() > 0 ? measured.force_uN.maxCoeff() : 0.0;
  for (const auto& [error, color, name] :
       {std::tuple{0.10, kLargeError, "error 10 %"}, std::tuple{0.03, kSmallError, "error 3 %"}}) {
    std::vector<double> low, high;
    for (const double depth : x) {
      low.push_back(changed(depth, 1.0 - error));
      high.push_back(changed(depth, 1.0 + error));
    }
    largest_uN = std::max(largest_uN, high.back());
    panel.series.push_back({"", ChartStyle::kBand, x, low, high, color, 0.25});
    panel.series.push_back({name, ChartStyle::kDashedLine, x, high, {}, color, 1.0, 1.8});
    panel.series.push_back({"", ChartStyle::kDashedLine, x, low, {}, color, 1.0, 1.8});
  }
  panel.series.push_back({"model, configuration 1", ChartStyle::kLine, x, middle, {}, kModel, 1.0, 2.5});
  if (measured.force_uN.size() > 0) {
    panel.series.push_back({"measured",
                            ChartStyle::kPoints,
                            to_vector(measured.indentation_um),
                            to_vector(measured.force_uN),
                            {},
                            kMeasured,
                            1.0,
                            11.0});
  }
  panel.y_end = axis_end(1.02 * largest_uN);
  return panel;
}

}  // namespace

void draw_identification(const Identification& identification, const MeasuredCurve& measured,
                         const std::filesystem::path& png) {
  const CellProfile& profile = identification.profile;
  double end_um = profile.puncture_indentation_um;
  if (measured.indentation_um.size() > 0) end_um = std::max(end_um, measured.indentation_um.maxCoeff());
  const FineCurve fine = fine_curve(profile, std::min(1.12 * end_um, 1.4 * profile.mid_radius_um - kStep_um));

  std::vector<ChartPanel> panels;
  if (!identification.curves.empty()) {
    panels.push_back(comparison(identification, end_um));
    panels.push_back(differences(identification, end_um));
  }
  panels.push_back(sensitivity(fine, measured, end_um, "What an error of the modulus does",
                               [&](double depth, double factor) { return factor * fine.at(depth); }));
  panels.push_back(sensitivity(fine, measured, end_um, "What an error of the depth does",
                               [&](double depth, double factor) { return fine.at(factor * depth); }));
  render_charts(panels, 2, png, {.width_px = 1600, .height_px = panels.size() > 2 ? 1200 : 640});
}

}  // namespace pellucida
