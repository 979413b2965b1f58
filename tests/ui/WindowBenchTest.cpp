// The real window measured by the program itself.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "pellucida/core/TemporaryFolder.h"
#include "support/Files.h"
#include "support/RunProgram.h"

namespace pellucida {
namespace {

TEST(WindowBench, ItPrintsWhatTheWindowDoes) {
  const TemporaryFolder folder;
  const auto file = folder / "figures.json";
  const auto run =
      test::run_program("bench pipeline --window --seconds 8 --json '" + file.string() + "'", folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* part :
       {"frames/s drawn", "longer than 50 ms", "start to first live frame", "MiB at the first frame"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << " in " << run.out;
  }
  const auto report = nlohmann::json::parse(test::text_of(file));
  const auto& programs = report.at("pipeline").at("window");
  ASSERT_EQ(programs.size(), 1U);
  ASSERT_EQ(programs[0].at("turns").size(), 1U);
  const auto& turn = programs[0].at("turns")[0];
  EXPECT_GT(turn.at("drawn").get<double>(), 0.0);
  EXPECT_GT(turn.at("start_s").get<double>(), 0.0);
  EXPECT_GT(turn.at("longest_block_ms").get<double>(), 0.0);
  const auto& memory = turn.at("memory_s_MiB");
  ASSERT_GE(memory.size(), 2U);
  EXPECT_GT(memory.front().at(1).get<double>(), 10.0);
}

TEST(WindowBench, AProgramWithoutFiguresIsSaid) {
  const TemporaryFolder folder;
  const auto run = test::run_program("bench pipeline --window --seconds 1 --against /bin/false", folder.path());
  EXPECT_EQ(run.exit_code, 3) << run.err;
  EXPECT_NE(run.err.find("/bin/false: its window can't be measured"), std::string::npos) << run.err;
  EXPECT_EQ(test::run_program("bench session --window", folder.path()).exit_code, 2);
  EXPECT_EQ(test::run_program("bench pipeline --minutes 1", folder.path()).exit_code, 2);
}

}  // namespace
}  // namespace pellucida
