#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "pellucida/core/Table.h"
#include "support/RunProgram.h"

// A session as a source, as its user types it: measured again, varied, played, stepped through.

namespace pellucida {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::run_program;

class Replay : public testing::Test {
 protected:
  // One recording serves all the tests below: a quick push, 30 frames.
  static void SetUpTestSuite() {
    folder_ = test::fresh_folder("replay", testing::TempDir());
    test::put(folder_ / "quick.json",
              R"({"image": {"frame_rate_hz": 15, "duration_s": 2.0},
                  "motion": {"approach_speed_um_per_s": 120, "indentation_speed_um_per_s": 40, "hold_s": 0.1}})");
    const Outcome recorded =
        run("analyze virtual:" + (folder_ / "quick.json").string() + " --output " + session(), "record");
    ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
  }

  static Outcome run(const std::string& arguments, const std::string& name) {
    return run_program(arguments, folder_ / (name + "_output"));
  }
  static std::string session() { return (folder_ / "s").string(); }
  static std::string at(const std::string& name) { return (folder_ / name).string(); }

  static std::vector<std::string> lines_of(const std::string& file) {
    std::vector<std::string> lines;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }
  static bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

  static inline fs::path folder_;
};

TEST_F(Replay, TheSameAgainIsTheSame) {
  for (const std::string rerun : {"tracking", "mechanics"}) {
    const Outcome again = run("replay " + session() + " --rerun " + rerun + " --output " + at(rerun), rerun);
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_TRUE(has(again.out, "30 / 30")) << again.out;
    const Outcome check = run("check " + at(rerun), rerun + "_check");
    EXPECT_EQ(check.exit_code, 0) << check.out;
    EXPECT_EQ(lines_of(at(rerun) + "/changes.csv").size(), 2U);
    EXPECT_EQ(lines_of(at(rerun) + "/differences.csv").size(), 31U);
  }
}

TEST_F(Replay, SeveralModuliAreSeveralSessionsAndOneTable) {
  const Outcome varied =
      run("replay " + session() + " --vary young_modulus_kPa=100,200 --vary poisson_ratio=0.4 --output " + at("varied"),
          "varied");
  ASSERT_EQ(varied.exit_code, 0) << varied.err;
  const auto table = lines_of(at("varied") + "/changes.csv");
  ASSERT_EQ(table.size(), 3U);
  const auto header = split_csv(table[0]), first = split_csv(table[1]), second = split_csv(table[2]);
  ASSERT_EQ(first.size(), header.size());
  EXPECT_EQ(first[0], "young_modulus_kPa=100,poisson_ratio=0.4");
  const auto ratio = static_cast<std::size_t>(std::find(header.begin(), header.end(), "force_ratio") - header.begin());
  ASSERT_LT(ratio, header.size());
  EXPECT_NEAR(std::stod(second[ratio]) / std::stod(first[ratio]), 2.0, 1e-3);
  std::ifstream head(at("varied") + "/young_modulus_kPa=200,poisson_ratio=0.4/session.json");
  const auto json = nlohmann::json::parse(head);
  EXPECT_EQ(json.at("profile").at("content").at("material").at("effective_young_modulus_kPa"), 200.0);
  const auto& change = json.at("provenance").at("replay").at("changes").at("material.effective_young_modulus_kPa");
  EXPECT_EQ(change.at("replayed"), 200.0);
}

TEST_F(Replay, ASessionIsMeasuredLikeAVideo) {
  const Outcome analyzed = run("analyze " + session() + " --output " + at("analyzed"), "analyzed");
  ASSERT_EQ(analyzed.exit_code, 0) << analyzed.err;
  const auto recorded = lines_of(session() + "/measurements.csv"),
             again = lines_of(at("analyzed") + "/measurements.csv");
  ASSERT_EQ(recorded.size(), again.size());
  const auto header = split_csv(recorded[0]);
  for (std::size_t i = 1; i < recorded.size(); ++i) {
    const auto one = split_csv(recorded[i]), other = split_csv(again[i]);
    for (std::size_t k = 0; k < header.size(); ++k) {
      // A run's own clock, and the checksum of a row that holds it.
      if (header[k] == "frame_age_ms" || header[k] == "row_crc32") continue;
      EXPECT_EQ(one[k], other[k]) << header[k] << " in row " << i;
    }
  }
}

TEST_F(Replay, PlaysAndSaysHowWellItKeptTheTime) {
  const Outcome played = run("replay " + session() + " --speed 4", "played");
  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_TRUE(has(played.out, "30 frames shown")) << played.out;
  EXPECT_TRUE(has(played.out, "at 4 x")) << played.out;
  EXPECT_TRUE(has(played.out, "of the wall clock")) << played.out;
  const Outcome looped = run("replay " + session() + " --speed 20 --loop 2 --backwards --every 3", "looped");
  ASSERT_EQ(looped.exit_code, 0) << looped.err;
  EXPECT_TRUE(has(looped.out, "20 frames shown")) << looped.out;
}

TEST_F(Replay, StepsForwardsAndBack) {
  test::put(folder_ / "keys", "\n\nb\n\n\nx\nq\n");
  const std::string command =
      "'" PELLUCIDA_PROGRAM "' replay " + session() + " --step <" + at("keys") + " >" + at("steps") + " 2>/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const auto lines = lines_of(at("steps"));
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_TRUE(lines[0].starts_with("frame 0 ")) << lines[0];
  EXPECT_TRUE(lines[0].ends_with("as recorded")) << lines[0];
  EXPECT_TRUE(lines[1].starts_with("frame 1 ")) << lines[1];
  EXPECT_EQ(lines[2], lines[0]);  // back, without measuring anything again
  EXPECT_EQ(lines[3], lines[1]);
  EXPECT_TRUE(lines[4].starts_with("frame 2 ")) << lines[4];
  EXPECT_TRUE(has(lines[5], "q to end")) << lines[5];
}

TEST_F(Replay, ASessionWithoutImagesHasItsForcesMeasuredAgain) {
  const Outcome without = run("analyze " + session() + " --no-frames --output " + at("without"), "without");
  ASSERT_EQ(without.exit_code, 0) << without.err;
  const Outcome again = run("replay " + at("without") + " --output " + at("without_again"), "without_again");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(has(again.out, "30 / 30")) << again.out;
  const Outcome tracked = run("replay " + at("without") + " --rerun tracking --output " + at("no"), "no_images");
  EXPECT_EQ(tracked.exit_code, 3);
  EXPECT_TRUE(has(tracked.err, "recorded without images")) << tracked.err;
}

TEST_F(Replay, RefusesInOneLine) {
  const struct {
    std::string arguments;
    int exit_code;
    const char* word;
  } cases[] = {
      {"replay " + at("nothing"), 3, "no session"},
      {"replay " + session() + " --vary young_modulus_kPa=100", 2, "--output"},
      {"replay " + session() + " --vary modulus=100 --output " + at("x"), 2, "known:"},
      {"replay " + session() + " --vary poisson_ratio=0.9 --output " + at("x"), 2, "poisson_ratio"},
      {"replay " + session() + " --vary poisson_ratio=soft --output " + at("x"), 2, "not a number"},
      {"replay " + session() + " --vary poisson_ratio=nan --output " + at("x"), 2, "not a number"},
      {"replay " + session() + " --speed nan", 2, "0.01 to 100"},
      {"replay " + session() + " --from nan", 2, "--from"},
      {"replay " + session() + " --vary k2_ratio=1 --output " + at("x"), 2, "msd.tip.k2_ratio"},
      {"replay " + session() + " --backwards --output " + at("x"), 2, "forwards"},
      {"replay " + session() + " --from 99 --output " + at("x"), 2, "no frame between"},
      {"replay " + session() + " --output " + session(), 2, "already holds a session"},
      {"replay " + session() + " --speed 2 --output " + at("x"), 2, "--speed"},
      {"analyze " + session() + " --fps 10 --output " + at("x"), 2, "--fps"},
      {"analyze virtual:default --from 1 --output " + at("x"), 2, "not a session"},
  };
  for (const auto& one : cases) {
    const Outcome outcome = run(one.arguments, "refused");
    EXPECT_EQ(outcome.exit_code, one.exit_code) << one.arguments;
    EXPECT_TRUE(has(outcome.err, one.word)) << one.arguments << ": " << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(folder_ / "x" / "session.json")) << one.arguments;
  }
}

}  // namespace
}  // namespace pellucida
