#include "DiskFile.h"

#include <sys/stat.h>

#include "TestSession.h"

namespace pellucida {
namespace {

using namespace test;

TEST(DiskFile, AppendsWholeLines) {
  const TemporaryFolder folder;
  AppendFile file(folder / "t.csv", "a,b");
  file.append("1,2");
  EXPECT_EQ(read_whole_file(folder / "t.csv"), "a,b\n1,2\n");
  EXPECT_EQ(file.byte_count(), 8U);
  EXPECT_THROW(AppendFile(folder / "t.csv", "a,b"), OutputError);
}

TEST(DiskFile, ReadingSaysWhyNot) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_whole_file(folder / "nothing"), InputError);
  EXPECT_THROW(read_whole_file(folder / ""), InputError);
  put(folder / "a", "12345");
  EXPECT_EQ(read_whole_file(folder / "a", 5), "12345");
  EXPECT_THROW(read_whole_file(folder / "a", 4), InputError);
  fs::create_symlink(folder / "a", folder / "link");
  EXPECT_THROW(read_whole_file(folder / "link"), InputError);
  // A pipe nobody writes to is refused, not waited for.
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(read_whole_file(folder / "pipe"), InputError);
}

}  // namespace
}  // namespace pellucida
