#include "pellucida/visualization_vtk/FeedView.h"

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkCutter.h>
#include <vtkImageData.h>
#include <vtkImageProperty.h>
#include <vtkImageSlice.h>
#include <vtkImageSliceMapper.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkStripper.h>

#include <algorithm>
#include <cmath>

#include "DashFilter.h"
#include "FeedLines.h"
#include "FeedMarks.h"
#include "ToolShapes.h"
#include "pellucida/core/Words.h"
#include "pellucida/core_vtk/SceneBlockFilter.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

constexpr double kLineWidth = 2.0;
// Of the caption's plate, and to the legend.
constexpr double kCaptionMargins_px = 43.0;
// A view lower than this shows the cell where the caption would be.
constexpr double kCaptionRoom_px = 220.0;
constexpr double kCellMargin = 1.7;  // half the view's height, in radii of the cell

bool has_points(const Frozen<vtkPolyData>& part) {
  return part && const_cast<vtkPolyData*>(part.get())->GetNumberOfPoints() > 0;
}

bool has_cell_value(const Frozen<vtkPolyData>& part, const char* array, int value) {
  if (!part) return false;
  vtkDataArray* kinds = const_cast<vtkPolyData*>(part.get())->GetCellData()->GetArray(array);
  for (vtkIdType i = 0; kinds && i < kinds->GetNumberOfTuples(); ++i) {
    if (kinds->GetComponent(i, 0) == value) return true;
  }
  return false;
}

}  // namespace

struct FeedView::Pipeline {
  vtkNew<SceneBlockFilter> frame;
  vtkNew<SceneBlockFilter> membranes;
  vtkNew<SceneBlockFilter> tools;
  vtkNew<SceneBlockFilter> model;
  vtkNew<vtkImageSliceMapper> image_mapper;
  vtkNew<vtkImageSlice> image;
  vtkNew<vtkPlane> image_plane;
  vtkNew<vtkCutter> section;
  vtkNew<vtkStripper> section_lines;
  vtkNew<DashFilter> dashes;
  FeedLines membrane_lines;
  FeedLines tool_lines;
  FeedLines model_lines;
};

FeedView::FeedView(StageSource* source) : source_(source), pipeline_(std::make_unique<Pipeline>()) {
  Pipeline& p = *pipeline_;
  for (auto [filter, block] : {std::pair{p.frame.Get(), SceneBlock::kFrame},
                               {p.membranes.Get(), SceneBlock::kMembranes},
                               {p.tools.Get(), SceneBlock::kTools},
                               {p.model.Get(), SceneBlock::kModel}}) {
    filter->SetBlock(block);
    filter->SetInputConnection(source_->GetOutputPort());
  }

  // The frame.
  p.image_mapper->SetInputConnection(p.frame->GetOutputPort());
  p.image->SetMapper(p.image_mapper);
  p.image->GetProperty()->SetInterpolationTypeToLinear();
  p.image->VisibilityOff();
  p.image->PickableOff();
  main_->AddViewProp(p.image);

  // The model's section with the image plane. A hair beside z = 0, where the mesh has nodes and the cut would be
  // double.
  p.image_plane->SetOrigin(0.0, 0.0, 1e-3);
  p.image_plane->SetNormal(0.0, 0.0, 1.0);
  p.section->SetCutFunction(p.image_plane);
  p.section->SetInputConnection(p.model->GetOutputPort());
  p.section_lines->SetInputConnection(p.section->GetOutputPort());
  p.section_lines->JoinContiguousSegmentsOn();
  p.section_lines->SetMaximumLength(100000);
  p.dashes->SetInputConnection(p.section_lines->GetOutputPort());

  p.tool_lines.build(p.tools->GetOutputPort(), main_, 1);
  p.tool_lines.ribbon->SetColors({palette::kNeedle, palette::kHolder}, array_name::kTool);
  p.membrane_lines.build(p.membranes->GetOutputPort(), main_, 2);
  p.membrane_lines.ribbon->SetColors({palette::kOuter, palette::kInner, palette::kOolemma}, array_name::kMembrane);
  p.model_lines.build(p.dashes->GetOutputPort(), main_, 3);
  p.model_lines.ribbon->SetColors({palette::kModel});

  // The image is shown as it is: lines are smooth by themselves.
  main_->SetUseFXAA(false);
  // As in the eyepiece: x right, y down, looking along +z.
  follow_theme();
  vtkCamera* camera = main_->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetViewUp(0.0, -1.0, 0.0);
  camera->SetPosition(0.0, 0.0, -100.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetClippingRange(1.0, 1000.0);
  refresh();
}

FeedView::~FeedView() = default;

// What lies over the image keeps its dark ground in every theme: the lines that the legend names are bright.
void FeedView::follow_theme() {
  main_->SetBackground(current_theme().window.data());
}

void FeedView::refresh() {
  Pipeline& p = *pipeline_;
  const Scene& scene = source_->GetScene();

  has_frame_ = static_cast<bool>(scene.frame);
  p.image->SetVisibility(has_frame_);
  if (has_frame_) {
    auto* frame = const_cast<vtkImageData*>(scene.frame.get());
    const double width_um = frame->GetDimensions()[0] * frame->GetSpacing()[0];
    const double height_um = frame->GetDimensions()[1] * frame->GetSpacing()[1];
    // A picture of another size starts afresh.
    if (width_um != frame_width_um_ || height_um != frame_height_um_) {
      frame_width_um_ = width_um;
      frame_height_um_ = height_um;
      window_high_ = window_low_ = 0.0;
      cell_radius_um_ = 0.0;
      cell_given_ = false;
      reset_camera();
    }
    if (image_look_.follows || !(window_high_ > window_low_)) refresh_window_level(frame);
  }
  p.membrane_lines.show(contours_shown_ && has_points(scene.membranes));
  p.tool_lines.show(tools_shown_ && has_points(scene.tools));
  p.model_lines.show(model_shown_ && has_points(scene.model));
  refresh_cell_frame();
  refresh_legend();
}

// The darkest and brightest half percent of the pixels span the window; it follows slowly, so that nothing flickers.
void FeedView::refresh_window_level(vtkImageData* frame) {
  const ImageView view = view_of(frame);
  std::vector<double> sample;
  const int stride =
      std::max(1, static_cast<int>(std::sqrt(view.width_px * static_cast<double>(view.height_px) / 8000.0)));
  for (int row = stride / 2; row < view.height_px; row += stride) {
    for (int column = stride / 2; column < view.width_px; column += stride) {
      sample.push_back(
          frame->GetPointData()->GetScalars()->GetComponent(static_cast<vtkIdType>(row) * view.width_px + column, 0));
    }
  }
  if (sample.empty()) return;
  const auto percentile = [&](double share) {
    auto at = sample.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), at, sample.end());
    return *at;
  };
  const double low = percentile(0.005);
  const double high = std::max(percentile(0.995), low + 1.0);
  const double follow = window_high_ > window_low_ ? 0.05 : 1.0;
  window_low_ += follow * (low - window_low_);
  window_high_ += follow * (high - window_high_);
  apply_image_look();
}

void FeedView::apply_image_look() {
  // Head room, so that coloured lines stand out against the brightest parts.
  const double range = window_high_ - window_low_;
  const double low_end = window_low_ - 0.10 * range, high_end = window_high_ + 0.20 * range;
  pipeline_->image->GetProperty()->SetColorWindow((high_end - low_end) / image_look_.contrast);
  pipeline_->image->GetProperty()->SetColorLevel(0.5 * (high_end + low_end) - image_look_.brightness * range);
}

void FeedView::set_image_look(const ImageLook& look) {
  image_look_ = look;
  if (window_high_ > window_low_) apply_image_look();
}

// Where the cell was first found; followed only when it has moved far or was mistaken, so that the picture stays
// where it is.
void FeedView::refresh_cell_frame() {
  const Frozen<vtkPolyData>& membranes = source_->GetScene().membranes;
  if (cell_given_ || !has_points(membranes)) return;
  double bounds_um[6];
  const_cast<vtkPolyData*>(membranes.get())->GetBounds(bounds_um);
  const double middle_um[2] = {0.5 * (bounds_um[0] + bounds_um[1]), 0.5 * (bounds_um[2] + bounds_um[3])};
  const double radius_um = 0.5 * std::max(bounds_um[1] - bounds_um[0], bounds_um[3] - bounds_um[2]);
  const double moved_um = std::hypot(middle_um[0] - cell_um_[0], middle_um[1] - cell_um_[1]);
  if (cell_radius_um_ > 0.0 && moved_um < 0.4 * cell_radius_um_ &&
      std::abs(radius_um - cell_radius_um_) < 0.3 * cell_radius_um_) {
    return;
  }
  cell_um_[0] = middle_um[0];
  cell_um_[1] = middle_um[1];
  cell_radius_um_ = radius_um;
  if (fitted_) fitted_scale_um_ = 0.0;
}

void FeedView::frame_place(const Eigen::Vector2d& middle_um, double radius_um) {
  cell_um_[0] = middle_um.x();
  cell_um_[1] = middle_um.y();
  cell_radius_um_ = radius_um;
  cell_given_ = true;
  reset_camera();
}

void FeedView::set_framing(FeedFraming framing) {
  framing_ = framing;
  reset_camera();
}

void FeedView::refresh_legend() {
  legend_.clear();
  if (!legend_shown_) return;
  const Scene& scene = source_->GetScene();
  if (contours_shown_) {
    const auto add_membrane = [&](Membrane kind, const std::string& text, const Color& color) {
      if (has_cell_value(scene.membranes, array_name::kMembrane, static_cast<int>(kind)))
        legend_.push_back({text, color});
    };
    add_membrane(Membrane::kOuter, say("Outer membrane"), palette::kOuter);
    add_membrane(Membrane::kInner, say("Inner membrane"), palette::kInner);
    add_membrane(Membrane::kOolemma, say("Oolemma"), palette::kOolemma);
  }
  if (model_shown_ && has_points(scene.model)) legend_.push_back({say("Model section"), palette::kModel, true});
  if (tools_shown_) {
    if (has_cell_value(scene.tools, array_name::kTool, 0)) legend_.push_back({say("Needle"), palette::kNeedle});
    if (has_cell_value(scene.tools, array_name::kTool, 1))
      legend_.push_back({say("Holding pipette"), palette::kHolder});
  }
  if (plan_) legend_.push_back({say("Plan"), palette::kPlan, true});
}

void FeedView::reset_camera() {
  fitted_ = true;
  fitted_scale_um_ = 0.0;
}

void FeedView::show_contours(bool shown) {
  contours_shown_ = shown;
  refresh();
}

void FeedView::show_model_section(bool shown) {
  model_shown_ = shown;
  refresh();
}

void FeedView::show_tools(bool shown) {
  tools_shown_ = shown;
  refresh();
}

void FeedView::set_plan(const std::optional<PlanMarks>& plan) {
  plan_ = plan;
  refresh_legend();
}

void FeedView::show_legend(bool shown) {
  legend_shown_ = shown;
  refresh_legend();
}

void FeedView::set_caption(std::string utf8) {
  caption_ = std::move(utf8);
}

void FeedView::set_empty_text(std::string utf8) {
  empty_text_ = std::move(utf8);
}

Eigen::Vector2d FeedView::place_um(double x_px, double y_px, double view_height_px) const {
  // The image is seen along the depth, without perspective: any depth gives the same place in its plane.
  main_->SetDisplayPoint(x_px * hud_ratio(), (view_height_px - 1.0 - y_px) * hud_ratio(), 0.0);
  main_->DisplayToWorld();
  const double* place = main_->GetWorldPoint();
  return {place[0] / place[3], place[1] / place[3]};
}

void FeedView::prepare(double width_px, double height_px) {
  if (!has_frame_ || width_px < 1.0 || height_px < 1.0) return;
  vtkCamera* camera = main_->GetActiveCamera();
  // After panning or zooming the view stays until the camera is reset.
  const double* focus = camera->GetFocalPoint();
  if (fitted_ && fitted_scale_um_ > 0.0 &&
      (camera->GetParallelScale() != fitted_scale_um_ || focus[0] != fitted_focus_um_[0] ||
       focus[1] != fitted_focus_um_[1])) {
    fitted_ = false;
  }
  if (fitted_) {
    const double aspect = width_px / height_px;
    double half_height_um = 0.5 * std::max(frame_height_um_, frame_width_um_ / aspect);
    fitted_focus_um_[0] = 0.5 * frame_width_um_;
    fitted_focus_um_[1] = 0.5 * frame_height_um_;
    if (framing_ == FeedFraming::kCell && cell_radius_um_ > 0.0) {
      half_height_um = std::min(half_height_um, kCellMargin * cell_radius_um_ * std::max(1.0, 1.0 / aspect));
      // Looks at the cell, but not beyond the frame's edges where that can be avoided.
      const double half_um[2] = {half_height_um * aspect, half_height_um};
      const double frame_um[2] = {frame_width_um_, frame_height_um_};
      for (int k = 0; k < 2; ++k) {
        if (2.0 * half_um[k] < frame_um[k]) {
          fitted_focus_um_[k] = std::clamp(cell_um_[k], half_um[k], frame_um[k] - half_um[k]);
        }
      }
    }
    fitted_scale_um_ = half_height_um;
    camera->SetFocalPoint(fitted_focus_um_[0], fitted_focus_um_[1], 0.0);
    camera->SetPosition(fitted_focus_um_[0], fitted_focus_um_[1], -100.0);
    camera->SetViewUp(0.0, -1.0, 0.0);
    camera->SetParallelScale(fitted_scale_um_);
  }
  camera->SetClippingRange(1.0, 1000.0);

  // Line widths in logical pixels.
  const double um_per_px = 2.0 * camera->GetParallelScale() / (height_px / hud_ratio());
  pipeline_->membrane_lines.set_width(kLineWidth, um_per_px);
  pipeline_->tool_lines.set_width(kLineWidth, um_per_px);
  pipeline_->model_lines.set_width(0.75 * kLineWidth, um_per_px);
  pipeline_->dashes->SetDashUm(6.0 * um_per_px);
  pipeline_->dashes->SetGapUm(5.0 * um_per_px);
}

void FeedView::draw_hud(HudCanvas& hud, double width_px, double height_px) {
  if (!has_frame_) {
    hud.text(0.5 * width_px, 0.5 * height_px, empty_text_,
             {.size_pt = font_size::kTitle, .color = current_theme().text_dim, .align = HudAlign::kCentre});
    return;
  }
  const ToHud place = [this](const Eigen::Vector2d& p_um) {
    const double world_um[3] = {p_um.x(), p_um.y(), 0.0};
    const auto [x, y] = to_hud(world_um);
    return Eigen::Vector2d(x, y);
  };
  if (plan_) draw_plan(hud, *plan_, place);
  const auto needle = needle_of(source_->GetScene());
  if (tools_shown_ && needle) draw_tip(hud, *needle, place);
  for (const HintMark& hint : hints_) draw_hint(hud, hint, place);
  const double um_per_px = 2.0 * main_->GetActiveCamera()->GetParallelScale() / height_px;
  const double legend_px = prompt_.empty() ? draw_legend(hud, legend_, width_px, height_px) : 0.0;
  draw_scale_bar(hud, um_per_px);
  if (const auto tip_um = needle ? std::optional(needle->tip_um) : reported_tip_um_) {
    draw_needle_pointer(hud, *tip_um, place, width_px, height_px, um_per_px);
  }
  if (!prompt_.empty()) {
    draw_prompt(hud, prompt_, width_px, height_px);
    return;
  }
  if (!caption_.empty()) {
    const HudText style{.color = palette::kText, .align = HudAlign::kRight};
    const double caption_width = hud.text_width_px(caption_, style);
    if (caption_width + legend_px + kCaptionMargins_px > width_px || height_px < kCaptionRoom_px) return;
    hud.rounded(width_px - caption_width - 28.0, height_px - 38.0, caption_width + 18.0, 26.0, 5.0, palette::kWindow,
                0.72);
    hud.text(width_px - 19.0, height_px - 25.0, caption_, style);
  }
}

}  // namespace pellucida