#include "pellucida/core_vtk/SceneData.h"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>

#include <cstdint>
#include <vector>

namespace pellucida {
namespace {

Observation two_squares() {
  Observation o;
  o.time_s = 0.5;
  o.frame_index = 15;
  o.center_um = {5.0, 5.0};
  o.axis = {1.0, 0.0};
  MembraneContour outer;
  outer.points_um.resize(2, 4);
  outer.points_um << 0, 10, 10, 0, 0, 0, 10, 10;
  outer.sigma_um = Eigen::VectorXd::Constant(4, 0.2);
  MembraneContour inner = outer;
  inner.membrane = Membrane::kInner;
  inner.sigma_um.resize(0);
  o.outer = outer;
  o.inner = inner;
  NeedlePose needle;
  needle.outline_um.resize(2, 2);
  needle.outline_um << 10, 40, 5, 5;
  o.needle = needle;
  return o;
}

TEST(SceneData, FrameKeepsPixelsSpacingAndStamp) {
  // Rows padded to 8 bytes, as cameras and libraries hand them out.
  const std::vector<std::uint8_t> pixels{1, 2, 3, 0, 0, 0, 0, 0, 4, 5, 6, 0, 0, 0, 0, 0};
  const auto frame = make_frame({.data = pixels.data(),
                                 .format = PixelFormat::kGray8,
                                 .width_px = 3,
                                 .height_px = 2,
                                 .row_bytes = 8,
                                 .pixel_size_um = 0.825},
                                1.25, 30);
  EXPECT_DOUBLE_EQ(frame->GetSpacing()[0], 0.825);
  EXPECT_DOUBLE_EQ(stamped_time_s(frame), 1.25);
  EXPECT_EQ(stamped_frame_index(frame), 30);
  EXPECT_EQ(frame->GetFieldData()->GetArray("schema_version")->GetNumberOfTuples(), 1);

  const ImageView view = view_of(frame);
  EXPECT_EQ(view.row_bytes, 3);
  const auto* bytes = static_cast<const std::uint8_t*>(view.data);
  EXPECT_EQ(std::vector<std::uint8_t>(bytes, bytes + 6), (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}));
}

TEST(SceneData, SixteenBitFramesStaySixteenBit) {
  const std::vector<std::uint16_t> pixels{100, 60000};
  const auto frame = make_frame({.data = pixels.data(),
                                 .format = PixelFormat::kGray16,
                                 .width_px = 2,
                                 .height_px = 1,
                                 .row_bytes = 4,
                                 .pixel_size_um = 1.0},
                                0.0, 0);
  EXPECT_EQ(frame->GetScalarType(), VTK_UNSIGNED_SHORT);
  EXPECT_EQ(static_cast<const std::uint16_t*>(view_of(frame).data)[1], 60000);
}

TEST(SceneData, MembranesAreClosedPolylinesWithTheContractsArrays) {
  const auto data = make_membranes(two_squares());
  ASSERT_EQ(data->GetNumberOfCells(), 2);
  vtkCell* line = data->GetCell(0);
  ASSERT_EQ(line->GetNumberOfPoints(), 5);
  EXPECT_EQ(line->GetPointId(0), line->GetPointId(4));
  EXPECT_EQ(data->GetCellData()->GetArray("membrane")->GetComponent(1, 0), 1);
  EXPECT_FLOAT_EQ(data->GetPointData()->GetArray("sigma_um")->GetComponent(0, 0), 0.2F);
  EXPECT_FLOAT_EQ(data->GetPointData()->GetArray("sigma_um")->GetComponent(4, 0), 0.0F);
  EXPECT_DOUBLE_EQ(data->GetFieldData()->GetArray("center_um")->GetComponent(0, 1), 5.0);
  EXPECT_DOUBLE_EQ(stamped_time_s(data), 0.5);
}

TEST(SceneData, TheNeedlesFirstPointIsItsTip) {
  const auto data = make_tools(two_squares());
  ASSERT_EQ(data->GetNumberOfCells(), 1);
  EXPECT_EQ(data->GetCellData()->GetArray("tool")->GetComponent(0, 0), 0);
  double point[3];
  data->GetPoint(data->GetCell(0)->GetPointId(0), point);
  EXPECT_DOUBLE_EQ(point[0], 10.0);
}

TEST(SceneData, TheToolsSayHowSureTheyAreAndWhatTold) {
  Observation seen = two_squares();
  seen.needle->confidence = 0.75;
  seen.needle->tip_sigma_um = 0.125;
  seen.needle->evidence = kShaftEdges | kKnownCone;
  const auto data = make_tools(seen);
  EXPECT_FLOAT_EQ(data->GetCellData()->GetArray("confidence")->GetComponent(0, 0), 0.75F);
  EXPECT_FLOAT_EQ(data->GetCellData()->GetArray("tip_sigma_um")->GetComponent(0, 0), 0.125F);
  EXPECT_EQ(data->GetCellData()->GetArray("evidence")->GetComponent(0, 0), 5);
}

TEST(SceneData, AnEmptyObservationGivesEmptyStampedData) {
  EXPECT_EQ(make_membranes({})->GetNumberOfCells(), 0);
  EXPECT_EQ(make_tools({})->GetNumberOfCells(), 0);
}

}  // namespace
}  // namespace pellucida
