// The picture about a needle's tip shows whether the membrane lies on it, in films of families that the network wasn't
// trained on.
#include "PunctureNetwork.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <optional>

#include "films/RandomFilm.h"
#include "pellucida/core/NeedleContact.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida::test {
namespace {

constexpr std::uint64_t kFirstPierced = 3101;
constexpr int kFilmsPierced = 20;
constexpr long kFramesAfter = 3;

struct Looks {
  std::optional<double> pushed, pierced;  // in the last frame in contact, and some frames after that
};

Looks look_at(const RandomFilm& film, PunctureNetwork& network) {
  const auto read = [&](VirtualMicroscope& microscope) -> std::optional<double> {
    const auto frame = microscope.next();
    const Observation& truth = microscope.truth().observation;
    const double pixel_um = film.scenario.image.pixel_size_um;
    const double depth_px = needle_contact(truth).tip_depth_um / pixel_um;
    if (depth_px < PunctureNetwork::kLeastDepth_px) return std::nullopt;
    const FrameSampler image(view_of(frame->image.get()));
    return network.read(image, {truth.needle->tip_um / pixel_um, truth.needle->direction}, depth_px,
                        truth.center_um / pixel_um);
  };
  const long frames = *VirtualMicroscope(film.scenario).info().frame_count;
  const long first = first_frame_in(film, CellState::kPunctured);
  if (first == 0 || first + kFramesAfter >= frames) return {};
  VirtualMicroscope microscope(film.scenario, film.look);
  for (long k = 0; k + 1 < first; ++k) microscope.skip();
  Looks looks;
  looks.pushed = read(microscope);
  for (long k = 1; k < kFramesAfter; ++k) microscope.skip();
  looks.pierced = read(microscope);
  return looks;
}

TEST(PunctureNetwork, APictureShowsWhetherTheMembraneLiesOnTheTip) {
  PunctureNetwork network;
  int punctures = 0, seen_pushed = 0, seen_pierced = 0, wrong_and_sure = 0;
  for (std::uint64_t seed = kFirstPierced; punctures < kFilmsPierced; ++seed) {
    const RandomFilm film = draw_film(Split::kValidation, seed, 640);
    if (!film.scenario.puncture.enabled) continue;
    const Looks looks = look_at(film, network);
    if (!looks.pushed || !looks.pierced) continue;
    ++punctures;
    seen_pushed += *looks.pushed < 0.5;
    seen_pierced += *looks.pierced > 0.5;
    wrong_and_sure += (*looks.pushed > 0.97) + (*looks.pierced < 0.03);
  }
  std::printf("of %d punctures %d seen pushed before, %d pierced after, %d wrong and sure\n", punctures, seen_pushed,
              seen_pierced, wrong_and_sure);
  EXPECT_GE(seen_pushed, 18);
  EXPECT_GE(seen_pierced, 18);
  EXPECT_LE(wrong_and_sure, 1);
}

}  // namespace
}  // namespace pellucida::test
