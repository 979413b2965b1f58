#include "pellucida/simulation/FrameWriter.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <vector>

#include "pellucida/acquisition/OpenSource.h"
#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "simulation/TestScenes.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

class FrameWriterTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("frame-writer-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static Scenario small(int bit_depth) {
    return parse_scenario(R"({"image": {"width_px": 320, "height_px": 240, "duration_s": 0.2, "bit_depth": )" +
                              std::to_string(bit_depth) + R"(}, "cell": {"center_x_um": 120, "center_y_um": 100}})",
                          "test");
  }

  fs::path folder_;
};

using test::bytes_of;

// Writes a short scene, opens it as any recording is opened, and compares every byte.
void expect_lossless(const fs::path& output, const Scenario& scenario) {
  VirtualMicroscope microscope(scenario);
  const auto writer = FrameWriter::open(output, microscope.info());
  std::vector<std::vector<unsigned char>> written;
  while (const auto frame = microscope.next()) {
    writer->write(*frame);
    written.push_back(bytes_of(*frame));
  }
  writer->close();
  EXPECT_NE(writer->format().find("lossless"), std::string::npos);

  SourceOptions options;
  options.pixel_size_um = scenario.image.pixel_size_um;
  options.frame_rate_hz = scenario.image.frame_rate_hz;
  const auto source = open_source(output.string(), options);
  EXPECT_EQ(source->info().bit_depth, scenario.image.bit_depth);
  std::size_t count = 0;
  while (const auto frame = source->next()) {
    ASSERT_LT(count, written.size());
    EXPECT_EQ(bytes_of(*frame), written[count]) << "frame " << count;
    ++count;
  }
  EXPECT_EQ(count, written.size());
}

TEST_F(FrameWriterTest, AviIsLossless) {
  expect_lossless(folder_ / "v.avi", small(8));
}
TEST_F(FrameWriterTest, MatroskaIsLossless) {
  expect_lossless(folder_ / "v.mkv", small(8));
}
TEST_F(FrameWriterTest, TiffIsLossless) {
  expect_lossless(folder_ / "v.tif", small(8));
}
TEST_F(FrameWriterTest, Tiff16IsLossless) {
  expect_lossless(folder_ / "v.tiff", small(16));
}
TEST_F(FrameWriterTest, FolderIsLossless) {
  expect_lossless(folder_ / "frames", small(8));
}
TEST_F(FrameWriterTest, Folder16IsLossless) {
  expect_lossless(folder_ / "frames", small(16));
}

TEST_F(FrameWriterTest, TiffKnowsItsScale) {
  VirtualMicroscope microscope(small(8));
  const auto writer = FrameWriter::open(folder_ / "v.tif", microscope.info());
  while (const auto frame = microscope.next()) writer->write(*frame);
  writer->close();
  const auto source = open_source((folder_ / "v.tif").string(), {});
  EXPECT_NEAR(source->info().pixel_size_um, 0.825, 1e-6);
  EXPECT_NEAR(source->info().frame_rate_hz, 30.0, 1e-6);
  EXPECT_EQ(source->info().pixel_size_origin, "metadata");
}

TEST_F(FrameWriterTest, Mp4SaysThatItIsLossy) {
  VirtualMicroscope microscope(small(8));
  const auto writer = FrameWriter::open(folder_ / "v.mp4", microscope.info());
  while (const auto frame = microscope.next()) writer->write(*frame);
  writer->close();
  EXPECT_NE(writer->format().find("lossy"), std::string::npos);
  EXPECT_GT(fs::file_size(folder_ / "v.mp4"), 1000u);
}

TEST_F(FrameWriterTest, WrongOutputsAreRefused) {
  const VirtualMicroscope eight(small(8)), sixteen(small(16));
  EXPECT_THROW(FrameWriter::open(folder_ / "v.gif", eight.info()), UsageError);
  EXPECT_THROW(FrameWriter::open(folder_ / "v.avi", sixteen.info()), UsageError);
  EXPECT_THROW(FrameWriter::open(folder_ / "none" / "v.avi", eight.info()), OutputError);
  EXPECT_THROW(FrameWriter::open(folder_ / "none" / "v.tif", eight.info()), OutputError);
  // A file is where the folder should be made.
  std::FILE* file = std::fopen((folder_ / "taken").c_str(), "w");
  std::fclose(file);
  EXPECT_THROW(FrameWriter::open(folder_ / "taken", eight.info()), OutputError);
}

}  // namespace
}  // namespace pellucida
