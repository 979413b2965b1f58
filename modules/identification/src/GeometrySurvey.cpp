#include "pellucida/identification/GeometrySurvey.h"

#include <Eigen/QR>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "ProfileSpecimen.h"
#include "SolidComparison.h"
#include "Workers.h"
#include "pellucida/core/Error.h"
#include "pellucida/fem/SolidReference.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/membrane/MembraneGeometry.h"

namespace pellucida {
namespace {

/// Over the radius: a zona of 2.5 to 20 um on a cell of 50 um, tips of 0.4 to 12, holders of 7.5 to 40 um.
constexpr double kThickness_ratio[] = {0.045, 0.40}, kTip_ratio[] = {0.008, 0.25}, kHolder_ratio[] = {0.15, 0.80};
constexpr double kDepthStep_ratio = 0.04, kDeepest_ratio = 1.0;
/// Longer elements than the default: at finer ones the surface beside a fine tip creases and no equilibrium is found.
constexpr double kEdgeLength_ratio = 1.6;
/// Highest sum of the sizes' powers, and power of the depth beside them.
constexpr int kHighestSum = 3, kSizesDepthPower = 3, kFolds = 8, kFewest = 60;

/// Member `index` of Halton's sequence in a base, 0 to 1.
double halton(int index, int base) {
  double share = 1.0, value = 0.0;
  for (int i = index; i > 0; i /= base) {
    share /= base;
    value += share * (i % base);
  }
  return value;
}

double evenly_in_log(double place, const double (&range)[2]) {
  return range[0] * std::pow(range[1] / range[0], place);
}

MembraneGeometry drawn(int index, double radius_um) {
  return {radius_um, radius_um * evenly_in_log(halton(index, 2), kThickness_ratio),
          radius_um * evenly_in_log(halton(index, 3), kTip_ratio),
          radius_um * evenly_in_log(halton(index, 5), kHolder_ratio)};
}

struct LogRatios {
  std::vector<double> force, pressure;
};

/// ln (solid / springs) at each depth step from the first on, as far as both reach.
LogRatios log_ratios(const CellProfile& profile, const MembraneGeometry& geometry, const std::stop_token& cancel) {
  ShellSpecimen specimen = specimen_of(profile);
  specimen.mid_radius_um = geometry.mid_radius_um;
  specimen.thickness_um = geometry.thickness_um;
  const CellProfile cell = adapted_to(profile, geometry);
  ShellContact contact;
  contact.tip_radius_um = geometry.tip_radius_um;  // not as wide as the springs' mesh needs it
  contact.tip_bond_per_um = profile.tip_bond_per_um * profile.tip_radius_um / geometry.tip_radius_um;
  contact.holder_ring_um = cell.holder_ring_um;
  contact.holder_half_width_um = cell.holder_half_width_um;
  contact.holder_bond_per_um = cell.holder_bond_per_um;
  const double step_um = kDepthStep_ratio * geometry.mid_radius_um,
               deepest_um = kDeepest_ratio * geometry.mid_radius_um;
  SolidReference solid(specimen, contact, {.edge_length_ratio = kEdgeLength_ratio});
  const SolidCurve reference = solid.run(deepest_um, step_um, {}, cancel);
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
  const double place = std::clamp(depth_ratio / kDepthStep_ratio - 1.0, 0.0, static_cast<double>(logs.size() - 1));
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
    for (int p = 0; p <= kHighestDepthPower; ++p) rows(k, p) = std::pow(kDepthStep_ratio * static_cast<double>(k), p);
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
    const MembraneGeometry geometry = k == 0 ? geometry_of(profile) : drawn(k, radius_um);
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
    const MembraneGeometry geometry = drawn(c, radius_um);
    const double log_thickness = std::log(geometry.thickness_um / own.thickness_um),
                 log_tip = std::log(geometry.tip_radius_um / own.tip_radius_um),
                 log_holder = std::log(geometry.holder_radius_um / own.holder_radius_um);
    const LogRatios& here = ratios[static_cast<std::size_t>(c)];
    for (std::size_t k = 0; k < std::min(here.force.size(), base.force.size()); ++k) {
      const double depth = kDepthStep_ratio * static_cast<double>(k + 1);
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
  profile.geometry_range = {kThickness_ratio[0], kThickness_ratio[1], kTip_ratio[0],  kTip_ratio[1],
                            kHolder_ratio[0],    kHolder_ratio[1],    kDeepest_ratio, options.cell_count};
  profile.geometry_terms = fit(forces, profile.geometry_range.spread_ratio);
  profile.geometry_pressure_terms = fit(pressures, profile.geometry_range.pressure_spread_ratio);

  // The modulus was set at the puncture's depth: there, or as deep as the terms reach, the force's factor is 1, and the
  // pressure's what it is at that modulus.
  const double anchor_ratio = std::min(profile.puncture_indentation_um / radius_um, kDeepest_ratio);
  const double anchor_log = value_at(base.force, anchor_ratio);
  std::vector<GeometryTerm> of_force = depth_terms(base.force, anchor_log);
  anchor(of_force, anchor_ratio);
  const std::vector<GeometryTerm> of_pressure = depth_terms(base.pressure, anchor_log);
  profile.geometry_terms.insert(profile.geometry_terms.begin(), of_force.begin(), of_force.end());
  profile.geometry_pressure_terms.insert(profile.geometry_pressure_terms.begin(), of_pressure.begin(),
                                         of_pressure.end());
  record_solid_error(profile, cancel);
}

}  // namespace pellucida
