#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/teaching/CellRunner.h"
#include "pellucida/visualization/Scaling.h"
#include "pellucida/visualization_vtk/View.h"

namespace pellucida {

struct PokedCellActors;

/// The colour of a term's arrow and of its row in a table.
Color term_color(ForceTerm term, const ThemeColors& theme) noexcept;

/// A poked cell in 3-D: its surface translucent, its connectors coloured by their tension with a scale in uN, needle
/// and holding pipette in glass, a ring where the hand is when the tip stays behind it, and the forces on one node as
/// arrows. The needle comes from the right.
class PokedCellView : public View {
 public:
  PokedCellView();
  ~PokedCellView() override;

  /// What to show from the next rendering on; null shows nothing.
  void set_snapshot(CellSnapshotPtr snapshot);
  void follow_theme() override;
  void show_springs(bool shown);
  void show_surface(bool shown);
  /// Arrows of a node one behind the other instead of all from the node.
  void set_head_to_tail(bool on);
  void reset_camera();

  /// Scales that two views share, so that they can be compared: at the ends of the connectors' colours and of the
  /// arrows of `CellSnapshot::field_uN`; above 0. Nothing: each view its own.
  struct Scales {
    double pull_uN = 0.0;
    double field_uN = 0.0;
  };
  void set_scales(const std::optional<Scales>& scales);
  /// Which of them are drawn; default: both, as far as they have a meaning.
  void show_scales(bool pull, bool field);
  /// What the scales would have to hold for this snapshot: all but the few connectors at the tip, and every arrow.
  static Scales scales_for(const CellSnapshot& snapshot);
  /// What the mouse does, at the bottom; the default is said for a cell to be poked.
  void set_hints(std::vector<std::string> utf8) { hints_ = std::move(utf8); }

  /// The motion of the hand (um along the push, um across) that moves the needle by so many device pixels on screen.
  Eigen::Vector2d hand_motion_um(double dx_px, double dy_px) const;
  /// The node nearest to a place on screen (device pixels, origin at the bottom left) on the near side of the cell;
  /// nothing more than 16 logical pixels away.
  std::optional<int> node_at(double x_px, double y_px) const;
  /// Where the needle's tip and where a node is on screen, device pixels.
  Eigen::Vector2d tip_on_screen_px() const;
  Eigen::Vector2d node_on_screen_px(int node) const;

 protected:
  void prepare(double width_px, double height_px) override;
  void draw_hud(HudCanvas& hud, double width_px, double height_px) override;

 private:
  Eigen::Vector3d contact_um() const;
  Eigen::Vector2d on_screen_px(const Eigen::Vector3d& place_um) const;
  void refresh();
  void refresh_surface();
  void refresh_arrows();
  void refresh_field();
  void draw_hand(HudCanvas& hud) const;
  void draw_scales(HudCanvas& hud, double width_px, double height_px) const;

  CellSnapshotPtr snapshot_;
  const ThemeColors* theme_ = &current_theme();
  std::unique_ptr<PokedCellActors> actors_;
  NiceRange pull_range_uN_{0.001};
  NiceRange field_range_uN_{0.001};
  std::optional<Scales> scales_;
  Scales used_;
  std::vector<std::string> hints_;
  bool springs_shown_ = true;
  bool surface_shown_ = true;
  bool head_to_tail_ = false;
  bool pull_scale_shown_ = true;
  bool field_scale_shown_ = true;
};

}  // namespace pellucida
