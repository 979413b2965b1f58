#pragma once
#include <Eigen/Core>
#include <vector>

#include "CellDetector.h"
#include "CommandedMotion.h"
#include "ContactLogic.h"
#include "FrameSampler.h"
#include "GlobalShiftEstimator.h"
#include "GrayImage.h"
#include "HolderFinder.h"
#include "MembraneSnakes.h"
#include "NeedleTracker.h"
#include "RestGeometry.h"
#include "RigidMotion.h"
#include "RivalTool.h"
#include "SceneReader.h"
#include "SoftZona.h"
#include "SteadyDrift.h"
#include "ToolFinder.h"
#include "pellucida/tracking/TrackerOptions.h"
#include "pellucida/tracking/TrackerTimings.h"
#include "pellucida/tracking/TrackingHints.h"

namespace pellucida {

/// One frame as the follower gets it.
struct FrameInput {
  ImageView view;
  FrameSampler image;                   ///< of `view`
  double noise = 0.0;                   ///< standard deviation of a pixel, 0..1 of the range
  CommandedMotion* command = nullptr;   ///< of the needle; null: unknown in this frame
  TrackerTimings* timings = nullptr;    ///< where the parts of `follow` put their time; not null
  const SceneReading* seen = nullptr;   ///< what the network shows of it; null: it wasn't asked
  const SceneReading* scene = nullptr;  ///< the same, to find cell and needle by; null: by lines
  SceneReader* reader = nullptr;        ///< to read membranes and tip by; null: their lines are known
  SceneReader* networks = nullptr;      ///< to ask for what lines alone don't say; null: not to be asked
  bool is_vouched = false;              ///< a person says that this is a cell
  double* refused_radius_px = nullptr;  ///< of what `start` refuses for its size alone; null: it wasn't asked
  double least_score = MembraneSnakes::kLeastAtFirst;  ///< of membranes that are read, at first sight
};

/// One cell followed from frame to frame: contours, needle, holder, rigid motion, rest shape and state belong together
/// here, in px. What is not found, or lost for good, is the caller's to look for anew.
class CellFollower {
 public:
  explicit CellFollower(const TrackerOptions& options) : options_(options), snakes_(options), contact_(options) {}

  /// Begins with a detected cell. False when its edges, looked at closely, are no membrane's; the follower then holds
  /// nothing.
  bool start(const FrameInput& frame, const DetectedCell& cell);

  /// What is known of a cell apart from how it is seen now: its shape at rest, with the centre where it is in the
  /// image, and its contact.
  struct Memory {
    RestGeometry rest;
    ContactLogic contact;
  };
  /// Of the cell that was followed until now, as it lay under `motion`.
  Memory memory(const RigidMove& motion) const;
  /// The cell just begun goes on as the one before, if it lies where that lay and is as large: what one frame of a cell
  /// under a needle shows of its shape at rest is little, and no puncture. Nothing is done for a cell that nothing
  /// touched, or another one.
  void resume(const FrameInput& frame, const Memory& before);

  /// The needle's tip is at `tip`, px, according to a person. False where no needle can be followed there; the needle
  /// is then what it was.
  bool expect_needle(const FrameInput& frame, const Eigen::Vector2d& tip);
  /// The holding pipette passes at `place`, px, according to a person: from now on it says how the cell moves. False
  /// where none can be found there; the holder is then what it was.
  bool expect_holder(const FrameInput& frame, const Eigen::Vector2d& place);
  /// See `NeedleTracker`; false in contact.
  bool take_bevel(const FrameSampler& image, TipNetwork& network);
  /// Its lines are one wall of a needle half as wide as that: its tip is read at that scale.
  void expect_needle_width(double half_width_px, const FrameSampler& image, TipNetwork& network);
  void forget_needle() {
    needle_.reset();
    needle_way_.reset();
    rival_.reset();
  }

  /// Follows into the next frame. False when the cell has been out of sight for too long.
  bool follow(const FrameInput& frame);

  const MembraneSnakes& snakes() const noexcept { return snakes_; }
  /// Round the snakes' oolemma, where the zona's outer edge is soft.
  const SoftZona& zona() const noexcept { return zona_; }
  const NeedleTracker& needle() const noexcept { return needle_; }
  /// The holding pipette as it was found with the cell; `motion()` takes it to where it is now.
  const std::optional<HolderFit>& holder() const noexcept { return holder_; }
  const RestGeometry& rest() const noexcept { return rest_; }
  bool is_read() const noexcept { return is_read_; }  ///< by networks, not by what the membranes look like
  CellState state() const noexcept { return contact_.state(); }
  /// Rigid motion since the cell was found, and where its resting centre is now.
  const RigidMove& motion() const noexcept { return motion_; }
  Eigen::Vector2d center_now() const { return motion_.apply(rest_.center); }
  /// Of its outline at rest, where it is now.
  contour::Circle circle_now() const { return {center_now(), rest_.outer_radius, 1.0, 0.0}; }
  /// The holder's direction now; holder needed.
  Eigen::Vector2d holder_direction() const { return motion_.turn(holder_->direction); }

  /// How far tip and membrane are past the resting membrane along the needle's axis, px; needle needed.
  double tip_depth() const;
  double membrane_depth() const noexcept { return membrane_depth_; }
  /// Standard deviations, px: of the contour under the needle; of the resting outline that both depths are taken from.
  double membrane_sigma() const;
  double rest_sigma() const;

  /// How far the cell's sides, across from the needle's line, lie from their resting place: RMS, a shift of the whole
  /// taken off, px; needle needed. Nothing that the needle hides or the contour is tied to is in it. 0 where they lie
  /// elsewhere while nothing touches the cell: they say nothing.
  double side_bulge() const;
  /// How likely the needle is through the membrane by the picture about its tip, 0..1; nothing where it wasn't read.
  std::optional<double> pierced_probability() const noexcept { return pierced_probability_; }

  /// How much deeper the outline is dented than it ever was since the cell was found, as a share of its radius, >= 0.
  double new_dent_ratio() const noexcept { return dent_ - least_dent_; }
  /// By more than noise and a cell's own motion make.
  bool is_dented() const noexcept { return new_dent_ratio() > least_new_dent_ratio(); }

  /// 0..1: as good as the contours were seen, less where they were suddenly seen worse than before.
  double confidence() const;
  /// The same, however vague the needle's tip.
  double membranes_confidence() const;
  /// Until the next start, or until it is taken back: no more confidence than in what one way of seeing alone has
  /// shown.
  /// `is_needle`: the needle too, whose tip the networks are then asked for in contact as well; of a cell whose zona
  /// does not show the needle may be plain to both.
  void doubt(bool is_doubtful, bool is_needle) noexcept {
    is_doubtful_ = is_doubtful;
    is_needle_doubtful_ = is_needle;
  }
  bool is_doubtful() const noexcept { return is_doubtful_; }

 private:
  static constexpr double kDented_ratio = 0.08;  // of the radius
  // A needle seen worse than this may be elsewhere, and with it what the frame says of the contact.
  static constexpr double kPoorNeedle = 0.5;
  NeedleZone zone() const;
  // Of the radius: a dent that counts as one where nothing pushes.
  static constexpr double kUnpushedDent_ratio = 0.06;
  // Of the quality: seen about as well.
  static constexpr double kAsWell_ratio = 0.8;
  // Of the tip's depth: the contour lies on it.
  static constexpr double kOnTip_ratio = 0.85;
  // Through the part of a contour that nothing dents.
  static contour::Circle circle_of(const Eigen::Matrix2Xd& points);
  bool is_cell(const FrameInput& frame, const contour::Circle& circle, double scene_share) const;
  bool is_sized(const FrameInput& frame, const contour::Circle& circle) const;
  static bool refuse(const FrameInput& frame, const contour::Circle& circle);
  contour::Circle resting_circle() const;
  contour::Circle reach_of_cell() const;
  void find_tools_of(const FrameInput& frame, const contour::Circle& circle);
  void find_needle(const FrameInput& frame, const contour::Circle& circle, const std::vector<FoundTool>& tools);
  void settle_facing(const FrameInput& frame, const contour::Circle& circle, const std::vector<FoundTool>& tools);
  static bool start_by_tip(NeedleTracker& needle, const FrameInput& frame, const SceneTool& seen,
                           const Eigen::Vector2d& center);
  static bool start_by_scene(NeedleTracker& needle, const FrameInput& frame, const SceneTool& seen,
                             const Eigen::Vector2d& center);
  std::optional<Eigen::Vector2d> notice_jump(const FrameInput& frame);
  bool is_wall_of_holder(const NeedleEstimate& lines, const SceneReading& scene, const Eigen::Vector2d& center) const;
  bool comes_as_before() const;
  bool is_along_needle(const HolderFit& holder, const Eigen::Vector2d& center) const;
  void read_tip_width(const FrameInput& frame, bool is_clear);
  void begin_command(const FrameInput& frame);
  void compare_with_command(const FrameInput& frame, bool is_seen);
  NeedleCue needle_cue(const FrameInput& frame, const Eigen::Vector2d& shift);
  void follow_needle(const FrameInput& frame, const Eigen::Vector2d& shift);
  Eigen::Vector2d tip_way() const { return needle_.motion() + scene_jump_; }  // px, with the last frame
  void follow_rigid_motion(const FrameInput& frame, const Eigen::Vector2d& jump);
  void follow_contours(const FrameInput& frame, const Eigen::Vector2d& shift);
  bool go_on(const FrameInput& frame, const NeedleZone* needle);
  void read_where_it_was(const FrameInput& frame, const NeedleZone* needle);
  bool read_sprung_back(const FrameInput& frame, const NeedleZone& needle);
  void follow_unpushed(const FrameInput& frame, const NeedleZone* needle);
  void read_unpushed(const FrameInput& frame, const NeedleZone* needle);
  void read_dimples(const FrameInput& frame);
  double oddness() const;
  void mend_dimple(const FrameInput& frame, const NeedleZone& needle);
  SnakeContour dimpled(SnakeContour snake, double reach_px) const;
  void read_boundaries(const FrameInput& frame, const NeedleZone* needle, const Eigen::Vector2d& shift);
  void check_rigid_motion(const FrameInput& frame, const Eigen::Vector2d& center_before, const Eigen::Vector2d& jump);
  void take_dimple();
  void measure_dent();
  double least_new_dent_ratio() const noexcept;
  double inward_px(const Eigen::Vector2d& toward, double from_ratio, double to_ratio) const;
  double flank_depth() const;
  double sides_off_rest() const;
  bool is_shape_pushed() const;
  bool is_pushed() const;
  void read_puncture(const FrameInput& frame);
  bool is_seen_through() const noexcept;
  bool is_seen_pushed() const noexcept;
  void follow_flanks();
  void follow_bulge();
  bool has_deep_flanks() const;
  bool are_flanks_back() const;
  bool are_flanks_pushed() const;
  bool cuts_dimple() const;
  Eigen::Vector2d apex() const;
  double apex_sigma() const;
  void learn_holder_motion(const FrameInput& frame);
  void learn_rest(const FrameInput& frame);
  void read_thickness(const FrameInput& frame);
  double outer_sigma() const;
  Eigen::Vector2d entry_point() const;
  void learn_flank_noise();
  double measure_membrane_depth() const;
  double depth_sigma() const;
  double past_sigma() const;
  double local_score(const SnakeContour& snake) const;
  double local_score() const;
  double whole_score() const;
  double quality_now() const;
  bool keeps_area() const;
  bool plausible() const;
  SnakeContour at_rest(const SnakeContour& like, double radius_px) const;
  bool lies_at_rest(const SnakeContour& outer) const;
  Eigen::Vector2d seat_center() const;
  double seat_way() const;
  double seat_way_sigma() const;
  void find_facing_holder(const FrameInput& frame, const contour::Circle& circle, const std::vector<FoundTool>& tools);
  void find_holder_anew(const FrameInput& frame);
  void check_holder_by_outline(const FrameInput& frame);
  bool take_holder_for_needle(const FrameInput& frame);
  void weigh_walls();
  double outline_sigma() const;
  void follow_seat();
  Eigen::Vector2d place_by_seat();
  void check_walls_by_outline(const FrameInput& frame);
  void check_walls_by_seat(const FrameInput& frame, const Eigen::Vector2d& seat_way, const Eigen::Vector2d& holder_way,
                           const Eigen::Vector2d& jump);
  void begin_watch(const FrameInput& frame, const contour::Circle& circle);
  void watch_facing(const FrameInput& frame);
  void forget_depths();
  void rest_at_first_sight(const contour::Circle& circle);
  void rest_now_at(const Eigen::Vector2d& center);
  bool has_drifted_here() const;
  bool is_drift_nearer_to_walls() const;
  bool may_be_pushed() const;

  TrackerOptions options_;
  MembraneSnakes snakes_;
  SoftZona zona_;
  NeedleTracker needle_;
  RivalTool rival_;                            // what faces the needle, until motion decides
  MembraneBackdrop backdrop_;                  // of the needle's tip, made anew for each frame
  std::optional<Eigen::Vector2d> needle_way_;  // the direction of the needle that was followed last
  GlobalShiftEstimator scene_;
  Eigen::Vector2d scene_jump_ = Eigen::Vector2d::Zero();  // px: of the picture as a whole, with the last frame
  RigidMotion rigid_;
  RigidMove motion_;
  SteadyDrift drift_;
  bool are_walls_seen_ = false;  // the holder was followed in this frame
  double walls_slip_ = 0.0;      // px, of late, along the pipette, from an untouched cell's outline
  double place_sigma_ = 0.0;     // px, of the shift, along the holder
  double walls_slid_px2_ = 0.0;  // of late, how far the walls have slid, squared
  Eigen::Vector2d beside_walls_ = Eigen::Vector2d::Zero();  // px: the cell is so far from where the walls alone put it
  Eigen::Vector2d seat_ = Eigen::Vector2d::Zero();  // centre of the circle through the part that stays where it is
  RestGeometry rest_;
  ContactLogic contact_;
  std::optional<HolderFit> holder_;
  std::optional<RestGeometry> unpressed_;  // without a needle: before the holder pressed, if it does
  SnakeContour outer_before_, inner_before_;
  double detection_score_ = 0.0, quality_ = 0.0, usual_quality_ = 0.0, first_quality_ = 0.0, membrane_depth_ = 0.0;
  double deepest_flank_ = 0.0, tip_at_deepest_flank_ = 0.0;  // px, of late
  double flank_before_ = 0.0, flank_noise_ = 0.0;            // px, of a cell that nothing pushes: from frame to frame
  double resting_bulge_ = 0.0;                               // px, of the sides of a cell that nothing pushes
  double largest_bulge_ = 0.0, tip_at_largest_bulge_ = 0.0;  // likewise, of the sides
  std::optional<double> pierced_probability_;                // in this frame
  double dent_ = 0.0, least_dent_ = 0.0;                     // of the radius
  double dent_noise_ratio_ = 0.0;  // of an undented cell without a needle: from frame to frame, of late
  bool touching_ = false;
  bool is_doubtful_ = false, is_needle_doubtful_ = false;
  bool walls_slide_ = false;  // the holder's, along themselves
  bool is_read_ = false;      // membranes and tip are read by networks, not followed by what they look like
  int bad_frames_ = 0, poor_frames_ = 0, astray_frames_ = 0, times_astray_ = 0, frames_followed_ = 0;
  double moved_by_reading_px_ = 0.0;  // the outer contour, RMS, by the last one
  int frames_since_reading_ = 0;      // of the boundaries
  int unseen_frames_ = 0;             // without a needle
  int pressed_frames_ = 0;            // by what was taken for the holder
};

}  // namespace pellucida
