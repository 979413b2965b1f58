#include "ToolShapes.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyDataNormals.h>

#include <algorithm>
#include <cmath>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

constexpr int kSides = 28;

// Points of the first line whose `tool` has the given number; empty when there is none.
Contour_um tool_line(const Scene& scene, int tool) {
  const auto tools = scene.tools.shallow_copy();
  if (!tools) return {};
  vtkDataArray* kinds = tools->GetCellData()->GetArray(array_name::kTool);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; kinds && cell < tools->GetNumberOfCells(); ++cell) {
    if (kinds->GetComponent(cell, 0) != tool) continue;
    tools->GetCellPoints(cell, ids);
    Contour_um line_um(2, ids->GetNumberOfIds());
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
      double p[3];
      tools->GetPoint(ids->GetId(i), p);
      line_um.col(i) << p[0], p[1];
    }
    return line_um;
  }
  return {};
}

Eigen::Vector2d perpendicular(const Eigen::Vector2d& direction) {
  return {-direction.y(), direction.x()};
}

}  // namespace

std::optional<NeedlePose> needle_of(const Scene& scene) {
  if (scene.observation) return scene.observation->needle;
  const Contour_um outline_um = tool_line(scene, 0);
  if (outline_um.cols() < 3) return std::nullopt;

  NeedlePose needle;
  needle.tip_um = outline_um.col(0);
  needle.direction = (needle.tip_um - outline_um.rowwise().mean()).normalized();
  needle.confidence = 1.0;
  needle.outline_um = outline_um;
  // The tip's half-width: the farthest point to a side within 2 um of the tip.
  constexpr double kTipReach_um = 2.0;
  for (Eigen::Index i = 1; i < outline_um.cols(); ++i) {
    const Eigen::Vector2d from_tip_um = outline_um.col(i) - needle.tip_um;
    if (-from_tip_um.dot(needle.direction) > kTipReach_um) continue;
    needle.tip_radius_um = std::max(needle.tip_radius_um, std::abs(from_tip_um.dot(perpendicular(needle.direction))));
  }
  return needle;
}

std::optional<HolderPose> holder_of(const Scene& scene) {
  return scene.observation ? scene.observation->holder : std::nullopt;
}

std::vector<ProfilePoint> needle_profile(const NeedlePose& needle, double length_um) {
  const double tip_radius_um = std::max(needle.tip_radius_um, 0.3);
  // Half-widths seen along the shaft, from the tip outwards.
  std::vector<ProfilePoint> seen;
  for (Eigen::Index i = 0; i < needle.outline_um.cols(); ++i) {
    const Eigen::Vector2d from_tip_um = needle.outline_um.col(i) - needle.tip_um;
    const double along_um = -from_tip_um.dot(needle.direction);
    if (along_um > 0.0 && along_um < length_um) {
      seen.push_back({along_um, std::abs(from_tip_um.dot(perpendicular(needle.direction)))});
    }
  }
  std::sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.along_um < b.along_um; });

  // A closed, slightly rounded tip, then the shaft.
  std::vector<ProfilePoint> profile{
      {0.0, 0.0}, {0.1 * tip_radius_um, 0.7 * tip_radius_um}, {0.5 * tip_radius_um, tip_radius_um}};
  for (const ProfilePoint& point : seen) {
    if (point.along_um < profile.back().along_um + 1.0) continue;
    profile.push_back({point.along_um, std::max(point.radius_um, profile.back().radius_um)});
  }
  // An outline that is too short gives a straight shaft.
  if (profile.back().along_um < 0.98 * length_um) profile.push_back({length_um, profile.back().radius_um});
  return profile;
}

std::vector<ProfilePoint> holder_profile(const HolderPose& holder, double length_um) {
  // A fire-polished glass tube whose wall is a third of its radius.
  const double radius_um = std::max(holder.outer_radius_um, 1.0);
  const double half_wall_um = radius_um / 6.0;
  std::vector<ProfilePoint> profile{{length_um, radius_um}};
  constexpr int kLipSteps = 8;
  for (int i = 0; i <= kLipSteps; ++i) {
    const double angle_rad = vtkMath::Pi() * i / kLipSteps;
    profile.push_back(
        {half_wall_um * (1.0 - std::sin(angle_rad)), radius_um - half_wall_um * (1.0 - std::cos(angle_rad))});
  }
  profile.push_back({length_um, radius_um - 2.0 * half_wall_um});
  return profile;
}

vtkSmartPointer<vtkPolyData> revolve_profile(const std::vector<ProfilePoint>& profile, const Eigen::Vector2d& origin_um,
                                             const Eigen::Vector2d& direction) {
  const Eigen::Vector2d side = perpendicular(direction);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  for (const ProfilePoint& point : profile) {
    for (int k = 0; k < kSides; ++k) {
      const double angle_rad = 2.0 * vtkMath::Pi() * k / kSides;
      const Eigen::Vector2d p = origin_um + direction * point.along_um + side * (point.radius_um * std::cos(angle_rad));
      points->InsertNextPoint(p.x(), p.y(), point.radius_um * std::sin(angle_rad));
    }
  }
  for (std::size_t row = 0; row + 1 < profile.size(); ++row) {
    const auto first = static_cast<vtkIdType>(row) * kSides;
    for (vtkIdType k = 0; k < kSides; ++k) {
      const vtkIdType after = (k + 1) % kSides;
      const vtkIdType quad[4] = {first + k, first + after, first + kSides + after, first + kSides + k};
      // Where the wall meets the axis a quad is a triangle.
      if (profile[row].radius_um <= 0.0) {
        faces->InsertNextCell({quad[0], quad[2], quad[3]});
      } else if (profile[row + 1].radius_um <= 0.0) {
        faces->InsertNextCell({quad[0], quad[1], quad[2]});
      } else {
        faces->InsertNextCell(4, quad);
      }
    }
  }
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetPolys(faces);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(shape);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

}  // namespace pellucida
