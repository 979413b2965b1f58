#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pellucida/core/Words.h"
#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/visualization/PlanMarks.h"
#include "pellucida/visualization_vtk/View.h"

class vtkImageData;

namespace pellucida {

/// What the feed shows until the user pans or zooms.
enum class FeedFraming {
  kCell,   ///< the cell with its surroundings, once found; until then the whole frame
  kFrame,  ///< the whole frame
};

/// How bright the image is shown; what is measured in it stays the same.
struct ImageLook {
  bool follows = true;      ///< black and white follow the image slowly; else they stay as they are
  double brightness = 0.0;  ///< -1..1: of the range from black to white
  double contrast = 1.0;    ///< > 0: times as steep

  bool operator==(const ImageLook&) const = default;
};

/// A line of the feed's legend.
struct LegendRow {
  std::string text;
  Color color;
  bool dashed = false;
};

/// The microscope's picture as it appears in the eyepiece (x right, y down), with what was found in it: membranes,
/// tools, the needle's tip and axis, and the model's own section in the image plane, dashed. A scale bar of a round
/// length and a legend of the lines come with it. Drag pans, wheel zooms (PanZoomStyle). The overlay always belongs to
/// the frame it is drawn on.
class FeedView : public View {
 public:
  /// Follows `source`, which must outlive the view.
  explicit FeedView(StageSource* source);
  ~FeedView() override;

  /// Takes the source's present output. Call after `Poll` or `SetScene`, before rendering.
  void refresh();
  void follow_theme() override;
  /// Undoes panning and zooming.
  void reset_camera();
  /// Default: kCell.
  void set_framing(FeedFraming framing);

  /// Frames this place in place of the cell that is found, until a picture of another size comes.
  void frame_place(const Eigen::Vector2d& middle_um, double radius_um);

  void set_image_look(const ImageLook& look);
  const ImageLook& image_look() const noexcept { return image_look_; }
  void show_contours(bool shown);
  void show_model_section(bool shown);
  void show_tools(bool shown);
  /// Default: on. Off for a small view beside one that has the same lines.
  void show_legend(bool shown);
  /// The injection plan: the straight path with its corridor, entry, depth stop and target. Nothing: none is drawn.
  void set_plan(const std::optional<PlanMarks>& plan);
  const std::optional<PlanMarks>& plan() const noexcept { return plan_; }

  /// Where a person pointed.
  void set_hints(std::vector<HintMark> marks) { hints_ = std::move(marks); }
  /// What a click is waited for, large at the top; empty for nothing.
  void set_prompt(std::string utf8) { prompt_ = std::move(utf8); }
  const std::string& prompt() const noexcept { return prompt_; }
  /// Where the manipulator says that the tip is: for the arrow at the edge while the needle isn't seen.
  void set_reported_tip(const std::optional<Eigen::Vector2d>& tip_um) { reported_tip_um_ = tip_um; }
  /// Where a place of the view, logical pixels from its upper left corner, lies in the image plane, um.
  Eigen::Vector2d place_um(double x_px, double y_px, double view_height_px) const;

  /// A line in the upper right corner, empty for none; left out where the legend leaves no room for it.
  void set_caption(std::string utf8);
  /// Shown in place of a frame that isn't there. Default: "Waiting for the first frame".
  void set_empty_text(std::string utf8);

 protected:
  void prepare(double width_px, double height_px) override;
  void draw_hud(HudCanvas& hud, double width_px, double height_px) override;

 private:
  struct Pipeline;

  void refresh_window_level(vtkImageData* frame);
  void apply_image_look();
  void refresh_cell_frame();
  void refresh_legend();

  StageSource* source_;
  std::unique_ptr<Pipeline> pipeline_;
  std::vector<LegendRow> legend_;
  std::string caption_;
  std::string empty_text_ = say("Waiting for the first frame");
  std::optional<PlanMarks> plan_;
  std::vector<HintMark> hints_;
  std::string prompt_;
  std::optional<Eigen::Vector2d> reported_tip_um_;
  bool contours_shown_ = true;
  bool model_shown_ = true;
  bool tools_shown_ = true;
  bool legend_shown_ = true;
  bool fitted_ = true;  // the camera follows the frame's size
  bool has_frame_ = false;
  double frame_width_um_ = 0.0;
  double frame_height_um_ = 0.0;
  FeedFraming framing_ = FeedFraming::kCell;
  double cell_um_[2] = {0.0, 0.0};  // middle of the framed cell
  double cell_radius_um_ = 0.0;     // 0 before one was found
  bool cell_given_ = false;         // by `frame_place`
  ImageLook image_look_;
  double window_low_ = 0.0;
  double window_high_ = 0.0;
  double fitted_scale_um_ = 0.0;
  double fitted_focus_um_[2] = {0.0, 0.0};
};

}  // namespace pellucida
