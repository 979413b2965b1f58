#include "commands/IdentifyPicture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "pellucida/charts_vtk/ChartPicture.h"
#include "pellucida/core/RoundNumbers.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

/// Colours that stay apart in print and for colour-blind eyes, one a configuration.
constexpr std::array<Color, 4> kConfigurationColors{Color::from_hex(0x0B5FA5), Color::from_hex(0xC8541A),
                                                    Color::from_hex(0x1B7F4D), Color::from_hex(0x7A3E9D)};
constexpr std::array<const char*, 4> kConfigurationNames{"1 aligned", "2 at 45°", "3 at 90°", "4 beside the axis"};
constexpr Color kModel = Color::from_hex(0x0B5FA5);
constexpr Color kReference = Color::from_hex(0x1A1D21);
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
ChartPanel sensitivity(const FineCurve& fine, const Identification& identification, const MeasuredCurve& measured,
                       double end_um, const std::string& title, const Changed& changed) {
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
  if (!identification.curves.empty()) {
    const ReferenceCurve& reference = identification.curves.front().reference;
    const Eigen::Index shown = (reference.depth_um.array() <= end_um + 1e-9).count();
    panel.series.push_back({"finite elements",
                            ChartStyle::kPoints,
                            to_vector(reference.depth_um.head(shown)),
                            to_vector(reference.force_uN.head(shown)),
                            {},
                            kReference,
                            1.0,
                            5.0});
  }
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

/// A ramp-and-hold record with what one and two arms make of it, and what they leave, nN.
void add_relaxation(const RelaxationPicture& picture, std::vector<ChartPanel>& panels) {
  const RelaxationRecord& record = *picture.record;
  const auto from = record.ramp_begin;
  const Eigen::Index count = record.time_s.size() - from;
  const auto nN = [&](const Eigen::VectorXd& force_uN) { return to_vector(1e3 * force_uN.tail(count)); };
  const std::vector<double> time_s = to_vector((record.time_s.tail(count).array() - record.time_s[from]).matrix());
  ChartPanel force{"Ramp and hold, measured and fitted", "Time since the ramp began (s)", "Force (nN)"};
  force.x_end = axis_end(time_s.back());
  force.y_end = axis_end(1.05e3 * record.force_uN.maxCoeff());
  force.legend_right = true;
  force.series.push_back({"measured", ChartStyle::kPoints, time_s, nN(record.force_uN), {}, kMeasured, 1.0, 4.0});
  force.series.push_back(
      {"spring and one arm", ChartStyle::kDashedLine, time_s, nN(picture.one->force_uN), {}, kLargeError, 1.0, 2.0});
  force.series.push_back(
      {"spring and two arms", ChartStyle::kLine, time_s, nN(picture.two->force_uN), {}, kModel, 1.0, 2.0});

  ChartPanel rest{"What the fits leave", "Time since the ramp began (s)", "Measured less fitted (nN)"};
  rest.x_end = force.x_end;
  rest.legend_right = true;
  double largest_nN = 0.0;
  for (const auto& [fit, name, color] : {std::tuple{picture.one, "spring and one arm", kLargeError},
                                         std::tuple{picture.two, "spring and two arms", kModel}}) {
    const Eigen::VectorXd off_uN = record.force_uN - fit->force_uN;
    largest_nN = std::max(largest_nN, 1e3 * off_uN.tail(count).cwiseAbs().maxCoeff());
    rest.series.push_back({name, ChartStyle::kLine, time_s, nN(off_uN), {}, color, 1.0, 1.5});
  }
  rest.y_end = axis_end(1.05 * largest_nN);
  rest.y_begin = -rest.y_end;
  panels.push_back(force);
  panels.push_back(rest);
}

}  // namespace

void draw_identification(const Identification& identification, const MeasuredCurve& measured,
                         const std::optional<RelaxationPicture>& relaxation, const std::filesystem::path& png) {
  const CellProfile& profile = identification.profile;
  double end_um = profile.puncture_indentation_um;
  if (measured.indentation_um.size() > 0) end_um = std::max(end_um, measured.indentation_um.maxCoeff());
  const FineCurve fine = fine_curve(profile, std::min(1.12 * end_um, 1.4 * profile.mid_radius_um - kStep_um));

  std::vector<ChartPanel> panels;
  if (!identification.curves.empty()) {
    panels.push_back(comparison(identification, end_um));
    panels.push_back(differences(identification, end_um));
  }
  panels.push_back(sensitivity(fine, identification, measured, end_um, "What an error of the modulus does",
                               [&](double depth, double factor) { return factor * fine.at(depth); }));
  panels.push_back(sensitivity(fine, identification, measured, end_um, "What an error of the depth does",
                               [&](double depth, double factor) { return fine.at(factor * depth); }));
  if (relaxation) add_relaxation(*relaxation, panels);
  const int rows = static_cast<int>(panels.size()) / 2;
  render_charts(panels, 2, png, {.width_px = 1600, .height_px = rows == 1 ? 640 : 600 * rows});
}

}  // namespace pellucida
