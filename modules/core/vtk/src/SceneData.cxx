#include "pellucida/core_vtk/SceneData.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cstring>

#include "pellucida/core/Version.h"
#include "pellucida/core_vtk/ObservationData.h"

namespace pellucida {
namespace {

void set_field_numbers(vtkDataObject* data, const char* name, std::initializer_list<double> values) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->InsertNextTuple(values.begin());
  data->GetFieldData()->AddArray(array);
}

double field_number(const vtkDataObject* data, const char* name) {
  auto* array = const_cast<vtkDataObject*>(data)->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : 0.0;
}

// Appends a contour's points; returns the id of the first.
vtkIdType append_points(vtkPoints* points, const Contour_um& contour_um) {
  const vtkIdType first = points->GetNumberOfPoints();
  for (Eigen::Index i = 0; i < contour_um.cols(); ++i) points->InsertNextPoint(contour_um(0, i), contour_um(1, i), 0.0);
  return first;
}

void append_line(vtkCellArray* lines, vtkIdType first, vtkIdType count, bool closed) {
  lines->InsertNextCell(static_cast<int>(count + (closed ? 1 : 0)));
  for (vtkIdType i = 0; i < count; ++i) lines->InsertCellPoint(first + i);
  if (closed) lines->InsertCellPoint(first);
}

template <class Array>
vtkSmartPointer<Array> named_array(const char* name) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  return array;
}

}  // namespace

void stamp(vtkDataObject* data, double time_s, long frame_index) {
  set_field_numbers(data, array_name::kTime, {time_s});
  for (const auto& [name, value] : {std::pair<const char*, int>{array_name::kFrameIndex, static_cast<int>(frame_index)},
                                    std::pair<const char*, int>{array_name::kSchemaVersion, kSchemaVersion}}) {
    auto array = named_array<vtkIntArray>(name);
    array->InsertNextValue(value);
    data->GetFieldData()->AddArray(array);
  }
}

double stamped_time_s(const vtkDataObject* data) {
  return field_number(data, array_name::kTime);
}

long stamped_frame_index(const vtkDataObject* data) {
  return static_cast<long>(field_number(data, array_name::kFrameIndex));
}

vtkSmartPointer<vtkImageData> make_frame(const ImageView& image, double time_s, long frame_index) {
  auto frame = vtkSmartPointer<vtkImageData>::New();
  frame->SetDimensions(image.width_px, image.height_px, 1);
  frame->SetSpacing(image.pixel_size_um, image.pixel_size_um, 1.0);
  const bool wide = image.format == PixelFormat::kGray16;
  frame->AllocateScalars(wide ? VTK_UNSIGNED_SHORT : VTK_UNSIGNED_CHAR, 1);
  frame->GetPointData()->GetScalars()->SetName("intensity");

  // Row by row, since the source's rows may be padded.
  const std::size_t row_bytes = static_cast<std::size_t>(image.width_px) * (wide ? 2 : 1);
  auto* target = static_cast<unsigned char*>(frame->GetScalarPointer());
  const auto* source = static_cast<const unsigned char*>(image.data);
  for (int row = 0; row < image.height_px; ++row) {
    std::memcpy(target + row * row_bytes, source + row * image.row_bytes, row_bytes);
  }
  stamp(frame, time_s, frame_index);
  return frame;
}

ImageView view_of(const vtkImageData* frame) {
  auto* image = const_cast<vtkImageData*>(frame);
  const bool wide = image->GetScalarType() == VTK_UNSIGNED_SHORT;
  int size[3];
  image->GetDimensions(size);
  return {.data = image->GetScalarPointer(),
          .format = wide ? PixelFormat::kGray16 : PixelFormat::kGray8,
          .width_px = size[0],
          .height_px = size[1],
          .row_bytes = static_cast<std::ptrdiff_t>(size[0]) * (wide ? 2 : 1),
          .pixel_size_um = image->GetSpacing()[0]};
}

vtkSmartPointer<vtkPolyData> make_membranes(const Observation& observation) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  auto membrane = named_array<vtkIntArray>(array_name::kMembrane);
  auto confidence = named_array<vtkFloatArray>(array_name::kConfidence);
  auto sigma_um = named_array<vtkFloatArray>(array_name::kSigma);

  for (const auto* contour : {&observation.outer, &observation.inner, &observation.oolemma}) {
    if (!*contour) continue;
    const MembraneContour& one = **contour;
    const auto count = static_cast<vtkIdType>(one.points_um.cols());
    append_line(lines, append_points(points, one.points_um), count, true);
    membrane->InsertNextValue(static_cast<int>(one.membrane));
    for (vtkIdType i = 0; i < count; ++i) {
      confidence->InsertNextValue(one.confidence.size() == count ? static_cast<float>(one.confidence[i]) : 1.0F);
      sigma_um->InsertNextValue(one.sigma_um.size() == count ? static_cast<float>(one.sigma_um[i]) : 0.0F);
    }
  }

  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetCellData()->AddArray(membrane);
  data->GetPointData()->AddArray(confidence);
  data->GetPointData()->AddArray(sigma_um);
  set_field_numbers(data, array_name::kCenter, {observation.center_um.x(), observation.center_um.y(), 0.0});
  set_field_numbers(data, array_name::kAxis, {observation.axis.x(), observation.axis.y(), 0.0});
  set_field_numbers(data, array_name::kRestRadius,
                    {observation.rest_outer_radius_um, observation.rest_inner_radius_um});
  add_observation(observation, data);
  stamp(data, observation.time_s, observation.frame_index);
  return data;
}

vtkSmartPointer<vtkPolyData> make_tools(const Observation& observation) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  auto tool = named_array<vtkIntArray>(array_name::kTool);
  auto evidence = named_array<vtkIntArray>(array_name::kEvidence);
  auto confidence = named_array<vtkFloatArray>(array_name::kConfidence);
  auto tip_sigma = named_array<vtkFloatArray>(array_name::kTipSigma);

  const auto append = [&](const Contour_um& outline_um, int kind, double sure, double sigma_um, unsigned told_by) {
    append_line(lines, append_points(points, outline_um), outline_um.cols(), false);
    tool->InsertNextValue(kind);
    confidence->InsertNextValue(static_cast<float>(sure));
    tip_sigma->InsertNextValue(static_cast<float>(sigma_um));
    evidence->InsertNextValue(static_cast<int>(told_by));
  };
  if (observation.needle && observation.needle->outline_um.cols() > 0) {
    const NeedlePose& needle = *observation.needle;
    append(needle.outline_um, 0, needle.confidence, needle.tip_sigma_um, needle.evidence);
  }
  if (observation.holder && observation.holder->outline_um.cols() > 0)
    append(observation.holder->outline_um, 1, observation.holder->confidence, 0.0, kNoNeedleEvidence);

  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  for (vtkDataArray* array : {static_cast<vtkDataArray*>(tool.Get()), static_cast<vtkDataArray*>(confidence.Get()),
                              static_cast<vtkDataArray*>(tip_sigma.Get()), static_cast<vtkDataArray*>(evidence.Get())})
    data->GetCellData()->AddArray(array);
  add_poses(observation, data);
  stamp(data, observation.time_s, observation.frame_index);
  return data;
}

}  // namespace pellucida
