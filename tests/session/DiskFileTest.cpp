#include "DiskFile.h"

#include <cerrno>

#include "TestSession.h"

namespace pellucida {
namespace {

using namespace test;

TEST(DiskFile, ReplacesAtOnce) {
  const TemporaryFolder folder;
  replace_file(folder / "a", "one");
  replace_file(folder / "a", "two");
  EXPECT_EQ(read_whole_file(folder / "a"), "two");
  EXPECT_FALSE(fs::exists(folder / "a.tmp"));
}

TEST(DiskFile, FailedReplacementKeepsTheOldFile) {
  const TemporaryFolder folder;
  replace_file(folder / "a", "one");
  // A folder in the way of the temporary file represents any refusal of the system.
  fs::create_directories(folder / "a.tmp");
  EXPECT_THROW(replace_file(folder / "a", "two"), OutputError);
  EXPECT_EQ(read_whole_file(folder / "a"), "one");
}

TEST(DiskFile, FullDeviceIsAnOutputErrorThatSaysSo) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const TemporaryFolder folder;
  fs::create_symlink("/dev/full", folder / "a.tmp");
  try {
    replace_file(folder / "a", "content");
    FAIL() << "a full device took it";
  } catch (const OutputError& error) {
    EXPECT_NE(std::string(error.what()).find("No space left on device); free some space"), std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(fs::exists(folder / "a"));
}

TEST(DiskFile, AppendsWholeLines) {
  const TemporaryFolder folder;
  AppendFile file(folder / "t.csv", "a,b");
  file.append("1,2");
  EXPECT_EQ(read_whole_file(folder / "t.csv"), "a,b\n1,2\n");
  EXPECT_EQ(file.byte_count(), 8U);
  EXPECT_THROW(AppendFile(folder / "t.csv", "a,b"), OutputError);
}

TEST(DiskFile, ReasonAndHelpAreOneLine) {
  for (const int reason : {ENOSPC, EACCES, EROFS, EFBIG, EIO, ENOTDIR}) {
    const std::string text = disk_error("/some/where", reason).what();
    EXPECT_TRUE(text.starts_with("/some/where: can't be written (")) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_NE(text.find("; "), std::string::npos);
  }
}

TEST(DiskFile, ReadingSaysWhyNot) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_whole_file(folder / "nothing"), InputError);
  EXPECT_THROW(read_whole_file(folder / ""), InputError);
}

}  // namespace
}  // namespace pellucida
