// The default detection on random films in two styles, of families that no network and no constant has seen. Limits are
// about twice what is found. film_report prints more.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <vector>

#include "SceneReader.h"
#include "films/FilmRun.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida::test {
namespace {

struct Tally {
  int frames = 0, found = 0, empty = 0, invented = 0, sure_and_wrong = 0;
  std::vector<double> outer_px;

  double median_px() {
    std::sort(outer_px.begin(), outer_px.end());
    return outer_px.empty() ? 1e9 : outer_px[outer_px.size() / 2];
  }
};

Tally tally_of(std::uint64_t first, int count, bool drawing) {
  Tally tally;
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed) {
    RandomFilm film = draw_film(Split::kValidation, seed, 512);
    film.drawing = drawing;
    const FilmRun run = run_film(film, {});
    tally.sure_and_wrong += run.confident_and_wrong_count;
    const int frames = static_cast<int>(run.errors.size());
    (run.has_cell ? tally.frames : tally.empty) += frames;
    (run.has_cell ? tally.found : tally.invented) += run.found_count;
    for (const FrameError& error : run.errors)
      if (error.outer_px >= 0) tally.outer_px.push_back(error.outer_px);
  }
  std::printf("found in %d of %d frames, %.2f px; %d of %d frames without a cell show one; %d sure and wrong\n",
              tally.found, tally.frames, tally.median_px(), tally.invented, tally.empty, tally.sure_and_wrong);
  return tally;
}

TEST(AutoDetection, KeepsThePrecisionOfLinesWhereMembranesAreLines) {
  Tally tally = tally_of(14001, 10, true);
  EXPECT_GT(tally.found, 0.95 * tally.frames);
  EXPECT_LT(tally.median_px(), 0.25);
  EXPECT_LT(tally.sure_and_wrong, 0.02 * tally.frames);
}

TEST(AutoDetection, IsNotSureOfALookThatIsNoLine) {
  Tally tally = tally_of(14101, 10, false);
  EXPECT_GT(tally.found, 0.85 * tally.frames);
  EXPECT_LT(tally.median_px(), 1.0);
  EXPECT_LT(tally.sure_and_wrong, 0.02 * tally.frames);
}

// Lines alone follow the zona's inner edge or the fringe beyond its halo there, 3 to 15 px off, and are sure of it.
TEST(AutoDetection, TheNetworkIsBelievedWhereLinesHaveTheCellElsewhere) {
  for (const std::uint64_t seed : {16014, 16019, 16039}) {
    const RandomFilm film = draw_film(Split::kValidation, seed, 640);
    VirtualMicroscope microscope(film.scenario, film.look);
    const std::optional<Frame> frame = microscope.next();
    MembraneTracker tracker;
    const Observation seen = tracker.process(view_of(frame->image.get()), frame->time_s, frame->frame_index);
    const FrameError error = compare(seen, microscope.truth().observation, film.scenario.image.pixel_size_um);
    ASSERT_TRUE(seen.outer) << "film " << seed;
    EXPECT_LT(error.outer_px, 2.0) << "film " << seed;
    EXPECT_LE(seen.confidence, 0.75) << "film " << seed;
  }
}

// Bubbles are no cells, and the holding pipette is no needle.
TEST(AutoDetection, InventsNoCellAndFollowsTheNeedleWhereThereIsNone) {
  int films = 0, frames = 0, invented = 0;
  std::vector<double> tip_px;
  for (std::uint64_t seed = 14201; films < 6; ++seed) {
    const RandomFilm film = draw_film(Split::kValidation, seed, 512);
    if (film.scenario.cell.in_view) continue;
    const FilmRun run = run_film(film, {});
    ++films;
    frames += static_cast<int>(run.errors.size());
    invented += run.found_count;
    for (const FrameError& error : run.errors)
      if (error.tip_px >= 0) tip_px.push_back(error.tip_px);
  }
  std::sort(tip_px.begin(), tip_px.end());
  ASSERT_FALSE(tip_px.empty());
  std::printf("%d of %d frames show a cell; needle in %zu, %.2f px off in the median, %.1f at 90 %%\n", invented,
              frames, tip_px.size(), tip_px[tip_px.size() / 2], tip_px[9 * tip_px.size() / 10]);
  EXPECT_LE(invented, frames / 20);
  EXPECT_GT(tip_px.size(), static_cast<std::size_t>(frames) * 8 / 10);
  EXPECT_LT(tip_px[tip_px.size() / 2], 5.0);
}

// Others read the picture after the network.
TEST(SceneReader, LeavesThePictureAlone) {
  const RandomFilm film = draw_film(Split::kValidation, 14001, 1024);
  VirtualMicroscope microscope(film.scenario, film.look);
  const auto frame = microscope.next();
  GrayImage image;
  load(view_of(frame->image.get()), image);
  const auto before = image.pixels;
  SceneReader().read(image);
  EXPECT_EQ(image.pixels, before);
}

}  // namespace
}  // namespace pellucida::test
