#include "pellucida/core_vtk/StageSource.h"

#include <gtest/gtest.h>
#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

#include <cstdint>

#include "pellucida/core_vtk/SceneBlockFilter.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

Scene scene_with_frame(int width_px, long frame_index) {
  const std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width_px) * 4, 7);
  Scene scene;
  scene.frame = Frozen<vtkImageData>(make_frame({.data = pixels.data(),
                                                 .format = PixelFormat::kGray8,
                                                 .width_px = width_px,
                                                 .height_px = 4,
                                                 .row_bytes = width_px,
                                                 .pixel_size_um = 0.5},
                                                0.1 * frame_index, frame_index));
  return scene;
}

TEST(StageSource, PollHandsOutTheNewestSceneOnce) {
  auto exchange = std::make_shared<SharedLatest<Scene>>();
  vtkNew<StageSource> source;
  EXPECT_FALSE(source->Poll());
  source->SetExchange(exchange);
  EXPECT_FALSE(source->Poll());

  exchange->publish(scene_with_frame(8, 1));
  exchange->publish(scene_with_frame(8, 2));
  EXPECT_TRUE(source->Poll());
  EXPECT_FALSE(source->Poll());
  source->Update();
  auto* blocks = source->GetOutput();
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 5U);
  EXPECT_STREQ(blocks->GetMetaData(0U)->Get(vtkCompositeDataSet::NAME()), "frame");
  EXPECT_EQ(stamped_frame_index(blocks->GetBlock(0)), 2);
  EXPECT_EQ(blocks->GetBlock(3), nullptr);
}

TEST(SceneBlockFilter, GivesTheImageWithItsExtentEvenWhenTheSizeChanges) {
  vtkNew<StageSource> source;
  vtkNew<SceneBlockFilter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetBlock(SceneBlock::kFrame);
  for (const int width_px : {8, 16}) {
    source->SetScene(scene_with_frame(width_px, 0));
    filter->Update();
    auto* image = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
    ASSERT_NE(image, nullptr);
    EXPECT_EQ(image->GetDimensions()[0], width_px);
    EXPECT_DOUBLE_EQ(image->GetSpacing()[0], 0.5);
  }
}

TEST(SceneBlockFilter, AMissingPartIsAnEmptyPolyData) {
  vtkNew<StageSource> source;
  source->SetScene(scene_with_frame(8, 0));
  vtkNew<SceneBlockFilter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetBlock(SceneBlock::kSurface);
  filter->Update();
  auto* surface = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(surface, nullptr);
  EXPECT_EQ(surface->GetNumberOfPoints(), 0);
}

}  // namespace
}  // namespace pellucida
