#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <filesystem>

#include "pellucida/charts_vtk/RenderPicture.h"
#include "pellucida/core/Error.h"
#include "pellucida/visualization_vtk/MessageLog.h"
#include "visualization/SyntheticScene.h"

namespace pellucida {
namespace {

std::filesystem::path out_file(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / name;
}

TEST(RenderPicture, WritesAPngOfTheSizeAskedWithoutVtkProblems) {
  MessageLog* log = MessageLog::install();
  const auto problems = log->problem_count();
  const auto file = out_file("pellucida_picture.png");
  const auto rows = test::synthetic_rows(120, 30.0);
  render_picture(test::synthetic_scene(30.0, 119), rows, file, {.width_px = 1600, .height_px = 1100});
  EXPECT_EQ(log->problem_count(), problems) << log->last_problem();

  vtkNew<vtkPNGReader> reader;
  ASSERT_TRUE(reader->CanReadFile(file.c_str()));
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], 1600);
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[1], 1100);
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

TEST(RenderPicture, DrawsASceneThatHoldsNothing) {
  MessageLog* log = MessageLog::install();
  const auto problems = log->problem_count();
  const auto file = out_file("pellucida_empty.png");
  render_picture(Scene{}, {}, file, {.width_px = 800, .height_px = 600});
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_EQ(log->problem_count(), problems) << log->last_problem();
}

TEST(RenderPicture, RefusesAFolderThatIsNotThere) {
  EXPECT_THROW(render_picture(Scene{}, {}, out_file("no_such_folder/picture.png"), {.width_px = 400, .height_px = 300}),
               OutputError);
}

TEST(RenderPicture, RefusesASizeNobodyCanRead) {
  EXPECT_THROW(render_picture(Scene{}, {}, out_file("tiny.png"), {.width_px = 10, .height_px = 10}), UsageError);
}

}  // namespace
}  // namespace pellucida
