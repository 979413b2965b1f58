#include "presenters/StatusPresenter.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

bool same(const Color& a, const Color& b) {
  return a.css() == b.css();
}

Scene touching() {
  Scene scene;
  scene.measurement.state = CellState::kContact;
  scene.measurement.contact_force_uN = 3.42;
  scene.measurement.frame_age_ms = 18.2;
  return scene;
}

TEST(StatusPresenter, ShowsTheAgeOfTheSceneShown) {
  StatusPresenter presenter;
  LiveStatus status;
  status.frame_count = 5;
  const Scene scene = touching();
  const StatusTexts texts = presenter.update(status, &scene, false, 0, 1.0);
  EXPECT_EQ(texts.frame_age.text, "Frame age 18 ms");
  EXPECT_EQ(texts.notice.text, "");
}

TEST(StatusPresenter, BeforeTheFirstSceneThereIsADash) {
  StatusPresenter presenter;
  const StatusTexts texts = presenter.update({}, nullptr, false, 0, 0.0);
  EXPECT_EQ(texts.frame_age.text, "Frame age –");
  EXPECT_EQ(texts.notice.text, "Waiting for the first frame");
}

TEST(StatusPresenter, WhatIsWrongWithTheForceIsTheNotice) {
  StatusPresenter presenter;
  LiveStatus status;
  status.frame_count = 5;
  Scene scene = touching();
  scene.remarks.reason = "check the pixel size";
  EXPECT_EQ(presenter.update(status, &scene, false, 0, 0.0).notice.text, "No force: check the pixel size");
  EXPECT_EQ(presenter.update(status, &scene, true, 0, 0.0).notice.text, "Paused");
}

// A slow display skips scenes that were measured.
TEST(StatusPresenter, CountsFramesMeasuredAndDrawnASecond) {
  StatusPresenter presenter;
  LiveStatus status;
  const Scene scene = touching();
  StatusTexts texts;
  for (int i = 0; i <= 30; ++i) {
    status.measured_count = static_cast<std::uint64_t>(3 * i);
    texts = presenter.update(status, &scene, false, static_cast<std::uint64_t>(i), 0.1 * i);
  }
  EXPECT_EQ(texts.frame_rate.text, "Frames/s: 30.0 measured, 10.0 drawn");
  EXPECT_EQ(presenter.update(status, &scene, true, 30, 3.1).frame_rate.text, "Frames/s: – measured, – drawn");
}

TEST(StatusPresenter, WarnsOfOldFrames) {
  StatusPresenter presenter;
  LiveStatus status;
  status.frame_count = 5;
  status.frame_age_ms = 400.0;
  const Scene scene = touching();
  EXPECT_TRUE(same(presenter.update(status, &scene, false, 0, 0.0).frame_age.color, palette::kWarning));
  // A paused picture is old on purpose.
  EXPECT_TRUE(same(presenter.update(status, &scene, true, 0, 0.0).frame_age.color, palette::kTextDim));
}

TEST(StatusPresenter, TheWorstLossIsTheOneNamed) {
  StatusPresenter presenter;
  LiveStatus status;
  status.skipped_count = 3;
  EXPECT_EQ(presenter.update(status, nullptr, false, 0, 0.0).lost.text, "3 frames not measured");
  status.gap_count = 1;
  EXPECT_EQ(presenter.update(status, nullptr, false, 0, 0.0).lost.text, "1 frame lost by the source");
  status.recorder_thinned_count = 5;
  EXPECT_EQ(presenter.update(status, nullptr, false, 0, 0.0).lost.text, "5 frames recorded without their surface");
  status.recorder_dropped_count = 2;
  const StatusTexts texts = presenter.update(status, nullptr, false, 0, 0.0);
  EXPECT_EQ(texts.lost.text, "2 frames recorded without their image");
  EXPECT_TRUE(same(texts.lost.color, palette::kRecord));
}

TEST(StatusPresenter, TellsWhetherAndWhereItRecords) {
  StatusPresenter presenter;
  LiveStatus status;
  EXPECT_EQ(presenter.update(status, nullptr, false, 0, 0.0).recording.text, "Not recording");
  status.recording = true;
  status.recording_folder = "/data/cell";
  status.recorded_count = 12;
  EXPECT_EQ(presenter.update(status, nullptr, false, 0, 0.0).recording.text, "Recording to /data/cell, 12 frames");
  EXPECT_EQ(presenter.update(status, nullptr, true, 0, 0.0).recording.text, "Recording paused, /data/cell, 12 frames");
  status.recording = false;
  EXPECT_EQ(presenter.update(status, nullptr, false, 0, 0.0).recording.text, "Recorded in /data/cell");
  status.waiting_note_count = 2;
  EXPECT_EQ(presenter.update(status, nullptr, false, 0, 0.0).recording.text,
            "Recorded in /data/cell, 2 notes wait for the next recording");
}

TEST(StatusPresenter, AFaultIsMoreImportantThanAnythingElse) {
  StatusPresenter presenter;
  LiveStatus status;
  status.finished = true;
  EXPECT_EQ(presenter.update(status, nullptr, true, 0, 0.0).notice.text, "The source has ended");
  status.fault = "frame 12: the file is cut off";
  EXPECT_EQ(presenter.update(status, nullptr, true, 0, 0.0).notice.text, "frame 12: the file is cut off");
}

}  // namespace
}  // namespace pellucida
