#include "pellucida/batch/RecordingBatch.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <cmath>
#include <fstream>

#include "TestSessions.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "support/Files.h"

// The batch with a stand-in for the program: a shell script that copies a session, or fails as its input says.

namespace pellucida {
namespace {

namespace fs = std::filesystem;

class RecordingBatchTest : public testing::Test {
 protected:
  void SetUp() override {
    test::write_session(at("template"), {0.0, 1.0, 2.0});
    // $1 analyze, $2 the input, $3 --output, $4 the session's folder.
    test::put(at("program"),
              "#!/bin/sh\n"
              "echo \"$2 $5\" >> '" +
                  at("calls").string() +
                  "'\n"
                  "case \"$(cat \"$2\")\" in\n"
                  "  broken) echo 'noise of a library' >&2; echo \"pellucida: $2: broken\" >&2; exit 3;;\n"
                  "  crash) echo 'last words' >&2; kill -SEGV $$;;\n"
                  "  half) cp -r '" +
                  at("template").string() +
                  "' \"$4\"; echo 'pellucida: cut off' >&2; exit 3;;\n"
                  "  torn) mkdir \"$4\"; echo '{}' > \"$4/session.json\"; exit 1;;\n"
                  "  full) echo 'pellucida: no space' >&2; exit 5;;\n"
                  "  slow) sleep 60;;\n"
                  "esac\n"
                  "cp -r '" +
                  at("template").string() + "' \"$4\"\n");
    fs::permissions(at("program"), fs::perms::owner_all);
    settings_.program = at("program");
    settings_.output = at("out");
    settings_.recipe = {{"--option=1"}, "profile", "1"};
  }
  fs::path at(const std::string& name) const { return folder_ / name; }
  void add(const std::string& name, const std::string& kind) {
    test::put(at(name + ".avi"), kind);
    recordings_.push_back({name, at(name + ".avi").string(), "group"});
  }
  // "measured failed ..."
  std::string run() {
    rows_ = run_recordings(recordings_, settings_);
    std::string results;
    for (const BatchRow& row : rows_) results += (results.empty() ? "" : " ") + row.result;
    return results;
  }
  // How many recordings the program was called for since the last question.
  long calls() {
    const std::string text = test::text_of(at("calls"));
    fs::remove(at("calls"));
    return std::count(text.begin(), text.end(), '\n');
  }

  TemporaryFolder folder_;
  BatchSettings settings_;
  std::vector<Recording> recordings_;
  std::vector<BatchRow> rows_;
};

TEST_F(RecordingBatchTest, ABrokenOneNeverStopsTheRest) {
  add("a", "fine");
  add("b", "broken");
  add("c", "crash");
  add("d", "half");
  add("e", "torn");
  add("f", "fine");
  settings_.job_count = 3;
  int told = 0;
  settings_.finished = [&](std::span<const BatchRow> all, const BatchRow&) {
    EXPECT_EQ(all.size(), 6U);
    ++told;
  };
  EXPECT_EQ(run(), "measured failed failed damaged failed measured");
  EXPECT_EQ(told, 6);
  EXPECT_EQ(rows_[1].exit_code, 3);
  EXPECT_EQ(rows_[1].error, at("b.avi").string() + ": broken");
  EXPECT_EQ(rows_[2].exit_code, 128 + SIGSEGV);
  EXPECT_EQ(rows_[2].error, "ended by signal 11 (Segmentation fault); its last words: last words");
  EXPECT_EQ(rows_[3].error, "cut off");
  EXPECT_EQ(rows_[3].numbers.frame_count, 3);
  EXPECT_TRUE(fs::exists(at("out/a/session.json")));
  EXPECT_FALSE(fs::exists(at("out/e")));
  EXPECT_FALSE(fs::exists(at("out/.unfinished")));
}

TEST_F(RecordingBatchTest, ARerunDoesOnlyWhatIsMissingOrChanged) {
  add("a", "fine");
  add("b", "broken");
  add("c", "half");
  add("d", "fine");
  EXPECT_EQ(run(), "measured failed damaged measured");
  EXPECT_EQ(calls(), 4);
  const double first_s = rows_[0].wall_time_s;
  // Without a session there is nothing to keep.
  EXPECT_EQ(run(), "measured failed damaged measured");
  EXPECT_EQ(calls(), 1);
  EXPECT_EQ(rows_[0].wall_time_s, first_s);

  test::put(at("a.avi"), "fine, but another");
  test::put(at("b.avi"), "mended");
  fs::remove_all(at("out/d"));
  add("new", "fine");
  EXPECT_EQ(run(), "measured measured damaged measured measured");
  EXPECT_EQ(calls(), 4);

  settings_.recipe.options = {"--option=2"};
  run();
  EXPECT_EQ(calls(), 5);
  settings_.recipe.version = "2";
  run();
  EXPECT_EQ(calls(), 5);
  settings_.recipe.profile_sha256 = "other";
  run();
  EXPECT_EQ(calls(), 5);
  settings_.again = true;
  run();
  EXPECT_EQ(calls(), 5);
  settings_.again = false;
  EXPECT_TRUE(is_finished(recordings_[0], settings_));
  run();
  EXPECT_EQ(calls(), 0);
}

TEST_F(RecordingBatchTest, WhatItDidNotMakeIsNeverTouched) {
  add("a", "fine");
  add("b", "fine");
  fs::create_directories(at("out/a"));
  test::put(at("out/a/thesis.txt"), "years of work");
  EXPECT_EQ(run(), "failed measured");
  EXPECT_EQ(rows_[0].exit_code, 5);
  EXPECT_NE(rows_[0].error.find("holds something that this batch did not make"), std::string::npos) << rows_[0].error;
  EXPECT_EQ(test::text_of(at("out/a/thesis.txt")), "years of work");
  // Nor a result that somebody changed.
  test::put(at("out/b/session.json"), test::text_of(at("out/b/session.json")) + "\n");
  EXPECT_EQ(run(), "failed failed");
}

TEST_F(RecordingBatchTest, AStopLeavesTheRestWaiting) {
  add("a", "fine");
  add("b", "slow");
  add("c", "fine");
  int asked = 0;
  settings_.stop_signal = [&] {
    // Once the first is done and the second runs.
    return fs::exists(at("out/a/session.json")) && fs::exists(at("out/.unfinished/b")) && ++asked > 3 ? SIGTERM : 0;
  };
  EXPECT_EQ(run(), "measured waiting waiting");
  EXPECT_FALSE(fs::exists(at("out/.unfinished")));
  settings_.stop_signal = nullptr;
  test::put(at("b.avi"), "fine");
  calls();
  EXPECT_EQ(run(), "measured measured measured");
  EXPECT_EQ(calls(), 2);
}

// Each of the others would find out only after its work.
TEST_F(RecordingBatchTest, AFullDiskEndsTheBatch) {
  add("a", "fine");
  add("b", "full");
  add("c", "fine");
  EXPECT_THROW(run(), OutputError);
  EXPECT_EQ(calls(), 2);
  EXPECT_TRUE(fs::exists(at("out/a/session.json")));
  EXPECT_TRUE(fs::is_empty(at("out/.unfinished")));
}

TEST_F(RecordingBatchTest, CollectingAnalysesNothing) {
  add("a", "fine");
  add("b", "broken");
  run();
  add("c", "fine");
  calls();
  settings_.only_collect = true;
  EXPECT_EQ(run(), "measured failed waiting");
  EXPECT_EQ(rows_[1].error, at("b.avi").string() + ": broken");
  EXPECT_EQ(calls(), 0);
}

TEST(TimeLeft, FollowsTheBytes) {
  EXPECT_TRUE(std::isnan(estimate_left_s(5.0, 0.0, 100.0)));
  EXPECT_DOUBLE_EQ(estimate_left_s(5.0, 25.0, 100.0), 15.0);
  EXPECT_DOUBLE_EQ(estimate_left_s(5.0, 100.0, 100.0), 0.0);
}

}  // namespace
}  // namespace pellucida
