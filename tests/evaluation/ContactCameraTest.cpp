#include "pellucida/evaluation/ContactCamera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/evaluation/Trial.h"

namespace pellucida {
namespace {

const TrialScene& scene() {
  static const TrialScene one;
  return one;
}

/// What a camera says of a tip held at `depth_um`, for `time_s`.
std::vector<ContactModel> frames_of(const ContactCameraOptions& options, double depth_um, double time_s,
                                    std::vector<double>* landed_s = nullptr) {
  SpecimenContact cell = scene().cell(1);
  const PlainVector3 tip_um = cell.force().tip_at(0.0, depth_um);
  ContactCamera camera(options, cell.force());
  std::vector<ContactModel> frames;
  for (int k = 0; k < std::lround(1000 * time_s); ++k) {
    const double now_s = 1e-3 * k;
    if (!camera.look(cell.advance(tip_um, now_s), now_s)) continue;
    frames.push_back(camera.newest());
    if (landed_s) landed_s->push_back(now_s);
  }
  return frames;
}

TEST(ContactCamera, LooksAtItsRateAndTellsItsDelayLater) {
  std::vector<double> landed_s;
  const auto frames = frames_of({}, 20.0, 2.0, &landed_s);
  EXPECT_NEAR(static_cast<double>(frames.size()), 30 * (2.0 - 0.04), 1.01);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    EXPECT_EQ(frames[k].frame_index, static_cast<long>(k));
    EXPECT_NEAR(landed_s[k] - frames[k].time_s, 0.04, 1.01e-3);
  }
}

TEST(ContactCamera, WithoutErrorsItTellsTheTruth) {
  ContactCameraOptions exact;
  exact.depth_sigma_um = exact.force_relative_sigma = exact.tip_sigma_um = 0.0;
  const SpecimenForce cell = scene().cell(1).force();
  const SpecimenReply truth = cell.at(cell.tip_at(0.0, 25.0));
  const ContactModel seen = frames_of(exact, 25.0, 0.2).back();
  EXPECT_EQ(seen.state, CellState::kContact);
  EXPECT_NEAR(seen.force_uN.eigen().norm(), truth.axial_force_uN, 1e-9);
  EXPECT_LT(seen.force_uN.eigen().dot(seen.push.eigen()), 0.0);
  EXPECT_NEAR(seen.depth_um, 25.0, 1e-9);
  EXPECT_NEAR(seen.stiffness_uN_per_um, truth.stiffness_uN_per_um, 1e-9);
  EXPECT_LT((seen.tip_um.eigen() - cell.tip_at(0.0, 25.0).eigen()).norm(), 1e-9);
}

TEST(ContactCamera, ErrorsAreAsLargeAsAskedAndTheSeedsOwn) {
  ContactCameraOptions options;
  options.seed = 7;
  const auto frames = frames_of(options, 25.0, 30.0);
  double sum = 0.0, sum2 = 0.0;
  for (const ContactModel& frame : frames) {
    sum += frame.depth_um - 25.0;
    sum2 += (frame.depth_um - 25.0) * (frame.depth_um - 25.0);
  }
  const auto count = static_cast<double>(frames.size());
  EXPECT_NEAR(sum / count, 0.0, 0.005);
  EXPECT_NEAR(std::sqrt(sum2 / count), 0.1, 0.0025);

  const auto again = frames_of(options, 25.0, 1.0);
  for (std::size_t k = 0; k < again.size(); ++k) EXPECT_EQ(again[k].depth_um, frames[k].depth_um);
  options.seed = 8;
  EXPECT_NE(frames_of(options, 25.0, 1.0).back().depth_um, again.back().depth_um);
}

TEST(ContactCamera, FeelsNothingOutsideTheCell) {
  const ContactModel seen = frames_of({}, -5.0, 0.2).back();
  EXPECT_EQ(seen.state, CellState::kFree);
  EXPECT_TRUE(seen.valid);
  EXPECT_EQ(seen.force_uN.eigen().norm(), 0.0);
}

TEST(ContactCamera, NumbersOutOfRangeAreRefused) {
  const SpecimenForce cell = scene().cell(1).force();
  ContactCameraOptions options;
  options.delay_s = 0.6;
  EXPECT_THROW(ContactCamera(options, cell), UsageError);
  options = {};
  options.frame_rate_hz = 0.0;
  EXPECT_THROW(ContactCamera(options, cell), UsageError);
  options = {};
  options.tip_sigma_um = -1.0;
  EXPECT_THROW(ContactCamera(options, cell), UsageError);
}

}  // namespace
}  // namespace pellucida
