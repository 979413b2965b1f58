#include "pellucida/mechanics/ForceCrossCheck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "pellucida/core/Error.h"
#include "pellucida/core/Resources.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

/// Reads `indentation_um,force_uN,...`, a header and rising depths.
void read_curve(const std::filesystem::path& file, std::vector<double>& depth_um, std::vector<double>& force_uN) {
  std::ifstream stream(file);
  std::string line;
  for (int number = 0; std::getline(stream, line); ++number) {
    if (number == 0) continue;
    const auto cells = split_csv(line);
    char* end = nullptr;
    const double depth = cells.size() > 1 ? std::strtod(cells[0].c_str(), &end) : NAN;
    const double force = cells.size() > 1 ? std::strtod(cells[1].c_str(), &end) : NAN;
    const bool rises = depth_um.empty() || depth > depth_um.back();
    if (!std::isfinite(depth) || !std::isfinite(force) || !rises) {
      throw InputError(file.string() + ", line " + std::to_string(number + 1) + ": no depth above the last, and force");
    }
    depth_um.push_back(depth);
    force_uN.push_back(force);
  }
  if (depth_um.size() < 2) throw InputError(file.string() + ": fewer than two rows");
}

std::optional<double> interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) noexcept {
  if (!(at >= x.front() && at <= x.back())) return std::nullopt;
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  const std::size_t k = above == x.end() ? x.size() - 1 : static_cast<std::size_t>(above - x.begin());
  const double t = (at - x[k - 1]) / (x[k] - x[k - 1]);
  return (1.0 - t) * y[k - 1] + t * y[k];
}

}  // namespace

std::optional<double> point_load_force_uN(double young_modulus_kPa, double poisson_ratio, double thickness_um,
                                          double depth_um, double dimple_radius_um, double tip_radius_um) noexcept {
  if (!(depth_um > 0.0) || !(tip_radius_um > 0.0) || !(tip_radius_um < 0.95 * dimple_radius_um)) return std::nullopt;
  const double square = std::pow(tip_radius_um / dimple_radius_um, 2), log = std::log(square);
  const double shape =
      (3.0 - 4.0 * square + square * square + 2.0 * log) / ((1.0 - square) * std::pow(1.0 - square + log, 3));
  return 2.0 * std::numbers::pi * 1e-3 * young_modulus_kPa * thickness_um * std::pow(depth_um, 3) /
         (dimple_radius_um * dimple_radius_um * (1.0 - poisson_ratio)) * shape;
}

ForceTables::ForceTables(std::string_view cell) {
  for (int configuration = 1; configuration <= 3; ++configuration) {
    const auto file =
        resource_folder() / "reference" / (std::string(cell) + "-" + std::to_string(configuration) + "-force.csv");
    if (!std::filesystem::exists(file)) continue;
    Table table;
    table.holder_angle_rad = 0.25 * std::numbers::pi * (configuration - 1);
    read_curve(file, table.depth_um, table.force_uN);
    tables_.push_back(std::move(table));
  }
}

std::optional<double> ForceTables::force_uN(double depth_um, double holder_angle_rad,
                                            double size_ratio) const noexcept {
  constexpr double kAngleTolerance_rad = 0.1;
  if (tables_.empty() || holder_angle_rad > tables_.back().holder_angle_rad + kAngleTolerance_rad) return std::nullopt;
  std::size_t next = 0;
  while (next + 1 < tables_.size() && tables_[next].holder_angle_rad < holder_angle_rad) ++next;
  const std::size_t before = next > 0 ? next - 1 : 0;
  const double span = tables_[next].holder_angle_rad - tables_[before].holder_angle_rad;
  const double t =
      span > 0.0 ? std::clamp((holder_angle_rad - tables_[before].holder_angle_rad) / span, 0.0, 1.0) : 0.0;
  const auto low = interpolate(tables_[before].depth_um, tables_[before].force_uN, depth_um / size_ratio);
  const auto high = interpolate(tables_[next].depth_um, tables_[next].force_uN, depth_um / size_ratio);
  if (!low || !high) return std::nullopt;
  return size_ratio * size_ratio * ((1.0 - t) * *low + t * *high);
}

double spread_percent(double estimate_uN, const ForceCrossCheck& opinions) noexcept {
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (const double force : std::array{estimate_uN, opinions.point_load_uN, opinions.table_uN}) {
    if (!std::isfinite(force)) continue;
    sum += force;
    squares += force * force;
    ++count;
  }
  const double mean = count > 0 ? sum / count : 0.0;
  if (count < 2 || !(mean > 0.0)) return ForceCrossCheck::kNone;
  return 100.0 * std::sqrt(std::max(0.0, squares / count - mean * mean)) / mean;
}

}  // namespace pellucida
