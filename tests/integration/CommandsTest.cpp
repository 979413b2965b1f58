#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <sstream>

#include "pellucida/core/Error.h"
#include "pellucida/core/Measurement.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/Version.h"
#include "support/RunProgram.h"

// Commands that need no long run: help, profiles, force, the headless workstation, bench.

namespace pellucida {
namespace {

namespace fs = std::filesystem;

TEST(Commands, EachHasHelpAndExplainsItsOptions) {
  const auto folder = test::fresh_folder("commands_help", testing::TempDir());
  for (const char* command : {"workstation", "simulate", "analyze", "identify", "force", "check", "convert", "export",
                              "bench", "devices", "profiles", "inject", "trial", "replay", "report"}) {
    const auto outcome = test::run_program(std::string(command) + " --help", folder);
    EXPECT_EQ(outcome.exit_code, 0) << command;
    EXPECT_GT(outcome.out.size(), 80U) << command;
  }
}

// A report of a fault has to say what it ran on.
TEST(Commands, VersionTellsOfProgramLibrariesAndDevices) {
  const auto outcome = test::run_program("--version", test::fresh_folder("commands_version", testing::TempDir()));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, std::string("Pellucida ") + kVersion);
  std::map<std::string, std::string> versions;
  while (std::getline(lines, line)) {
    const std::size_t end = line.find("  ");
    ASSERT_NE(end, std::string::npos) << line;
    versions[line.substr(0, end)] = line.substr(line.find_first_not_of(' ', end));
  }
  const auto is_version = [](const std::string& text) {
    return text.find('.') != std::string::npos && text.find_first_not_of("0123456789.") == std::string::npos;
  };
  for (const char* library :
       {"VTK", "Qt", "OpenCV", "ITK", "libtiff", "Eigen", "Ceres Solver", "nlohmann JSON", "CLI11"}) {
    EXPECT_TRUE(is_version(versions[library])) << library << " " << versions[library];
  }
  for (const char* library : {"SDL", "libspnav", "libserialport"}) {
    const std::string& version = versions[library];
    EXPECT_TRUE(is_version(version) || version.starts_with("not in this build: no ")) << library << " " << version;
  }
}

TEST(Commands, ProfilesAreListed) {
  const auto outcome = test::run_program("profiles", test::fresh_folder("commands_profiles", testing::TempDir()));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("mouse-oocyte"), std::string::npos);
  EXPECT_NE(outcome.out.find("mouse-embryo"), std::string::npos);
}

// Whatever this machine has: each kind is listed, what is always present is usable, and what is not states why.
TEST(Commands, DevicesTellsOfEachKindAndWhyNot) {
  const auto folder = test::fresh_folder("commands_devices", testing::TempDir());
  const auto outcome = test::run_program("devices --json", folder);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::set<std::string> kinds, usable;
  const auto report = nlohmann::json::parse(outcome.out);
  for (const auto& device : report.at("devices")) {
    kinds.insert(device.at("kind"));
    EXPECT_FALSE(device.at("detail").get<std::string>().empty()) << device.dump();
    if (device.at("usable").get<bool>()) usable.insert(device.at("name"));
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"camera", "hand", "manipulator", "serial port"}));
  for (const char* name : {"mouse", "simulated", "virtual"}) EXPECT_TRUE(usable.count(name)) << name;

  const auto listed = test::run_program("devices", folder);
  EXPECT_EQ(listed.exit_code, 0);
  EXPECT_NE(listed.out.find("openhaptics"), std::string::npos) << listed.out;
  EXPECT_NE(listed.out.find("spacemouse"), std::string::npos) << listed.out;

  const auto asked = test::run_program("devices --ask /dev/ttyPELLUCIDA", folder);
  EXPECT_EQ(asked.exit_code, 6);
  EXPECT_NE(asked.err.find("there is no /dev/ttyPELLUCIDA"), std::string::npos) << asked.err;
}

TEST(Commands, ForcePassesTheMeasuredPuncturePoint) {
  const auto folder = test::fresh_folder("commands_force", testing::TempDir());
  const auto file = folder / "f.csv";
  const auto outcome = test::run_program(
      "force mouse-oocyte --configuration 1 --max-indentation-um 44 --step-um 2 --output '" + file.string() + "'",
      folder);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Table table = Table::read(file);
  const auto force_uN = table.column("force_uN");
  EXPECT_DOUBLE_EQ(force_uN[0], 0.0);
  EXPECT_NEAR(force_uN[force_uN.size() - 1], 7.5, 0.075);
}

// A third of a second of the virtual microscope, measured both ways; the session says how it was asked for.
TEST(Commands, AnalyzeTakesTheQualityAsked) {
  const auto folder = test::fresh_folder("commands_quality", testing::TempDir());
  std::ofstream(folder / "short.json") << R"({"image": {"duration_s": 0.3}})";
  for (const std::string quality : {"live", "high"}) {
    const auto session = folder / quality;
    std::ostringstream command;
    command << "analyze 'virtual:" << (folder / "short.json").string() << "' --quality " << quality
            << " --no-frames --output '" << session.string() << "'";
    const auto outcome = test::run_program(command.str(), folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("free"), std::string::npos) << outcome.out;
    std::ifstream in(session / "session.json");
    const std::string record((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    EXPECT_NE(record.find(std::string("--quality ").append(quality)), std::string::npos) << record.substr(0, 400);
  }
}

// A cell known to be stiffer than its kind: its forces, its scale and its risk by depth are in the session.
TEST(Commands, AnalyzeWithAKnownForceMakesTheForcesThisCellsOwn) {
  const auto folder = test::fresh_folder("commands_palpation", testing::TempDir());
  const auto scenario = folder / "short.json";
  std::ofstream(scenario) << R"({"motion": {"gap_um": 6, "indentation_um": 12, "hold_s": 0}})";
  const std::string run = "analyze 'virtual:" + scenario.string() + "' --no-frames --output '";
  ASSERT_EQ(test::run_program(run + (folder / "usual").string() + "'", folder).exit_code, 0);
  const auto palpated =
      test::run_program(run + (folder / "known").string() + "' --known-force-uN 1.0 --at-indentation-um 5", folder);
  ASSERT_EQ(palpated.exit_code, 0) << palpated.err;
  EXPECT_NE(palpated.out.find("times the profile's forces"), std::string::npos);
  const auto palpation = nlohmann::json::parse(test::text_of(folder / "known/session.json")).at("palpation");
  const double ratio = palpation.at("cell_scale_ratio").get<double>();
  EXPECT_GT(ratio, 1.2);
  EXPECT_GT(palpation.at("puncture_risk").size(), 5U);
  const auto last_row = [&](const char* session) {
    const std::string text = test::text_of(folder / session / "measurements.csv");
    const std::size_t end = text.find_last_not_of('\n');
    const std::size_t start = text.rfind('\n', end) + 1;
    return measurement_from_csv(text.substr(start, end + 1 - start));
  };
  const Measurement usual = last_row("usual"), known = last_row("known");
  EXPECT_NEAR(known.contact_force_uN, ratio * usual.contact_force_uN, 1e-3 * known.contact_force_uN);
  EXPECT_GT(known.puncture_probability, 0.0);
  EXPECT_TRUE(std::isnan(usual.puncture_probability));
  EXPECT_GE(usual.lateral_force_uN, 0.0);
  EXPECT_GT(usual.stiffness_uN_per_um, 0.0);
  EXPECT_NE(test::text_of(folder / "known/events.csv").find("palpation"), std::string::npos);
  // A force without its depth is wrong usage.
  EXPECT_EQ(test::run_program(run + (folder / "none").string() + "' --known-force-uN 1.0", folder).exit_code, 2);
}

TEST(Commands, ForceTakesAnyAngleOffsetAndTip) {
  const auto folder = test::fresh_folder("commands_force_any", testing::TempDir());
  const auto last_force_uN = [&](const std::string& options) {
    const auto file = folder / "f.csv";
    const auto outcome = test::run_program(
        "force mouse-oocyte --replace --max-indentation-um 20 --step-um 4 --output '" + file.string() + "' " + options,
        folder);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto force_uN = Table::read(file).column("force_uN");
    return force_uN[force_uN.size() - 1];
  };
  const double aligned = last_force_uN("--configuration 1"), across = last_force_uN("--configuration 3");
  EXPECT_NEAR(last_force_uN("--angle-deg 90"), across, 1e-9);
  EXPECT_NEAR(last_force_uN("--offset-um 10"), last_force_uN("--configuration 4"), 1e-9);
  const double between = last_force_uN("--angle-deg 60");
  EXPECT_GT(between, across);
  EXPECT_LT(between, aligned);
  EXPECT_GT(last_force_uN("--tip-radius-um 8"), aligned);
  for (const char* wrong : {"--angle-deg 100", "--offset-um 60", "--tip-radius-um 40",
                            "--configuration 2 --angle-deg 5", "--configuration 5"}) {
    EXPECT_EQ(test::run_program("force mouse-oocyte --output '" + (folder / "w.csv").string() + "' " + wrong, folder)
                  .exit_code,
              2)
        << wrong;
  }
}

// An operator who gives up leaves the last ticks, too, however few they are.
TEST(Commands, AGivenUpInjectionKeepsEveryTickOfTheHand) {
  const auto folder = test::fresh_folder("commands_given_up", testing::TempDir());
  const auto session = folder / "session";
  const auto outcome =
      test::run_program("inject --no-frames --max-duration-s 2 --output '" + session.string() + "'", folder);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("given up"), std::string::npos) << outcome.out;
  // A block of a second, and what was left.
  EXPECT_TRUE(std::filesystem::exists(session / "haptics" / "haptics_00000000.vtp"));
  EXPECT_TRUE(std::filesystem::exists(session / "haptics" / "haptics_00000001.vtp"));
}

// With no display the main job runs headless, a guided injection from end to end: a session that checks out, the hand
// in it, and a picture that shows something.
TEST(Commands, WorkstationWithoutADisplayLeavesASessionAndAPicture) {
  const auto folder = test::fresh_folder("commands_headless", testing::TempDir());
  const auto session = folder / "session";
  const auto outcome = test::run_program("workstation --session '" + session.string() + "'", folder);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 12) << outcome.out;
  for (const char* said : {"simulated operator", "puncture expected at 7.5 uN", "membrane gave way",
                           "left in the cell; needle taken out"}) {
    EXPECT_NE(outcome.out.find(said), std::string::npos) << outcome.out;
  }
  EXPECT_EQ(test::run_program("check '" + session.string() + "'", folder).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(session / "haptics" / "haptics_00000005.vtp"));
  const auto head = nlohmann::json::parse(test::text_of(session / "session.json"));
  EXPECT_EQ(head["plan"]["schema"], "pellucida-injection-plan");

  const cv::Mat picture = cv::imread((session / "picture.png").string());
  ASSERT_GE(picture.cols, 1200);
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(picture, mean, deviation);
  EXPECT_GT(deviation[1], 10.0);  // a picture, not one colour
}

TEST(Commands, ReviewNeedsADisplayAndTakesNoOptionsOfARun) {
  const auto folder = test::fresh_folder("commands_review", testing::TempDir());
  const auto blind = test::run_program("workstation --mode review --session S", folder);
  EXPECT_EQ(blind.exit_code, static_cast<int>(ExitCode::kDeviceMissing));
  EXPECT_NE(blind.err.find("set DISPLAY"), std::string::npos) << blind.err;
  for (const char* option : {"--source virtual", "--profile mouse-embryo", "--hand mouse", "--every 2"}) {
    const auto refused = test::run_program("workstation --mode review " + std::string(option), folder);
    EXPECT_EQ(refused.exit_code, static_cast<int>(ExitCode::kWrongUsage)) << option;
    EXPECT_NE(refused.err.find("has no meaning with --mode review"), std::string::npos) << refused.err;
  }
}

TEST(Commands, TheStartPageNeedsADisplayAndTakesNoOptionsOfARun) {
  const auto folder = test::fresh_folder("commands_start", testing::TempDir());
  const auto blind = test::run_program("workstation --mode start", folder);
  EXPECT_EQ(blind.exit_code, static_cast<int>(ExitCode::kDeviceMissing));
  EXPECT_NE(blind.err.find("set DISPLAY"), std::string::npos) << blind.err;
  for (const char* option :
       {"--source virtual", "--profile mouse-embryo", "--hand mouse", "--session S", "--speed 2"}) {
    const auto refused = test::run_program("workstation --mode start " + std::string(option), folder);
    EXPECT_EQ(refused.exit_code, static_cast<int>(ExitCode::kWrongUsage)) << option;
    EXPECT_NE(refused.err.find("has no meaning with --mode start"), std::string::npos) << refused.err;
  }
}

TEST(Commands, BenchWritesItsFigures) {
  const auto folder = test::fresh_folder("commands_bench", testing::TempDir());
  const auto file = folder / "b.json";
  const auto outcome = test::run_program("bench pipeline --seconds 0.1 --json '" + file.string() + "'", folder);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = nlohmann::json::parse(test::text_of(file));
  for (const char* key : {"p50", "p99", "p99_9", "max", "count"}) {
    EXPECT_GT(report["pipeline"]["frame_to_force_us"][key].get<double>(), 0.0) << key;
  }
  EXPECT_GT(report["pipeline"]["frames_per_s"].get<double>(), 0.0);
  EXPECT_GT(report["pipeline"]["display_frames_per_s"].get<double>(), 0.0);
}

TEST(Commands, BenchTrackingTimesTheTrackerAndItsParts) {
  const auto folder = test::fresh_folder("commands_bench_tracking", testing::TempDir());
  const auto file = folder / "b.json";
  const auto outcome = test::run_program("bench tracking --seconds 0.1 --json '" + file.string() + "'", folder);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto tracking = nlohmann::json::parse(test::text_of(file)).at("tracking");
  const auto frames = tracking["frame_us"]["count"].get<int>();
  EXPECT_GT(frames, 100);
  for (const char* part : {"needle", "rigid", "contours", "report"}) {
    EXPECT_EQ(tracking["parts_us"][part]["count"].get<int>(), frames) << part;
    EXPECT_GT(tracking["parts_us"][part]["max"].get<double>(), 0.0) << part;
  }
  EXPECT_GE(tracking["detect_us"]["count"].get<int>(), 5);
  EXPECT_GT(tracking["frames_per_s"].get<double>(), 0.0);
}

// Three simulated operators in all four modalities: files that a script can read, and the same ones again.
TEST(Commands, TrialTellsOfTheSimulatedOperatorInAllModalities) {
  const auto folder = test::fresh_folder("commands_trial", testing::TempDir());
  const auto run = [&](const std::string& name) {
    return test::run_program(
        "trial --simulated --trials 3 --seed 11 --no-picture --output '" + (folder / name).string() + "'", folder);
  };
  const auto outcome = run("one");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("SIMULATED operator"), std::string::npos);
  EXPECT_NE(outcome.out.find("guide, same simulated operator"), std::string::npos);
  const auto text_of = [&](const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(folder / name / "trials.csv").rdbuf();
    return text.str();
  };
  std::istringstream rows(text_of("one"));
  int count = -1;
  for (std::string row; std::getline(rows, row); ++count) {
    EXPECT_EQ(row.rfind(count < 0 ? "operator,modality,seed,success" : "simulated,", 0), 0U) << row;
  }
  EXPECT_EQ(count, 12);
  EXPECT_TRUE(fs::exists(folder / "one" / "summary.csv"));
  ASSERT_EQ(run("two").exit_code, 0);
  EXPECT_EQ(text_of("two"), text_of("one"));
}

TEST(Commands, InjectAndTrialNameModalitiesAlike) {
  const auto folder = test::fresh_folder("commands_modalities", testing::TempDir());
  const auto exit_code = [&](const std::string& options) {
    return test::run_program(options + " --scenario nowhere.json --output '" + (folder / "t").string() + "'", folder)
        .exit_code;
  };
  for (const std::string name : {"2d", "3d", "haptics", "guide"}) {
    EXPECT_EQ(exit_code("trial --simulated --modality " + name), 3) << name;
    EXPECT_EQ(exit_code("inject --modality " + name), 3) << name;
  }
  // By their earlier names, too.
  for (const std::string name : {"image", "3d+haptics", "3d+haptics+guide"}) {
    EXPECT_EQ(exit_code("inject --modality " + name), 3) << name;
  }
  EXPECT_EQ(exit_code("inject --modality 4d"), 2);
}

TEST(Commands, TrialWithoutItsOptionsIsWrongUsage) {
  const auto folder = test::fresh_folder("commands_trial_usage", testing::TempDir());
  const std::string output = "--output '" + (folder / "t").string() + "'";
  EXPECT_EQ(test::run_program("trial " + output, folder).exit_code, 2);
  EXPECT_EQ(test::run_program("trial --simulated", folder).exit_code, 2);
  EXPECT_EQ(test::run_program("trial --simulated --modality 4d " + output, folder).exit_code, 2);
  EXPECT_EQ(test::run_program("trial --simulated --scenario default " + output, folder).exit_code, 2);
  EXPECT_EQ(test::run_program("trial --simulated --scenario nowhere.json " + output, folder).exit_code, 3);
  EXPECT_EQ(test::run_program("trial --simulated --trials 1 --no-picture --output /proc/none/t", folder).exit_code, 5);
}

}  // namespace
}  // namespace pellucida
