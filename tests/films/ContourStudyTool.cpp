// A developer's tool, not installed and no test: how the model's section moves with each size of cell and tools, beside
// the section of specimens from finite elements. What a sequence of contours can say of those sizes follows from it.
//   contour_study FOLDER [--force] > FILE.csv
// `force`: the model's and the specimen's, uN; --force: that alone.
// A row a point: specimen, depth, what was changed, its step, and the middle line (x, z) over the middle radius at rest
// angles 4 degrees apart from the needle's pole; `truth` is the specimen's own.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "films/RandomFilm.h"
#include "pellucida/core/Error.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/simulation/CellReference.h"

namespace {

using namespace pellucida;

constexpr double kDepths_um[] = {6, 12, 18, 24, 30, 36, 42};
constexpr double kStep_rad = 4.0 * std::numbers::pi / 180.0;

struct Point {
  double angle, x, z;
};

/// At even angles, from a half section by rising angle.
void print(const std::string& name, double depth_um, const char* what, double step, const std::vector<Point>& half,
           double radius_um) {
  std::size_t k = 0;
  for (double angle = 0.0; angle < std::numbers::pi; angle += kStep_rad) {
    while (k + 2 < half.size() && half[k + 1].angle < angle) ++k;
    const Point &a = half[k], &b = half[k + 1];
    const double t = (angle - a.angle) / (b.angle - a.angle);
    std::printf("%s,%.3f,%s,%.3f,%.4f,%.6f,%.6f\n", name.c_str(), depth_um, what, step, angle,
                ((1 - t) * a.x + t * b.x) / radius_um, ((1 - t) * a.z + t * b.z) / radius_um);
  }
}

std::vector<Point> half_of(const Indenter& indenter) {
  const Eigen::Matrix3Xd &rest = indenter.model().rest().points_um, &now = indenter.positions_um();
  std::vector<Point> half;
  for (Eigen::Index i = 0; i < rest.cols(); ++i) {
    if (std::abs(rest(1, i)) > 1e-6 || rest(0, i) < -1e-6) continue;
    half.push_back({std::atan2(rest(0, i), rest(2, i)), now(0, i), now(2, i)});
  }
  std::sort(half.begin(), half.end(), [](const Point& a, const Point& b) { return a.angle < b.angle; });
  return half;
}

std::vector<Point> half_of(const CellReference& specimen, double depth_um) {
  const auto section = specimen.section(depth_um);
  std::vector<Point> half;
  for (Eigen::Index i = specimen.angle_rad().size() / 2; i < specimen.angle_rad().size(); ++i) {
    const Eigen::Vector2d middle = 0.5 * (section.outer_um.col(i) + section.inner_um.col(i));
    half.push_back({specimen.angle_rad()[i], middle.x(), middle.y()});
  }
  return half;
}

void study(const CellProfile& profile, const std::string& path, bool force_alone) {
  const CellReference specimen = CellReference::load(path, 1);
  const ReferenceGeometry& g = specimen.geometry();
  const MembraneGeometry own{g.middle_radius_um, g.thickness_um, g.tip_radius_um,
                             g.holder_ring_um + g.holder_half_width_um};
  const std::string name = path.substr(path.rfind('/') + 1);
  struct Change {
    const char* what;
    double MembraneGeometry::*length;
    double step;
  };
  const Change changes[] = {{"none", &MembraneGeometry::thickness_um, 0.0},
                            {"thickness", &MembraneGeometry::thickness_um, 0.15},
                            {"tip", &MembraneGeometry::tip_radius_um, 0.2},
                            {"holder", &MembraneGeometry::holder_radius_um, 0.15}};
  for (const Change& change : changes) {
    if (force_alone && change.step > 0.0) break;
    MembraneGeometry geometry = own;
    geometry.*change.length *= std::exp(change.step);
    Indenter indenter(profile, geometry, -Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitZ());
    for (const double depth_um : kDepths_um) {
      if (depth_um > specimen.max_indentation_um()) break;
      const IndentationState state = indenter.advance_to(depth_um);
      if (state.report.status != SolveStatus::kConverged) break;
      if (!force_alone) print(name, depth_um, change.what, change.step, half_of(indenter), g.middle_radius_um);
      if (change.step > 0.0) continue;
      if (!force_alone) print(name, depth_um, "truth", 0.0, half_of(specimen, depth_um), g.middle_radius_um);
      std::printf("%s,%.3f,force,0,0,%.5f,%.5f\n", name.c_str(), depth_um, state.push_force_uN,
                  specimen.force_uN(depth_um));
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const bool force_alone = count == 3 && std::string(arguments[2]) == "--force";
    if (count != 2 && !force_alone) throw UsageError("contour_study FOLDER [--force]");
    const CellProfile profile = load_profile("mouse-oocyte");
    std::printf("specimen,depth_um,change,step,angle_rad,x,z\n");
    for (const std::string& path : test::specimens_in(arguments[1])) study(profile, path, force_alone);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "contour_study: %s\n", error.what());
    return 1;
  }
  return 0;
}
