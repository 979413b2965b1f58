#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <regex>

#include "pellucida/core/Measurement.h"
#include "pellucida/core/Table.h"
#include "support/RunProgram.h"
#include "support/WaitUntil.h"

// `pellucida analyze FOLDER`: six recordings, two of them broken.

namespace pellucida {
namespace {

namespace fs = std::filesystem;

constexpr int kCount = 6, kBroken = 2;

class Batch : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = test::fresh_folder("batch", testing::TempDir());
    const std::string make = "bash '" PELLUCIDA_SOURCE_DIR "/tests/integration/make_recordings' '" PELLUCIDA_PROGRAM
                             "' '" +
                             (folder_ / "in").string() + "' " + std::to_string(kCount) + ' ' + std::to_string(kBroken);
    ASSERT_EQ(std::system(make.c_str()), 0);
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static std::string arguments(const std::string& output, const std::string& more) {
    return "analyze '" + (folder_ / "in").string() + "' --output '" + (folder_ / output).string() +
           "' --pixel-size-um 0.825 " + more;
  }
  static test::Outcome run(const std::string& output, const std::string& more = "") {
    return test::run_program(arguments(output, more), folder_ / "run");
  }
  static std::vector<std::vector<std::string>> table(const fs::path& file) {
    std::vector<std::vector<std::string>> rows;
    std::ifstream stream(folder_ / file);
    for (std::string line; std::getline(stream, line);) rows.push_back(split_csv(line));
    return rows;
  }
  // Name to result, as summary.csv says.
  static std::map<std::string, std::string> results(const std::string& output) {
    std::map<std::string, std::string> found;
    for (const auto& row : table(output + "/summary.csv")) found[row[0]] = row[3];
    found.erase("name");
    return found;
  }
  // measurements.csv without what belongs to the computer: the frame's age, and with it the row's checksum.
  static std::vector<std::string> numbers(const fs::path& session) {
    std::vector<std::string> rows;
    for (const auto& cells : table(session / "measurements.csv")) {
      if (cells[0] == "frame") continue;
      std::string line;
      for (const auto& cell : cells) line += (line.empty() ? "" : ",") + cell;
      Measurement m = measurement_from_csv(line.substr(0, line.rfind(',')));
      m.frame_age_ms = Measurement::kNotMeasured;
      rows.push_back(to_csv(m));
    }
    return rows;
  }
  static std::map<std::string, fs::file_time_type> written(const std::string& output) {
    std::map<std::string, fs::file_time_type> times;
    if (!fs::exists(folder_ / output)) return times;
    for (const auto& entry : fs::directory_iterator(folder_ / output)) {
      const auto head = entry.path() / "session.json";
      if (fs::exists(head)) times[entry.path().filename()] = fs::last_write_time(head);
    }
    return times;
  }

  static fs::path folder_;
};
fs::path Batch::folder_;

const std::map<std::string, std::string> kExpected{{"control_broken0", "damaged"}, {"control_cell0", "measured"},
                                                   {"control_cell2", "measured"},  {"treated_broken1", "failed"},
                                                   {"treated_cell1", "measured"},  {"treated_cell3", "measured"}};

TEST_F(Batch, GivesTheSameNumbersWithOneJobAndTwoAndSaysWhatFailed) {
  const auto one = run("one", "--group-by folder");
  EXPECT_EQ(one.exit_code, 7) << one.err;
  EXPECT_NE(one.out.find("6 recordings: 4 measured, 1 damaged, 1 failed"), std::string::npos) << one.out;
  EXPECT_NE(one.err.find("broken1.avi: empty file (0 bytes); copy or record it again"), std::string::npos) << one.err;
  EXPECT_NE(one.err.find("2 of 6 recordings were not measured to their end"), std::string::npos) << one.err;
  EXPECT_EQ(results("one"), kExpected);

  const auto two = run("two", "--jobs 2 --no-frames");
  EXPECT_EQ(two.exit_code, 7) << two.err;
  EXPECT_EQ(results("two"), kExpected);
  EXPECT_FALSE(fs::exists(folder_ / "two/groups.csv"));
  for (const auto& [name, result] : kExpected) {
    if (result == "failed") continue;
    const auto rows = numbers("one/" + name);
    EXPECT_GT(rows.size(), 10U) << name;
    EXPECT_EQ(rows, numbers("two/" + name)) << name;
    EXPECT_EQ(test::run_program("check '" + (folder_ / "one" / name).string() + "'", folder_ / "run").exit_code, 0);
  }

  // Groups: the treated cells give way at less force.
  const auto groups = table("one/groups.csv");
  ASSERT_GT(groups.size(), 4U);
  const auto row = std::find_if(groups.begin(), groups.end(),
                                [](const auto& r) { return r[0] == "treated" && r[1] == "puncture_force_uN"; });
  ASSERT_NE(row, groups.end());
  EXPECT_EQ((*row)[2], "2");
  EXPECT_LT(std::stod((*row)[6]), 0.0);
  EXPECT_EQ((*row)[9], "-1");
  const std::string page = test::text_of(folder_ / "one/index.html");
  EXPECT_NE(page.find("puncture force"), std::string::npos);
  EXPECT_EQ(page, test::text_of(folder_ / "one/report.html"));

  // Again: what is finished stays as it is; another option makes it anew.
  const auto before = written("one");
  ASSERT_EQ(before.size(), 5U);
  EXPECT_EQ(run("one", "--group-by folder").exit_code, 7);
  EXPECT_EQ(written("one"), before);
  EXPECT_NE(run("one", "--list").out.find("control_cell0," + (folder_ / "in/control/cell0.avi").string() + ",finished"),
            std::string::npos);
  EXPECT_EQ(run("one", "--revolve-step-deg 30 --only control_cell0").exit_code, 0);
  for (const auto& [name, time] : written("one")) EXPECT_EQ(time > before.at(name), name == "control_cell0") << name;
}

TEST_F(Batch, AnInterruptedOneGoesOnWhereItWas) {
  for (const int number : {SIGINT, SIGKILL}) {
    const std::string output = "signal" + std::to_string(number);
    const std::string command = "exec '" PELLUCIDA_PROGRAM "' " + arguments(output, "") + " >/dev/null 2>&1";
    const pid_t batch = fork();
    ASSERT_GE(batch, 0);
    if (batch == 0) {
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(99);
    }
    // In the middle: one is finished, another begun.
    ASSERT_TRUE(test::wait_until([&] {
      return !written(output).empty() && fs::exists(folder_ / output / ".unfinished/control_cell2/session");
    }));
    kill(batch, number);
    int status = 0;
    waitpid(batch, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), number);
    const auto before = written(output);
    EXPECT_FALSE(before.contains("treated_cell3"));
    if (number == SIGINT) {
      EXPECT_EQ(results(output).at("treated_cell3"), "waiting");
      EXPECT_FALSE(fs::exists(folder_ / output / ".unfinished"));
    }

    EXPECT_EQ(run(output).exit_code, 7);
    EXPECT_EQ(results(output), kExpected);
    EXPECT_FALSE(fs::exists(folder_ / output / ".unfinished"));
    const auto after = written(output);
    for (const auto& [name, time] : before) EXPECT_EQ(after.at(name), time) << name;
  }
}

// As several computers share the work.
TEST_F(Batch, OneByOneAndThenCollected) {
  const auto only = run("parts", "--only control_cell0 --only treated_cell1");
  EXPECT_EQ(only.exit_code, 0) << only.err;
  EXPECT_FALSE(fs::exists(folder_ / "parts/summary.csv"));
  EXPECT_EQ(run("parts", "--only treated_broken1").exit_code, 7);
  EXPECT_EQ(run("parts", "--collect").exit_code, 7);
  EXPECT_EQ(results("parts"), (std::map<std::string, std::string>{{"control_broken0", "waiting"},
                                                                  {"control_cell0", "measured"},
                                                                  {"control_cell2", "waiting"},
                                                                  {"treated_broken1", "failed"},
                                                                  {"treated_cell1", "measured"},
                                                                  {"treated_cell3", "waiting"}}));
}

TEST_F(Batch, WrongUsageIsOneError) {
  EXPECT_EQ(run("x", "--only nobody").exit_code, 2);
  EXPECT_EQ(run("x", "--profile nobody").exit_code, 2);
  EXPECT_EQ(run("x", "--list --collect").exit_code, 2);
  EXPECT_EQ(run("x", "--jobs 0").exit_code, 2);
  EXPECT_EQ(run("in").exit_code, 2);
  EXPECT_EQ(run("x", "--group-by '" + (folder_ / "none.csv").string() + "'").exit_code, 3);
  const std::string one = "analyze '" + (folder_ / "in/control/cell0.avi").string() + "' --output x --collect";
  EXPECT_EQ(test::run_program(one, folder_ / "run").exit_code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "x"));
}

}  // namespace
}  // namespace pellucida
