#include "pellucida/core_vtk/ObservationData.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <array>
#include <initializer_list>
#include <utility>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

using NamedNumber = std::pair<const char*, double>;

void add_numbers(vtkPolyData* data, const char* name, std::initializer_list<NamedNumber> numbers) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(numbers.size()));
  array->SetNumberOfTuples(1);
  int component = 0;
  for (const auto& [what, value] : numbers) {
    array->SetComponentName(component, what);
    array->SetComponent(0, component++, value);
  }
  data->GetFieldData()->AddArray(array);
}

/// The one tuple of a field array of at least N components.
template <std::size_t N>
std::optional<std::array<double, N>> numbers_of(vtkPolyData* data, const char* name) {
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() < 1 || array->GetNumberOfComponents() < static_cast<int>(N)) return {};
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i) values[i] = array->GetComponent(0, static_cast<int>(i));
  return values;
}

/// A component that sessions of earlier versions lack; 0 there.
double later_number_of(vtkPolyData* data, const char* name, int component, double missing = 0.0) {
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfComponents() > component ? array->GetComponent(0, component) : missing;
}

/// The points of a polyline; the first is not repeated.
Contour_um points_of(vtkPolyData* data, const vtkIdList* ids, vtkIdType count) {
  Contour_um points_um(2, count);
  for (vtkIdType i = 0; i < count; ++i) {
    double point[3];
    data->GetPoint(const_cast<vtkIdList*>(ids)->GetId(i), point);
    points_um.col(i) << point[0], point[1];
  }
  return points_um;
}

Eigen::VectorXd values_of(vtkDataArray* array, vtkIdList* ids, vtkIdType count) {
  Eigen::VectorXd values(count);
  for (vtkIdType i = 0; i < count; ++i) values[i] = array->GetComponent(ids->GetId(i), 0);
  return values;
}

template <class Values>
void round_to_32_bit(Values& values) {
  values = values.template cast<float>().template cast<double>().eval();
}

void round_contour(std::optional<MembraneContour>& contour) {
  if (!contour) return;
  const Eigen::Index count = contour->points_um.cols();
  round_to_32_bit(contour->points_um);
  if (contour->confidence.size() != count) contour->confidence = Eigen::VectorXd::Ones(count);
  round_to_32_bit(contour->confidence);
  if (contour->sigma_um.size() != count) contour->sigma_um.resize(0);
  round_to_32_bit(contour->sigma_um);
}

bool read_contours(vtkPolyData* membranes, Observation& o) {
  vtkDataArray* kind = membranes->GetCellData()->GetArray(array_name::kMembrane);
  vtkDataArray* confidence = membranes->GetPointData()->GetArray(array_name::kConfidence);
  vtkDataArray* sigma_um = membranes->GetPointData()->GetArray(array_name::kSigma);
  if (membranes->GetNumberOfCells() > 0 && !(kind && confidence && sigma_um)) return false;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < membranes->GetNumberOfCells(); ++cell) {
    membranes->GetCellPoints(cell, ids);
    const vtkIdType count = ids->GetNumberOfIds() - 1;
    const int number = static_cast<int>(kind->GetComponent(cell, 0));
    if (count < 1 || number < 0 || number > static_cast<int>(Membrane::kOolemma)) return false;
    MembraneContour contour;
    contour.membrane = static_cast<Membrane>(number);
    contour.points_um = points_of(membranes, ids, count);
    contour.confidence = values_of(confidence, ids, count);
    contour.sigma_um = values_of(sigma_um, ids, count);
    if (contour.sigma_um.isZero(0.0)) contour.sigma_um.resize(0);
    auto& place = contour.membrane == Membrane::kOuter   ? o.outer
                  : contour.membrane == Membrane::kInner ? o.inner
                                                         : o.oolemma;
    place = std::move(contour);
  }
  return true;
}

Contour_um outline_of(vtkPolyData* tools, int tool) {
  vtkDataArray* kind = tools->GetCellData()->GetArray(array_name::kTool);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; kind && cell < tools->GetNumberOfCells(); ++cell) {
    if (static_cast<int>(kind->GetComponent(cell, 0)) != tool) continue;
    tools->GetCellPoints(cell, ids);
    return points_of(tools, ids, ids->GetNumberOfIds());
  }
  return {};
}

void read_tools(vtkPolyData* tools, Observation& o) {
  if (const auto pose = numbers_of<8>(tools, array_name::kNeedlePose)) {
    const auto& p = *pose;
    o.needle.emplace();
    o.needle->tip_um << p[0], p[1];
    o.needle->direction << p[2], p[3];
    o.needle->tip_radius_um = p[4];
    o.needle->confidence = p[5];
    o.needle->tip_sigma_um = p[6];
    o.needle->evidence = static_cast<NeedleEvidence>(static_cast<unsigned>(p[7]));
    o.needle->tip_radius_sigma = later_number_of(tools, array_name::kNeedlePose, 8);
    o.needle->outline_um = outline_of(tools, 0);
  }
  if (const auto pose = numbers_of<6>(tools, array_name::kHolderPose)) {
    const auto& p = *pose;
    o.holder.emplace();
    o.holder->mouth_um << p[0], p[1];
    o.holder->direction << p[2], p[3];
    o.holder->outer_radius_um = p[4];
    o.holder->confidence = p[5];
    o.holder->outer_radius_sigma = later_number_of(tools, array_name::kHolderPose, 6);
    o.holder->outline_um = outline_of(tools, 1);
  }
}

}  // namespace

void round_as_stored(Observation& observation) {
  round_contour(observation.outer);
  round_contour(observation.inner);
  round_contour(observation.oolemma);
  if (observation.needle) round_to_32_bit(observation.needle->outline_um);
  if (observation.holder) round_to_32_bit(observation.holder->outline_um);
}

void add_observation(const Observation& o, vtkPolyData* membranes) {
  add_numbers(membranes, array_name::kObservation,
              {{"state", static_cast<double>(o.state)},
               {"confidence", o.confidence},
               {"rotation_rad", o.rotation_rad},
               {"indentation_um", o.indentation_um},
               {"indentation_sigma_um", o.indentation_sigma_um},
               {"dimple_radius_um", o.dimple_radius_um},
               {"rest_beyond_um", o.rest_beyond_um},
               {"side_bulge_um", o.side_bulge_um},
               {"pierced_probability", o.pierced_probability}});
}

void add_poses(const Observation& o, vtkPolyData* tools) {
  if (o.needle) {
    const NeedlePose& n = *o.needle;
    add_numbers(tools, array_name::kNeedlePose,
                {{"tip_x_um", n.tip_um.x()},
                 {"tip_y_um", n.tip_um.y()},
                 {"direction_x", n.direction.x()},
                 {"direction_y", n.direction.y()},
                 {"tip_radius_um", n.tip_radius_um},
                 {"confidence", n.confidence},
                 {"tip_sigma_um", n.tip_sigma_um},
                 {"evidence", static_cast<double>(n.evidence)},
                 {"tip_radius_sigma", n.tip_radius_sigma}});
  }
  if (o.holder) {
    const HolderPose& h = *o.holder;
    add_numbers(tools, array_name::kHolderPose,
                {{"mouth_x_um", h.mouth_um.x()},
                 {"mouth_y_um", h.mouth_um.y()},
                 {"direction_x", h.direction.x()},
                 {"direction_y", h.direction.y()},
                 {"outer_radius_um", h.outer_radius_um},
                 {"confidence", h.confidence},
                 {"outer_radius_sigma", h.outer_radius_sigma}});
  }
}

std::optional<Observation> read_observation(const vtkPolyData* membranes, const vtkPolyData* tools) {
  // VTK's readers of its own objects are not const; nothing is written.
  auto* contours = const_cast<vtkPolyData*>(membranes);
  if (!contours) return std::nullopt;
  const auto numbers = numbers_of<6>(contours, array_name::kObservation);
  const auto center_um = numbers_of<2>(contours, array_name::kCenter);
  const auto axis = numbers_of<2>(contours, array_name::kAxis);
  const auto rest_radius_um = numbers_of<2>(contours, array_name::kRestRadius);
  if (!numbers || !center_um || !axis || !rest_radius_um) return std::nullopt;
  const double state = numbers->at(0);
  if (!(state >= 0.0 && state <= static_cast<double>(CellState::kLost))) return std::nullopt;

  Observation o;
  o.time_s = stamped_time_s(contours);
  o.frame_index = stamped_frame_index(contours);
  o.state = static_cast<CellState>(static_cast<int>(state));
  o.confidence = numbers->at(1);
  o.rotation_rad = numbers->at(2);
  o.indentation_um = numbers->at(3);
  o.indentation_sigma_um = numbers->at(4);
  o.dimple_radius_um = numbers->at(5);
  o.rest_beyond_um = later_number_of(contours, array_name::kObservation, 6);
  o.side_bulge_um = later_number_of(contours, array_name::kObservation, 7);
  o.pierced_probability = later_number_of(contours, array_name::kObservation, 8, Observation{}.pierced_probability);
  o.center_um << center_um->at(0), center_um->at(1);
  o.axis << axis->at(0), axis->at(1);
  o.rest_outer_radius_um = rest_radius_um->at(0);
  o.rest_inner_radius_um = rest_radius_um->at(1);
  if (!read_contours(contours, o)) return std::nullopt;
  if (tools) read_tools(const_cast<vtkPolyData*>(tools), o);
  return o;
}

}  // namespace pellucida
