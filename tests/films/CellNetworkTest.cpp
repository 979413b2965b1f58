// What is a cell and what is none, in films of families that the network wasn't trained on.
#include "CellNetwork.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "RingChoice.h"
#include "films/RandomFilm.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida::test {
namespace {

constexpr std::uint64_t kFirstJudged = 52001;
constexpr double kCell = 0.5;

TEST(CellNetwork, TellsCellsFromBubblesInFilmsOfFamiliesNeverSeen) {
  CellNetwork network;
  int cells = 0, taken = 0, wide = 0, bubbles = 0, mistaken = 0;
  for (std::uint64_t seed = kFirstJudged; cells < 24 || bubbles < 12; ++seed) {
    const RandomFilm film = draw_film(Split::kValidation, seed, 640);
    const Scenario& scenario = film.scenario;
    const bool has_cell = scenario.cell.in_view, has_bubble = scenario.bystander.bubble_radius_um > 15.0;
    if (has_cell ? cells >= 24 : !has_bubble || bubbles >= 12) continue;
    VirtualMicroscope microscope(scenario, film.look);
    const auto frame = microscope.next();
    const FrameSampler image(view_of(frame->image.get()));
    const double pixel_um = scenario.image.pixel_size_um;
    if (has_cell) {
      const Observation& truth = microscope.truth().observation;
      const Eigen::Vector2d center_px = truth.center_um / pixel_um;
      const double radius_px = truth.rest_outer_radius_um / pixel_um;
      ++cells;
      taken += network.read(image, center_px, radius_px) > kCell;
      wide += network.read(image, center_px, 1.8 * radius_px) > kCell;
    } else {
      const Scenario::Bystander& other = scenario.bystander;
      const Eigen::Vector2d center_px = Eigen::Vector2d(other.bubble_x_um, other.bubble_y_um) / pixel_um;
      ++bubbles;
      mistaken += network.read(image, center_px, other.bubble_radius_um / pixel_um) > kCell;
    }
  }
  std::printf("%d of %d cells taken for one, %d by a circle too wide; %d of %d bubbles\n", taken, cells, wide, mistaken,
              bubbles);
  EXPECT_GE(taken, cells - 1);
  EXPECT_LE(wide, 2);
  EXPECT_LE(mistaken, 1);
}

// Lines may find a cell's halo, half as large again: the ring within it that is a cell's is taken; none about a bubble.
TEST(CellNetwork, FindsTheCellWithinItsHalo) {
  SceneReader reader;
  int cells = 0, taken = 0, bubbles = 0, mistaken = 0;
  for (std::uint64_t seed = kFirstJudged; cells < 16 || bubbles < 8; ++seed) {
    const RandomFilm film = draw_film(Split::kValidation, seed, 640);
    const Scenario& scenario = film.scenario;
    const bool has_cell = scenario.cell.in_view, has_bubble = scenario.bystander.bubble_radius_um > 15.0;
    if (has_cell ? cells >= 16 : !has_bubble || bubbles >= 8) continue;
    VirtualMicroscope microscope(scenario, film.look);
    const auto frame = microscope.next();
    const ImageView view = view_of(frame->image.get());
    GrayImage whole;
    load(view, whole);
    const double pixel_um = scenario.image.pixel_size_um;
    const Observation& truth = microscope.truth().observation;
    const Scenario::Bystander& other = scenario.bystander;
    const Eigen::Vector2d center_um =
        has_cell ? truth.center_um : Eigen::Vector2d(other.bubble_x_um, other.bubble_y_um);
    const double radius_px = (has_cell ? truth.rest_outer_radius_um : other.bubble_radius_um) / pixel_um;
    SceneReading scene;
    add_likeliest_ring(scene, whole, TrackerOptions{}, {center_um / pixel_um, 1.5 * radius_px, 1.0, 0.0},
                       FrameSampler(view), reader);
    ++(has_cell ? cells : bubbles);
    if (!has_cell) mistaken += !scene.cells.empty();
    if (has_cell && !scene.cells.empty()) taken += std::abs(scene.cells.front().radius_px / radius_px - 1.0) < 0.15;
  }
  std::printf("%d of %d cells found within a ring half as large again; %d of %d bubbles\n", taken, cells, mistaken,
              bubbles);
  EXPECT_GE(taken, cells / 2);
  EXPECT_LE(mistaken, 1);
}

}  // namespace
}  // namespace pellucida::test
