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
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("frog"), std::string::npos);
  }
}

}  // namespace
}  // namespace pellucida
