#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "pellucida/core/Measurement.h"
#include "support/RunProgram.h"

// Real images and videos, where the folder with them lies beside the checkout (their licences don't let them into it).
// What is asserted is honesty: no crash, a row a frame, and no confident cell where there is none.

namespace pellucida {
namespace {

namespace fs = std::filesystem;

const fs::path kReal = fs::path(PELLUCIDA_SOURCE_DIR).parent_path() / "shared" / "real";

class RealInput : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(kReal)) GTEST_SKIP() << "no real images beside the checkout";
  }

  // Rows of an analysis that must end with 0 (measured) or 4 (nothing to measure), never otherwise.
  static std::vector<Measurement> analyze(const fs::path& input, double pixel_size_um) {
    const auto folder = test::fresh_folder("real_" + input.stem().string(), testing::TempDir());
    const auto outcome =
        test::run_program("analyze '" + input.string() + "' --no-frames --pixel-size-um " +
                              std::to_string(pixel_size_um) + " --output '" + (folder / "s").string() + "'",
                          folder);
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 4) << input << ": " << outcome.exit_code << outcome.err;
    std::printf("%s: exit %d\n%s", input.filename().c_str(), outcome.exit_code, outcome.out.c_str());
    std::ifstream file(folder / "s" / "measurements.csv");
    std::string line;
    std::getline(file, line);
    std::vector<Measurement> rows;
    while (std::getline(file, line)) rows.push_back(measurement_from_csv(line));
    EXPECT_EQ(outcome.exit_code == 0,
              std::any_of(rows.begin(), rows.end(), [](const Measurement& m) { return !std::isnan(m.cell_x_um); }))
        << "the exit code tells whether any frame showed a cell";
    return rows;
  }
};

TEST_F(RealInput, ALarvaIsNoRoundCell) {
  const auto rows = analyze(kReal / "needle" / "zebrafish_larva_poke.mkv", 1.0);
  ASSERT_EQ(rows.size(), 125U);
  for (const auto& row : rows) {
    EXPECT_TRUE(row.state == CellState::kNoCell || row.confidence < 0.8) << "frame " << row.frame;
    EXPECT_TRUE(std::isnan(row.contact_force_uN) || row.contact_force_uN == 0.0 || row.confidence < 0.8);
  }
}

TEST_F(RealInput, ARedCellInAPipetteRunsThrough) {
  EXPECT_GT(analyze(kReal / "aspiration" / "red_cell_aspiration.mp4", 0.16).size(), 300U);
}

TEST_F(RealInput, EveryStillGivesOneRow) {
  for (const auto& entry : fs::directory_iterator(kReal / "oocyte_stills")) {
    if (entry.path().string().find("_mask") != std::string::npos) continue;
    EXPECT_EQ(analyze(entry.path(), 0.5).size(), 1U) << entry.path();
  }
}

}  // namespace
}  // namespace pellucida
