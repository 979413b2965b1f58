#include "StreamFacts.h"

#include <gtest/gtest.h>

#include "RecordedSession.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/report/PassportReport.h"

namespace pellucida {
namespace {

using test::SyntheticRows;

SyntheticRows some_rows() {
  SyntheticRows rows;
  rows.approach(10);
  rows.push(0.5, 8.0, test::linear);
  return rows;
}

// A session of these rows, read again, and its report.
class StreamFacts : public testing::Test {
 protected:
  SessionReader session_of(const SyntheticRows& rows, const SessionInfo& info = {}) {
    test::write_session(folder_ / "s", rows, 1.02, info);
    return SessionReader(folder_ / "s");
  }
  TemporaryFolder folder_;
};

constexpr const char* kClocks =
    R"({"session":"source","hand":"run","injector":"run","source_to_run":{"offset_s":0.0123,"drift_ppm":-41.26,)"
    R"("drift_sigma_ppm":1.5,"scatter_s":0.00042,"pair_count":118},"pairs_source_s_run_s":[[0,0.0123]]})";

TEST_F(StreamFacts, TheClocksOfALiveRecordingAreTold) {
  SessionInfo info;
  info.source.live = true;
  info.clocks_json = kClocks;
  const SessionReader session = session_of(some_rows(), info);
  const std::string words = clock_words(session);
  for (const char* part : {"frames on the source's", "injector on the computer's", "12.3 ms ahead", "118 pairs"}) {
    EXPECT_NE(words.find(part), std::string::npos) << part << ": " << words;
  }
  EXPECT_NE(words.find("41.3"), std::string::npos) << words;
  EXPECT_NE(words.find("1.5 ppm"), std::string::npos) << words;
  EXPECT_NE(words.find("0.42 ms of scatter"), std::string::npos) << words;
  // No hand was recorded.
  EXPECT_EQ(words.find("hand"), std::string::npos) << words;
  const PassportInput input = passport_input(session);
  EXPECT_NE(passport_page(session, input, cell_passports(input)).find("<dt>Clocks</dt>"), std::string::npos);
}

TEST_F(StreamFacts, AShortRunHasNoDrift) {
  SessionInfo info;
  info.source.live = true;
  info.clocks_json = R"({"session":"source","injector":"run","pairs_source_s_run_s":[[0,0.1]]})";
  EXPECT_NE(clock_words(session_of(some_rows(), info)).find("too short"), std::string::npos);
}

TEST_F(StreamFacts, ARecordingsOwnTimesAreTheOnlyClock) {
  EXPECT_NE(clock_words(session_of(some_rows())).find("one: the source's"), std::string::npos);
}

TEST_F(StreamFacts, ALiveRecordingOfAnEarlierVersionSaysNothing) {
  SessionInfo info;
  info.source.live = true;
  EXPECT_EQ(clock_words(session_of(some_rows(), info)), "not recorded");
}

// What a stranger wrote there.
TEST_F(StreamFacts, StrangeClocksAreNoClocks) {
  for (const char* text : {"[1,2]", "7", R"({"session":{},"source_to_run":{"offset_s":"x"}})",
                           R"({"session":"source","injector":"run","source_to_run":[1]})"}) {
    const TemporaryFolder folder;
    SessionInfo info;
    info.source.live = true;
    info.clocks_json = text;
    test::write_session(folder / "s", some_rows(), 1.02, info);
    const std::string words = clock_words(SessionReader(folder / "s"));
    EXPECT_TRUE(words == "not recorded" || words.find("too short") != std::string::npos) << text << ": " << words;
  }
}

TEST_F(StreamFacts, WholeFramesAreNotCounted) {
  const SessionReader session = session_of(some_rows());
  EXPECT_EQ(incomplete_frame_words(session), "none");
  EXPECT_TRUE(frame_doubts(session).empty());
}

TEST_F(StreamFacts, LostDamagedAndUnmeasuredFramesAreCounted) {
  SyntheticRows rows;
  rows.approach(10);
  rows.event(event_kind::kGap, "3 frames missing from the source before frame 10");
  rows.event(event_kind::kDamaged, "from frame 10 on not decoded as recorded (Invalid data)");
  for (int i = 0; i < 4; ++i) rows.add(std::nullopt);
  rows.event(event_kind::kDamaged, "over, after 4 frames");
  rows.push(0.5, 4.0, test::linear);
  rows.event(event_kind::kDropped, "2 frames (3 to 4) kept without their image: the disk is too slow");
  rows.event(event_kind::kThinned, "1 frame (5) kept without their surface: the disk is too slow");
  for (int i = 0; i < 2; ++i) rows.add(std::nullopt);
  const SessionReader session = session_of(rows);
  EXPECT_EQ(incomplete_frame_words(session),
            "3 lost by the source, 4 damaged, 2 without image for want of time, 1 without surface for want of time, "
            "2 not measured");
  ASSERT_EQ(frame_doubts(session).size(), 1U);
  EXPECT_NE(frame_doubts(session)[0].find("4 frames of the source could not be decoded"), std::string::npos);
}

TEST_F(StreamFacts, ADamageToTheEndCountsTheRowsBehindIt) {
  SyntheticRows rows;
  rows.approach(10);
  rows.event(event_kind::kDamaged, "from frame 10 on not decoded as recorded");
  for (int i = 0; i < 5; ++i) rows.add(std::nullopt);
  const SessionReader session = session_of(rows);
  EXPECT_EQ(incomplete_frame_words(session), "5 damaged (to the end)");
  EXPECT_NE(frame_doubts(session).at(0).find("to the end"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
