#include "pellucida/acquisition/FolderContent.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "support/Files.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

Names names(const std::vector<fs::path>& files) {
  Names result;
  for (const fs::path& file : files) result.push_back(file.filename());
  return result;
}

const cv::Mat kPixels(8, 8, CV_8U, cv::Scalar(7));

TEST(FolderContent, KindsAreRecognised) {
  const TemporaryFolder folder;
  for (const char* file : {"b10.avi", "b9.AVI", "notes.txt", "table.csv", ".hidden.mp4"})
    test::put(folder / file, "text");
  fs::create_symlink("nowhere", folder / "gone.mkv");
  fs::create_directories(folder / "below.avi");
  ASSERT_TRUE(cv::imwrite((folder / "2.png").string(), kPixels));
  ASSERT_TRUE(cv::imwrite((folder / "10.tif").string(), kPixels));
  // An image without an ending is one all the same; an empty one keeps its place.
  fs::copy_file(folder / "2.png", folder / "image");
  test::put(folder / "3.jpg", "");
  const FolderContent content = content_of(folder.path());
  EXPECT_EQ(names(content.videos), (Names{"b9.AVI", "b10.avi", "gone.mkv"}));
  EXPECT_EQ(names(content.images), (Names{"2.png", "3.jpg", "10.tif", "image"}));
  EXPECT_EQ(names(content.folders), (Names{"below.avi"}));
  EXPECT_TRUE(content.stacks.empty());
}

TEST(FolderContent, PagesMakeAStack) {
  const TemporaryFolder folder;
  test::put(folder / "1 torn.tif", "II*");
  ASSERT_TRUE(cv::imwritemulti((folder / "2.tif").string(), std::vector<cv::Mat>(3, kPixels)));
  ASSERT_TRUE(cv::imwrite((folder / "overview.png").string(), kPixels));
  const FolderContent content = content_of(folder.path());
  EXPECT_EQ(names(content.stacks), (Names{"1 torn.tif", "2.tif"}));
  EXPECT_EQ(names(content.images), (Names{"overview.png"}));
}

TEST(FolderContent, WhatIsNoFolderIsAnError) {
  const TemporaryFolder folder;
  EXPECT_THROW(content_of(folder / "nowhere"), InputError);
}

}  // namespace
}  // namespace pellucida
