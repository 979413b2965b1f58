#pragma once
#include <memory>
#include <optional>
#include <string>

#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/visualization/Scaling.h"
#include "pellucida/visualization_vtk/View.h"

namespace pellucida {

struct MembraneActors;

/// Meaning of the outer membrane's colour.
enum class SurfaceColoring { kPlain, kTension, kDisplacement };

/// The cell in 3-D: outer membrane translucent, inner one solid, needle and holding pipette in glass, an arrow for the
/// force on each of a few hundred nodes (coloured and sized by it, with a scale in uN), and one bold arrow with its
/// value for the force of the needle on the cell.
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

  /// The needle's force as it is written beside the bold arrow; empty where the arrow isn't drawn.
  const std::string& contact_label() const noexcept { return contact_label_; }

  /// The node of the surface seen at a point of the view, in logical pixels, origin at the top left; nothing beside
  /// the cell.
  std::optional<long> node_at(double x_px, double y_px) const;
  /// Shown where there is no surface, in place of the reason as a live run has it; empty: that.
  void set_empty_text(std::string utf8);
  /// Marks a node with a ring; nothing: none.
  void mark_node(std::optional<long> node);

  void set_coloring(SurfaceColoring coloring);
  void show_arrows(bool shown);
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
  void refresh_arrows(vtkPolyData* surface);
  void refresh_coloring(vtkPolyData* surface);
  void refresh_tools();
  void refresh_contact_force();
  void draw_contact_label(HudCanvas& hud) const;
  void draw_node_mark(HudCanvas& hud) const;

  StageSource* source_;
  std::unique_ptr<MembraneActors> actors_;
  SurfaceColoring coloring_ = SurfaceColoring::kPlain;
  NiceRange force_range_uN_{0.001};
  NiceRange tension_range_uN_per_um_{0.0001};
  NiceRange displacement_range_um_{1.0};
  NiceRange contact_range_uN_{1.0};
  bool arrows_shown_ = true;
  bool tools_shown_ = true;
  bool has_surface_ = false;
  bool has_forces_ = false;
  bool coloring_available_ = false;
  bool beyond_scale_ = false;
  bool framed_ = false;
  double arrow_scale_ = 1.0;
  double center_um_[3] = {0.0, 0.0, 0.0};
  double radius_um_ = 50.0;
  std::string contact_label_;
  double contact_tail_um_[3] = {0.0, 0.0, 0.0};
  std::string empty_text_;
  std::optional<long> marked_node_;
};

}  // namespace pellucida
