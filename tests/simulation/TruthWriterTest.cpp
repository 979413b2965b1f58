#include <gtest/gtest.h>

#include <filesystem>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida {
namespace {

TEST(TruthWriter, WhatIsWrittenReadsBack) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "truth-writer";
  std::filesystem::create_directories(folder);
  VirtualMicroscope microscope(
      parse_scenario(R"({"image": {"frame_rate_hz": 2}, "cell": {"perivitelline_gap_um": 3}})", "test"));
  long frames = 0;
  Truth last;
  {
    TruthWriter writer(folder / "t.csv");
    while (microscope.next()) {
      writer.write(microscope.truth());
      last = microscope.truth();
      ++frames;
    }
  }

  const Table rows = Table::read(folder / "t.csv");
  ASSERT_EQ(rows.rows(), frames);
  const auto end = frames - 1;
  EXPECT_EQ(rows.column("frame")(end), static_cast<double>(end));
  EXPECT_NEAR(rows.column("time_s")(end), last.observation.time_s, 1e-8);
  EXPECT_EQ(rows.column("state")(0), 1.0);
  EXPECT_EQ(rows.column("state")(end), 2.0);
  EXPECT_NEAR(rows.column("contact_force_uN")(end), last.contact_force_uN, 1e-7);
  EXPECT_NEAR(rows.column("tip_x_um")(end), last.observation.needle->tip_um.x(), 1e-6);
  EXPECT_NEAR(rows.column("volume_um3")(end), last.volume_um3, 5e-4);
  EXPECT_NEAR(rows.column("axis_deg")(end), 0.0, 1e-9);

  // All three membranes of each frame.
  const Table contours = Table::read(folder / "t_contours.csv");
  const auto points = last.observation.outer->points_um.cols();
  ASSERT_EQ(contours.rows(), frames * 3 * points);
  EXPECT_EQ(contours.column("membrane")(contours.rows() - 1), 2.0);
  const auto first_outer = contours.rows() - 3 * points;
  EXPECT_NEAR(contours.column("x_um")(first_outer), last.observation.outer->points_um(0, 0), 1e-6);
  std::filesystem::remove_all(folder);
}

TEST(TruthWriter, UnwritableFileIsAnOutputError) {
  EXPECT_THROW(TruthWriter("/no/such/folder/t.csv"), OutputError);
}

}  // namespace
}  // namespace pellucida
