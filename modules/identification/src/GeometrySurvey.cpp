#include "pellucida/identification/GeometrySurvey.h"

#include <Eigen/QR>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "SolidComparison.h"
#include "SurveyedSolid.h"
#include "Workers.h"
#include "pellucida/core/Error.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/membrane/MembraneGeometry.h"
#include "pellucida/membrane/SolidForce.h"

namespace pellucida {
namespace {

/// Highest sum of the sizes' powers, and power of the depth beside them.
constexpr int kHighestSum = 3, kSizesDepthPower = 3, kFolds = 8, kFewest = 60;

struct LogRatios {
  std::vector<double> force, pressure;
};

/// ln (solid / springs) at each depth step from the first on, as far as both reach.
LogRatios log_ratios(const CellProfile& profile, const MembraneGeometry& geometry, const std::stop_token& cancel) {
  const double step_um = kSurveyStep_ratio * geometry.mid_radius_um,
               deepest_um = kSurveyDeepest_ratio * geometry.mid_radius_um;
  const SolidCurve reference = surveyed_solid(profile, geometry).run(deepest_um, step_um, {}, cancel);
  CellProfile bare = profile;
  bare.geometry_terms.clear();
  bare.geometry_pressure_terms.clear();
  const MembraneSetup setup{geometry.mid_radius_um, geometry.thickness_um};
  const auto springs = force_curve(bare, geometry, setup, deepest_um, step_um);
  LogRatios ratios;
  for (std::size_t k = 1; k < std::min(reference.steps.size(), springs.size()); ++k) {
    if (springs[k].report.status != SolveStatus::kConverged) break;
    const double pressure_ratio = 1e3 * reference.steps[k].pressure_kPa / springs[k].pressure_Pa;
    if (!(pressure_ratio > 0.0)) break;
    ratios.force.push_back(std::log(reference.steps[k].force_uN / springs[k].push_force_uN));
    ratios.pressure.push_back(std::log(pressure_ratio));
  }
  return ratios;
}

std::vector<GeometryTerm> all_terms() {
  std::vector<GeometryTerm> terms;
  for (int h = 0; h <= kHighestSum; ++h)
    for (int a = 0; a + h <= kHighestSum; ++a)
      for (int o = 0; o + a + h <= kHighestSum; ++o)
        for (int d = 0; h + a + o > 0 && d <= kSizesDepthPower; ++d) terms.push_back({h, a, o, d, 0.0});
  return terms;
}

/// Between the depth steps, linear.
double value_at(const std::vector<double>& logs, double depth_ratio) {
  const double place = std::clamp(depth_ratio / kSurveyStep_ratio - 1.0, 0.0, static_cast<double>(logs.size() - 1));
  const auto k = std::min(static_cast<std::size_t>(place), logs.size() - 2);
  return logs[k] + (place - static_cast<double>(k)) * (logs[k + 1] - logs[k]);
}

/// Terms of the depth alone: `logs` of the profile's own geometry, which begin at the first depth step and are taken as
/// the same above it, less `anchor_log`.
std::vector<GeometryTerm> depth_terms(const std::vector<double>& logs, double anchor_log) {
  const auto count = static_cast<Eigen::Index>(logs.size());
  if (count < 2 * kHighestDepthPower)
    throw NothingMeasuredError("survey of geometries: the profile's own has too few equilibria");
  Eigen::MatrixXd rows(count + 1, kHighestDepthPower + 1);
  Eigen::VectorXd values(count + 1);
  for (Eigen::Index k = 0; k <= count; ++k) {
    for (int p = 0; p <= kHighestDepthPower; ++p) rows(k, p) = std::pow(kSurveyStep_ratio * static_cast<double>(k), p);
    values[k] = logs[static_cast<std::size_t>(std::max<Eigen::Index>(k - 1, 0))] - anchor_log;
  }
  const Eigen::VectorXd fitted = rows.colPivHouseholderQr().solve(values);
  std::vector<GeometryTerm> terms;
  for (int p = 0; p <= kHighestDepthPower; ++p) terms.push_back({0, 0, 0, p, fitted[p]});
  return terms;
}

/// Moves the constant one so that their sum is 0 at a depth.
void anchor(std::vector<GeometryTerm>& terms, double depth_ratio) {
  double sum = 0.0;
  for (const GeometryTerm& term : terms) sum += term.coefficient * std::pow(depth_ratio, term.depth);
  terms.front().coefficient -= sum;
}

Eigen::VectorXd solve(const Eigen::MatrixXd& rows, const Eigen::VectorXd& values) {
  return rows.colPivHouseholderQr().solve(values);
}

/// RMS of what a fit to the other cells leaves, over the cells left out.
double left_out_rms(const Eigen::MatrixXd& rows, const Eigen::VectorXd& values, const std::vector<int>& cell_of_row) {
  double squares = 0.0;
  for (int fold = 0; fold < kFolds; ++fold) {
    std::vector<int> in, out;
    for (int k = 0; k < static_cast<int>(cell_of_row.size()); ++k)
      (cell_of_row[static_cast<std::size_t>(k)] % kFolds == fold ? out : in).push_back(k);
    const Eigen::VectorXd fitted = solve(rows(in, Eigen::all), values(in));
    squares += (values(out) - rows(out, Eigen::all) * fitted).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace

void survey_geometry(CellProfile& profile, const GeometrySurveyOptions& options,
                     const std::function<void(double share)>& progress, const std::stop_token& cancel) {
  if (options.cell_count < kFewest)
    throw UsageError("survey of geometries: give " + std::to_string(kFewest) + " cells or more");
  const double radius_um = profile.mid_radius_um;
  std::vector<LogRatios> ratios(static_cast<std::size_t>(options.cell_count) + 1);
  std::atomic<int> done = 0;
  run_jobs(options.cell_count + 1, options.threads, [&](int k) {
    if (cancel.stop_requested()) return;
    const MembraneGeometry geometry = k == 0 ? geometry_of(profile) : surveyed_geometry(k, radius_um);
    ratios[static_cast<std::size_t>(k)] = log_ratios(profile, geometry, cancel);
    if (progress) progress(static_cast<double>(++done) / (options.cell_count + 1));
  });
  if (cancel.stop_requested()) throw Error(ExitCode::kOurFault, "identify: cancelled; nothing was written");

  // A row for each cell and depth.
  const std::vector<GeometryTerm> terms = all_terms();
  const MembraneGeometry own = geometry_of(profile);
  std::vector<double> forces, pressures;
  std::vector<int> cell_of_row;
  std::vector<Eigen::RowVectorXd> lines;
  const LogRatios& base = ratios.front();
  for (int c = 1; c <= options.cell_count; ++c) {
    const MembraneGeometry geometry = surveyed_geometry(c, radius_um);
    const double log_thickness = std::log(geometry.thickness_um / own.thickness_um),
                 log_tip = std::log(geometry.tip_radius_um / own.tip_radius_um),
                 log_holder = std::log(geometry.holder_radius_um / own.holder_radius_um);
    const LogRatios& here = ratios[static_cast<std::size_t>(c)];
    for (std::size_t k = 0; k < std::min(here.force.size(), base.force.size()); ++k) {
      const double depth = kSurveyStep_ratio * static_cast<double>(k + 1);
      Eigen::RowVectorXd line(static_cast<Eigen::Index>(terms.size()));
      for (std::size_t t = 0; t < terms.size(); ++t) {
        line[static_cast<Eigen::Index>(t)] = std::pow(log_thickness, terms[t].thickness) *
                                             std::pow(log_tip, terms[t].tip) * std::pow(log_holder, terms[t].holder) *
                                             std::pow(depth, terms[t].depth);
      }
      lines.push_back(line);
      forces.push_back(here.force[k] - base.force[k]);
      pressures.push_back(here.pressure[k] - base.pressure[k]);
      cell_of_row.push_back(c);
    }
  }
  if (lines.size() < 10 * terms.size()) {
    throw NothingMeasuredError("survey of geometries: " + std::to_string(lines.size()) +
                               " equilibria are too few for " + std::to_string(terms.size()) +
                               " terms; does the profile's own geometry have any?");
  }
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(lines.size()), static_cast<Eigen::Index>(terms.size()));
  for (std::size_t k = 0; k < lines.size(); ++k) rows.row(static_cast<Eigen::Index>(k)) = lines[k];
  const auto fit = [&](const std::vector<double>& logs, double& spread) {
    const Eigen::VectorXd all = Eigen::Map<const Eigen::VectorXd>(logs.data(), static_cast<Eigen::Index>(logs.size()));
    const Eigen::VectorXd fitted = solve(rows, all);
    spread = left_out_rms(rows, all, cell_of_row);
    std::vector<GeometryTerm> with_values = terms;
    for (std::size_t t = 0; t < terms.size(); ++t) with_values[t].coefficient = fitted[static_cast<Eigen::Index>(t)];
    return with_values;
  };
  profile.geometry_range = {kSurveyThickness_ratio[0], kSurveyThickness_ratio[1], kSurveyTip_ratio[0],
                            kSurveyTip_ratio[1],       kSurveyHolder_ratio[0],    kSurveyHolder_ratio[1],
                            kSurveyDeepest_ratio,      options.cell_count};
  profile.geometry_terms = fit(forces, profile.geometry_range.spread_ratio);
  profile.geometry_pressure_terms = fit(pressures, profile.geometry_range.pressure_spread_ratio);

  // The modulus was set at the puncture's depth: there, or as deep as the terms reach, the force's factor is 1, and the
  // pressure's what it is at that modulus.
  const double anchor_ratio = std::min(profile.puncture_indentation_um / radius_um, kSurveyDeepest_ratio);
  const double anchor_log = value_at(base.force, anchor_ratio);
  std::vector<GeometryTerm> of_force = depth_terms(base.force, anchor_log);
  anchor(of_force, anchor_ratio);
  const std::vector<GeometryTerm> of_pressure = depth_terms(base.pressure, anchor_log);
  profile.geometry_terms.insert(profile.geometry_terms.begin(), of_force.begin(), of_force.end());
  profile.geometry_pressure_terms.insert(profile.geometry_pressure_terms.begin(), of_pressure.begin(),
                                         of_pressure.end());
  profile.geometry_range.solid_force_ratio = solid_force_ratio(profile);
  record_solid_error(profile, cancel);
}

}  // namespace pellucida
