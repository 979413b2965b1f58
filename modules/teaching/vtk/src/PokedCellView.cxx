#include "pellucida/teaching_vtk/PokedCellView.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>

#include "ColorMap.h"
#include "PokedCellActors.h"
#include "pellucida/core/Words.h"

namespace pellucida {
namespace {

constexpr double kViewAngle_deg = 22.0;
constexpr double kLongestArrow_ratio = 0.55;  // of the cell's radius
constexpr double kPickReach_px = 16.0;
constexpr double kSpringWidth_px = 1.4;
constexpr double kExplainedSprings = 0.45;  // opacity, beside arrows
// The colour scale ends above all but the few connectors at the tip.
constexpr double kPullShare = 0.98;
// The longest arrow of a field, of the cell's radius.
constexpr double kLongestFieldArrow_ratio = 0.4;
// The hand shows once it is so far from the tip.
constexpr double kLagShown_um = 0.7;

constexpr std::array<Color, kForceTermCount> kTermsOnDark = {
    Color::from_hex(0x39D5FF), Color::from_hex(0xFFA94D), Color::from_hex(0xD59BFF),
    Color::from_hex(0x86E57F), Color::from_hex(0x7F97FF), Color::from_hex(0xFF5F9E),
    Color::from_hex(0xFFF27A), Color::from_hex(0xB0B8C2), Color::from_hex(0xFFFFFF)};
constexpr std::array<Color, kForceTermCount> kTermsOnLight = {
    Color::from_hex(0x007CA3), Color::from_hex(0xB85C00), Color::from_hex(0x8A3FC7),
    Color::from_hex(0x2B7A24), Color::from_hex(0x2F45C8), Color::from_hex(0xC2185B),
    Color::from_hex(0x7A6A00), Color::from_hex(0x59636E), Color::from_hex(0x10161D)};

double quantile_of_sizes(const Eigen::VectorXd& values, double share) {
  std::vector<double> sizes(static_cast<std::size_t>(values.size()));
  for (Eigen::Index k = 0; k < values.size(); ++k) sizes[static_cast<std::size_t>(k)] = std::abs(values[k]);
  const auto place = sizes.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), place, sizes.end());
  return *place;
}

}  // namespace

Color term_color(ForceTerm term, const ThemeColors& theme) noexcept {
  return (theme.is_light ? kTermsOnLight : kTermsOnDark)[static_cast<std::size_t>(term)];
}

PokedCellView::PokedCellView() : actors_(std::make_unique<PokedCellActors>()) {
  actors_->build(main_);
  hints_ = {say("Drag: needle"), say("Click: forces on a node"), say("Right drag: turn")};
  main_->GradientBackgroundOn();
  main_->AutomaticLightCreationOff();
  vtkNew<vtkLight> key;
  key->SetLightTypeToCameraLight();
  key->SetPosition(-0.6, 0.8, 1.0);
  vtkNew<vtkLight> fill;
  fill->SetLightTypeToCameraLight();
  fill->SetPosition(0.8, -0.5, 0.6);
  fill->SetIntensity(0.35);
  main_->AddLight(key);
  main_->AddLight(fill);
  follow_theme();
  reset_camera();
}

PokedCellView::~PokedCellView() = default;

void PokedCellView::follow_theme() {
  theme_ = &current_theme();
  main_->SetBackground(theme_->view_bottom.data());
  main_->SetBackground2(theme_->view_top.data());
  actors_->set_theme(*theme_, kSpringWidth_px);
  refresh();
}

void PokedCellView::show_springs(bool shown) {
  springs_shown_ = shown;
  refresh();
}
void PokedCellView::show_surface(bool shown) {
  surface_shown_ = shown;
  refresh();
}
void PokedCellView::set_head_to_tail(bool on) {
  head_to_tail_ = on;
  refresh();
}

void PokedCellView::set_snapshot(CellSnapshotPtr snapshot) {
  snapshot_ = std::move(snapshot);
  refresh();
}

void PokedCellView::refresh() {
  PokedCellActors& p = *actors_;
  const bool shown = snapshot_ != nullptr;
  p.spring_actor->SetVisibility(shown && springs_shown_);
  p.wall.show(shown && surface_shown_);
  p.needle.show(shown);
  p.holder.show(shown);
  if (!shown) {
    p.arrows.hide();
    p.field_actor->VisibilityOff();
    return;
  }
  if (p.mesh != snapshot_->mesh) p.set_mesh(snapshot_->mesh);
  const Scales own = scales_for(*snapshot_);
  used_ = scales_ ? *scales_ : Scales{pull_range_uN_.update(own.pull_uN), field_range_uN_.update(own.field_uN)};
  refresh_surface();
  refresh_field();
  refresh_arrows();
  const Eigen::Vector3d tip_um = contact_um() + snapshot_->tip_um;
  p.needle_pose->Identity();
  p.needle_pose->Translate(tip_um.data());
  p.needle_pose->RotateY(-90.0);
}

void PokedCellView::refresh_surface() {
  PokedCellActors& p = *actors_;
  const Eigen::Matrix3Xd& x_um = snapshot_->x_um;
  p.points->SetNumberOfPoints(x_um.cols());
  for (Eigen::Index n = 0; n < x_um.cols(); ++n) p.points->SetPoint(n, x_um.col(n).data());
  p.points->Modified();
  const Eigen::VectorXd& pulls_uN = snapshot_->spring_pull_uN;
  for (Eigen::Index k = 0; k < pulls_uN.size(); ++k) p.pulls_uN->SetValue(k, pulls_uN[k]);
  p.pulls_uN->Modified();
  p.pull_colors->SetTableRange(-used_.pull_uN, used_.pull_uN);
}

void PokedCellView::refresh_field() {
  PokedCellActors& p = *actors_;
  const Eigen::Matrix3Xd& field_uN = snapshot_->field_uN;
  p.field_actor->SetVisibility(field_uN.cols() > 0);
  if (field_uN.cols() == 0) return;
  p.field_uN->SetNumberOfTuples(field_uN.cols());
  for (Eigen::Index n = 0; n < field_uN.cols(); ++n) p.field_uN->SetTuple(n, field_uN.col(n).data());
  p.field_uN->Modified();
  p.scale_field(kLongestFieldArrow_ratio * snapshot_->mesh->mid_radius_um, used_.field_uN);
}

PokedCellView::Scales PokedCellView::scales_for(const CellSnapshot& s) {
  const double strongest_uN = s.field_uN.cols() > 0 ? s.field_uN.colwise().norm().maxCoeff() : 0.0;
  return {quantile_of_sizes(s.spring_pull_uN, kPullShare), strongest_uN};
}

void PokedCellView::show_scales(bool pull, bool field) {
  pull_scale_shown_ = pull;
  field_scale_shown_ = field;
}

void PokedCellView::set_scales(const std::optional<Scales>& scales) {
  scales_ = scales;
  refresh();
}

void PokedCellView::refresh_arrows() {
  const auto& forces = snapshot_->node_forces;
  actors_->spring_actor->GetProperty()->SetOpacity(forces ? kExplainedSprings : 1.0);
  actors_->wall.set_opacity(forces ? PokedCellActors::kExplainedOpacity : PokedCellActors::kWallOpacity);
  if (!forces) {
    actors_->arrows.hide();
    return;
  }
  actors_->arrows.show(*forces, snapshot_->x_um.col(forces->node), kLongestArrow_ratio * snapshot_->mesh->mid_radius_um,
                       head_to_tail_, *theme_);
}

void PokedCellView::reset_camera() {
  const double radius_um = snapshot_ ? snapshot_->mesh->mid_radius_um : 50.0;
  const Eigen::Vector3d from = Eigen::Vector3d(0.32, 1.0, 0.55).normalized();
  const double distance_um = 1.42 * radius_um / std::sin(0.5 * kViewAngle_deg * EIGEN_PI / 180.0);
  // A little room for the needle on the right.
  const Eigen::Vector3d middle_um(0.0, 0.0, 0.15 * radius_um);
  const Eigen::Vector3d at_um = middle_um + distance_um * from;
  vtkCamera* camera = main_->GetActiveCamera();
  camera->SetViewAngle(kViewAngle_deg);
  camera->SetFocalPoint(middle_um.data());
  camera->SetPosition(at_um.data());
  camera->SetViewUp(1.0, 0.0, 0.0);
}

Eigen::Vector3d PokedCellView::contact_um() const {
  return snapshot_->mesh->mid_radius_um * Eigen::Vector3d::UnitZ();
}

Eigen::Vector2d PokedCellView::on_screen_px(const Eigen::Vector3d& place_um) const {
  const auto [x, y] = to_hud(place_um.data());
  return hud_ratio() * Eigen::Vector2d(x, y);
}

Eigen::Vector2d PokedCellView::tip_on_screen_px() const {
  return snapshot_ ? on_screen_px(contact_um() + snapshot_->tip_um) : Eigen::Vector2d::Zero();
}

Eigen::Vector2d PokedCellView::node_on_screen_px(int node) const {
  return on_screen_px(snapshot_->x_um.col(node));
}

Eigen::Vector2d PokedCellView::hand_motion_um(double dx_px, double dy_px) const {
  if (!snapshot_) return Eigen::Vector2d::Zero();
  // How a micrometre of each motion looks on screen; where one of them is seen end-on, it doesn't move.
  const Eigen::Vector3d tip_um = contact_um() + snapshot_->tip_um;
  const Eigen::Vector2d here = on_screen_px(tip_um);
  Eigen::Matrix2d seen;
  seen << on_screen_px(tip_um + snapshot_->mesh->push) - here, on_screen_px(tip_um + Eigen::Vector3d::UnitX()) - here;
  const Eigen::Matrix2d square =
      seen.transpose() * seen + 0.05 * seen.squaredNorm() * 0.05 * Eigen::Matrix2d::Identity();
  return square.ldlt().solve(seen.transpose() * Eigen::Vector2d(dx_px, dy_px));
}

std::optional<int> PokedCellView::node_at(double x_px, double y_px) const {
  if (!snapshot_) return std::nullopt;
  const Eigen::Vector3d eye_um(main_->GetActiveCamera()->GetPosition());
  std::optional<int> nearest;
  double least_px = kPickReach_px * hud_ratio();
  for (int node = 0; node < snapshot_->x_um.cols(); ++node) {
    const Eigen::Vector3d x_um = snapshot_->x_um.col(node);
    if (x_um.dot(eye_um - x_um) < 0.0) continue;  // the far side
    const double away_px = (on_screen_px(x_um) - Eigen::Vector2d(x_px, y_px)).norm();
    if (away_px >= least_px) continue;
    least_px = away_px;
    nearest = node;
  }
  return nearest;
}

void PokedCellView::prepare(double width_px, double height_px) {
  // The whole cell in a narrow view too.
  main_->GetActiveCamera()->SetUseHorizontalViewAngle(width_px < height_px);
  main_->ResetCameraClippingRange();
}

void PokedCellView::draw_hud(HudCanvas& hud, double width_px, double height_px) {
  if (!snapshot_) return;
  draw_scales(hud, width_px, height_px);
  draw_hand(hud);
  // As much of it as there is room for.
  const HudText style{.color = theme_->text_dim};
  double x = 16.0;
  for (const std::string& hint : hints_) {
    const double width = hud.text_width_px(hint, style);
    if (x + width > width_px) break;
    hud.text(x, 18.0, hint, style);
    x += width + 20.0;
  }
}

void PokedCellView::draw_scales(HudCanvas& hud, double width_px, double height_px) const {
  const double bar_height = std::clamp(0.42 * height_px, 70.0, 200.0);
  const double y = height_px - bar_height - 40.0;
  if (springs_shown_ && pull_scale_shown_) {
    draw_color_bar(hud, ColorMapKind::kPull, 16.0, y, bar_height, used_.pull_uN, say("Pull of a connector (µN)"),
                   HudAlign::kLeft, true, *theme_);
  }
  if (snapshot_->field_uN.cols() > 0 && field_scale_shown_) {
    draw_color_bar(hud, ColorMapKind::kForce, width_px - 16.0, y, bar_height, used_.field_uN, say("Node force (µN)"),
                   HudAlign::kRight, false, *theme_);
  }
}

// The hand as a ring, tied to the tip: its way ahead of the tip is the force.
void PokedCellView::draw_hand(HudCanvas& hud) const {
  const CellSnapshot& s = *snapshot_;
  const Eigen::Vector3d hand_um =
      contact_um() + s.hand_along_um * s.mesh->push + s.hand_across_um * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d tip_um = contact_um() + s.tip_um;
  if ((hand_um - tip_um).norm() < kLagShown_um) return;
  const auto [x0, y0] = to_hud(tip_um.data());
  const auto [x1, y1] = to_hud(hand_um.data());
  hud.line(x0, y0, x1, y1, 2.0, theme_->warning, 0.9);
  hud.disc(x1, y1, 7.0, theme_->warning);
  hud.disc(x1, y1, 4.0, theme_->is_light ? theme_->raised : theme_->window);
  hud.text(x1, y1 + 18.0, say("hand"), {.color = theme_->warning, .bold = true, .align = HudAlign::kCentre});
}

}  // namespace pellucida
