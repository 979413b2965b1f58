#include "films/RandomFilm.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "pellucida/core/Error.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida::test {
namespace {

constexpr std::uint64_t kFilms = 12;
constexpr std::array kSplits{Split::kTuning, Split::kValidation, Split::kWide, Split::kUnseen};

TEST(RandomFilm, IsWholeAndInItsRanges) {
  for (const Split split : kSplits)
    for (std::uint64_t seed = 1; seed <= kFilms; ++seed) {
      const RandomFilm film = draw_film(split, seed);
      SCOPED_TRACE(film.look.name);
      const VirtualMicroscope microscope(film.scenario, film.look);  // checks every range
      const long frames = *microscope.info().frame_count;
      EXPECT_GE(frames, 30);
      EXPECT_LE(frames, 60);
      const Scenario& s = film.scenario;
      const double pixel_um = s.image.pixel_size_um, radius_um = 52.5 * s.cell.size_scale;
      EXPECT_GE(pixel_um, 0.2 - 1e-9);
      EXPECT_LE(pixel_um, 2.0 + 1e-9);
      EXPECT_GE(2 * radius_um / pixel_um, 59.9);
      EXPECT_LE(2 * radius_um / pixel_um, 500.1);
      EXPECT_EQ(s.cell.in_view, film.contrast != "none");
      // The whole cell is in the picture.
      EXPECT_GT(s.cell.center_x_um, radius_um);
      EXPECT_GT(s.cell.center_y_um, radius_um);
      EXPECT_LT(s.cell.center_x_um, pixel_um * s.image.width_px - radius_um);
      EXPECT_LT(s.cell.center_y_um, pixel_um * s.image.height_px - radius_um);
    }
}

TEST(RandomFilm, SameSeedSameFilmAndFamiliesKeptApart) {
  std::array<std::set<std::string>, kSplits.size()> families;
  for (const Split split : kSplits)
    for (std::uint64_t seed = 1; seed <= kFilms; ++seed) {
      const RandomFilm one = draw_film(split, seed), two = draw_film(split, seed);
      EXPECT_EQ(one.family, two.family);
      EXPECT_EQ(one.scenario.tools.holder_angle_deg, two.scenario.tools.holder_angle_deg);
      EXPECT_EQ(one.scenario.motion.indentation_um, two.scenario.motion.indentation_um);
      EXPECT_EQ(one.look.contrast.defocus_um, two.look.contrast.defocus_um);
      families[static_cast<std::size_t>(split)].insert(one.family);
    }
  std::set<std::string> known;
  for (const std::set<std::string>& some : families) {
    EXPECT_GE(some.size(), 4u);
    for (const std::string& family : some) EXPECT_TRUE(known.insert(family).second) << family;
  }
  EXPECT_NE(draw_film(Split::kTuning, 1).scenario.tools.holder_angle_deg,
            draw_film(Split::kTuning, 2).scenario.tools.holder_angle_deg);
  EXPECT_THROW(split_of("test"), UsageError);
}

}  // namespace
}  // namespace pellucida::test
