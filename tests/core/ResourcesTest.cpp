#include "pellucida/core/Resources.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

class ResourcesTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / "resources_test";
    fs::create_directories(folder_ / "profiles");
    std::ofstream(folder_ / "profiles" / "frog.json") << "{}";
    setenv("PELLUCIDA_RESOURCES", folder_.c_str(), 1);
  }
  void TearDown() override { unsetenv("PELLUCIDA_RESOURCES"); }

  fs::path folder_;
};

TEST_F(ResourcesTest, TheEnvironmentNamesTheFolder) {
  EXPECT_EQ(resource_folder(), folder_);
  EXPECT_EQ(list_resources("profiles", ".json"), std::vector<std::string>{"frog"});
  EXPECT_EQ(find_resource("profiles", "frog", ".json"), folder_ / "profiles" / "frog.json");
}

TEST_F(ResourcesTest, AFileOfTheUsersOwnIsTakenAsItIs) {
  const auto own = folder_ / "own.json";
  std::ofstream(own) << "{}";
  EXPECT_EQ(find_resource("profiles", own.string(), ".json"), own);
}

TEST_F(ResourcesTest, AnUnknownNameListsTheKnownOnes) {
  try {
    find_resource("profiles", "toad", ".json");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("frog"), std::string::npos);
  }
  // A file that isn't there is an input that can't be read.
  EXPECT_THROW(find_resource("profiles", "toad.json", ".json"), InputError);
  EXPECT_THROW(find_resource("profiles", "own/toad", ".json"), InputError);
}

/// The error that the rule ends in.
std::string fault_of(const char* named, const fs::path& program) {
  try {
    return "found " + resource_folder(named, program).string();
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST_F(ResourcesTest, AnInstalledProgramFindsThemBesideItself) {
  const fs::path prefix = folder_ / "prefix";
  fs::create_directories(prefix / "share" / "pellucida");
  EXPECT_EQ(resource_folder(nullptr, prefix / "bin" / "pellucida"), prefix / "share" / "pellucida");
  EXPECT_EQ(resource_folder("", prefix / "bin" / "pellucida"), prefix / "share" / "pellucida");
}

TEST_F(ResourcesTest, AnInstallationWithoutThemSaysWhereTheyShouldBe) {
  const fs::path prefix = folder_ / "bare";
  const std::string fault = fault_of(nullptr, prefix / "bin" / "pellucida");
  for (const std::string& part : {(prefix / "share" / "pellucida").string(), std::string("install Pellucida again"),
                                  std::string("PELLUCIDA_RESOURCES")}) {
    EXPECT_NE(fault.find(part), std::string::npos) << fault;
  }
}

TEST_F(ResourcesTest, AVariableThatNamesNoFolderIsAnErrorNotPassedOver) {
  fs::create_directories(folder_ / "prefix" / "share" / "pellucida");
  const fs::path missing = folder_ / "missing";
  const std::string fault = fault_of(missing.c_str(), folder_ / "prefix" / "bin" / "pellucida");
  EXPECT_NE(fault.find("PELLUCIDA_RESOURCES names " + missing.string()), std::string::npos) << fault;
}

// This program lies in a build tree.
TEST(Resources, ABuildTreeHasThoseOfItsSources) {
  EXPECT_TRUE(fs::equivalent(resource_folder(), fs::path(PELLUCIDA_SOURCE_DIR) / "resources"));
}

}  // namespace
}  // namespace pellucida
