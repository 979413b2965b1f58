#include "pellucida/operation/HapticPathBlock.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

constexpr int kPathCount = 2;

const PlainVector3& place(const HapticRecord& record, int path) {
  return path == 0 ? record.wanted_um : record.pipette_um;
}

// A point array with the same `value(record)` on both paths.
template <class Array, class Value>
void add_scalar(vtkPolyData* block, const char* name, std::span<const HapticRecord> records, Value value) {
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(kPathCount * static_cast<vtkIdType>(records.size()));
  vtkIdType point = 0;
  for (int path = 0; path < kPathCount; ++path) {
    for (const HapticRecord& record : records) array->SetComponent(point++, 0, static_cast<double>(value(record)));
  }
  block->GetPointData()->AddArray(array);
}

template <class Value>
void add_vector(vtkPolyData* block, const char* name, std::span<const HapticRecord> records, Value value) {
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(kPathCount * static_cast<vtkIdType>(records.size()));
  vtkIdType point = 0;
  for (int path = 0; path < kPathCount; ++path) {
    for (std::size_t i = 0; i < records.size(); ++i) {
      const PlainVector3 v = value(i, path);
      array->SetTuple3(point++, v.x, v.y, v.z);
    }
  }
  block->GetPointData()->AddArray(array);
}

PlainVector3 velocity(std::span<const HapticRecord> records, std::size_t i, int path) {
  if (records.size() < 2) return {};
  const HapticRecord& before = records[i == 0 ? 0 : i - 1];
  const HapticRecord& after = records[i == 0 ? 1 : i];
  const double dt_s = after.time_s - before.time_s;
  if (!(dt_s > 0.0)) return {};
  return PlainVector3((place(after, path).eigen() - place(before, path).eigen()) / dt_s);
}

}  // namespace

Frozen<vtkPolyData> make_haptic_path_block(std::span<const HapticRecord> records, double session_lag_s) {
  if (records.empty()) return {};
  auto block = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> paths;
  paths->SetName(array_name::kPath);
  for (int path = 0; path < kPathCount; ++path) {
    lines->InsertNextCell(static_cast<vtkIdType>(records.size()));
    for (const HapticRecord& record : records) {
      const PlainVector3& p = place(record, path);
      lines->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
    }
    paths->InsertNextValue(path);
  }
  block->SetPoints(points);
  block->SetLines(lines);
  block->GetCellData()->AddArray(paths);

  using R = const HapticRecord&;
  add_scalar<vtkDoubleArray>(block, array_name::kTime, records, [&](R r) { return r.time_s - session_lag_s; });
  add_vector(block, "velocity_um_per_s", records, [&](std::size_t i, int path) { return velocity(records, i, path); });
  add_vector(block, "hand_m", records, [&](std::size_t i, int) { return records[i].hand_m; });
  add_vector(block, "force_N", records, [&](std::size_t i, int) { return records[i].hand_force_N; });
  add_vector(block, "guide_force_N", records, [&](std::size_t i, int) { return records[i].guide_force_N; });
  add_vector(block, "contact_force_uN", records, [&](std::size_t i, int) { return records[i].contact_force_uN; });
  add_scalar<vtkFloatArray>(block, "contact_age_ms", records, [](R r) { return 1e3 * r.contact_age_s; });
  add_scalar<vtkFloatArray>(block, "energy_margin_uJ", records, [](R r) { return 1e6 * r.energy_margin_J; });
  add_scalar<vtkIntArray>(block, "limits", records, [](R r) { return static_cast<int>(r.limits); });
  add_scalar<vtkIntArray>(block, "fixtures", records, [](R r) { return static_cast<int>(r.fixtures); });
  add_scalar<vtkIntArray>(block, "buttons", records, [](R r) { return static_cast<int>(r.buttons); });
  add_scalar<vtkIntArray>(block, "hand_state", records, [](R r) { return static_cast<int>(r.hand_state); });
  add_scalar<vtkIntArray>(block, "contact_state", records, [](R r) { return static_cast<int>(r.contact_state); });
  return Frozen<vtkPolyData>(block);
}

}  // namespace pellucida
