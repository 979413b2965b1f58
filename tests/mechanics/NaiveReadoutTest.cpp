// The read-out that prescribes every node, against the finite elements of a thin shell, which the springs are: why it
// isn't used.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>

#include "pellucida/core/Resources.h"
#include "pellucida/core/Table.h"
#include "pellucida/mechanics/ForceCrossCheck.h"
#include "pellucida/mechanics/RevolvedContour.h"
#include "pellucida/membrane/Indenter.h"
#include "support/TestProfiles.h"

namespace pellucida {
namespace {

/// Middle surface of configuration 1 by rest angle: across and along the axis, um.
using Profile = std::map<double, Eigen::Vector2d>;

/// All depths of the shipped section. Both sides are the same there; the right one is taken.
std::map<double, Profile> read_sections() {
  std::ifstream file(resource_folder() / "reference" / "thin-shell-oocyte-1-profile.csv");
  std::map<double, Profile> sections;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    const auto cells = split_csv(line);
    const double angle = std::stod(cells[1]);
    if (angle >= 0.0) sections[std::stod(cells[0])][angle] = {std::stod(cells[2]), std::stod(cells[3])};
  }
  return sections;
}

Eigen::Vector2d place_at(const Profile& section, double angle) {
  auto above = section.upper_bound(angle);
  if (above == section.end()) return std::prev(above)->second;
  // Left of the first point is its mirror image.
  if (above == section.begin()) {
    const double t = angle / above->first;
    return {t * above->second.x(), above->second.y()};
  }
  const auto below = std::prev(above);
  const double t = (angle - below->first) / (above->first - below->first);
  return (1.0 - t) * below->second + t * above->second;
}

TEST(NaiveReadout, IsBiasedEvenWithAPerfectShape) {
  const CellProfile profile = load_profile("mouse-oocyte");
  Indenter indenter(profile, setup_for_configuration(profile, 1));
  const MembraneModel& model = indenter.model();
  const ForceTables truth("thin-shell-oocyte");
  int count = 0;
  for (const auto& [depth, section] : read_sections()) {
    if (depth < 6.0) continue;
    // Each node where the finite elements say that very piece of membrane is.
    Eigen::Matrix3Xd laid(3, model.rest().points_um.cols());
    for (Eigen::Index n = 0; n < laid.cols(); ++n) {
      const Eigen::Vector3d p = model.rest().points_um.col(n);
      const double across = std::hypot(p.x(), p.y());
      const Eigen::Vector2d place = place_at(section, std::atan2(across, p.z()));
      laid.col(n) = across > 0.0 ? Eigen::Vector3d(place.x() * p.x() / across, place.x() * p.y() / across, place.y())
                                 : Eigen::Vector3d(0.0, 0.0, place.y());
    }
    const double true_uN = truth.force_uN(depth, 0.0).value();
    const double naive = 100.0 * (naive_force_uN(model, laid) / true_uN - 1.0);
    const double solved = 100.0 * (indenter.advance_to(depth).push_force_uN / true_uN - 1.0);
    std::printf("%5.1f um: every node prescribed %+6.1f %%, equilibrium %+5.1f %%\n", depth, naive, solved);
    EXPECT_LT(std::abs(solved), 5.0) << depth;
    ++count;
    EXPECT_LT(naive, -24.0) << depth;
  }
  EXPECT_GT(count, 10);
}

}  // namespace
}  // namespace pellucida
