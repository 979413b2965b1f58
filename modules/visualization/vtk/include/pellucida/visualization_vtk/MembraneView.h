#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/visualization/NodeForce.h"
#include "pellucida/visualization/PlanMarks.h"
#include "pellucida/visualization/Scaling.h"
#include "pellucida/visualization_vtk/View.h"

namespace pellucida {

/// A droplet in the cell as the view draws it.
struct DropletMark {
  Eigen::Vector3d center_um = Eigen::Vector3d::Zero();  ///< frame W
  double radius_um = 0.0;
  std::string text;  ///< beside it, UTF-8
};

struct BoldArrow;
struct MembraneActors;

/// The cell in 3-D: outer membrane translucent or in the colours of a quantity, inner one solid (clear once the needle
/// or a droplet is in it), needle and holding pipette in glass, an arrow for the force on each of a few hundred nodes
/// (coloured and sized by it, with a scale in uN; grey where it can't be told from zero), and one bold arrow with its
/// value for the whole force of the needle, and of the holding pipette where the arrows show that.
class MembraneView : public View {
 public:
  /// Follows `source`, which must outlive the view.
  explicit MembraneView(StageSource* source);
  ~MembraneView() override;

  /// Takes the source's present output. Call after `Poll` or `SetScene`, before rendering.
  void refresh();
  void follow_theme() override;
  /// Frames cell and tool tips, seen from the front and above.
  void reset_camera();

  /// What is shown.
  const Scene& scene() const { return source_->GetScene(); }
  /// The needle's force as it is written beside the bold arrow; empty where the arrow isn't drawn.
  const std::string& contact_label() const noexcept { return contact_label_; }

  /// The force of the holding pipette on the cell, likewise.
  const std::string& holder_label() const noexcept;

  /// The node of the surface seen at a point of the view, in logical pixels, origin at the top left; nothing beside
  /// the cell.
  std::optional<long> node_at(double x_px, double y_px) const;
  /// Shown where there is no surface, in place of the reason as a live run has it; empty: that.
  void set_empty_text(std::string utf8);
  /// Marks a node with a ring; nothing: none.
  void mark_node(std::optional<long> node);

  void set_coloring(SurfaceColoring coloring);
  SurfaceColoring coloring() const noexcept { return coloring_; }
  void show_arrows(bool shown);
  /// Default: kTools.
  void set_node_force(NodeForceKind kind);
  NodeForceKind node_force() const noexcept;
  /// The scene has forces on its nodes, but not those chosen: it comes from a session of an earlier version.
  bool lacks_node_force() const noexcept { return lacks_force_; }
  /// The 95 % interval at each arrow. Default: off.
  void show_error_bars(bool shown);
  /// The mesh of the mechanical model in its solved shape, as a wire. Default: off.
  void show_model(bool shown);
  /// The injection plan, also where the cell hides it. Nothing: none is drawn.
  void set_plan(const std::optional<PlanMarks>& plan) { plan_ = plan; }
  /// Droplets in the cell, as balls; the inner membrane is then clear. Empty: none.
  void set_droplets(std::vector<DropletMark> droplets);
  void show_tools(bool shown);
  /// Most arrows drawn, 1..5000.
  void set_arrow_count(int count);
  /// Arrow size, 1 = the default, in which the longest arrow is 0.35 of the cell's radius; 0.1..5.
  void set_arrow_scale(double scale);
  /// Forces below this share of the scale's end are not drawn, 0..1.
  void set_arrow_threshold(double ratio);
  /// Lengths by the logarithm, so that small forces show.
  void set_arrow_log_scale(bool on);

 protected:
  void prepare(double width_px, double height_px) override;
  void draw_hud(HudCanvas& hud, double width_px, double height_px) override;

 private:
  // The upper end of a colour scale, and when it grew last.
  struct Scale {
    NiceRange range{1.0};
    double before = 0.0;
    double grew_s = 0.0;
    bool used = false;
    bool beyond = false;  ///< some values lie beyond it
    double update(double greatest, double time_s);
    bool is_news(double time_s) const;
  };

  void refresh_arrows();
  void refresh_coloring(vtkPolyData* surface);
  void refresh_tools();
  void refresh_bold_arrows(vtkPolyData* surface);
  Scale& force_scale();
  Scale& color_scale();
  void draw_scales(HudCanvas& hud, double width_px, double height_px);
  void draw_arrow_notes(HudCanvas& hud, double x, double y);
  void draw_inside(HudCanvas& hud) const;
  void draw_droplets(HudCanvas& hud) const;
  void draw_bold_arrow(HudCanvas& hud, const BoldArrow& arrow) const;
  void draw_node_mark(HudCanvas& hud) const;

  StageSource* source_;
  std::unique_ptr<MembraneActors> actors_;
  SurfaceColoring coloring_ = SurfaceColoring::kPlain;
  std::array<Scale, kNodeForceKinds.size()> force_scales_;
  std::array<Scale, kSurfaceColorings.size()> color_scales_;
  NiceRange contact_range_uN_{1.0};
  bool arrows_shown_ = true;
  bool bars_shown_ = false;
  bool tools_shown_ = true;
  bool model_shown_ = false;
  bool has_surface_ = false;
  bool has_forces_ = false;
  bool lacks_force_ = false;
  bool has_sure_ = false, has_unsure_ = false;  // arrows that can be told from zero, and that can't
  bool coloring_available_ = false;
  bool punctured_ = false;
  bool framed_ = false;
  double arrow_scale_ = 1.0;
  double center_um_[3] = {0.0, 0.0, 0.0};
  double radius_um_ = 50.0;
  std::string contact_label_;
  std::string empty_text_;
  std::optional<long> marked_node_;
  std::optional<PlanMarks> plan_;
  std::vector<DropletMark> droplets_;
};

}  // namespace pellucida
