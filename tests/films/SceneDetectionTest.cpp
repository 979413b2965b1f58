// Cells and needles found by the scene network in films of families it wasn't trained on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "SceneReader.h"
#include "films/RandomFilm.h"
#include "pellucida/core/Resources.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida::test {
namespace {

constexpr std::uint64_t kFirst = 2001, kFilms = 24;

TEST(SceneDetection, FindsTheCellOfFilmsOfFamiliesNeverSeen) {
  SceneReader reader;
  int films = 0, found = 0, needles = 0;
  for (std::uint64_t seed = kFirst; seed < kFirst + kFilms; ++seed) {
    const RandomFilm film = draw_film(Split::kValidation, seed, 1024);
    if (!film.scenario.cell.in_view) continue;
    VirtualMicroscope microscope(film.scenario, film.look);
    const auto frame = microscope.next();
    GrayImage image;
    load(view_of(frame->image.get()), image);
    const SceneReading scene = reader.read(image);
    const Observation& truth = microscope.truth().observation;
    const double pixel_um = film.scenario.image.pixel_size_um, radius_px = truth.rest_outer_radius_um / pixel_um;
    const Eigen::Vector2d center_px = truth.center_um / pixel_um, tip_px = truth.needle->tip_um / pixel_um;
    ++films;
    const bool is_found = !scene.cells.empty() && (scene.cells.front().center - center_px).norm() < 0.1 * radius_px &&
                          std::abs(scene.cells.front().radius_px / radius_px - 1) < 0.1;
    found += is_found;
    needles += std::any_of(scene.needles.begin(), scene.needles.end(),
                           [&](const SceneTool& needle) { return (needle.tip - tip_px).norm() < 0.1 * radius_px; });
    if (!is_found) std::printf("not found: film %lu, %s\n", static_cast<unsigned long>(seed), film.look.name.c_str());
  }
  std::printf("%d films: cell found in %d, needle's tip in %d\n", films, found, needles);
  ASSERT_GE(films, 12);
  EXPECT_GE(found, films - 2);
  EXPECT_GE(needles, films / 2);
}

// Of two tools that face each other the one with the finer tip is the needle; in this picture one wall of the holding
// pipette was the finer.
TEST(SceneDetection, AWallOfTheHoldingPipetteIsNoFinerNeedle) {
  const RandomFilm film =
      draw_film(Split::kWide, 711183, 1024, specimens_in((resource_folder() / "reference").string()));
  VirtualMicroscope microscope(film.scenario, film.look);
  for (int k = 0; k < 20; ++k) microscope.skip();
  const auto frame = microscope.next();
  const Observation seen = MembraneTracker().process(view_of(frame->image.get()), 0.0, 0);
  ASSERT_TRUE(seen.needle);
  EXPECT_GT(seen.needle->direction.dot(microscope.truth().observation.needle->direction), 0.95);
}

}  // namespace
}  // namespace pellucida::test
