#include "presenters/StatusPresenter.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

bool same(const Color& a, const Color& b) {
  return a.css() == b.css();
}

Measurement touching() {
  Measurement m;
  m.state = CellState::kContact;
  m.confidence = 0.93;
  m.indentation_um = 23.4;
  m.contact_force_uN = 3.42;
  m.contact_force_lower_uN = 3.10;
  m.contact_force_upper_uN = 3.75;
  m.pressure_Pa = 152.0;
  m.frame_age_ms = 18.2;
  return m;
}

TEST(StatusPresenter, ShowsTheRowsFigures) {
  StatusPresenter presenter;
  LiveStatus status;
  status.frame_count = 5;
  const StatusTexts texts = presenter.update(status, touching(), false, 1.0);
  EXPECT_EQ(texts.state.text, "Contact");
  EXPECT_TRUE(same(texts.state.color, state_color(CellState::kContact)));
  EXPECT_EQ(texts.indentation.text, "23.4 µm");
  EXPECT_EQ(texts.force.text, "3.42 µN");
  EXPECT_EQ(texts.force_interval, "95 %: 3.10 – 3.75 µN");
  EXPECT_EQ(texts.pressure.text, "152 Pa");
  EXPECT_EQ(texts.confidence.text, "93 %");
  EXPECT_EQ(texts.frame_age.text, "Frame age 18 ms");
  EXPECT_EQ(texts.notice.text, "");
}

TEST(StatusPresenter, BeforeTheFirstRowThereAreDashes) {
  StatusPresenter presenter;
  const StatusTexts texts = presenter.update({}, std::nullopt, false, 0.0);
  EXPECT_EQ(texts.state.text, "Waiting");
  EXPECT_EQ(texts.force.text, "–");
  EXPECT_EQ(texts.force_interval, "");
  EXPECT_EQ(texts.confidence.text, "–");
  EXPECT_EQ(texts.notice.text, "Waiting for the first frame");
}

TEST(StatusPresenter, CountsFramesASecond) {
  StatusPresenter presenter;
  LiveStatus status;
  StatusTexts texts;
  for (int i = 0; i <= 30; ++i) {
    status.measured_count = static_cast<std::uint64_t>(3 * i);
    texts = presenter.update(status, touching(), false, 0.1 * i);
  }
  EXPECT_EQ(texts.frame_rate.text, "30.0 frames/s");
  EXPECT_EQ(presenter.update(status, touching(), true, 3.1).frame_rate.text, "– frames/s");
}

TEST(StatusPresenter, WarnsOfOldFramesAndWeakMeasurements) {
  StatusPresenter presenter;
  LiveStatus status;
  status.frame_count = 5;
  status.frame_age_ms = 400.0;
  Measurement m = touching();
  m.confidence = 0.3;
  EXPECT_TRUE(same(presenter.update(status, m, false, 0.0).frame_age.color, palette::kWarning));
  EXPECT_TRUE(same(presenter.update(status, m, false, 0.0).confidence.color, palette::kWarning));
  // A paused picture is old on purpose.
  EXPECT_TRUE(same(presenter.update(status, m, true, 0.0).frame_age.color, palette::kTextDim));
}

TEST(StatusPresenter, TheWorstLossIsTheOneNamed) {
  StatusPresenter presenter;
  LiveStatus status;
  status.skipped_count = 3;
  EXPECT_EQ(presenter.update(status, touching(), false, 0.0).lost.text, "3 frames not measured");
  status.gap_count = 1;
  EXPECT_EQ(presenter.update(status, touching(), false, 0.0).lost.text, "1 frame lost by the source");
  status.recorder_dropped_count = 2;
  const StatusTexts texts = presenter.update(status, touching(), false, 0.0);
  EXPECT_EQ(texts.lost.text, "2 frames recorded without their image");
  EXPECT_TRUE(same(texts.lost.color, palette::kRecord));
}

TEST(StatusPresenter, TellsWhetherAndWhereItRecords) {
  StatusPresenter presenter;
  LiveStatus status;
  EXPECT_EQ(presenter.update(status, touching(), false, 0.0).recording.text, "Not recording");
  status.recording = true;
  status.recording_folder = "/data/cell";
  status.recorded_count = 12;
  EXPECT_EQ(presenter.update(status, touching(), false, 0.0).recording.text, "Recording to /data/cell, 12 frames");
  EXPECT_EQ(presenter.update(status, touching(), true, 0.0).recording.text, "Recording paused, /data/cell, 12 frames");
  status.recording = false;
  EXPECT_EQ(presenter.update(status, touching(), false, 0.0).recording.text, "Recorded in /data/cell");
  status.waiting_note_count = 2;
  EXPECT_EQ(presenter.update(status, touching(), false, 0.0).recording.text,
            "Recorded in /data/cell, 2 notes wait for the next recording");
}

TEST(StatusPresenter, AFaultIsMoreImportantThanAnythingElse) {
  StatusPresenter presenter;
  LiveStatus status;
  status.finished = true;
  EXPECT_EQ(presenter.update(status, touching(), true, 0.0).notice.text, "The source has ended");
  status.fault = "frame 12: the file is cut off";
  EXPECT_EQ(presenter.update(status, touching(), true, 0.0).notice.text, "frame 12: the file is cut off");
}

}  // namespace
}  // namespace pellucida
