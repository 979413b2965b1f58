#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "support/RunProgram.h"
#include "support/WaitUntil.h"

// What a command leaves behind: no input overwritten, no older result torn, a session closed when a signal comes.

namespace pellucida {
namespace {

namespace fs = std::filesystem;

class Outputs : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = test::fresh_folder(std::string("outputs_") + info->name(), testing::TempDir());
  }
  std::string at(const std::string& name) const {
    std::string text(1, '\'');
    text += (folder_ / name).string();
    text += '\'';
    return text;
  }
  test::Outcome run(const std::string& arguments) const { return test::run_program(arguments, folder_ / "run"); }

  fs::path folder_;
};

TEST_F(Outputs, AnInputIsNeverOverwritten) {
  const fs::path shipped = fs::path(PELLUCIDA_SOURCE_DIR) / "resources/profiles/mouse-oocyte.json";
  fs::copy_file(shipped, folder_ / "own.json");
  fs::create_hard_link(folder_ / "own.json", folder_ / "same.csv");
  EXPECT_EQ(run("force " + at("own.json") + " --output " + at("own.json")).exit_code, 2);
  EXPECT_EQ(run("force " + at("own.json") + " --output " + at("same.csv")).exit_code, 2);
  EXPECT_EQ(run("identify --from " + at("own.json") + " --keep-constants --output " + at("own.json")).exit_code, 2);
  EXPECT_EQ(test::text_of(folder_ / "own.json"), test::text_of(shipped));
  test::put(folder_ / "c.csv", "indentation_um,force_uN\n0,0\n10,1\n20,3\n30,5\n");
  EXPECT_EQ(run("identify --measured-curve " + at("c.csv") + " --output " + at("c.csv")).exit_code, 2);
  EXPECT_TRUE(test::text_of(folder_ / "c.csv").starts_with("indentation_um,force_uN\n0,0"));
}

TEST_F(Outputs, AFileTooLargeLeavesTheOlderOne) {
  test::put(folder_ / "f.csv", "older");
  // The program's files may have one block of 512 bytes.
  const std::string limited = "sh -c 'ulimit -f 1; exec \"$0\" \"$@\"' " PELLUCIDA_PROGRAM
                              " force mouse-oocyte --step-um 1 --replace --output " +
                              at("f.csv") + " 2>/dev/null";
  const int status = std::system(limited.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 5);
  EXPECT_EQ(test::text_of(folder_ / "f.csv"), "older");
  EXPECT_FALSE(fs::exists(folder_ / "f.csv.tmp"));
}

TEST_F(Outputs, WhatCantBePrintedIsNoSuccess) {
  ASSERT_TRUE(fs::is_character_file("/dev/full"));
  const int status = std::system(PELLUCIDA_PROGRAM " --version >/dev/full 2>/dev/null");
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 5);
}

TEST_F(Outputs, FilesAreReplacedOnRequestAlone) {
  const std::string film = "simulate --duration-s 0.2 --fps 10 --output " + at("r.avi");
  const std::string curve = "force mouse-oocyte --max-indentation-um 4 --step-um 4 --output " + at("r.csv");
  const std::string bench = "bench tracking --seconds 0.1 --json " + at("r.json");
  for (const std::string& command : {film, curve, bench}) {
    ASSERT_EQ(run(command).exit_code, 0);
    const auto again = run(command);
    EXPECT_EQ(again.exit_code, 2);
    EXPECT_NE(again.err.find("already there"), std::string::npos) << again.err;
    EXPECT_NE(again.err.find("--replace"), std::string::npos) << again.err;
    EXPECT_EQ(run(command + " --replace").exit_code, 0);
  }
  const auto picture = run("workstation --screenshot " + at("r.csv"));
  EXPECT_EQ(picture.exit_code, 2);
  EXPECT_NE(picture.err.find("already there"), std::string::npos) << picture.err;
}

TEST_F(Outputs, AFolderOfAnotherRunsImagesIsNotMixed) {
  const std::string simulate = "simulate --duration-s 0.2 --fps 10 --output " + at("frames");
  ASSERT_EQ(run(simulate).exit_code, 0);
  const auto again = run(simulate);
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_NE(again.err.find("already holds images"), std::string::npos) << again.err;
}

TEST_F(Outputs, NumbersThatMakeNoSenseAreRefused) {
  for (const char* arguments :
       {"force mouse-oocyte --step-um nan --output x.csv", "force mouse-oocyte --max-indentation-um inf --output x.csv",
        "identify --scale-uncertainty-percent nan --output x.json",
        "identify --young-modulus-kPa 1e300 --output x.json",
        "identify --puncture-force-uN 1e300 --puncture-indentation-um 30 --output x.json",
        "analyze v.avi --output s --known-force-sigma-percent nan", "simulate --seed -1 --output x",
        "inject --max-duration-s nan --output s", "inject --seed -1 --output s", "bench tracking --seconds inf",
        "bench tracking --seconds nan", "workstation --after -1", "workstation --after nan",
        "workstation --after 1e300", "trial --simulated --seed -1 --output t"}) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments << '\n' << outcome.err;
    // A range in words, not with 309 digits.
    EXPECT_LT(outcome.err.size(), 400U) << outcome.err;
  }
}

// A value that is refused leaves no session that blocks the corrected call.
TEST_F(Outputs, ARefusedStepLeavesNoSession) {
  const std::string analyze = "analyze virtual --output " + at("s") + " --revolve-step-deg ";
  EXPECT_EQ(run(analyze + "7").exit_code, 2);
  EXPECT_EQ(run(analyze + "0.001").exit_code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "s"));
}

TEST_F(Outputs, ASignalClosesTheSession) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const fs::path session = folder_ / std::to_string(number);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      const std::string err = (folder_ / "err.txt").string();
      if (!std::freopen("/dev/null", "w", stdout) || !std::freopen(err.c_str(), "w", stderr)) _exit(99);
      execl(PELLUCIDA_PROGRAM, "pellucida", "analyze", "virtual", "--output", session.c_str(), nullptr);
      _exit(99);
    }
    const auto rows = [&] {
      const std::string text = test::text_of(session / "measurements.csv");
      return std::count(text.begin(), text.end(), '\n');
    };
    ASSERT_TRUE(test::wait_until([&] { return rows() > 3; }));
    kill(child, number);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), number);
    const auto head = nlohmann::json::parse(test::text_of(session / "session.json"));
    EXPECT_EQ(head["complete"], true);
    EXPECT_NE(test::text_of(session / "events.csv").find("stopped"), std::string::npos);
    EXPECT_NE(test::text_of(folder_ / "err.txt").find("completing what is done"), std::string::npos);
    EXPECT_EQ(run("check '" + session.string() + "'").exit_code, 0);
  }
}

}  // namespace
}  // namespace pellucida
