#include "ContainerExtent.h"

#include "TestFiles.h"

namespace pellucida {
namespace {

using namespace test;

TEST(ContainerExtent, WholeFilesAreNotCutOff) {
  const TemporaryFolder folder;
  write_video(folder / "a.avi", 20, 30.0);
  write_video(folder / "b.mp4", 20, 30.0, "mp4v");
  write_video(folder / "c.mkv", 20, 30.0);
  EXPECT_EQ(container_extent(folder / "a.avi").kind, ContainerExtent::Kind::kRiff);
  EXPECT_EQ(container_extent(folder / "b.mp4").kind, ContainerExtent::Kind::kIso);
  EXPECT_EQ(container_extent(folder / "c.mkv").kind, ContainerExtent::Kind::kMatroska);
  for (const char* name : {"a.avi", "b.mp4", "c.mkv"}) {
    const ContainerExtent extent = container_extent(folder / name);
    EXPECT_FALSE(extent.cut_off()) << name;
    EXPECT_GT(extent.declared_bytes, 0U) << name;
    EXPECT_EQ(extent.file_bytes, fs::file_size(folder / name)) << name;
  }
}

TEST(ContainerExtent, EachCutIsSeen) {
  const TemporaryFolder folder;
  write_video(folder / "a.avi", 20, 30.0);
  write_video(folder / "b.mp4", 20, 30.0, "mp4v");
  write_video(folder / "c.mkv", 20, 30.0);
  for (const double share : {0.99, 0.7, 0.3}) {
    for (const char* name : {"a.avi", "b.mp4", "c.mkv"}) {
      const std::string part = folder / (std::string("cut_") + name);
      fs::copy_file(folder / name, part, fs::copy_options::overwrite_existing);
      cut(part, share);
      EXPECT_TRUE(container_extent(part).cut_off()) << name << " at " << share;
    }
  }
}

TEST(ContainerExtent, OtherFilesDeclareNothing) {
  const TemporaryFolder folder;
  put(folder / "short", "RIFF");
  put(folder / "text", "just some words in a file");
  for (const char* name : {"short", "text", "missing"}) {
    EXPECT_FALSE(container_extent(folder / name).cut_off()) << name;
    EXPECT_EQ(container_extent(folder / name).kind, ContainerExtent::Kind::kUnknown) << name;
  }
}

// A second box whose 64 bit size leads back to the first.
TEST(ContainerExtent, ASizeThatGoesRoundEndsThere) {
  const TemporaryFolder folder;
  const std::string first(
      "\0\0\0\x10"
      "ftyp"
      "isomisom",
      16);
  put(folder / "x", first + std::string("\0\0\0\x01"
                                        "free"
                                        "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xF0",
                                        16));
  const ContainerExtent extent = container_extent(folder / "x");
  EXPECT_EQ(extent.kind, ContainerExtent::Kind::kIso);
  EXPECT_TRUE(extent.cut_off());
}

// No head, however garbled, may send the reader round in circles.
TEST(ContainerExtent, GarbledHeadsEnd) {
  const TemporaryFolder folder;
  cv::RNG random(11);
  for (const std::string& start :
       {std::string("RIFF"), std::string("\0\0\0\0ftyp", 8), std::string("\x1A\x45\xDF\xA3")}) {
    for (int i = 0; i < 200; ++i) {
      std::string bytes = start;
      while (bytes.size() < 64) bytes += static_cast<char>(random.uniform(0, 256) * (random.uniform(0, 3) == 0));
      put(folder / "x", bytes);
      const ContainerExtent extent = container_extent(folder / "x");
      EXPECT_EQ(extent.file_bytes, 64U);
    }
  }
}

}  // namespace
}  // namespace pellucida
