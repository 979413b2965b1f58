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

// The first frame of so many films with a cell and so many with a bubble and none: visit(view, is_cell, center_px,
// radius_px) of the cell's outer boundary or the bubble's rim.
template <class Visit>
void visit_films(int cells, int bubbles, const Visit& visit) {
  for (std::uint64_t seed = kFirstJudged; cells > 0 || bubbles > 0; ++seed) {
    const RandomFilm film = draw_film(Split::kValidation, seed, 640);
    const Scenario::Bystander& other = film.scenario.bystander;
    const bool is_cell = film.scenario.cell.in_view;
    if (is_cell ? cells == 0 : bubbles == 0 || !(other.bubble_radius_um > 15.0)) continue;
    --(is_cell ? cells : bubbles);
    VirtualMicroscope microscope(film.scenario, film.look);
    const auto frame = microscope.next();
    const Observation& truth = microscope.truth().observation;
    const Eigen::Vector2d center_um = is_cell ? truth.center_um : Eigen::Vector2d(other.bubble_x_um, other.bubble_y_um);
    const double radius_um = is_cell ? truth.rest_outer_radius_um : other.bubble_radius_um;
    const double pixel_um = film.scenario.image.pixel_size_um;
    visit(view_of(frame->image.get()), is_cell, Eigen::Vector2d(center_um / pixel_um), radius_um / pixel_um);
  }
}

TEST(CellNetwork, TellsCellsFromBubblesInFilmsOfFamiliesNeverSeen) {
  constexpr int kCells = 24, kBubbles = 12;
  CellNetwork network;
  int taken = 0, wide = 0, mistaken = 0;
  visit_films(kCells, kBubbles,
              [&](const ImageView& view, bool is_cell, const Eigen::Vector2d& center_px, double radius_px) {
                const FrameSampler image(view);
                (is_cell ? taken : mistaken) += network.read(image, center_px, radius_px) > kCell;
                if (is_cell) wide += network.read(image, center_px, 1.8 * radius_px) > kCell;
              });
  std::printf("%d of %d cells taken for one, %d by a circle too wide; %d of %d bubbles\n", taken, kCells, wide,
              mistaken, kBubbles);
  EXPECT_GE(taken, kCells - 1);
  EXPECT_LE(wide, 2);
  EXPECT_LE(mistaken, 1);
}

// Lines may find a cell's halo, half as large again: the ring within it that is a cell's is taken; none about a bubble.
TEST(CellNetwork, FindsTheCellWithinItsHalo) {
  constexpr int kCells = 16, kBubbles = 8;
  SceneReader reader;
  int taken = 0, mistaken = 0;
  visit_films(kCells, kBubbles,
              [&](const ImageView& view, bool is_cell, const Eigen::Vector2d& center_px, double radius_px) {
                GrayImage whole;
                load(view, whole);
                SceneReading scene;
                add_likeliest_ring(scene, whole, TrackerOptions{}, {center_px, 1.5 * radius_px, 1.0, 0.0},
                                   FrameSampler(view), reader);
                if (scene.cells.empty()) return;
                if (is_cell) taken += std::abs(scene.cells.front().radius_px / radius_px - 1.0) < 0.15;
                if (!is_cell) ++mistaken;
              });
  std::printf("%d of %d cells found within a ring half as large again; %d of %d bubbles\n", taken, kCells, mistaken,
              kBubbles);
  EXPECT_GE(taken, kCells / 2);
  EXPECT_LE(mistaken, 1);
}

}  // namespace
}  // namespace pellucida::test
