// Cells and needles of films of families that no network and no constant has seen, followed by --detection scene.
// Limits are about twice what is found. film_report prints more.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "GlobalShiftEstimator.h"
#include "films/FilmRun.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida::test {
namespace {

constexpr std::uint64_t kFirst = 3001, kFilms = 16, kFilmsOfBoth = 5;
constexpr double kAtFirst_ratio = 0.013, kPoorAtFirst_ratio = 0.03;  // of the radius, RMS

double share_of(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 1e9 : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

TEST(SceneTracking, FollowsFilmsOfFamiliesNeverSeen) {
  TrackerOptions options;
  options.detection = TrackerOptions::Detection::kScene;
  std::vector<double> outer, tip;
  int frames = 0, found = 0, contact = 0, false_punctures = 0;
  for (std::uint64_t seed = kFirst; seed < kFirst + kFilms; ++seed) {
    const FilmRun run = run_film(draw_film(Split::kValidation, seed, 640), options);
    if (!run.has_cell) {
      EXPECT_EQ(run.found_count, 0) << "film " << seed;
      continue;
    }
    frames += static_cast<int>(run.errors.size());
    found += run.found_count;
    contact += run.contact_count;
    false_punctures += run.false_puncture_count;
    for (const FrameError& error : run.errors) {
      if (error.outer_px >= 0) outer.push_back(error.outer_px);
      if (error.tip_px >= 0) tip.push_back(error.tip_px);
    }
  }
  std::printf("%d frames: found %d; outer %.2f px median, %.2f 95 %%; tip %.2f, %.2f; false punctures %d of %d\n",
              frames, found, share_of(outer, 0.5), share_of(outer, 0.95), share_of(tip, 0.5), share_of(tip, 0.95),
              false_punctures, contact);
  EXPECT_GT(found, 0.8 * frames);
  EXPECT_LT(share_of(outer, 0.5), 0.4);
  EXPECT_LT(share_of(tip, 0.5), 1.0);
  EXPECT_LE(false_punctures, contact / 50);
}

// Live, most frames go on with what was read some frames before; in high quality each one is read.
TEST(SceneTracking, FramesBetweenTwoReadingsAreFollowedAsWellAsThoseRead) {
  struct Errors {
    std::vector<double> outer_px, tip_px;
  };
  const auto errors_of = [](TrackerOptions::Quality quality) {
    TrackerOptions options;
    options.detection = TrackerOptions::Detection::kScene;
    options.quality = quality;
    Errors errors;
    for (std::uint64_t seed = kFirst; seed < kFirst + kFilmsOfBoth; ++seed) {
      for (const FrameError& error : run_film(draw_film(Split::kValidation, seed, 640), options).errors) {
        if (error.outer_px >= 0) errors.outer_px.push_back(error.outer_px);
        if (error.tip_px >= 0) errors.tip_px.push_back(error.tip_px);
      }
    }
    return errors;
  };
  const Errors live = errors_of(TrackerOptions::Quality::kLive), high = errors_of(TrackerOptions::Quality::kHigh);
  const auto expect_alike = [](const char* what, const std::vector<double>& one, const std::vector<double>& other) {
    std::printf("%s, live %.2f px median, %.2f 95 %%; each frame read %.2f, %.2f\n", what, share_of(one, 0.5),
                share_of(one, 0.95), share_of(other, 0.5), share_of(other, 0.95));
    EXPECT_LT(share_of(one, 0.5), share_of(other, 0.5) + 0.1) << what;
    EXPECT_LT(share_of(one, 0.95), share_of(other, 0.95) + 0.3) << what;
  };
  expect_alike("outer", live.outer_px, high.outer_px);
  expect_alike("tip", live.tip_px, high.tip_px);
}

// In this film the membrane springs back in frame 16 or 17; the picture as a whole stays.
TEST(SceneTracking, AMembraneThatSpringsBackIsNoJumpOfThePicture) {
  const RandomFilm film = draw_film(Split::kTuning, 40003, 640);
  VirtualMicroscope microscope(film.scenario, film.look);
  GlobalShiftEstimator shift;
  for (int k = 0; k < 20; ++k) {
    const auto frame = microscope.next();
    EXPECT_FALSE(shift.update(FrameSampler(view_of(frame->image.get())))) << "frame " << k;
  }
  EXPECT_EQ(microscope.truth().observation.state, CellState::kPunctured);
}

// Before a reading that nothing ties to the tip was held against its own depth, three of these punctures were told
// after three frames, one never; the last film has a steep dimple that such a reading cuts across, and none until
// frame 20.
TEST(SceneTracking, PuncturesAreToldWithinTwoFrames) {
  for (const std::uint64_t seed : {170009, 170011, 170055, 170059}) {
    SCOPED_TRACE(seed);
    const FilmRun run = run_film(draw_film(Split::kTuning, seed, 640), {});
    ASSERT_TRUE(run.punctures);
    ASSERT_TRUE(run.puncture_delay);
    EXPECT_LE(*run.puncture_delay, 2);
    EXPECT_EQ(run.false_puncture_count, 0);
  }
  const FilmRun steep = run_film(draw_film(Split::kTuning, 170081, 640), {});
  EXPECT_GT(steep.contact_count, 10);
  EXPECT_EQ(steep.false_puncture_count, 0);
}

// Dimples of 0.7 of the radius, which the contour lost; 11 to 27 frames of each were a puncture that never was before
// the cell's sides were asked.
TEST(SceneTracking, ACellWhoseSidesBulgeIsPushed) {
  for (const std::uint64_t seed : {179205, 179247, 179256}) {
    SCOPED_TRACE(seed);
    const FilmRun run = run_film(draw_film(Split::kWide, seed, 640), {});
    EXPECT_GT(run.contact_count, 20);
    EXPECT_EQ(run.false_puncture_count, 0);
    EXPECT_LT(run.force_rms_percent, 35.0);
  }
}

// Films whose holders are bent, hardly in view, or slide along their walls for a tracker; each was lost by 10 px and
// more before; 5.6 um is the largest of today, of 21029. Depths count from where the holder seats the cell; the tip's
// radius is geometry, not a look.
TEST(SceneTracking, DepthsCountFromTheSeatAndTheTipHasItsRadius) {
  for (const std::uint64_t seed : {21029, 22031, 22037, 23004}) {
    SCOPED_TRACE(seed);
    const FilmRun run = run_film(draw_film(Split::kValidation, seed, 640), {});
    std::vector<double> off_um;
    for (std::size_t k = 0; k < run.sights.size(); ++k)
      if (run.sights[k].truth == CellState::kContact && run.sights[k].has_needle)
        off_um.push_back(std::abs(run.sights[k].tip_um - run.sights[k].true_tip_um));
    ASSERT_GT(off_um.size(), 20U);
    EXPECT_LT(share_of(off_um, 0.9), 7.0);
    EXPECT_NEAR(std::log(run.seen_sizes.tip_radius_um / run.true_sizes.tip_radius_um), 0.0, 0.45);
  }
}

// The tracker begins with the needle deep in the cell, as it does after it has lost one; in the last film the membrane
// has given way. Read from the outline as detection gave it, contours were off by 2.0 to 4.3 % of the radius.
TEST(SceneTracking, ADimpleIsFollowedFromItsFirstSight) {
  const std::vector<std::string> specimens = specimens_in(PELLUCIDA_SOURCE_DIR "/resources/reference");
  int good_count = 0;
  for (const auto& [seed, skipped] : {std::pair{173005, 20}, {173017, 19}, {173023, 26}, {173012, 15}, {173035, 22}}) {
    SCOPED_TRACE(seed);
    const RandomFilm film = draw_film(Split::kTuning, static_cast<std::uint64_t>(seed), 1024, specimens);
    VirtualMicroscope microscope(film.scenario, film.look);
    for (int k = 0; k < skipped; ++k) microscope.skip();
    const auto frame = microscope.next();
    MembraneTracker tracker;
    const Observation seen = tracker.process(view_of(frame->image.get()), 0.0, 0);
    const Observation& truth = microscope.truth().observation;
    EXPECT_EQ(seen.state, truth.state);
    const double off_ratio = compare(seen, truth, 1.0).outer_px / truth.rest_outer_radius_um;
    EXPECT_LT(off_ratio, kPoorAtFirst_ratio);
    if (off_ratio < kAtFirst_ratio) ++good_count;
  }
  EXPECT_GE(good_count, 4);
}

// The outline ran round a cumulus cell, 2.2 and 9.4 px off throughout.
TEST(SceneTracking, ACumulusCellOnTheZonaIsNoPartOfIt) {
  for (const auto& [seed, most_px] : {std::pair{314089, 1.0}, {314219, 4.0}}) {
    SCOPED_TRACE(seed);
    const FilmRun run = run_film(draw_film(Split::kTuning, static_cast<std::uint64_t>(seed), 640), {});
    std::vector<double> outer_px;
    for (const FrameError& error : run.errors) outer_px.push_back(error.outer_px);
    EXPECT_GT(run.found_count, 20);
    EXPECT_LT(share_of(outer_px, 0.5), most_px);
  }
}

// A sharp zona and blurred ones: what is said of the thickness goes with what can be seen of it.
TEST(SceneTracking, AThicknessIsAsSureAsTheOutlineIsSharp) {
  TrackerOptions options;
  options.detection = TrackerOptions::Detection::kScene;
  std::vector<double> sigma_px, off_sigmas;
  for (std::uint64_t seed = kFirst; seed < kFirst + kFilms; ++seed) {
    const RandomFilm film = draw_film(Split::kValidation, seed, 640);
    VirtualMicroscope microscope(film.scenario, film.look);
    MembraneTracker tracker(options);
    const auto frame = microscope.next();
    const Observation seen = tracker.process(view_of(frame->image.get()), 0.0, 0);
    const Observation& truth = microscope.truth().observation;
    if (!seen.outer || !truth.outer || !(seen.rest_inner_radius_um > 0.0)) continue;
    const double thickness_um = seen.rest_outer_radius_um - seen.rest_inner_radius_um;
    const double true_um = truth.rest_outer_radius_um - truth.rest_inner_radius_um;
    sigma_px.push_back(seen.rest_thickness_sigma_um / film.scenario.image.pixel_size_um);
    off_sigmas.push_back(std::abs(thickness_um - true_um) / seen.rest_thickness_sigma_um);
  }
  std::printf("%zu films: sigma %.2f to %.2f px; off by %.2f of it in the median, %.2f at 80 %%\n", sigma_px.size(),
              share_of(sigma_px, 0.0), share_of(sigma_px, 1.0), share_of(off_sigmas, 0.5), share_of(off_sigmas, 0.8));
  ASSERT_GE(sigma_px.size(), 8U);
  EXPECT_LT(share_of(sigma_px, 0.25), 0.4);
  EXPECT_GT(share_of(sigma_px, 1.0), 2.5 * share_of(sigma_px, 0.0));
  EXPECT_LT(share_of(off_sigmas, 0.8), 1.5);
}

// A wrong pixel size: no cell of the kind is as large, and what was seen says so.
TEST(SceneTracking, ACellOfNoSizeOfTheKindIsReportedAsRefused) {
  const RandomFilm film = draw_film(Split::kTuning, 178113, 640);
  VirtualMicroscope microscope(film.scenario, film.look);
  const auto frame = microscope.next();
  const double radius_um = microscope.truth().observation.rest_outer_radius_um;
  const auto seen_at = [&](double too_large) {
    TrackerOptions options;
    options.expected_radius_um = radius_um;
    ImageView view = view_of(frame->image.get());
    view.pixel_size_um *= too_large;
    return MembraneTracker(options).process(view, 0.0, 0);
  };
  const Observation right = seen_at(1.0), wrong = seen_at(4.0);
  EXPECT_TRUE(right.outer);
  EXPECT_EQ(right.refused_radius_um, 0.0);
  EXPECT_FALSE(wrong.outer);
  EXPECT_NEAR(wrong.refused_radius_um, 4.0 * radius_um, 0.2 * radius_um);
}

}  // namespace
}  // namespace pellucida::test
