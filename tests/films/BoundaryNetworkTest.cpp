// A reading of the normals near a place, beside one of all of them, in films of families that the network wasn't
// trained on.
#include "BoundaryNetwork.h"

#include <gtest/gtest.h>

#include <cmath>

#include "films/RandomFilm.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida::test {
namespace {

constexpr std::uint64_t kFirstRead = 3001;
constexpr int kFilmsRead = 6;
constexpr double kNear_radii = 0.3, kFar_radii = 1.2;  // well within the quarter that is read, and well out of it

TEST(BoundaryNetwork, AReadingNearAPlaceIsThatOfAllNormals) {
  BoundaryNetwork network;
  int cells = 0;
  for (std::uint64_t seed = kFirstRead; seed < kFirstRead + kFilmsRead; ++seed) {
    const RandomFilm film = draw_film(Split::kValidation, seed, 640);
    if (!film.scenario.cell.in_view) continue;
    ++cells;
    VirtualMicroscope microscope(film.scenario, film.look);
    const auto frame = microscope.next();
    const Observation& truth = microscope.truth().observation;
    const FrameSampler image(view_of(frame->image.get()));
    const Eigen::Matrix2Xd outline = 1.01 * truth.outer->points_um / film.scenario.image.pixel_size_um;
    const BoundaryReading all = network.read(image, outline);
    const double radius_px = truth.rest_outer_radius_um / film.scenario.image.pixel_size_um;
    for (const Eigen::Index at : {3, 40, 100}) {
      const BoundaryReading near = network.read_near(image, outline, all.points.col(at));
      Eigen::ArrayXd away_radii = (all.points.colwise() - all.points.col(at)).colwise().norm().transpose() / radius_px;
      double off_px = 0.0;
      int read = 0;
      for (Eigen::Index i = 0; i < away_radii.size(); ++i) {
        if (away_radii[i] < kNear_radii) {
          off_px += std::abs(near.outer.offset_px[i] - all.outer.offset_px[i]);
          ++read;
        } else if (away_radii[i] > kFar_radii) {
          EXPECT_EQ(near.outer.offset_px[i], 0.0);
          EXPECT_NEAR(near.outer.sigma_px[i], 0.02 * radius_px, 1e-3 * radius_px);
        }
      }
      EXPECT_GT(read, 8);
      EXPECT_LT(off_px / read, 0.004 * radius_px) << "film " << seed << ", normal " << at;
    }
  }
  EXPECT_GE(cells, kFilmsRead / 2);
}

}  // namespace
}  // namespace pellucida::test
