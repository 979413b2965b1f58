#include "pellucida/visualization_vtk/HudCanvas.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "ColorByte.h"
#include "pellucida/visualization_vtk/Letters.h"

namespace pellucida {
namespace {

void apply(const HudText& style, double ratio, vtkTextProperty* property) {
  set_typeface(property, style.bold);
  property->SetFontSize(static_cast<int>(std::lround(style.size_pt * ratio)));
  property->SetColor(style.color.red, style.color.green, style.color.blue);
  property->SetVerticalJustificationToCentered();
  property->SetJustification(style.align == HudAlign::kLeft     ? VTK_TEXT_LEFT
                             : style.align == HudAlign::kCentre ? VTK_TEXT_CENTERED
                                                                : VTK_TEXT_RIGHT);
}

}  // namespace

HudCanvas::HudCanvas(vtkRenderer* renderer) : renderer_(renderer) {
  colors_->SetNumberOfComponents(4);
  colors_->SetName("color");
  points_->SetDataTypeToFloat();
  shapes_->SetPoints(points_);
  shapes_->SetPolys(polygons_);
  shapes_->GetPointData()->SetScalars(colors_);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shapes_);
  actor_->SetMapper(mapper);
  actor_->PickableOff();
  renderer_->AddActor2D(actor_);
}

HudCanvas::~HudCanvas() = default;

void HudCanvas::begin(double ratio) {
  ratio_ = ratio;
  text_count_ = 0;
  points_->Reset();
  polygons_->Reset();
  colors_->Reset();
}

void HudCanvas::polygon(const std::vector<double>& xy, const Color& color, double opacity, unsigned clear_corners) {
  const auto count = static_cast<int>(xy.size() / 2);
  polygons_->InsertNextCell(count);
  for (int i = 0; i < count; ++i) {
    polygons_->InsertCellPoint(points_->InsertNextPoint(xy[2 * i] * ratio_, xy[2 * i + 1] * ratio_, 0.0));
    const double solid = (clear_corners >> i) & 1U ? 0.0 : opacity;
    const unsigned char rgba[4] = {to_byte(color.red), to_byte(color.green), to_byte(color.blue), to_byte(solid)};
    colors_->InsertNextTypedTuple(rgba);
  }
}

void HudCanvas::rectangle(double x, double y, double width_px, double height_px, const Color& color, double opacity) {
  polygon({x, y, x + width_px, y, x + width_px, y + height_px, x, y + height_px}, color, opacity);
}

void HudCanvas::rounded(double x, double y, double width_px, double height_px, double radius_px, const Color& color,
                        double opacity) {
  constexpr int kSteps = 6;
  const double r = std::min({radius_px, 0.5 * width_px, 0.5 * height_px});
  const double corner_x[] = {x + width_px - r, x + r, x + r, x + width_px - r};
  const double corner_y[] = {y + height_px - r, y + height_px - r, y + r, y + r};
  std::vector<double> xy;
  for (int corner = 0; corner < 4; ++corner) {
    for (int i = 0; i <= kSteps; ++i) {
      const double angle_rad = (corner + static_cast<double>(i) / kSteps) * 0.5 * vtkMath::Pi();
      xy.push_back(corner_x[corner] + r * std::cos(angle_rad));
      xy.push_back(corner_y[corner] + r * std::sin(angle_rad));
    }
  }
  polygon(xy, color, opacity);
}

void HudCanvas::line(double x0, double y0, double x1, double y1, double width_px, const Color& color, double opacity) {
  const double length = std::hypot(x1 - x0, y1 - y0);
  if (length <= 0.0) return;
  // A solid core between two rims that fade out, half a device pixel to either side of the edge.
  const double rim = 0.5 / ratio_;
  const double core = std::max(0.5 * width_px - rim, 0.0);
  const double edge = 0.5 * width_px + rim;
  const double nx = -(y1 - y0) / length;
  const double ny = (x1 - x0) / length;
  const auto strip = [&](double from, double to, unsigned clear_corners) {
    polygon({x0 + from * nx, y0 + from * ny, x0 + to * nx, y0 + to * ny, x1 + to * nx, y1 + to * ny, x1 + from * nx,
             y1 + from * ny},
            color, opacity, clear_corners);
  };
  strip(core, edge, 0b0110);
  strip(-core, core, 0);
  strip(-edge, -core, 0b1001);
}

void HudCanvas::disc(double x, double y, double radius_px, const Color& color, double opacity) {
  rounded(x - radius_px, y - radius_px, 2.0 * radius_px, 2.0 * radius_px, radius_px, color, opacity);
}

vtkTextActor* HudCanvas::next_text() {
  if (text_count_ == texts_.size()) {
    auto actor = vtkSmartPointer<vtkTextActor>::New();
    actor->SetTextScaleModeToNone();
    actor->PickableOff();
    actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
    renderer_->AddActor2D(actor);
    texts_.push_back(actor);
  }
  return texts_[text_count_++];
}

void HudCanvas::text(double x, double y, const std::string& utf8, const HudText& style) {
  if (utf8.empty()) return;
  vtkTextActor* actor = next_text();
  apply(style, ratio_, actor->GetTextProperty());
  actor->SetInput(utf8.c_str());
  actor->SetPosition(std::round(x * ratio_), std::round(y * ratio_));
  actor->VisibilityOn();
}

void HudCanvas::end() {
  points_->Modified();
  polygons_->Modified();
  colors_->Modified();
  shapes_->Modified();
  actor_->SetVisibility(points_->GetNumberOfPoints() > 0);
  for (std::size_t i = text_count_; i < texts_.size(); ++i) texts_[i]->VisibilityOff();
}

double HudCanvas::text_width_px(const std::string& utf8, const HudText& style) {
  vtkNew<vtkTextProperty> property;
  apply(style, ratio_, property);
  int box[4] = {0, 0, 0, 0};
  vtkTextRenderer* letters = vtkTextRenderer::GetInstance();
  if (!letters || !letters->GetBoundingBox(property, utf8, box, 72)) return 0.0;
  return (box[1] - box[0] + 1) / ratio_;
}

}  // namespace pellucida
