#include "films/MembraneTable.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "pellucida/core/Error.h"

namespace pellucida::test {

MembraneTable::MembraneTable(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != "indentation_um,theta0_rad,load_r_kPa,load_z_kPa,tension_uN_per_um") {
    throw InputError(path + ": not a table of a membrane's loads");
  }
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    double depth_um = 0.0;
    MembraneRow row;
    if (!(numbers >> depth_um >> row.theta0_rad >> row.load_r_kPa >> row.load_z_kPa >> row.tension_uN_per_um)) {
      throw InputError(path + ": five numbers wanted in \"" + line + '"');
    }
    if (depths_.empty() || depths_.back().indentation_um != depth_um) depths_.push_back({depth_um, {}});
    depths_.back().rows.push_back(row);
  }
  if (depths_.empty()) throw InputError(path + ": no rows");
}

MembraneRow MembraneTable::Depth::at(double theta0_rad) const {
  const auto above = std::upper_bound(rows.begin(), rows.end(), theta0_rad,
                                      [](double theta, const MembraneRow& row) { return theta < row.theta0_rad; });
  if (above == rows.begin()) return rows.front();
  if (above == rows.end()) return rows.back();
  const MembraneRow &a = *(above - 1), &b = *above;
  const double t = (theta0_rad - a.theta0_rad) / (b.theta0_rad - a.theta0_rad);
  return {theta0_rad, std::lerp(a.load_r_kPa, b.load_r_kPa, t), std::lerp(a.load_z_kPa, b.load_z_kPa, t),
          std::lerp(a.tension_uN_per_um, b.tension_uN_per_um, t)};
}

Eigen::Vector2d MembraneTable::Depth::load_uN_per_um2(double theta0_rad, double half_rad) const {
  // Points evenly over the disk, by the golden angle.
  constexpr int kPoints = 200;
  constexpr double kUN_per_um2_per_kPa = 1e-3;
  const double golden_rad = std::numbers::pi * (3.0 - std::sqrt(5.0));
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int k = 0; k < kPoints; ++k) {
    const double away_rad = half_rad * std::sqrt((k + 0.5) / kPoints), turn_rad = k * golden_rad;
    // The direction's own meridian is the plane of x and z.
    const double along = theta0_rad + away_rad * std::cos(turn_rad), across = away_rad * std::sin(turn_rad);
    const Eigen::Vector3d p(std::sin(along) * std::cos(across), std::sin(across), std::cos(along) * std::cos(across));
    const double from_axis = std::hypot(p.x(), p.y());
    const MembraneRow row = at(std::atan2(from_axis, p.z()));
    sum += Eigen::Vector2d(from_axis > 0.0 ? row.load_r_kPa * p.x() / from_axis : 0.0, row.load_z_kPa);
  }
  return kUN_per_um2_per_kPa / kPoints * sum;
}

}  // namespace pellucida::test
