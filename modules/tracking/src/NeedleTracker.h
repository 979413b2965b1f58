#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>

#include "CommandedMotion.h"
#include "ContourMath.h"
#include "FrameSampler.h"
#include "MembraneSnakes.h"
#include "NeedleModel.h"
#include "NeedleStart.h"
#include "ShaftFit.h"
#include "ShaftMotion.h"
#include "TipFinder.h"
#include "TipFollower.h"
#include "TipNetwork.h"
#include "TipWidthNetwork.h"
#include "ToolFinder.h"
#include "pellucida/core/Observation.h"

namespace pellucida {

/// The needle in px: a cone with a round tip or one cut off.
struct NeedleEstimate {
  Eigen::Vector2d tip = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< shaft to tip
  double tip_half_width = 2.0;    ///< as its edges are followed, for what has to keep away from them
  double tip_radius = 2.0;        ///< half its width at the tip, as geometry
  double tip_radius_sigma = 0.0;  ///< standard deviation of its logarithm; 0: as edges show it
  double widening = 0.0;          ///< half width gained per px behind the tip
  double edge_blur = 0.0;  ///< px, standard deviation: how far its edges' own darkness reaches beyond its outline
  double confidence = 0.0;
  double tip_sigma = 0.0;    ///< px along the direction
  bool is_disputed = false;  ///< its end and its width have the tip in different places
  NeedleEvidence evidence = kNoNeedleEvidence;
};

/// What is known of a frame before its needle is looked for.
struct NeedleCue {
  double reach_px = 34.0;                    ///< how far the tip may be from where it is expected
  bool in_the_clear = false;                 ///< nothing touches or covers the tip, so its cone may be learnt
  const CommandedMotion* command = nullptr;  ///< where the tip was sent; null: no manipulator says
  Eigen::Vector2d scene_jump_px = Eigen::Vector2d::Zero();  ///< the whole picture jumped by about this
  /// A body ahead that must not be confused with a needle far out of focus: where that ends is looked for in front of
  /// the body, and not at all where little room is left.
  std::optional<contour::Circle> body;
  MembraneBackdrop* membrane = nullptr;  ///< what the tip is seen against; null: plain medium
  double depth_px = 0.0;                 ///< how far the tip was past the resting membrane
  bool is_free = false;                  ///< nothing is touched
  double covered_px = 0.0;               ///< so far behind the tip the cell reaches
  bool is_quick = false;                 ///< the small tip network may read frames between those of the large ones
};

/// Follows the injection needle. Across, by the learnt look of the shaft (ShaftFit). Along, by a Kalman filter of place
/// and speed that weighs what each frame says, each with its own variance: the place where the edges end (TipFinder),
/// the shaft's width on the cone learnt in the clear, the motion commanded, the membrane's apex (take_dimple).
/// `track` allocates only while the needle is learnt.
class NeedleTracker {
 public:
  /// Looks for the tip along a tool found by voting, near `expected` where other evidence says where it is. False when
  /// the tool's edges can't be followed, or end elsewhere.
  bool start(const FrameSampler& image, const FoundTool& tool, double noise, const ExpectedTip* expected = nullptr);

  /// Looks for a needle anywhere in an image, with no cell to go by: of the tools that lines alone suggest, the longest
  /// and darkest. `gray` is the same image. For now and then, not for every frame: about 20 ms.
  bool start_anywhere(const FrameSampler& image, const GrayImage& gray, double noise);

  /// Follows it from the last frame. False when it isn't seen.
  bool track(const FrameSampler& image, double noise, const NeedleCue& cue);

  /// This frame's contour says that the membrane's apex, which rests on the tip, is at `apex` (px, standard deviation
  /// `sigma_px` along the needle): one more piece of evidence for the tip. For frames in contact only.
  void take_dimple(const Eigen::Vector2d& apex, double sigma_px);

  /// The tip rests on the membrane's apex at `apex` (px, standard deviation `sigma_px`), wherever it was taken to be: a
  /// needle far out of focus is known no better than by what it begins to push.
  void rest_on(const Eigen::Vector2d& apex, double sigma_px);

  /// The tip is where it was sent, so far ahead of where this frame has it: it wasn't seen, or misread.
  void hold(const CommandedMotion::Along& due);

  /// Half its width as a whole picture shows it, px: what scales the networks' looks at its tip.
  void expect_half_width(double half_width_px) noexcept { scene_half_width_ = half_width_px; }

  /// Reads the tip's place, moves the tip by `share` of the way to it, and learns how far from the tip its edges end,
  /// as a bevel's or a spike's end earlier, and how far beside the axis it lies. False, and nothing happens, where the
  /// network isn't sure.
  /// `cue` (may be null) says where its shaft is seen, which is then held against the reading.
  bool read_tip(TipNetwork& network, const FrameSampler& image, double share, const NeedleCue* cue = nullptr);

  /// The same for a needle found just now, which may end anywhere along it up to beside `last`, px.
  bool find_tip(TipNetwork& network, const FrameSampler& image, const Eigen::Vector2d& last);

  /// The same for a needle in contact, whose tip a membrane that springs back seems to take along: where the shaft has
  /// not gone back with it, such a reading is doubted until it lasts. `command` (may be null) doubts it longer, and by
  /// less.
  bool read_tip_in_contact(TipNetwork& network, const FrameSampler& image, const NeedleCue& cue,
                           const CommandedMotion* command);
  /// Takes this frame's doubted reading after all: the membrane has not sprung back. Nothing happens without one.
  void believe_reading();

  /// Where a network reads the tip at the side of the needle's end, as a bevel's is, it is taken over. For needles that
  /// are followed by lines, while nothing hides the tip. False, and nothing happens, where it is not so.
  bool take_bevel(TipNetwork& network, const FrameSampler& image);

  /// Where a network reads the tip of a needle whose shaft is followed; nothing where it isn't sure, and nothing else
  /// happens.
  std::optional<Eigen::Vector2d> tip_read(TipNetwork& network, const FrameSampler& image) const;

  /// Reads how wide the needle is at its tip: the mean of the first readings, which all share what a look makes wrong.
  /// Where the edges followed agree with it they are the more precise. Nothing happens once it was read often enough.
  void read_width(TipWidthNetwork& network, const FrameSampler& image);
  bool is_width_read() const noexcept { return width_readings_ > 0; }

  /// Whether that is where lines have it; also where the network isn't sure, or no needle is followed.
  bool is_where_read(TipNetwork& network, const FrameSampler& image) const;

  /// Begins with a needle whose shaft can't be followed, by its tip alone: about `axis`, `half_width_px` wide some way
  /// behind the tip. False where the network isn't sure.
  bool start_read(TipNetwork& network, const FrameSampler& image, const NeedleAxis& axis, double half_width_px);
  /// Follows such a needle; its direction stays. False when its tip isn't seen.
  bool follow_read(TipNetwork& network, const FrameSampler& image, const NeedleCue& cue);
  /// From now on by its tip alone: its shaft can't be followed any more. False, and nothing happens, where the network
  /// isn't sure.
  bool go_on_read(TipNetwork& network, const FrameSampler& image);
  /// Whether it is known by its tip alone.
  bool is_read() const noexcept { return read_half_width_ > 0.0; }

  const NeedleEstimate& estimate() const noexcept { return now_; }
  /// Its lines are alike on both their sides and on both sides of it: drawn where its edges are, not what optics make
  /// of them.
  bool is_even() const;
  /// Seen well, or, a faint one, about as well as of late: one lifted out of focus fades, and lets a membrane go
  /// slowly.
  bool is_clear() const noexcept;
  bool valid() const noexcept { return valid_; }
  void reset() noexcept { *this = NeedleTracker(); }
  /// How far the tip moved with the last frame, beyond a jump of the whole scene.
  Eigen::Vector2d motion() const noexcept { return motion_; }

 private:
  static constexpr std::size_t kEnds = 3;
  static constexpr double kEndFloor = 0.08;  // units: error of the end's place in the clear that noise does not explain
  // A measurement of how much further ahead the tip is, px.
  struct Along {
    bool valid = false;
    double ahead = 0.0, variance = 0.0;
  };
  bool start(const FrameSampler& image, NeedleGuess guess, double noise);
  void prepare();
  void set_zero();
  bool is_end_plain() const;
  void learn_end(const FrameSampler& image, double noise, const ShaftResult& shaft);
  std::optional<TipReading> best_reading(TipNetwork& network, const FrameSampler& image, bool is_quick, double& share);
  void take(const TipReading& seen, double share);
  TipReading beside_shaft(const FrameSampler& image, const TipReading& read, const NeedleCue& cue);
  // How far across the needle a reading has leapt from where it is due; 0: it hasn't.
  double leap_across_px(const Eigen::Vector2d& read, const Eigen::Vector2d& due) const;
  Eigen::Vector2d tip() const;
  double again_px() const;
  double width_behind(const FrameSampler& image) const;
  void take_width();
  ShaftResult align(const FrameSampler& image, double noise, int rounds);
  Along find_end(const FrameSampler& image, double noise, const ShaftResult& shaft, double reach_px,
                 const NeedleCue& cue);
  bool fuse(const Along& end, const Along& cone, bool clear, bool is_sent, NeedleEvidence& evidence);
  void update(double ahead, double variance);
  void learn(double end_ahead);
  void fill(double noise, const ShaftResult& shaft);
  double confidence() const;
  void learn_confidence();

  NeedleEstimate now_;
  NeedleAxis axis_, axis_before_;
  Eigen::Vector2d due_ = Eigen::Vector2d::Zero();  // where this frame's tip was expected
  NeedleModel model_;
  ShaftFit shaft_;
  TipFinder tip_;
  Eigen::Vector2d motion_ = Eigen::Vector2d::Zero();
  // Along the needle: place (relative to axis_.tip) and speed (px a frame), and their covariance.
  double ahead_ = 0.0, speed_ = 0.0;
  Eigen::Matrix2d covariance_ = Eigen::Matrix2d::Zero();
  double unrest_ = 1.0;  // px: how much the speed has been changing from frame to frame
  // Of each roundness tried: the mean logarithm of what it leaves unexplained, over that of a half ball.
  std::array<double, kEnds> end_misfits_{};
  int end_frames_ = 0;             // that this was learnt from
  std::size_t end_ = 0;            // the one that fits best
  double anchor_sigma_ = 1.0;      // px: how well the cone's place on the needle is known
  double clarity_ = 0.0;           // 0..1: how well its shaft is seen
  double usual_confidence_ = 0.0;  // of late
  double beside_ = 0.0;            // px: the tip lies so far beside the axis, as a bevel's does
  double read_half_width_ = 0.0;   // px; above 0: no shaft is followed
  double scene_half_width_ = 0.0;  // px; 0: no scene was seen
  double end_bias_ = 0.0;          // px: the tip lies so much further ahead than its edges end
  int frames_since_learning_ = 0;
  // Of the readings of its width: sums of 1 / sigma^2 and of logarithm / sigma^2, and how many.
  double width_information_ = 0.0, width_log_sum_ = 0.0;
  int width_readings_ = 0;
  int leaps_ = 0, read_frames_ = 0;  // of a tip known by readings alone: leaps in a row, frames followed
  bool is_across_known_ = false;     // likewise: where it lies across the needle
  TipFollower tip_follower_;         // of a needle that networks read
  ShaftMotion shaft_motion_;         // likewise
  int misreadings_ = 0;              // by that, in a row
  bool is_by_shaft_ = false;         // where the tip was last read
  int sprung_readings_ = 0;          // in a row, not believed
  std::optional<TipReading> doubted_;
  bool clear_seen_ = false;
  bool valid_ = false;
};

}  // namespace pellucida
