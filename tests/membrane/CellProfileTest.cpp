#include "pellucida/membrane/CellProfile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "support/DocsPage.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

class CellProfileFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("pellucida-profile-" + std::to_string(std::random_device{}()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& text) const {
    const fs::path file = folder_ / "cell.json";
    std::ofstream(file) << text;
    return file;
  }

  /// The text of the InputError that reading `text` gives.
  std::string fault(const std::string& text) const {
    try {
      read_profile(write(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_;
};

TEST(ShippedProfiles, HoldTableOneAndTheirGeometry) {
  const CellProfile oocyte = load_profile("mouse-oocyte");
  EXPECT_EQ(oocyte.name, "mouse-oocyte");
  EXPECT_DOUBLE_EQ(oocyte.young_modulus_kPa, 17.9);
  EXPECT_DOUBLE_EQ(oocyte.puncture_force_uN, 7.5);
  EXPECT_DOUBLE_EQ(oocyte.puncture_indentation_um, 44.0);
  const CellProfile embryo = load_profile("mouse-embryo");
  EXPECT_DOUBLE_EQ(embryo.young_modulus_kPa, 42.2);
  EXPECT_DOUBLE_EQ(embryo.puncture_force_uN, 13.0);
  EXPECT_DOUBLE_EQ(embryo.puncture_indentation_um, 53.0);
  for (const auto& profile : {oocyte, embryo}) {
    EXPECT_DOUBLE_EQ(profile.mid_radius_um, 50.0);
    EXPECT_DOUBLE_EQ(profile.thickness_um, 5.0);
    EXPECT_DOUBLE_EQ(profile.inner_radius_um, 47.5);
    EXPECT_GT(profile.effective_young_modulus_kPa, profile.young_modulus_kPa);
    EXPECT_FALSE(profile.sources.empty());
    EXPECT_FALSE(profile.errors.empty());
  }
}

// One oocyte of unknown size gave 10 to 35 kPa (docs/method.md, 3.7), and was not punctured: the profile says all of
// that.
TEST(ShippedProfiles, TheOneOfARecordIsAsSoftAndAsUnsure) {
  const CellProfile afm = load_profile("oocyte-afm"), oocyte = load_profile("mouse-oocyte");
  EXPECT_GT(afm.young_modulus_kPa, 10.0);
  EXPECT_LT(afm.young_modulus_kPa, 35.0);
  EXPECT_GT(afm.effective_young_modulus_kPa, 10.0);
  EXPECT_LT(afm.effective_young_modulus_kPa, 35.0);
  EXPECT_NEAR(afm.puncture_force_uN / oocyte.puncture_force_uN,
              afm.effective_young_modulus_kPa / oocyte.effective_young_modulus_kPa, 1e-3);
  EXPECT_GE(afm.force_scale_relative_sigma, 0.5);
  EXPECT_EQ(afm.relaxation_arms.size(), 2U);
  EXPECT_NE(to_json(afm).find("not measured"), std::string::npos);
}

TEST(ShippedProfiles, AnUnknownNameIsAUsageErrorThatNamesTheKnown) {
  try {
    load_profile("mouse-ocyte");
    FAIL();
  } catch (const UsageError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("mouse-ocyte"), std::string::npos);
    EXPECT_NE(text.find("mouse-embryo, mouse-oocyte"), std::string::npos);
  }
}

TEST_F(CellProfileFile, WhatIsWrittenReadsBackTheSame) {
  const std::string text = to_json(load_profile("mouse-oocyte"));
  const CellProfile again = load_profile(write(text).string());
  EXPECT_EQ(to_json(again), text);
}

TEST(ShippedProfiles, KeysAreOnThePage) {
  CellProfile profile;
  ProfileReference reference;
  ProfileError error;
  RelaxationArm arm;
  GeometryRange range;
  GeometryTerm term;
  const std::string page = markdown(fields_of(profile)) + "\n### with relaxation_arms\n\n" +
                           markdown(relaxation_fields_of(profile)) + "\n### relaxation_arms, an entry\n\n" +
                           markdown(fields_of(arm)) + "\n### with geometry_terms\n\n" + markdown(fields_of(range)) +
                           "\n### geometry_terms, an entry\n\n" + markdown(fields_of(term)) +
                           "\n### references, an entry\n\n" + markdown(fields_of(reference)) +
                           "\n### errors, an entry\n\n" + markdown(fields_of(error));
  EXPECT_TRUE(docs_section_is("profiles.md", "## Keys", page));
}

TEST_F(CellProfileFile, AMissingKeyIsNamed) {
  auto json = nlohmann::json::parse(to_json(load_profile("mouse-oocyte")));
  json["msd"]["body"].erase("k2_ratio");
  const std::string text = fault(json.dump());
  EXPECT_NE(text.find("cell.json"), std::string::npos);
  EXPECT_NE(text.find("msd.body.k2_ratio"), std::string::npos);
}

TEST_F(CellProfileFile, EveryNumberIsChecked) {
  const auto good = nlohmann::json::parse(to_json(load_profile("mouse-oocyte")));
  const std::vector<std::pair<std::string, nlohmann::json>> faults = {{"/geometry/mid_radius_um", -50},
                                                                      {"/geometry/thickness_um", 80},
                                                                      {"/geometry/inner_radius_um", 40},
                                                                      {"/material/young_modulus_kPa", "soft"},
                                                                      {"/material/poisson_ratio", 0.7},
                                                                      {"/material/effective_young_modulus_kPa", 0},
                                                                      {"/contact/tip_radius_um", 0},
                                                                      {"/msd/tip/hinge_ratio", -1},
                                                                      {"/mesh/frequency", 0},
                                                                      {"/geometry_range/tip_from_ratio", 0.9},
                                                                      {"/geometry_range/spread_ratio", -1},
                                                                      {"/geometry_terms/0/tip", 4},
                                                                      {"/geometry_pressure_terms/0/tip", 4},
                                                                      {"/schema", "other"},
                                                                      {"/schema_version", 99},
                                                                      {"/errors", 3}};
  for (const auto& [pointer, value] : faults) {
    auto broken = good;
    broken[nlohmann::json::json_pointer(pointer)] = value;
    const std::string text = fault(broken.dump());
    const std::string key = pointer.substr(pointer.rfind('/') + 1);
    EXPECT_NE(text.find(key), std::string::npos) << pointer << ": " << text;
  }
}

TEST_F(CellProfileFile, AFaultSaysWhereAndWhatIsAllowed) {
  auto json = nlohmann::json::parse(to_json(load_profile("mouse-oocyte")));
  json["contact"]["holder_half_width_um"] = 20;
  EXPECT_NE(fault(json.dump()).find("cell.json: contact.holder_half_width_um is 20; allowed: above 0, up to 17.5"),
            std::string::npos);
  json["contact"]["holder_half_width_um"] = 5;
  json["errors"][0]["to_um"] = "deep";
  EXPECT_NE(fault(json.dump()).find("cell.json: errors[0]: to_um is \"deep\", but must be a number"),
            std::string::npos);
}

TEST_F(CellProfileFile, TermsOfThePressureNeedThoseOfTheForce) {
  auto json = nlohmann::json::parse(to_json(load_profile("mouse-oocyte")));
  json.erase("geometry_terms");
  EXPECT_NE(fault(json.dump()).find("geometry_pressure_terms needs geometry_terms"), std::string::npos);
}

TEST_F(CellProfileFile, AFileThatIsNoJsonIsAnInputError) {
  EXPECT_NE(fault("not json at all").find("JSON"), std::string::npos);
  EXPECT_NE(fault("").find("JSON"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
