#include "pellucida/core/OutputFile.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>

#include "pellucida/core/TemporaryFolder.h"
#include "support/Files.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;
using test::put;
using test::text_of;

TEST(OutputFile, IsThereWhenItIsWhole) {
  const TemporaryFolder folder;
  put(folder / "a", "old");
  {
    OutputFile file(folder / "a");
    file.add("one");
    file.write("two");
    EXPECT_EQ(text_of(folder / "a"), "old");
    file.finish();
  }
  EXPECT_EQ(text_of(folder / "a"), "one\ntwo");
  EXPECT_FALSE(fs::exists(folder / "a.tmp"));
}

TEST(OutputFile, LeavesTheOlderOneWhereItIsNotFinished) {
  const TemporaryFolder folder;
  put(folder / "a", "old");
  { OutputFile(folder / "a").write("new"); }
  EXPECT_EQ(text_of(folder / "a"), "old");
  EXPECT_FALSE(fs::exists(folder / "a.tmp"));
}

TEST(OutputFile, TakesNoOtherFilesPlaceWhileItIsMade) {
  const TemporaryFolder folder;
  put(folder / "outside", "mine");
  put(folder / "a.1.tmp", "mine");
  fs::create_symlink(folder / "outside", folder / "a.tmp");
  replace_file(folder / "a", "new");
  EXPECT_EQ(text_of(folder / "a"), "new");
  EXPECT_EQ(text_of(folder / "outside"), "mine");
  EXPECT_EQ(text_of(folder / "a.1.tmp"), "mine");
}

TEST(OutputFile, FollowsAUsersLinkAndReplacesAStrangers) {
  const TemporaryFolder folder;
  put(folder / "far", "old");
  fs::create_symlink(folder / "far", folder / "a");
  OutputFile file(folder / "a");
  file.write("new");
  file.finish();
  EXPECT_EQ(text_of(folder / "far"), "new");
  EXPECT_TRUE(fs::is_symlink(folder / "a"));
  replace_file(folder / "a", "newer");
  EXPECT_EQ(text_of(folder / "far"), "new");
  EXPECT_FALSE(fs::is_symlink(folder / "a"));
}

TEST(OutputFile, WritesToADeviceItself) {
  OutputFile file("/dev/null");
  file.add("gone");
  file.finish();
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(OutputFile, FullDeviceIsAnOutputErrorThatSaysSo) {
  ASSERT_TRUE(fs::is_character_file("/dev/full"));
  OutputFile file("/dev/full");
  file.add("content");
  try {
    file.finish();
    FAIL() << "a full device took it";
  } catch (const OutputError& error) {
    EXPECT_NE(std::string(error.what()).find("No space left on device); free some space"), std::string::npos)
        << error.what();
  }
}

TEST(OutputFile, AFolderInTheWayIsAnOutputError) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "a" / "b");
  EXPECT_THROW(OutputFile(folder / "a"), OutputError);
  EXPECT_THROW(replace_file(folder / "a", "new"), OutputError);
  EXPECT_THROW(OutputFile(folder / "nowhere" / "a"), OutputError);
}

TEST(OutputFile, ReasonAndHelpAreOneLine) {
  for (const int reason : {ENOSPC, EACCES, EROFS, EFBIG, EIO, ENOTDIR}) {
    const std::string text = disk_error("/some/where", reason).what();
    EXPECT_TRUE(text.starts_with("/some/where: can't be written (")) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_NE(text.find("; "), std::string::npos);
  }
}

TEST(OutputFile, AnInputIsKnownByEveryName) {
  const TemporaryFolder folder;
  put(folder / "a", "input");
  fs::create_hard_link(folder / "a", folder / "b");
  fs::create_symlink(folder / "a", folder / "c");
  for (const char* name : {"a", "b", "c"}) {
    EXPECT_THROW(require_apart(folder / name, folder / "a", "--output"), UsageError) << name;
  }
  EXPECT_NO_THROW(require_apart(folder / "d", folder / "a", "--output"));
  EXPECT_NO_THROW(require_apart(folder / "a", "", "--output"));
}

}  // namespace
}  // namespace pellucida
