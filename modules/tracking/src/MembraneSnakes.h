#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "BoundaryMotion.h"
#include "BoundaryNetwork.h"
#include "CellDetector.h"
#include "EdgeTemplate.h"
#include "FrameSampler.h"
#include "MembraneBackdrop.h"
#include "NeedleZone.h"
#include "NormalStrip.h"
#include "Snake.h"
#include "pellucida/tracking/TrackerOptions.h"

namespace pellucida {

/// Times the rigidity, for a faint step that single normals see badly.
inline constexpr double kSoftRigidity = 20.0;
/// Of the predicted shape's own bending that the snake resists.
inline constexpr double kShapeShare = 0.1;
/// px beside a pushing tip over which the membrane goes with it: standard deviation of a bell.
inline double wrapped_px(double tip_half_width_px) noexcept {
  return 3.0 * tip_half_width_px + 8.0;
}

/// One snake: contour, what its edge looks like, and how well it was seen.
struct SnakeContour {
  Eigen::Matrix2Xd points;  ///< px, closed, positive area; empty when there is none
  EdgeKind kind;
  double scale_px = 1.3;
  double strength = 0.0;          ///< learnt median feature along the edge
  double center_offset_px = 0.0;  ///< learnt: from the filter's peak to the line's own centre, outwards
  double agreement = 0.0;         ///< 0..1: how alike the profiles across the edge are all round the contour
  Eigen::VectorXd sigma_px;       ///< (n)
  Eigen::VectorXd confidence;     ///< (n) 0..1
  double score = 0.0;             ///< mean confidence where no needle covers the edge

  bool is_soft() const noexcept { return kind.step != 0.0; }
};

/// The pair of coupled snakes.
class MembraneSnakes {
 public:
  explicit MembraneSnakes(const TrackerOptions& options) : options_(options) {}

  /// Starts from a detection, and learns the edges' look on `image`. False when the edges found do not look like a
  /// membrane's.
  bool start(const FrameSampler& image, const DetectedCell& cell, double noise, const NeedleZone* needle);

  /// Starts from a rough outline (2 x n, px, closed), whatever the edges look like, and is read from then on (`read`)
  /// instead of followed. `share` 0..1: how sure it is that this is a cell. False when the network sees no boundary:
  /// when its score about what it ends on is below `least_score`.
  bool start(const FrameSampler& image, BoundaryNetwork& network, const Eigen::Matrix2Xd& outline, double share,
             const NeedleZone* needle, double least_score = kLeastAtFirst);
  /// Set on 229 pictures of tuning and wide families: 0.84 and more in 95 % of the contours that ended on the boundary,
  /// 0.58 at most beside a cell.
  static constexpr double kLeastAtFirst = 0.76;

  /// Moves the contours with the cell by `shift`, and near the needle's tip by `push`, the needle's own motion.
  void predict(const Eigen::Vector2d& shift, const Eigen::Vector2d& push, const NeedleZone* needle);

  /// Finds both contours in a band of `search_px` round the last ones, moved by `shift` (and with `push`, the needle's
  /// own motion, near its tip). Returns the outer contour's score.
  double track(const FrameSampler& image, double noise, const Eigen::Vector2d& shift, const Eigen::Vector2d& push,
               const NeedleZone* needle, double search_px);

  /// Moves both contours onto the boundaries that a network reads along their normals, in so many `rounds`, whatever
  /// they look like; near the needle the membrane's rules hold. Returns the outer contour's score. Allocates.
  double read(const FrameSampler& image, BoundaryNetwork& network, const NeedleZone* needle, int rounds);

  /// How far the last round of a reading has moved the outer contour, px, RMS.
  double moved_px() const noexcept { return moved_px_; }
  /// What was read in this frame counts: the next ones are held against it (`go_on`).
  void keep_reading(const FrameSampler& image);
  /// Moves both contours, from where `predict` has put them, to where what was read last has gone since. Where that is
  /// unlike what is seen now, nothing happens.
  bool go_on(const FrameSampler& image, double noise, const NeedleZone* needle);

  const SnakeContour& outer() const noexcept { return outer_; }
  const SnakeContour& inner() const noexcept { return inner_; }
  bool has_inner() const noexcept { return inner_.points.cols() > 0; }
  /// 0..1: how sure it was at the start that this is a cell.
  double sureness() const noexcept { return sureness_; }
  double thickness_px() const noexcept { return thickness_; }
  /// Half width of the outer membrane's line as learnt; 0 before.
  double line_width_px() const noexcept {
    return outer_look_.edge.valid() ? outer_look_.edge.width() * outer_look_.step_px : 0.0;
  }

  /// The outer membrane's line about `tip`, as MembraneBackdrop::set has it; empty before that is learnt.
  void show_behind(const Eigen::Vector2d& tip, const Eigen::Vector2d& shift, double wrapped_px,
                   MembraneBackdrop& backdrop) const {
    backdrop.set(outer_.points, outer_look_.edge, outer_look_.step_px, tip, shift, wrapped_px);
  }

  /// As EdgeTemplate::asymmetry, of the outer membrane's line; 1 before it is learnt.
  double asymmetry() const noexcept { return outer_look_.edge.valid() ? outer_look_.edge.asymmetry() : 1.0; }

  /// Puts back contours kept from before (after a try that failed).
  void restore(const SnakeContour& outer, const SnakeContour& inner) {
    outer_ = outer;
    inner_ = inner;
  }

 private:
  // What a membrane looks like, and how finely it is sampled along the normals.
  struct Look {
    EdgeTemplate edge;
    double step_px = 0.5;
    double usual_score = 0.0;
    double loose_ratio = 0.0;  ///< share of the last round's edges not found within reach
    int poor_run = 0;          ///< longest run of points that hardly show the look, in the last round
    double usual_poor_run = 0.0;
  };

  // First sight (MembraneStart.cpp).
  void settle(const FrameSampler& image, double noise, SnakeContour& snake, const NeedleZone* needle);
  void rough_round(const FrameSampler& image, double noise, SnakeContour& snake, const NeedleZone* needle,
                   double reach_px);
  void learn_strength(const FrameSampler& image, SnakeContour& snake, const NeedleZone* needle);
  void learn_looks(const FrameSampler& image, double noise, const NeedleZone* needle);
  void measure_gaps();
  bool is_on_another_line();
  void learn_thickness(const NeedleZone* needle, double share);

  // Each frame.
  void search(const FrameSampler& image, const NeedleZone* needle, double search_px);
  bool follow(const FrameSampler& image, double noise, const NeedleZone* needle, bool give_up_early);
  double fine_round(const FrameSampler& image, double noise, bool is_outer, const NeedleZone* needle);
  void localise(const FrameSampler& image, double noise, bool is_outer, const NeedleZone* needle);
  void use_thickness(const NeedleZone* needle);
  void use_needle(SnakeContour& snake, bool is_outer, const NeedleZone& needle);
  void distrust_bumps(double radius_px, const NeedleZone* needle);
  void relax_on(const BoundaryPlaces& places, bool is_outer, double radius_px, const NeedleZone* needle,
                SnakeContour& snake);
  static bool hides(const Look& look);
  bool trustworthy(const SnakeContour& snake, const Look& look) const;
  bool learn_look(const FrameSampler& image, const SnakeContour& snake, Look& look, const NeedleZone* needle,
                  double share);
  void sample_profiles(const FrameSampler& image, const Eigen::Matrix2Xd& points, double step_px, int samples,
                       int smoothing);

  TrackerOptions options_;
  SnakeContour outer_, inner_;
  Look outer_look_, inner_look_;
  BoundaryMotion outer_motion_, inner_motion_;
  Eigen::VectorXd outer_read_sigma_px_, inner_read_sigma_px_;
  double moved_px_ = 0.0;
  double sureness_ = 0.0;
  double thickness_ = 0.0;        ///< median distance between the two, px
  double thickness_sigma_ = 0.0;  ///< how far single places differ from it, px
  long frames_ = 0;
  int vain_frames_ = 0;  // left, of those after a search in vain

  // Scratch, kept from frame to frame.
  Snake snake_;
  PathSearch path_search_;
  NormalStrip strip_;
  Eigen::MatrixXf feature_, reward_outer_, reward_inner_;
  std::vector<float> profiles_, smoothed_;
  Eigen::Matrix2Xd normals_, even_, outer_predicted_, outer_kept_, inner_kept_;
  Eigen::VectorXd edges_, sigmas_, rigidity_, shape_share_, gaps_;
  std::vector<Eigen::Index> gap_places_;
  std::vector<double> sorted_;
};

}  // namespace pellucida
