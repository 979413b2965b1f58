#include "presenters/NodeHistory.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "pellucida/core/Error.h"
#include "pellucida/core/Words.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/session/SessionReader.h"
#include "presenters/SigmaInterval.h"

namespace pellucida {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
// Meridians are 0.1 degrees apart at least.
constexpr double kSameMeridian_rad = 1e-3;
// Nearer to the axis than this a node belongs to every meridian.
constexpr double kPole_rad = 1e-4;

std::optional<Eigen::Vector3d> vector_of(vtkDataArray* array, vtkIdType tuple) {
  if (!array || array->GetNumberOfComponents() != 3 || tuple >= array->GetNumberOfTuples()) return std::nullopt;
  Eigen::Vector3d vector;
  array->GetTuple(tuple, vector.data());
  return vector;
}

// Where a node lay on the sphere at rest: from the axis, and round it.
struct Angles {
  double polar_rad = 0.0;
  double azimuth_rad = 0.0;
};

std::optional<Angles> angles_of(vtkPolyData* surface, long number) {
  const auto axis = vector_of(surface->GetFieldData()->GetArray(array_name::kAxis), 0);
  const auto direction = vector_of(surface->GetPointData()->GetArray(array_name::kRestDirection), number);
  if (!axis || !direction) return std::nullopt;
  // The axis lies in the image plane.
  const Eigen::Vector3d across(-axis->y(), axis->x(), 0.0);
  return Angles{std::acos(std::clamp(direction->dot(*axis), -1.0, 1.0)),
                std::atan2(direction->z(), direction->dot(across))};
}

bool is_pole(const Angles& angles) {
  return angles.polar_rad < kPole_rad || angles.polar_rad > std::numbers::pi - kPole_rad;
}

void add_point(Curve& curve, double x, const SurfaceNode& node, NodeArray array) {
  const double value = value_of(node, array);
  if (!std::isfinite(value)) {
    curve.add_gap();
    return;
  }
  const auto [low, high] = sigma_interval(value, sigma_of(node, array));
  curve.add(x, value, low, high);
}

}  // namespace

NodeHistory read_node_history(const std::filesystem::path& session, long node,
                              const std::function<bool(std::size_t, std::size_t)>& go_on) {
  const SessionReader reader(session);
  NodeHistory history;
  history.node = node;
  const std::size_t count = reader.steps().size();
  for (std::size_t i = 0; i < count; ++i) {
    std::optional<SurfaceNode> state;
    try {
      // What is frozen may be read by anybody.
      const auto surface = reader.load(i, SessionPart::kSurface);
      if (surface) state = surface_node(surface.shallow_copy(), node);
    } catch (const InputError&) {
      ++history.unreadable_count;
    }
    history.times_s.push_back(reader.steps()[i].time_s);
    history.states.push_back(state.value_or(SurfaceNode{}));
    if (go_on && !go_on(i + 1, count)) return history;
  }
  history.whole = true;
  return history;
}

CurveChartData node_over_time(const NodeHistory& history, NodeArray array) {
  CurveChartData data;
  data.x_title = say("Time (s)");
  data.y_title = axis_title(array);
  data.empty_text = say("The session holds no such array of this node");
  if (!history.times_s.empty()) {
    data.x_begin = history.times_s.front();
    data.x_end = history.times_s.back();
  }
  for (std::size_t i = 0; i < history.states.size(); ++i) {
    add_point(data.curve, history.times_s[i], history.states[i], array);
  }
  return data;
}

CurveChartData along_meridian(vtkPolyData* surface, long number, NodeArray array) {
  CurveChartData data;
  data.x_title = say("Angle from the needle (°)");
  data.y_title = axis_title(array);
  data.x_end = 180.0;
  data.empty_text = say("No meridian: this frame has no surface with its rest directions");
  const auto chosen = surface_node(surface, number);
  const auto place = chosen ? angles_of(surface, number) : std::nullopt;
  if (!place) return data;
  std::vector<std::pair<double, SurfaceNode>> nodes;
  for (long i = 0; i < surface->GetNumberOfPoints(); ++i) {
    const auto angles = angles_of(surface, i);
    if (!angles) continue;
    const double apart_rad = std::remainder(angles->azimuth_rad - place->azimuth_rad, 2.0 * std::numbers::pi);
    if (!is_pole(*angles) && std::abs(apart_rad) > kSameMeridian_rad) continue;
    const auto node = surface_node(surface, i);
    if (node && node->membrane == chosen->membrane) nodes.emplace_back(kDegrees * angles->polar_rad, *node);
  }
  std::sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [angle_deg, node] : nodes) add_point(data.curve, angle_deg, node, array);
  return data;
}

double polar_angle_deg(vtkPolyData* surface, long number) {
  const auto angles = surface && number >= 0 ? angles_of(surface, number) : std::nullopt;
  return angles ? kDegrees * angles->polar_rad : SurfaceNode::kNone;
}

}  // namespace pellucida
