#include "pellucida/vtk_files/DataWriter.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <cstring>
#include <random>
#include <vector>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/vtk_files/DataFile.h"
#include "session/SameData.h"

namespace pellucida {
namespace {

using namespace test;

// As any program reads it that knows VTK's files.
template <class Reader>
auto read_by_vtk(const std::string& content) {
  vtkNew<Reader> reader;
  reader->SetReadFromInputString(true);
  reader->SetInputString(content);
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), 0UL);
  return vtkSmartPointer(reader->GetOutput());
}

vtkSmartPointer<vtkImageData> noisy_image(PixelFormat format, int width_px, int height_px) {
  std::mt19937 random(7);
  const std::size_t bytes = format == PixelFormat::kGray16 ? 2 : 1;
  std::vector<std::uint8_t> pixels(bytes * static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px));
  for (std::uint8_t& pixel : pixels) pixel = static_cast<std::uint8_t>(100 + random() % 9);
  return make_frame({pixels.data(), format, width_px, height_px, static_cast<std::ptrdiff_t>(bytes) * width_px, 0.4375},
                    0.25, 3);
}

template <class Array>
void add_array(vtkFieldData* arrays, const char* name, int components, vtkIdType count, double start) {
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i) {
    array->SetVariantValue(i, vtkVariant(start + 0.1 * static_cast<double>(i)));
  }
  arrays->AddArray(array);
}

// A strip of quads, `columns` of them, moved by `shift_um`, with a line along it and arrays of every kind.
vtkSmartPointer<vtkPolyData> banner(int columns, double shift_um) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads, lines;
  for (int i = 0; i <= columns; ++i) {
    points->InsertNextPoint(i + shift_um, 0.0, 0.1 * i);
    points->InsertNextPoint(i + shift_um, 1.0, 0.0);
  }
  lines->InsertNextCell(columns);
  for (vtkIdType i = 0; i < columns; ++i) {
    const vtkIdType quad[4] = {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1};
    quads->InsertNextCell(4, quad);
    lines->InsertCellPoint(2 * i);
  }
  data->SetPoints(points);
  data->SetLines(lines);
  data->SetPolys(quads);
  const vtkIdType count = points->GetNumberOfPoints();
  add_array<vtkFloatArray>(data->GetPointData(), "narrow", 3, count, shift_um);
  add_array<vtkDoubleArray>(data->GetPointData(), "wide", 1, count, shift_um);
  add_array<vtkIntArray>(data->GetPointData(), "kind <\"&\">", 1, count, 5.0);
  add_array<vtkIntArray>(data->GetCellData(), "cell", 2, columns + 1, 1.0);
  add_array<vtkDoubleArray>(data->GetFieldData(), "one_tuple", 3, 1, shift_um);
  data->GetFieldData()->GetArray("one_tuple")->SetComponentName(1, "middle_um");
  stamp(data, shift_um, 12);
  return data;
}

TEST(DataWriter, VtksOwnReaderGivesBackAnImage) {
  DataWriter writer;
  for (const PixelFormat format : {PixelFormat::kGray8, PixelFormat::kGray16}) {
    const auto image = noisy_image(format, 61, 47);
    const std::string small = writer.write(image, Packing::kSmall);
    const std::string quick = writer.write(image, Packing::kQuick);
    EXPECT_LT(small.size(), quick.size());
    for (const std::string& content : {small, quick}) {
      for (const auto& read : {read_by_vtk<vtkXMLImageDataReader>(content), image_from(content)}) {
        EXPECT_EQ(read->GetDimensions()[0], 61);
        EXPECT_EQ(read->GetDimensions()[1], 47);
        EXPECT_EQ(read->GetSpacing()[1], 0.4375);
        ASSERT_TRUE(read->GetPointData()->GetScalars());
        expect_same_arrays(image->GetPointData(), read->GetPointData());
        expect_same_arrays(image->GetFieldData(), read->GetFieldData());
      }
    }
  }
}

// Larger than one part of an array may be.
TEST(DataWriter, VtksOwnReaderGivesBackALargeImage) {
  const auto image = noisy_image(PixelFormat::kGray16, 2000, 1501);
  const std::string content = DataWriter().write(image);
  for (const auto& read : {read_by_vtk<vtkXMLImageDataReader>(content), image_from(content)}) {
    const std::size_t bytes = std::size_t{2} * 2000 * 1501;
    EXPECT_EQ(std::memcmp(image->GetScalarPointer(), read->GetScalarPointer(), bytes), 0);
  }
}

TEST(DataWriter, VtksOwnReaderGivesBackASurface) {
  const auto data = banner(40, 0.5);
  const std::string content = DataWriter().write(data);
  expect_same(data, read_by_vtk<vtkXMLPolyDataReader>(content));
  expect_same(data, poly_from(content));
  EXPECT_STREQ(read_by_vtk<vtkXMLPolyDataReader>(content)->GetFieldData()->GetArray("one_tuple")->GetComponentName(1),
               "middle_um");
}

// What comes again is packed once, and never taken for something else.
TEST(DataWriter, WhatWasKeptIsUsedForTheSameNumbersAlone) {
  DataWriter writer;
  std::size_t first = 0;
  for (int i = 0; i < 4; ++i) {
    const auto data = banner(400, 0.25 * i);
    const std::string content = writer.write(data);
    expect_same(data, read_by_vtk<vtkXMLPolyDataReader>(content));
    if (i == 0) first = content.size();
    EXPECT_LE(content.size(), first + first / 10);
  }
  // Another topology of the same size, then the first one again.
  const auto turned = banner(400, 0.0);
  vtkNew<vtkCellArray> quads;
  for (vtkIdType i = 0; i < 400; ++i) {
    const vtkIdType quad[4] = {2 * i + 1, 2 * i + 3, 2 * i + 2, 2 * i};
    quads->InsertNextCell(4, quad);
  }
  turned->SetPolys(quads);
  expect_same(turned, poly_from(writer.write(turned)));
  expect_same(banner(400, 0.0), poly_from(writer.write(banner(400, 0.0))));
  expect_same(banner(399, 0.0), poly_from(writer.write(banner(399, 0.0))));
}

// By the object: another one of the same name is packed anew.
TEST(DataWriter, WhatIsPackedOnceIsReadAsItWouldBe) {
  const auto data = banner(400, 0.25);
  add_array<vtkFloatArray>(data->GetPointData(), "same as narrow", 3, data->GetNumberOfPoints(), 0.25);
  DataWriter packer;
  const PackedArrays common = packer.pack(data);
  EXPECT_TRUE(common.find(data->GetPoints()->GetData()));
  EXPECT_FALSE(common.find(data->GetFieldData()->GetArray("one_tuple")));
  for (int variant = 0; variant < 2; ++variant) {
    vtkNew<vtkPolyData> other;
    other->ShallowCopy(data);
    add_array<vtkFloatArray>(other->GetPointData(), "narrow", 3, data->GetNumberOfPoints(), 7.0 + variant);
    const std::string content = DataWriter().write(other.Get(), &common);
    expect_same(other.Get(), read_by_vtk<vtkXMLPolyDataReader>(content));
    expect_same(other.Get(), poly_from(content));
    // Lines, quads, points and the arrays in common were not packed again.
    EXPECT_EQ(content.size(), DataWriter().write(other.Get()).size());
  }
  expect_same(data, poly_from(DataWriter().write(data, &common)));
}

TEST(DataWriter, NothingIsAFileToo) {
  for (const std::string& content : {empty_poly_file(), DataWriter().write(vtkNew<vtkPolyData>().Get())}) {
    EXPECT_EQ(read_by_vtk<vtkXMLPolyDataReader>(content)->GetNumberOfPoints(), 0);
    EXPECT_EQ(poly_from(content)->GetNumberOfPoints(), 0);
  }
}

// For the same numbers.
TEST(DataWriter, FilesAreSmallerThanVtksOwn) {
  const auto image = noisy_image(PixelFormat::kGray8, 320, 240);
  EXPECT_LT(DataWriter().write(image).size(), serialise(image).size());
  const auto data = banner(400, 0.0);
  EXPECT_LT(DataWriter().write(data).size(), serialise(data).size());
}

}  // namespace
}  // namespace pellucida
