#include "pellucida/batch/RecordingSummary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "TestSessions.h"
#include "pellucida/core/TemporaryFolder.h"

namespace pellucida {
namespace {

constexpr double kNoForce = std::numeric_limits<double>::quiet_NaN();

TEST(RecordingSummary, NumbersAreThoseOfTheSession) {
  const TemporaryFolder folder;
  // The needle comes back harder after the puncture: the peak is not the puncture's.
  test::write_session(folder / "s", {0.0, 1.0, 3.0, kNoForce, 0.0, 4.0},
                      {{0.1, event_kind::kWarning, "mismatch+slip: contour 3.0 um from the model"},
                       {0.2, event_kind::kWarning, "slip: contour 3.0 um from the model"},
                       {0.4, event_kind::kPuncture, "at 3.00 uN and 4.0 um"},
                       {0.5, event_kind::kPuncture, "at 4.00 uN and 10.0 um"}});
  const RecordingSummary s = summarize_recording(folder / "s");
  EXPECT_EQ(s.frame_count, 6);
  EXPECT_NEAR(s.duration_s, 0.5, 1e-12);
  EXPECT_NEAR(s.measured_share, 5.0 / 6.0, 1e-12);
  EXPECT_EQ(s.peak_force_uN, 4.0);
  EXPECT_NEAR(s.peak_force_lower_uN, 3.6, 1e-9);
  EXPECT_NEAR(s.peak_force_upper_uN, 4.4, 1e-9);
  EXPECT_NEAR(s.peak_picture_sigma_percent, 5.0, 1e-6);
  EXPECT_NEAR(s.peak_scale_sigma_percent, 40.0, 1e-6);
  EXPECT_EQ(s.peak_depth_um, 10.0);
  EXPECT_EQ(s.peak_stiffness_uN_per_um, 0.25);
  EXPECT_NEAR(s.puncture_time_s, 0.4, 1e-12);
  EXPECT_EQ(s.puncture_force_uN, 3.0);
  EXPECT_EQ(s.puncture_depth_um, 4.0);
  EXPECT_EQ(s.warning_count, 2);
  EXPECT_EQ(s.warnings, "mismatch 1; slip 2");
}

TEST(RecordingSummary, ARevokedPunctureIsNone) {
  const TemporaryFolder folder;
  const std::vector<double> forces{0.0, 1.0, 3.0, 3.5, 0.0};
  test::write_session(folder / "s", forces,
                      {{0.2, event_kind::kPuncture, "at 3.00 uN and 4.0 um"}, {0.3, event_kind::kRevoked, ""}});
  EXPECT_TRUE(std::isnan(summarize_recording(folder / "s").puncture_time_s));
  test::write_session(folder / "later", forces,
                      {{0.2, event_kind::kPuncture, "at 3.00 uN and 4.0 um"},
                       {0.3, event_kind::kRevoked, ""},
                       {0.4, event_kind::kPuncture, "at 3.50 uN and 5.0 um"}});
  EXPECT_NEAR(summarize_recording(folder / "later").puncture_time_s, 0.4, 1e-12);
}

TEST(RecordingSummary, WhatWasNotMeasuredIsNoNumber) {
  const TemporaryFolder folder;
  test::write_session(folder / "s", {kNoForce, 0.0});
  const RecordingSummary s = summarize_recording(folder / "s");
  EXPECT_EQ(s.measured_share, 0.5);
  EXPECT_TRUE(std::isnan(s.peak_force_uN));
  EXPECT_TRUE(std::isnan(s.puncture_force_uN));
  EXPECT_EQ(s.warnings, "");
  test::write_session(folder / "none", {});
  EXPECT_EQ(summarize_recording(folder / "none").frame_count, 0);
  EXPECT_TRUE(std::isnan(summarize_recording(folder / "none").measured_share));
}

}  // namespace
}  // namespace pellucida
