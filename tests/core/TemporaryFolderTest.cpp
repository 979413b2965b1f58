#include "pellucida/core/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace pellucida {
namespace {

TEST(TemporaryFolder, GoesAwayWithAllInIt) {
  std::filesystem::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    EXPECT_TRUE(std::filesystem::is_empty(path));
    std::filesystem::create_directories(folder / "deep");
    std::ofstream(folder / "deep" / "file") << "x";
    EXPECT_NE(TemporaryFolder().path(), path);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace pellucida
