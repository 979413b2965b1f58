#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "pellucida/core/Table.h"
#include "support/RunProgram.h"

// The dose passport as a user gets it: simulate, analyze, report; its numbers against the microscope's own truth.

namespace pellucida {
namespace {

namespace fs = std::filesystem;

class Report : public testing::Test {
 protected:
  // One film of a puncture serves all the assertions below.
  static void SetUpTestSuite() {
    folder_ = test::fresh_folder("report", testing::TempDir());
    const std::string at = folder_.string();
    ASSERT_EQ(run("simulate --scenario puncture --output " + at + "/v.avi --truth " + at + "/t.csv").exit_code, 0);
    ASSERT_EQ(run("analyze " + at + "/v.avi --output " + at + "/s --pixel-size-um 0.825 --no-frames").exit_code, 0);
    reported_ = run("report " + at + "/s");
    std::istringstream table(test::text_of(folder_ / "s/report/cells.csv"));
    std::string header, row;
    std::getline(table, header);
    while (std::getline(table, row)) {
      ++row_count_;
      const auto names = split_csv(header), cells = split_csv(row);
      ASSERT_EQ(names.size(), cells.size());
      for (std::size_t i = 0; i < names.size(); ++i) cells_[names[i]] = cells[i];
    }
    read_truth();
  }

  static test::Outcome run(const std::string& arguments) { return test::run_program(arguments, folder_ / "run"); }

  // The rows of the truth in contact, up to the puncture.
  static void read_truth() {
    const Table t = Table::read(folder_ / "t.csv");
    const auto state = t.column("state"), depth = t.column("indentation_um"), force = t.column("contact_force_uN"),
               time = t.column("time_s");
    for (Eigen::Index i = 0; i < t.rows(); ++i) {
      if (state[i] == 3.0) {
        puncture_s_ = time[i];
        return;
      }
      if (state[i] != 2.0) continue;
      depths_um_.push_back(depth[i]);
      forces_uN_.push_back(force[i]);
    }
  }

  static double number(const std::string& name) {
    const std::string& cell = cells_.at(name);
    return cell.empty() ? std::nan("") : std::stod(cell);
  }

  // Work of the truth up to its last frame before the puncture.
  static double true_work_pJ() {
    double work_pJ = 0.5 * forces_uN_[0] * depths_um_[0];
    for (std::size_t i = 1; i < depths_um_.size(); ++i) {
      work_pJ += 0.5 * (forces_uN_[i] + forces_uN_[i - 1]) * (depths_um_[i] - depths_um_[i - 1]);
    }
    return work_pJ;
  }

  // The truth's slope by the same rule: the median over all pairs of its frames within 2.5 um.
  static double true_stiffness(double depth_um) {
    std::vector<double> slopes;
    for (std::size_t i = 0; i < depths_um_.size(); ++i) {
      for (std::size_t j = i + 1; j < depths_um_.size(); ++j) {
        if (std::abs(depths_um_[i] - depth_um) > 2.5 || std::abs(depths_um_[j] - depth_um) > 2.5) continue;
        slopes.push_back((forces_uN_[j] - forces_uN_[i]) / (depths_um_[j] - depths_um_[i]));
      }
    }
    std::sort(slopes.begin(), slopes.end());
    return slopes.at(slopes.size() / 2);
  }

  static inline fs::path folder_;
  static inline test::Outcome reported_;
  static inline int row_count_ = 0;
  static inline std::map<std::string, std::string> cells_;
  static inline std::vector<double> depths_um_, forces_uN_;
  static inline double puncture_s_ = 0.0;
};

TEST_F(Report, SaysWhatItFoundAndWhereItPutIt) {
  EXPECT_EQ(reported_.exit_code, 0) << reported_.err;
  EXPECT_NE(reported_.out.find("cell 1: punctured; peak force 7."), std::string::npos) << reported_.out;
  EXPECT_NE(reported_.out.find("report.html"), std::string::npos);
  EXPECT_EQ(reported_.err, "");
  EXPECT_EQ(row_count_, 1);
  EXPECT_EQ(cells_.at("outcome"), "punctured");
  EXPECT_EQ(cells_.at("contacts"), "1");
  EXPECT_EQ(cells_.at("doubts"), "");
}

// The bands allow about twice the error found: 2.2 % of the force, 0.24 um, 2.3 % of the work. The truth is a solid's,
// the estimate a spring network's.
TEST_F(Report, PeakPunctureAndWorkAreTheTruths) {
  const double force_uN = *std::max_element(forces_uN_.begin(), forces_uN_.end());
  const double depth_um = *std::max_element(depths_um_.begin(), depths_um_.end());
  EXPECT_NEAR(number("peak_force_uN"), force_uN, 0.045 * force_uN);
  EXPECT_NEAR(number("puncture_force_uN"), force_uN, 0.045 * force_uN);
  EXPECT_NEAR(number("puncture_depth_um"), depth_um, 0.5);
  EXPECT_NEAR(number("puncture_s"), puncture_s_, 0.001);
  EXPECT_NEAR(number("puncture_work_pJ"), true_work_pJ(), 0.05 * true_work_pJ());
  EXPECT_NEAR(number("drop_uN"), force_uN, 0.045 * force_uN);
  std::printf("force %.3f for %.3f uN, depth %.2f for %.2f um, work %.1f for %.1f pJ\n", number("puncture_force_uN"),
              force_uN, number("puncture_depth_um"), depth_um, number("puncture_work_pJ"), true_work_pJ());
}

TEST_F(Report, TheIntervalsHoldTheTruth) {
  const double force_uN = *std::max_element(forces_uN_.begin(), forces_uN_.end());
  EXPECT_LT(number("puncture_force_lower_uN"), force_uN);
  EXPECT_GT(number("puncture_force_upper_uN"), force_uN);
  EXPECT_LT(number("puncture_work_lower_pJ"), true_work_pJ());
  EXPECT_GT(number("puncture_work_upper_pJ"), true_work_pJ());
  for (const int depth_um : {5, 10, 20, 30, 40}) {
    const std::string name = "stiffness_" + std::to_string(depth_um) + "um_";
    const double stiffness = true_stiffness(depth_um);
    std::printf("stiffness at %d um: %.4f for %.4f uN/um\n", depth_um, number(name + "uN_per_um"), stiffness);
    EXPECT_NEAR(number(name + "uN_per_um"), stiffness, 0.1 * stiffness);
    EXPECT_LT(number(name + "lower_uN_per_um"), stiffness);
    EXPECT_GT(number(name + "upper_uN_per_um"), stiffness);
  }
}

// Half a second of the film before the touch, the needle at 20 um/s; strain and tension as the surfaces have them.
TEST_F(Report, TheOtherNumbersAreThere) {
  EXPECT_NEAR(number("approach_speed_um_per_s"), 20.0, 1.0);
  EXPECT_NEAR(number("radius_um"), 52.5, 0.1);
  EXPECT_GT(number("largest_area_strain_percent"), 5.0);
  EXPECT_LT(number("largest_area_strain_percent"), 8.0);
  EXPECT_GT(number("largest_mean_tension_uN_per_um"), 0.02);
  EXPECT_GT(number("largest_tension_uN_per_um"), number("largest_mean_tension_uN_per_um"));
  // No hand was recorded, and there was no removal without a puncture.
  EXPECT_EQ(cells_.at("deposit_s"), "");
  EXPECT_EQ(cells_.at("hysteresis_pJ"), "");
  EXPECT_EQ(cells_.at("unmeasured_frames"), "0");
}

TEST_F(Report, TheSessionStaysFine) {
  const auto checked = run("check " + (folder_ / "s").string());
  EXPECT_EQ(checked.exit_code, 0) << checked.out;
  EXPECT_EQ(checked.out.find("note"), std::string::npos) << checked.out;
}

TEST_F(Report, AReportIsReplacedOnRequestAlone) {
  const std::string again = "report " + (folder_ / "s").string();
  const auto refused = run(again);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("report.html: already there"), std::string::npos) << refused.err;
  EXPECT_EQ(run(again + " --replace").exit_code, 0);
}

TEST_F(Report, WrongUseAndBadSessionsHaveTheirCodes) {
  const std::string session = (folder_ / "s").string();
  EXPECT_EQ(run("report").exit_code, 2);
  EXPECT_EQ(run("report " + session + " --output " + session).exit_code, 2);
  EXPECT_EQ(run("report " + folder_.string()).exit_code, 3);
  EXPECT_EQ(run("report " + session + " --output " + (folder_ / "v.avi").string()).exit_code, 5);
  // A cut-off session is reported, with a warning.
  fs::create_directory(folder_ / "cut");
  for (const char* name : {"session.json", "measurements.csv", "events.csv"}) {
    fs::copy_file(folder_ / "s" / name, folder_ / "cut" / name);
  }
  fs::resize_file(folder_ / "cut/measurements.csv", fs::file_size(folder_ / "cut/measurements.csv") / 2);
  const auto cut = run("report " + (folder_ / "cut").string());
  EXPECT_EQ(cut.exit_code, 0) << cut.err;
  EXPECT_NE(cut.err.find("warning: 1 row(s)"), std::string::npos) << cut.err;
}

// Pages of no cell are written, and the code says that there was none.
TEST_F(Report, ASessionWithoutACellIsCodeFour) {
  fs::create_directory(folder_ / "none");
  for (const char* name : {"session.json", "events.csv"}) {
    fs::copy_file(folder_ / "s" / name, folder_ / "none" / name);
  }
  const std::string rows = test::text_of(folder_ / "s/measurements.csv");
  test::put(folder_ / "none/measurements.csv", rows.substr(0, rows.find('\n') + 1));
  const auto outcome = run("report " + (folder_ / "none").string());
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.err.find("no cell was found"), std::string::npos) << outcome.err;
  EXPECT_NE(test::text_of(folder_ / "none/report/report.html").find("No cell was found"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
