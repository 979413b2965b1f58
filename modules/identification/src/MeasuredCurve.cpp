#include "pellucida/identification/MeasuredCurve.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"

namespace pellucida {

MeasuredCurve read_measured_curve(const std::filesystem::path& file) {
  const Table table = Table::read(file);
  constexpr Eigen::Index kMostPoints = 10000;
  if (table.rows() > kMostPoints) {
    throw InputError(file.string() + ": " + std::to_string(table.rows()) + " rows; a measured curve has " +
                     std::to_string(kMostPoints) + " at most: thin it out");
  }
  for (const char* name : {"indentation_um", "force_uN"}) {
    if (!table.has(name)) {
      throw InputError(file.string() + ": no column \"" + name +
                       "\" in its header; a measured curve has the columns indentation_um,force_uN");
    }
  }
  const Eigen::VectorXd depth_um = table.column("indentation_um"), force_uN = table.column("force_uN");
  std::vector<std::pair<double, double>> points;
  int beyond_rest = 0;
  for (Eigen::Index k = 0; k < table.rows(); ++k) {
    const std::string row = file.string() + ": row " + std::to_string(k + 1);
    if (!std::isfinite(depth_um[k]) || !std::isfinite(force_uN[k])) {
      throw InputError(row + " lacks its indentation or force; give both or remove the row");
    }
    if (depth_um[k] < 0.0) throw InputError(row + " has an indentation below 0 um; count it from the contact");
    beyond_rest += depth_um[k] > 0.0 ? 1 : 0;
    points.emplace_back(depth_um[k], force_uN[k]);
  }
  if (beyond_rest < 3) {
    throw InputError(file.string() + ": " + std::to_string(beyond_rest) +
                     " points beyond rest; a force scale needs three at least");
  }
  std::sort(points.begin(), points.end());
  MeasuredCurve curve;
  curve.indentation_um.resize(static_cast<Eigen::Index>(points.size()));
  curve.force_uN.resize(curve.indentation_um.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    curve.indentation_um[static_cast<Eigen::Index>(k)] = points[k].first;
    curve.force_uN[static_cast<Eigen::Index>(k)] = points[k].second;
  }
  return curve;
}

}  // namespace pellucida
