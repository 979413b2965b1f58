#include <gtest/gtest.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "pellucida/core/Table.h"
#include "pellucida/membrane/CellProfile.h"
#include "support/RunProgram.h"

// `pellucida identify` as a user runs it. The whole identification takes half a minute of two cores, so that it is run
// on coarse finite elements down to a small depth here.

namespace pellucida {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& file) {
  return std::string("'").append(file.string()).append("'");
}

TEST(Identify, WritesAProfileThatTheOtherCommandsTake) {
  const auto folder = test::fresh_folder("identify", testing::TempDir());
  const auto profile = folder / "small-cell.json";
  const auto outcome =
      test::run_program("identify --output " + quoted(profile) +
                            " --radius-um 40 --thickness-um 5 --puncture-force-uN 1.2 --puncture-indentation-um 12 "
                            "--max-indentation-um 12 --edge-length-ratio 1.8",
                        folder);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (int configuration = 1; configuration <= 4; ++configuration) {
    EXPECT_NE(outcome.out.find("configuration " + std::to_string(configuration)), std::string::npos) << outcome.out;
  }
  const CellProfile cell = read_profile(profile);
  EXPECT_EQ(cell.name, "small-cell");
  EXPECT_DOUBLE_EQ(cell.mid_radius_um, 40.0);
  EXPECT_DOUBLE_EQ(cell.inner_radius_um, 37.5);
  EXPECT_GE(cell.errors.size(), 4U);
  bool says_how = false;
  for (const auto& [what, where] : cell.sources) says_how = says_how || where.find("identify") != std::string::npos;
  EXPECT_TRUE(says_how);

  const auto picture = cv::imread((folder / "small-cell.png").string());
  ASSERT_GE(picture.cols, 1400);
  cv::Scalar mean, deviation;
  cv::meanStdDev(picture, mean, deviation);
  EXPECT_GT(deviation[1], 10.0);

  const auto curve = folder / "curve.csv";
  const auto force =
      test::run_program("force " + quoted(profile) + " --configuration 1 --output " + quoted(curve), folder);
  ASSERT_EQ(force.exit_code, 0) << force.err;
  const Eigen::VectorXd force_uN = Table::read(curve).column("force_uN");
  EXPECT_NEAR(force_uN[force_uN.size() - 1], 1.2, 1e-5);
}

TEST(Identify, AddsScaleAndRelaxationToAProfile) {
  const auto folder = test::fresh_folder("identify_from", testing::TempDir());
  const auto profile = folder / "mine.json", measured = folder / "measured.csv";
  {
    std::ofstream file(measured);
    file << "indentation_um,force_uN\n0,0\n10,2.2\n20,4\n30,7.8\n40,12.9\n";
  }
  const fs::path record = fs::path(PELLUCIDA_SOURCE_DIR) / "tests/data/oocyte_relaxation/curve_01.csv";
  const auto outcome =
      test::run_program("identify --from mouse-oocyte --keep-constants --no-picture --measured-curve " +
                            quoted(measured) + " --relaxation " + quoted(record) + " --output " + quoted(profile),
                        folder);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("spring and one arm"), std::string::npos) << outcome.out;
  const CellProfile before = load_profile("mouse-oocyte"), after = read_profile(profile);
  EXPECT_EQ(after.relaxation_arms.size(), 2U);
  EXPECT_NEAR(after.effective_young_modulus_kPa / before.effective_young_modulus_kPa, 2.0, 0.1);
  EXPECT_GT(after.force_scale_relative_sigma, 0.0);
  EXPECT_LT(after.force_scale_relative_sigma, 0.01);
  EXPECT_DOUBLE_EQ(after.body.k2_ratio, before.body.k2_ratio);
  // The measured curve is taken to be as quick as the record's ramp, 20 um/s; its arms relax meanwhile.
  EXPECT_NEAR(after.relaxation_anchor_ramp_s, after.puncture_indentation_um / 20.0, 2e-4);
  EXPECT_GT(after.relaxation_elastic_ratio, 1.1);
  EXPECT_LT(after.relaxation_elastic_ratio, 2.0);

  // Pushed as fast as that the force is the anchored one again; then it falls.
  const auto curve = folder / "held.csv", quasi_static = folder / "force.csv";
  const std::string force = "force " + quoted(profile) + " --step-um 4 --output ";
  ASSERT_EQ(test::run_program(force + quoted(curve) + " --speed-um-per-s 20 --hold-s 30", folder).exit_code, 0);
  ASSERT_EQ(test::run_program(force + quoted(quasi_static), folder).exit_code, 0);
  const Table held = Table::read(curve);
  const Eigen::VectorXd time_s = held.column("time_s"), force_uN = held.column("force_uN");
  const Eigen::VectorXd anchored_uN = Table::read(quasi_static).column("force_uN");
  const Eigen::Index peak = anchored_uN.size() - 1;
  EXPECT_NEAR(time_s[peak], after.puncture_indentation_um / 20.0, 1e-6);
  EXPECT_NEAR(force_uN[peak], anchored_uN[peak], 0.0011 * anchored_uN[peak]);
  EXPECT_LT(force_uN[force_uN.size() - 1], 0.6 * force_uN[peak]);
  EXPECT_EQ(
      test::run_program("force mouse-oocyte --replace --speed-um-per-s 20 --output " + quoted(curve), folder).exit_code,
      2);
}

TEST(Identify, WrongInputEndsWithItsExitCodeAndOneLine) {
  const auto folder = test::fresh_folder("identify_wrong", testing::TempDir());
  const auto bad_curve = folder / "bad.csv";
  {
    std::ofstream file(bad_curve);
    file << "depth,force_uN\n1,1\n2,2\n3,3\n";
  }
  const std::string output = " --output " + quoted(folder / "p.json");
  const auto expect = [&](const std::string& arguments, int code, const std::string& word) {
    const auto outcome = test::run_program("identify " + arguments, folder);
    EXPECT_EQ(outcome.exit_code, code) << arguments << outcome.err;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << arguments << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(folder / "p.json")) << arguments;
  };
  expect("", 2, "--output");
  expect("--radius-um -50" + output, 2, "--radius-um");
  expect("--poisson-ratio 0.7" + output, 2, "--poisson-ratio");
  expect("--thickness-um 40" + output, 2, "thickness");
  expect("--tip-radius-um 45" + output, 2, "tip");
  expect("--puncture-force-uN 3" + output, 2, "--puncture-indentation-um");
  expect("--puncture-force-uN 3 --puncture-indentation-um 90" + output, 2, "1.4 radii");
  expect("--keep-constants" + output, 2, "--from");
  expect("--from no-such-cell" + output, 2, "no-such-cell");
  expect("--measured-curve " + quoted(bad_curve) + output, 3, "indentation_um");
  expect("--measured-curve " + quoted(folder / "none.csv") + output, 3, "none.csv");
  expect("--relaxation " + quoted(bad_curve) + output, 3, "style");
  expect("--output '/proc/none/p.json'", 5, "/proc/none/p.json");
}

}  // namespace
}  // namespace pellucida
