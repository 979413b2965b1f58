#include "visualization/SyntheticScene.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida::test {
namespace {

constexpr double kPixel_um = 0.825;
constexpr int kWidth_px = 728;
constexpr int kHeight_px = 486;
constexpr double kRadius_um = 48.0;
constexpr double kInner_um = 40.0;
constexpr double kDimple_um = 16.0;
const Eigen::Vector2d kCenter_um(290.0, 200.0);

// Axial and lateral coordinates of a membrane point at `angle_rad` from the axis towards the needle.
Eigen::Vector2d meridian(double radius_um, double angle_rad, double depth_um) {
  const double lateral_um = radius_um * std::sin(angle_rad);
  double axial_um = radius_um * std::cos(angle_rad);
  if (axial_um > 0.0) axial_um -= depth_um * std::exp(-lateral_um * lateral_um / (kDimple_um * kDimple_um));
  return {axial_um, lateral_um};
}

MembraneContour contour(Membrane kind, double radius_um, double depth_um) {
  constexpr int kCount = 240;
  MembraneContour one{.membrane = kind, .points_um = Contour_um(2, kCount), .sigma_um = {}, .confidence = {}};
  for (int i = 0; i < kCount; ++i)
    one.points_um.col(i) = kCenter_um + meridian(radius_um, 2.0 * EIGEN_PI * i / kCount, depth_um);
  return one;
}

Measurement row_of(double depth_um, long frame_index) {
  Measurement m;
  m.frame = frame_index;
  m.time_s = static_cast<double>(frame_index) / 30.0;
  m.state = depth_um > 0.0 ? CellState::kContact : CellState::kFree;
  m.confidence = 0.96;
  m.cell_x_um = kCenter_um.x();
  m.cell_y_um = kCenter_um.y();
  m.axis_deg = 0.0;
  m.indentation_um = depth_um;
  m.contact_force_uN = 0.004 * depth_um * depth_um;
  m.contact_force_lower_uN = 0.92 * m.contact_force_uN;
  m.contact_force_upper_uN = 1.08 * m.contact_force_uN;
  m.pressure_Pa = 40.0 + 3.0 * depth_um;
  m.frame_age_ms = 21.0;
  return m;
}

vtkSmartPointer<vtkPolyData> surfaces(double depth_um, const std::vector<std::pair<int, double>>& membranes,
                                      double force_uN) {
  constexpr int kRows = 49;
  constexpr int kSides = 36;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> kind;
  vtkNew<vtkDoubleArray> force;
  vtkNew<vtkDoubleArray> moved;
  vtkNew<vtkDoubleArray> tension;
  kind->SetName(array_name::kMembrane);
  force->SetName(array_name::kForce);
  force->SetNumberOfComponents(3);
  moved->SetName(array_name::kDisplacement);
  moved->SetNumberOfComponents(3);
  tension->SetName(array_name::kTension);
  vtkNew<vtkDoubleArray> needle, holder, sigma, strain;
  needle->SetName(array_name::kNeedleForce);
  holder->SetName(array_name::kHolderForce);
  for (vtkDoubleArray* tool : {needle.Get(), holder.Get()}) tool->SetNumberOfComponents(3);
  sigma->SetName(array_name::kForceSigma);
  strain->SetName(array_name::kAreaStrain);
  double pushed_uN = 0.0;
  for (const auto& [membrane, radius_um] : membranes) {
    const vtkIdType first = points->GetNumberOfPoints();
    for (int row = 0; row < kRows; ++row) {
      const double angle_rad = EIGEN_PI * row / (kRows - 1);
      const Eigen::Vector2d p = meridian(radius_um, angle_rad, depth_um);
      const double near = std::exp(-p.y() * p.y() / (kDimple_um * kDimple_um)) * (p.x() > 0.0 || row == 0 ? 1.0 : 0.0);
      for (int k = 0; k < kSides; ++k) {
        const double turn_rad = 2.0 * EIGEN_PI * k / kSides;
        points->InsertNextPoint(kCenter_um.x() + p.x(), kCenter_um.y() + p.y() * std::cos(turn_rad),
                                p.y() * std::sin(turn_rad));
        kind->InsertNextValue(membrane);
        const double push = membrane == 0 ? force_uN : 0.0;
        force->InsertNextTuple3(-push * near * near + 0.1 * push * std::cos(angle_rad),
                                0.12 * push * std::sin(angle_rad) * std::cos(turn_rad),
                                0.12 * push * std::sin(angle_rad) * std::sin(turn_rad));
        moved->InsertNextTuple3(-depth_um * near, 0.0, 0.0);
        tension->InsertNextValue(0.02 + 0.2 * near);
        strain->InsertNextValue(30.0 * near - 4.0);
        // Six rows under the needle, one ring at the holder that bears the same.
        const double pushes_uN = membrane == 0 && row < 6 ? push : 0.0;
        const bool held = membrane == 0 && row == kRows - 7;
        pushed_uN += pushes_uN;
        needle->InsertNextTuple3(-pushes_uN, 0.0, 0.0);
        holder->InsertNextTuple3(held ? pushed_uN / kSides : 0.0, 0.0, 0.0);
        // Under a tool no node's force is known by itself.
        sigma->InsertNextValue(membrane != 0 ? 0.0 : (pushes_uN > 0.0 || held ? push : 0.02 * push));
      }
    }
    for (int row = 0; row + 1 < kRows; ++row) {
      for (int k = 0; k < kSides; ++k) {
        const auto at = [&](int r, int c) { return first + static_cast<vtkIdType>(r) * kSides + c % kSides; };
        const vtkIdType quad[4] = {at(row, k), at(row + 1, k), at(row + 1, k + 1), at(row, k + 1)};
        cells->InsertNextCell(4, quad);
      }
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  for (vtkDataArray* array :
       {static_cast<vtkDataArray*>(kind), static_cast<vtkDataArray*>(force), static_cast<vtkDataArray*>(moved),
        static_cast<vtkDataArray*>(tension), static_cast<vtkDataArray*>(needle), static_cast<vtkDataArray*>(holder),
        static_cast<vtkDataArray*>(sigma), static_cast<vtkDataArray*>(strain)}) {
    surface->GetPointData()->AddArray(array);
  }
  return surface;
}

vtkSmartPointer<vtkImageData> frame(const Observation& seen) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 5.0);
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(kWidth_px) * kHeight_px);
  for (int row = 0; row < kHeight_px; ++row) {
    for (int column = 0; column < kWidth_px; ++column) {
      const Eigen::Vector2d p(column * kPixel_um, row * kPixel_um);
      double value = 165.0 + 0.03 * column;
      const bool near_cell = (p - kCenter_um).norm() < kRadius_um + 8.0;
      for (const auto* one : {&seen.outer, &seen.inner}) {
        if (!near_cell) break;
        const double distance_um = std::sqrt(((*one)->points_um.colwise() - p).colwise().squaredNorm().minCoeff());
        value -= 70.0 * std::exp(-distance_um * distance_um / 4.0);
      }
      if ((p - kCenter_um).norm() < kInner_um - 4.0) value += 0.8 * noise(random) - 12.0;
      pixels[static_cast<std::size_t>(row) * kWidth_px + column] =
          static_cast<std::uint8_t>(std::clamp(value + noise(random), 0.0, 255.0));
    }
  }
  return make_frame({.data = pixels.data(),
                     .format = PixelFormat::kGray8,
                     .width_px = kWidth_px,
                     .height_px = kHeight_px,
                     .row_bytes = kWidth_px,
                     .pixel_size_um = kPixel_um},
                    seen.time_s, seen.frame_index);
}

}  // namespace

Scene synthetic_scene(double indentation_um, long frame_index) {
  const double d = indentation_um;
  auto seen = std::make_shared<Observation>();
  seen->frame_index = frame_index;
  seen->state = d > 0.0 ? CellState::kContact : CellState::kFree;
  seen->confidence = 0.96;
  seen->outer = contour(Membrane::kOuter, kRadius_um, d);
  seen->inner = contour(Membrane::kInner, kInner_um, d);
  seen->center_um = kCenter_um;
  seen->rest_outer_radius_um = kRadius_um;
  seen->rest_inner_radius_um = kInner_um;
  seen->indentation_um = d;

  NeedlePose needle;
  needle.tip_um = kCenter_um + Eigen::Vector2d(kRadius_um - d, 0.0);
  needle.direction = {-1.0, 0.0};
  needle.tip_radius_um = 1.5;
  needle.confidence = 0.9;
  needle.outline_um = Contour_um(2, 5);
  const double to_edge_um = kWidth_px * kPixel_um - needle.tip_um.x();
  needle.outline_um << 0.0, 1.0, to_edge_um, to_edge_um, 1.0, 0.0, 1.5, 8.0, -8.0, -1.5;
  needle.outline_um.colwise() += needle.tip_um;
  seen->needle = needle;

  HolderPose holder;
  holder.mouth_um = kCenter_um - Eigen::Vector2d(kRadius_um, 0.0);
  holder.direction = {-1.0, 0.0};
  holder.outer_radius_um = 26.0;
  holder.outline_um = Contour_um(2, 4);
  const double left_um = holder.mouth_um.x();
  holder.outline_um << 0.0, left_um, left_um, 0.0, holder.mouth_um.y() - 26.0, holder.mouth_um.y() - 26.0,
      holder.mouth_um.y() + 26.0, holder.mouth_um.y() + 26.0;
  seen->holder = holder;

  Scene scene;
  scene.measurement = row_of(d, frame_index);
  scene.measurement.tip_x_um = needle.tip_um.x();
  scene.measurement.tip_y_um = needle.tip_um.y();
  scene.frame = Frozen<vtkImageData>(frame(*seen));
  scene.membranes = Frozen<vtkPolyData>(make_membranes(*seen));
  scene.tools = Frozen<vtkPolyData>(make_tools(*seen));
  scene.surface =
      Frozen<vtkPolyData>(surfaces(d, {{0, kRadius_um}, {1, kInner_um}}, 0.05 * scene.measurement.contact_force_uN));
  scene.model = Frozen<vtkPolyData>(surfaces(0.95 * d, {{0, 0.5 * (kRadius_um + kInner_um)}}, 0.0));
  scene.observation = seen;
  return scene;
}

std::vector<Measurement> synthetic_rows(int count, double deepest_um) {
  std::vector<Measurement> rows;
  for (int i = 0; i < count; ++i) {
    const double d = deepest_um * std::max(0.0, (i - 0.2 * count) / (0.8 * count));
    rows.push_back(row_of(d, i));
  }
  return rows;
}

}  // namespace pellucida::test
