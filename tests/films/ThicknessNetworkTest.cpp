// How thick a zona is, in films of families that the network wasn't trained on.
#include "ThicknessNetwork.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "films/RandomFilm.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida::test {
namespace {

constexpr std::uint64_t kFirstMeasured = 3201;
constexpr int kCellsMeasured = 24;
constexpr double kSupposed_ratio = 1.3;  // of the true thickness, or the true one of it

TEST(ThicknessNetwork, ReadsAZonaFromAThicknessThatIsWrong) {
  ThicknessNetwork network;
  std::vector<double> off, apart;
  for (std::uint64_t seed = kFirstMeasured; off.size() < kCellsMeasured; ++seed) {
    const RandomFilm film = draw_film(Split::kValidation, seed, 640);
    if (!film.scenario.cell.in_view) continue;
    VirtualMicroscope microscope(film.scenario, film.look);
    const auto frame = microscope.next();
    const Observation& truth = microscope.truth().observation;
    const double pixel_um = film.scenario.image.pixel_size_um;
    const double thickness_px = (truth.rest_outer_radius_um - truth.rest_inner_radius_um) / pixel_um;
    const FrameSampler image(view_of(frame->image.get()));
    const Eigen::Matrix2Xd outline = truth.outer->points_um / pixel_um;
    const double from_thin =
        std::log(network.read(image, outline, thickness_px / kSupposed_ratio).thickness_px / thickness_px);
    const double from_thick =
        std::log(network.read(image, outline, thickness_px * kSupposed_ratio).thickness_px / thickness_px);
    off.push_back(std::max(std::abs(from_thin), std::abs(from_thick)));
    apart.push_back(std::abs(from_thin - from_thick));
  }
  std::sort(off.begin(), off.end());
  std::sort(apart.begin(), apart.end());
  std::printf("thickness %.3f off in the median, %.3f at 90 %%; from thin and thick %.3f apart in the median\n",
              off[kCellsMeasured / 2], off[kCellsMeasured * 9 / 10], apart[kCellsMeasured / 2]);
  EXPECT_LT(off[kCellsMeasured / 2], 0.06);
  EXPECT_LT(off[kCellsMeasured * 9 / 10], 0.2);
  EXPECT_LT(apart[kCellsMeasured / 2], 0.05);
}

}  // namespace
}  // namespace pellucida::test
