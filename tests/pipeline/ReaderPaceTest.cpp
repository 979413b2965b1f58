#include "ReaderPace.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace pellucida {
namespace {

using std::chrono::milliseconds;

class ReaderPaceTest : public testing::Test {
 protected:
  ReaderTurn next() { return pace_.next_turn(stop_.get_token()); }

  SteadyClock clock_;
  ReaderPace pace_{clock_};
  std::stop_source stop_;
};

TEST_F(ReaderPaceTest, ReadsUntilThereIsAnotherTurn) {
  EXPECT_EQ(next(), ReaderTurn::kRead);
  EXPECT_EQ(next(), ReaderTurn::kRead);
  stop_.request_stop();
  EXPECT_EQ(next(), ReaderTurn::kStop);
}

TEST_F(ReaderPaceTest, APauseIsReportedOnceAtItsBeginningAndOnceAtItsEnd) {
  pace_.set_paused(true);
  EXPECT_TRUE(pace_.paused());
  EXPECT_EQ(next(), ReaderTurn::kPaused);
  std::jthread button([&] {
    std::this_thread::sleep_for(milliseconds(20));
    pace_.set_paused(false);
  });
  EXPECT_EQ(next(), ReaderTurn::kResumed);  // waits for the button
  EXPECT_EQ(next(), ReaderTurn::kRead);
}

TEST_F(ReaderPaceTest, APauseTheReaderNeverSawIsNotReported) {
  pace_.set_paused(true);
  pace_.set_paused(false);
  EXPECT_EQ(next(), ReaderTurn::kRead);
}

TEST_F(ReaderPaceTest, ARestartIsDoneAtOnceAlsoInAPauseAndAfterTheEnd) {
  pace_.end();
  EXPECT_TRUE(pace_.ended());
  pace_.ask_restart();
  EXPECT_EQ(next(), ReaderTurn::kRestart);
  EXPECT_FALSE(pace_.ended());
  pace_.set_paused(true);
  EXPECT_EQ(next(), ReaderTurn::kPaused);
  pace_.ask_restart();
  EXPECT_EQ(next(), ReaderTurn::kRestart);
  pace_.set_paused(false);
  EXPECT_EQ(next(), ReaderTurn::kResumed);
}

TEST_F(ReaderPaceTest, AWaitingReaderCanBeStopped) {
  pace_.end();
  std::jthread owner([&] {
    std::this_thread::sleep_for(milliseconds(20));
    stop_.request_stop();
  });
  EXPECT_EQ(next(), ReaderTurn::kStop);
  EXPECT_FALSE(pace_.wait_until_due(1e6, stop_.get_token()));
}

TEST_F(ReaderPaceTest, ARecordingGoesAtItsOwnPaceAndAPauseDoesNotCount) {
  const double start_s = clock_.now_s();
  EXPECT_TRUE(pace_.wait_until_due(5.0, stop_.get_token()));  // the first frame is due at once
  EXPECT_TRUE(pace_.wait_until_due(5.05, stop_.get_token()));
  EXPECT_GE(clock_.now_s() - start_s, 0.05);
  pace_.set_paused(true);
  EXPECT_EQ(next(), ReaderTurn::kPaused);
  pace_.set_paused(false);
  EXPECT_EQ(next(), ReaderTurn::kResumed);
  const double resumed_s = clock_.now_s();
  EXPECT_TRUE(pace_.wait_until_due(60.0, stop_.get_token()));
  EXPECT_LT(clock_.now_s() - resumed_s, 30.0);
}

// The window, the hand and the reader at once.
TEST_F(ReaderPaceTest, AnyThreadMayAsk) {
  std::atomic<long> paused_count{0}, resumed_count{0}, restart_count{0}, read_count{0};
  std::jthread reader([&](std::stop_token stop) {
    for (;;) {
      switch (pace_.next_turn(stop)) {
        case ReaderTurn::kRead:
          if (++read_count % 50 == 0) pace_.end();
          break;
        case ReaderTurn::kPaused:
          ++paused_count;
          break;
        case ReaderTurn::kResumed:
          ++resumed_count;
          break;
        case ReaderTurn::kRestart:
          ++restart_count;
          break;
        case ReaderTurn::kStop:
          return;
      }
    }
  });
  {
    std::jthread window([&] {
      for (int i = 0; i < 500; ++i) pace_.set_paused(i % 2 == 0);
    });
    std::jthread other([&] {
      for (int i = 0; i < 500; ++i) {
        pace_.ask_restart();
        static_cast<void>(pace_.paused() || pace_.ended());
      }
    });
  }
  // It still reads; its source may end again on the way.
  const long before = read_count;
  while (read_count < before + 10) {
    pace_.ask_restart();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  reader.request_stop();
  reader.join();
  EXPECT_EQ(paused_count, resumed_count);
  EXPECT_GE(restart_count, 1);
}

// A clock that a test sets: no sleep, so that the figures don't depend on the machine.
TEST(ReaderPaceFigures, AreTimeTakenOverTimeDue) {
  ManualClock clock;
  ReaderPace pace(clock, 2.0);
  const std::stop_source stop;
  clock.set(10.0);
  EXPECT_TRUE(pace.wait_until_due(5.0, stop.get_token()));  // the first frame begins the pace
  EXPECT_EQ(pace.figures().error_ratio(), 0.0);
  clock.set(12.0);
  EXPECT_TRUE(pace.wait_until_due(9.0, stop.get_token()));  // four seconds of the recording in two: in time
  EXPECT_EQ(pace.figures().recorded_s(), 4.0);
  EXPECT_EQ(pace.figures().wall_s(), 2.0);
  EXPECT_EQ(pace.figures().error_ratio(), 0.0);
  EXPECT_EQ(pace.figures().largest_lateness_s, 0.0);
  clock.set(15.3);
  EXPECT_TRUE(pace.wait_until_due(15.0, stop.get_token()));  // due at 15.0
  EXPECT_NEAR(pace.figures().largest_lateness_s, 0.3, 1e-12);
  EXPECT_NEAR(pace.figures().error_ratio(), 0.06, 1e-12);
  clock.set(20.0);
  EXPECT_TRUE(pace.wait_until_due(25.0, stop.get_token()));  // due at 20.0: a late frame moves none after it
  EXPECT_EQ(pace.figures().error_ratio(), 0.0);
  EXPECT_NEAR(pace.figures().largest_lateness_s, 0.3, 1e-12);
}

}  // namespace
}  // namespace pellucida
