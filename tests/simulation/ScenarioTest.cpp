#include "pellucida/simulation/Scenario.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "support/DocsPage.h"

namespace pellucida {
namespace {

// The message of the error that `text` brings about; "" when it brings none.
template <class ErrorType>
std::string message_of(const std::string& text) {
  try {
    parse_scenario(text, "test");
  } catch (const ErrorType& error) {
    return error.what();
  }
  return "";
}

TEST(Scenario, EmptyObjectIsTheDefault) {
  const Scenario scenario = parse_scenario("{}", "test");
  EXPECT_EQ(scenario.image.width_px, 728);
  EXPECT_EQ(scenario.image.height_px, 486);
  EXPECT_DOUBLE_EQ(scenario.image.pixel_size_um, 0.825);
  EXPECT_EQ(scenario.name, "test");
}

TEST(Scenario, ReadsEveryGroup) {
  const Scenario s = parse_scenario(
      R"({"description": "d", "seed": 9, "image": {"bit_depth": 16}, "cell": {"size_scale": 2}, "tools": {"mirrored": true},
          "motion": {"hold_s": 3}, "puncture": {"enabled": true}, "optics": {"noise": false}, "drift": {"x_um_per_s": -1},
          "debris": {"count": 0}, "lamp": {"step_ratio": 0.6}, "bystander": {"cell_radius_um": 30}})",
      "test");
  EXPECT_EQ(s.description, "d");
  EXPECT_EQ(s.seed, 9u);
  EXPECT_EQ(s.image.bit_depth, 16);
  EXPECT_EQ(s.cell.size_scale, 2);
  EXPECT_TRUE(s.tools.mirrored);
  EXPECT_EQ(s.motion.hold_s, 3);
  EXPECT_TRUE(s.puncture.enabled);
  EXPECT_FALSE(s.optics.noise);
  EXPECT_EQ(s.drift.x_um_per_s, -1);
  EXPECT_EQ(s.debris.count, 0);
  EXPECT_EQ(s.lamp.step_ratio, 0.6);
  EXPECT_EQ(s.bystander.cell_radius_um, 30);
}

TEST(Scenario, SaysWhichKeyIsUnknown) {
  EXPECT_EQ(message_of<UsageError>(R"({"lamp": {"blur": 1}})"),
            "scenario 'test': lamp.blur is an unknown key; known: step_time_s, step_ratio, flicker_ratio, flicker_hz");
  EXPECT_EQ(message_of<UsageError>(R"({"camera": {}})"),
            "scenario 'test': camera is an unknown key; known: description, look, seed, image, cell, tools, motion, "
            "puncture, "
            "optics, drift, lamp, debris, bystander");
}

TEST(Scenario, DefaultsAreInTheirRangesAndOnThePage) {
  Scenario scenario;
  EXPECT_NO_THROW(validate(scenario));
  EXPECT_TRUE(docs_section_is("scenarios.md", "## Keys", markdown(fields_of(scenario))));
}

TEST(Scenario, KeysMayFollowItsName) {
  const Scenario s = load_scenario("injection,cell.stiffness_ratio=0.5,seed=3,look=dic");
  EXPECT_EQ(s.name, "injection,cell.stiffness_ratio=0.5,seed=3,look=dic");
  EXPECT_EQ(s.cell.stiffness_ratio, 0.5);
  EXPECT_EQ(s.seed, 3U);
  EXPECT_EQ(s.look, "dic");
  EXPECT_EQ(s.motion.gap_um, load_scenario("injection").motion.gap_um);
  EXPECT_THROW(load_scenario("injection,cell.stiffness_ratio=50"), UsageError);
  EXPECT_THROW(load_scenario("injection,cell.colour=red"), UsageError);
  EXPECT_THROW(load_scenario("injection,seed"), UsageError);
  EXPECT_THROW(load_scenario("injection,seed.x=1"), UsageError);
}

TEST(Scenario, SaysWhichValueIsOutOfRange) {
  const std::string pixel = message_of<UsageError>(R"({"image": {"pixel_size_um": 0}})");
  EXPECT_NE(pixel.find("image.pixel_size_um is 0; allowed: 0.05 to 5"), std::string::npos) << pixel;
  const std::string depth = message_of<UsageError>(R"({"image": {"bit_depth": 12}})");
  EXPECT_NE(depth.find("allowed: 8 or 16"), std::string::npos) << depth;
  const std::string needle =
      message_of<UsageError>(R"({"tools": {"needle_tip_radius_um": 3, "needle_shaft_radius_um": 2}})");
  EXPECT_NE(needle.find("needle_shaft_radius_um is 2"), std::string::npos) << needle;
}

TEST(Scenario, SaysWhichTypeIsWrong) {
  EXPECT_NE(message_of<UsageError>(R"({"image": {"width_px": 100.5}})").find("image.width_px is 100.5"),
            std::string::npos);
  EXPECT_NE(message_of<UsageError>(R"({"image": 3})").find("image is no group"), std::string::npos);
  EXPECT_NE(message_of<UsageError>(R"({"seed": -1})").find("seed is -1"), std::string::npos);
  EXPECT_NE(message_of<UsageError>(R"({"optics": {"noise": 1}})").find("optics.noise is 1"), std::string::npos);
}

TEST(Scenario, TextThatIsNoJsonIsAnInputError) {
  EXPECT_NE(message_of<InputError>("{").find("is no JSON"), std::string::npos);
  EXPECT_NE(message_of<InputError>("{\"seed\": 1e999}").find("too large"), std::string::npos);
  EXPECT_NE(message_of<InputError>("[]").find("no JSON object"), std::string::npos);
}

TEST(Scenario, AnUnknownNameIsWrongUsage) {
  EXPECT_THROW(load_scenario("no-such-scenario"), UsageError);
}

TEST(Scenario, EmptyFileIsAnInputError) {
  const auto file = std::filesystem::path(testing::TempDir()) / "empty-scenario.json";
  std::ofstream(file).close();
  EXPECT_THROW(load_scenario(file.string()), InputError);
  std::filesystem::remove(file);
}

TEST(Scenario, DepthBeyondTheReferenceIsRefused) {
  EXPECT_THROW(VirtualMicroscope(parse_scenario(R"({"motion": {"indentation_um": 45}})", "test")), UsageError);
  // With a puncture before the limit the needle may go on.
  EXPECT_NO_THROW(VirtualMicroscope(
      parse_scenario(R"({"motion": {"indentation_um": 60}, "puncture": {"enabled": true}})", "test")));
  // A larger cell takes more.
  EXPECT_NO_THROW(
      VirtualMicroscope(parse_scenario(R"({"motion": {"indentation_um": 60}, "cell": {"size_scale": 1.5}})", "test")));
  EXPECT_THROW(VirtualMicroscope(parse_scenario(R"({"cell": {"reference": "frog"}})", "test")), UsageError);
  EXPECT_THROW(VirtualMicroscope(
                   parse_scenario(R"({"cell": {"reference": "mouse-embryo"}, "motion": {"indentation_um": 54}})", "t")),
               UsageError);
}

TEST(Scenario, EveryShippedOneOpens) {
  const auto names = scenario_names();
  EXPECT_GE(names.size(), 7u);
  for (const auto& name : names) {
    SCOPED_TRACE(name);
    const auto microscope = open_virtual(name);
    EXPECT_EQ(microscope->info().name, "virtual:" + name);
    EXPECT_EQ(microscope->info().pixel_size_origin, "scenario");
    EXPECT_FALSE(microscope->scenario().description.empty());
    EXPECT_TRUE(microscope->next().has_value());
  }
}

TEST(Scenario, DefaultIsTheMainJob) {
  const auto microscope = open_virtual("default");
  const auto count = *microscope->info().frame_count;
  EXPECT_GE(count, 150);
  EXPECT_LE(count, 200);

  // Some 15 frames without contact, then a force that never falls, to 7.5 uN at 44 um.
  int free_count = 0;
  double force = 0, indentation = 0;
  while (microscope->next()) {
    const Truth& truth = microscope->truth();
    if (truth.observation.state == CellState::kFree) ++free_count;
    EXPECT_GE(truth.contact_force_uN, force);
    EXPECT_LE(truth.contact_force_uN - force, 0.15);
    force = truth.contact_force_uN;
    indentation = truth.observation.indentation_um;
  }
  EXPECT_GE(free_count, 12);
  EXPECT_LE(free_count, 20);
  EXPECT_NEAR(force, 7.5, 1e-6);
  EXPECT_NEAR(indentation, 44.0, 1e-6);
}

}  // namespace
}  // namespace pellucida
