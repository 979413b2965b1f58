#include "pellucida/tracking/MembraneTracker.h"

#include <cmath>
#include <string>

#include "CellDetector.h"
#include "ContactLogic.h"
#include "FrameSampler.h"
#include "GrayImage.h"
#include "MembraneSnakes.h"
#include "NeedleTracker.h"
#include "RestGeometry.h"
#include "RigidMotion.h"
#include "ToolFinder.h"
#include "pellucida/core/Error.h"
#include "pellucida/tracking/ContourMath.h"

namespace pellucida {
namespace {

// The share of the tip in the indentation; the rest is the contour, which rounds a steep dimple a little.
constexpr double kTipShare = 0.8;

void require(bool holds, const char* name, const char* range, double value) {
  if (!holds)
    throw UsageError(std::string("tracker option ") + name + " is " + std::to_string(value) + "; give a value " +
                     range);
}

void check(const TrackerOptions& o) {
  require(o.min_cell_diameter_px >= 16.0, "min_cell_diameter_px", "of 16 or more", o.min_cell_diameter_px);
  require(o.max_cell_diameter_px > o.min_cell_diameter_px, "max_cell_diameter_px", "above min_cell_diameter_px",
          o.max_cell_diameter_px);
  require(o.contour_point_count >= 64 && o.contour_point_count <= 512, "contour_point_count", "in 64..512",
          o.contour_point_count);
  require(o.edge_scale_px >= 0.5 && o.edge_scale_px <= 10.0, "edge_scale_px", "in 0.5..10", o.edge_scale_px);
  require(o.search_px >= 1.0 && o.search_px <= 100.0, "search_px", "in 1..100", o.search_px);
  require(o.wide_search_px >= o.search_px && o.wide_search_px <= 200.0, "wide_search_px", "in search_px..200",
          o.wide_search_px);
  require(o.snake_iterations >= 1 && o.snake_iterations <= 50, "snake_iterations", "in 1..50", o.snake_iterations);
  require(o.elasticity >= 0.0 && o.rigidity >= 0.0 && o.tip_rigidity > 0.0 && o.tip_rigidity <= o.rigidity,
          "tip_rigidity", "above 0 and not above rigidity", o.tip_rigidity);
  require(o.redetect_interval_frames >= 1, "redetect_interval_frames", "of 1 or more", o.redetect_interval_frames);
}

void check(const ImageView& image) {
  if (image.data == nullptr) throw UsageError("tracker: the image has no pixels");
  if (image.width_px < 1 || image.height_px < 1)
    throw UsageError("tracker: the image is " + std::to_string(image.width_px) + " x " +
                     std::to_string(image.height_px) + " px; both must be 1 or more");
  const std::ptrdiff_t pixel_bytes = image.format == PixelFormat::kGray16 ? 2 : 1;
  if (image.row_bytes < image.width_px * pixel_bytes)
    throw UsageError("tracker: the image's rows have " + std::to_string(image.row_bytes) + " bytes; " +
                     std::to_string(image.width_px * pixel_bytes) + " are needed");
  if (!(image.pixel_size_um > 0.0) || !std::isfinite(image.pixel_size_um))
    throw UsageError("tracker: the pixel size is " + std::to_string(image.pixel_size_um) + " um; give one above 0");
}

}  // namespace

class MembraneTracker::Impl {
 public:
  explicit Impl(const TrackerOptions& options) : options_(options), snakes_(options), contact_(options) {}

  Observation process(const ImageView& view, double time_s, long frame_index) {
    check(view);
    view_ = view;
    image_ = FrameSampler(view);
    noise_ = noise_level(image_);
    ++frames_since_detection_;
    if (!has_cell_) {
      if (frames_since_detection_ >= options_.redetect_interval_frames) detect();
    } else {
      follow();
    }
    return report(view.pixel_size_um, time_s, frame_index);
  }

  const TrackerOptions& options() const noexcept { return options_; }

 private:
  struct Holder {
    bool valid = false;
    Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
    double offset = 0.0;
    double half_width = 0.0;
    double confidence = 0.0;
  };

  NeedleZone zone() const {
    const NeedleEstimate& n = needle_.estimate();
    return {n.tip, n.direction, n.tip_half_width, n.widening, touching_};
  }

  // Finds cell and tools with no hint from before.
  void detect() {
    frames_since_detection_ = 0;
    const GrayImage whole = gray();
    const std::optional<DetectedCell> cell = detect_cell(whole, options_);
    if (!cell) return;
    touching_ = false;
    needle_.reset();
    find_tools_of(cell->circle);
    const NeedleZone needle_zone = zone();
    if (!snakes_.start(image_, *cell, noise_, needle_.valid() ? &needle_zone : nullptr)) return;
    detection_score_ = std::min(1.0, snakes_.sureness() / 0.6);
    ever_ = has_cell_ = true;
    bad_frames_ = 0;
    score_ = snakes_.outer().score;

    // The rest shape as far as this one frame shows it: the circle through the undeformed part.
    const contour::Circle circle = fit(snakes_.outer().points);
    rest_ = {};
    rest_.center = circle.center;
    rest_.outer_radius = circle.radius;
    rest_.inner_radius = snakes_.has_inner() ? fit(snakes_.inner().points).radius : 0.0;
    rigid_shift_.setZero();
    learn_holder_motion();
    membrane_depth_ = measure_membrane_depth();
    const bool entered = needle_.valid() && tip_depth() > 2.0 * options_.contact_px;
    const bool through = entered && tip_depth() > 8.0 * options_.contact_px && membrane_depth_ < 0.5 * tip_depth();
    contact_.reset(!entered ? CellState::kFree : through ? CellState::kPunctured : CellState::kContact);
    touching_ = entered && !through;
    if (!entered) learn_rest();
    quality_ = usual_quality_ = first_quality_ = quality_now();
    poor_frames_ = 0;
  }

  // The whole image in floating point: for searches, not for following.
  GrayImage gray() const {
    GrayImage whole;
    load(view_, whole);
    return whole;
  }

  static contour::Circle fit(const Eigen::Matrix2Xd& points) {
    contour::Circle circle = contour::fit_circle(points, 3.0);
    return circle;
  }

  void find_tools_of(const contour::Circle& circle) {
    holder_.valid = false;
    std::vector<FoundTool> tools = find_tools(gray(), circle);
    // The holder is broad, the needle narrow.
    for (const FoundTool& tool : tools) {
      if (tool.half_width() < 0.2 * circle.radius) continue;
      holder_ = {true, tool.direction, tool.offset(), tool.half_width(),
                 std::clamp(tool.strength / (3.0 * circle.radius), 0.0, 1.0)};
      break;
    }
    find_needle(circle, tools);
  }

  void find_needle(const contour::Circle& circle, const std::vector<FoundTool>& tools) {
    for (const FoundTool& tool : tools) {
      if (tool.half_width() >= 0.2 * circle.radius) continue;
      if (holder_.valid && tool.direction.dot(holder_.direction) > 0.8) continue;
      if (needle_.start(image_, tool, circle, noise_)) return;
    }
    needle_.reset();
  }

  // The pixels of the holder, outside the cell: what tells the cell's rigid motion. Its rim is what shows a motion
  // along the pipette, so the pixels go close to the membrane and not far up the shaft.
  void learn_holder_motion() {
    rigid_.reset();
    if (!holder_.valid) return;
    const Eigen::Vector2d across(-holder_.direction.y(), holder_.direction.x());
    std::vector<Eigen::Vector2d> points;
    const double half = holder_.half_width + 6.0;
    for (double s = 0.7 * rest_.outer_radius; s < 1.6 * rest_.outer_radius; s += 1.0) {
      for (double v = holder_.offset - half; v <= holder_.offset + half; v += 1.0) {
        if (std::hypot(s, v) < rest_.outer_radius + 3.0) continue;
        points.push_back(rest_.center + s * holder_.direction + v * across);
      }
    }
    rigid_.learn(image_, points, noise_);
  }

  Eigen::Vector2d center_now() const { return rest_.center + rigid_shift_; }

  // How far the tip is past the resting membrane, px.
  double tip_depth() const {
    const NeedleEstimate& n = needle_.estimate();
    return (n.tip - rest_.entry_point(center_now(), n.tip, n.direction)).dot(n.direction);
  }

  double measure_membrane_depth() const {
    if (!needle_.valid()) return 0.0;
    const NeedleEstimate& n = needle_.estimate();
    const Eigen::Vector2d entry = rest_.entry_point(center_now(), n.tip, n.direction);
    return first_crossing(snakes_.outer().points, entry, n.direction, 0.0);
  }

  void learn_rest() {
    const contour::Circle outer = fit(snakes_.outer().points);
    if (outer.inlier_ratio < 0.6) return;
    rest_.learn(outer.center - rigid_shift_, outer.radius,
                snakes_.has_inner() ? fit(snakes_.inner().points).radius : 0.0);
  }

  // Mean confidence of the outer contour on the needle's side, where a dimple is or is not.
  double local_score() const {
    if (!needle_.valid()) return snakes_.outer().score;
    const NeedleZone needle_zone = zone();
    double sum = 0.0, count = 0.0;
    const SnakeContour& outer = snakes_.outer();
    for (Eigen::Index i = 0; i < outer.points.cols(); ++i) {
      const Eigen::Vector2d d = outer.points.col(i) - needle_zone.tip;
      const double across = std::abs(needle_zone.direction.x() * d.y() - needle_zone.direction.y() * d.x());
      if (across > 0.45 * rest_.outer_radius || d.dot(needle_zone.direction) > 0.8 * rest_.outer_radius) continue;
      if (needle_zone.covers(outer.points.col(i), 2.0)) continue;
      sum += outer.confidence[i];
      count += 1.0;
    }
    return count > 3.0 ? sum / count : snakes_.outer().score;
  }

  // The weakest of what was seen: the whole outer contour, the inner one, and the outer one on the needle's side.
  double quality_now() const {
    const double both =
        snakes_.has_inner() ? std::min(snakes_.outer().score, snakes_.inner().score) : snakes_.outer().score;
    return std::min(both, local_score());
  }

  void follow() {
    // The needle.
    if (needle_.valid()) {
      const bool clear = contact_.state() == CellState::kFree && tip_depth() < -6.0;
      if (!needle_.track(image_, noise_, {34.0, clear, {}}) && needle_.estimate().confidence < 0.1) needle_.reset();
    } else if (frames_since_detection_ % 3 == 0 || frames_since_detection_ < 10) {
      find_needle({center_now(), rest_.outer_radius, 1.0, 0.0},
                  find_tools(gray(), {center_now(), rest_.outer_radius, 1.0, 0.0}));
    }
    // Rigid motion of the whole: by the holder where there is one, else later by the far side.
    const Eigen::Vector2d shift_before = rigid_shift_;
    if (rigid_.valid() && rigid_.track(image_, 38.0, needle_.valid() ? needle_.motion() : Eigen::Vector2d::Zero()))
      rigid_shift_ = rigid_.motion();
    const Eigen::Vector2d shift = rigid_shift_ - shift_before;

    const bool punctured = contact_.state() == CellState::kPunctured;
    touching_ = needle_.valid() && !punctured && tip_depth() > 0.5;
    const NeedleZone needle_zone = zone();
    const NeedleZone* known = needle_.valid() ? &needle_zone : nullptr;

    // Contours: the narrow band first; where that fails, wider, and with the membrane sprung back.
    const SnakeContour outer_before = snakes_.outer(), inner_before = snakes_.inner();
    snakes_.track(image_, noise_, shift, needle_.motion(), known, options_.search_px);
    double quality = quality_now();
    if (quality < std::max(0.6, 0.88 * usual_quality_)) {
      SnakeContour best_outer = snakes_.outer(), best_inner = snakes_.inner();
      const auto attempt = [&](const NeedleZone* with, bool from_rest, double reach) {
        snakes_.restore(outer_before, inner_before);
        if (from_rest)
          snakes_.restore(at_rest(outer_before, rest_.outer_radius), at_rest(inner_before, rest_.inner_radius));
        snakes_.track(image_, noise_, from_rest ? Eigen::Vector2d::Zero() : shift, needle_.motion(), with, reach);
        const double now = quality_now();
        if (now > quality + 0.05) {
          quality = now;
          best_outer = snakes_.outer();
          best_inner = snakes_.inner();
        }
      };
      attempt(known, false, options_.wide_search_px);
      NeedleZone loose = needle_zone;
      loose.touching = false;
      if (known && touching_) {
        attempt(&loose, false, options_.wide_search_px);
        attempt(&loose, true, 2.0 * options_.search_px);
        attempt(&loose, true, options_.wide_search_px);
      } else {
        attempt(known, true, options_.wide_search_px);
      }
      snakes_.restore(best_outer, best_inner);
    }
    quality_ = quality;
    score_ = snakes_.outer().score;
    const bool good = score_ >= options_.min_tracking_score && plausible();
    bad_frames_ = good ? 0 : bad_frames_ + 1;
    if (!good) {
      snakes_.restore(outer_before, inner_before);
      if (bad_frames_ >= options_.lost_after_frames) start_afresh();
      return;
    }

    usual_quality_ += 0.1 * (quality_ - usual_quality_);
    // Far worse than when the cell was found, frame after frame: something else is followed. Look afresh.
    poor_frames_ = quality_ < 0.55 * first_quality_ ? poor_frames_ + 1 : 0;
    if (poor_frames_ >= 2 * options_.lost_after_frames) return start_afresh();

    // Without a holder the side away from the needle tells the rigid motion.
    if (!rigid_.valid()) rigid_shift_ = far_side_center() - rest_.center;
    membrane_depth_ = measure_membrane_depth();
    contact_.update({needle_.valid() ? tip_depth() : -1e3, membrane_depth_, needle_.valid()});
    const bool away = !needle_.valid() || tip_depth() < -2.0;
    if (contact_.state() == CellState::kFree && away) learn_rest();
  }

  // The cell is lost; perhaps it is somewhere else.
  void start_afresh() {
    has_cell_ = false;
    needle_.reset();
    frames_since_detection_ = options_.redetect_interval_frames;
    detect();
  }

  SnakeContour at_rest(const SnakeContour& like, double radius) const {
    SnakeContour result = like;
    if (like.points.cols() == 0 || radius <= 0.0) return result;
    const Eigen::Index n = like.points.cols();
    for (Eigen::Index i = 0; i < n; ++i) {
      const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(n);
      result.points.col(i) = center_now() + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    return result;
  }

  // Centre of the resting circle through the part of the contour away from the needle, radius fixed.
  Eigen::Vector2d far_side_center() const {
    Eigen::Vector2d center = center_now();
    const Eigen::Vector2d away = needle_.valid() ? needle_.estimate().direction : Eigen::Vector2d::Zero();
    for (int round = 0; round < 10; ++round) {
      Eigen::Matrix2d normal = 1e-6 * Eigen::Matrix2d::Identity();
      Eigen::Vector2d right = Eigen::Vector2d::Zero();
      const Eigen::Matrix2Xd& points = snakes_.outer().points;
      for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Eigen::Vector2d d = points.col(i) - center;
        const Eigen::Vector2d n = d.normalized();
        if (contact_.state() != CellState::kFree && n.dot(away) < 0.2) continue;
        const double off = d.norm() - rest_.outer_radius;
        const double w = 1.0 / (1.0 + off * off / 4.0);
        normal += w * n * n.transpose();
        right += w * off * n;
      }
      center += normal.inverse() * right;
    }
    return center;
  }

  // A contour that encloses far too little or too much, or crosses itself, is none.
  bool plausible() const {
    const Eigen::Matrix2Xd& points = snakes_.outer().points;
    const double area = contour::signed_area(points), rest = M_PI * rest_.outer_radius * rest_.outer_radius;
    return area > 0.5 * rest && area < 1.4 * rest && !contour::self_intersects(points);
  }

  MembraneContour membrane(const SnakeContour& snake, Membrane which, const Eigen::Vector2d& start_direction,
                           double pixel_size_um) const {
    // Begin where the ray from the centre towards the needle crosses; carry sigma and confidence along.
    const Eigen::Index n = snake.points.cols();
    const double arc = std::max(0.0, contour::ray_crossing_arc(snake.points, center_now(), start_direction));
    MembraneContour result;
    result.membrane = which;
    result.points_um = contour::resample(snake.points, n, arc) * pixel_size_um;
    result.sigma_um.resize(n);
    result.confidence.resize(n);
    const double spacing = contour::arc_length(snake.points) / static_cast<double>(n);
    const Eigen::Index first = spacing > 0.0 ? static_cast<Eigen::Index>(std::lround(arc / spacing)) : 0;
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Index k = contour::wrap(first + i, n);
      result.sigma_um[i] = snake.sigma_px[k] * pixel_size_um;
      result.confidence[i] = snake.confidence[k];
    }
    return result;
  }

  Observation report(double pixel_size_um, double time_s, long frame_index) const {
    Observation out;
    out.time_s = time_s;
    out.frame_index = frame_index;
    if (!has_cell_) {
      out.state = ever_ ? CellState::kLost : CellState::kNoCell;
      return out;
    }
    out.state = contact_.state();
    const Eigen::Vector2d center = center_now();
    Eigen::Vector2d axis = holder_.valid ? Eigen::Vector2d(-holder_.direction) : Eigen::Vector2d::UnitX();
    if (needle_.valid()) axis = (needle_.estimate().tip - center).normalized();
    if (needle_.valid()) axis = -needle_.estimate().direction;
    out.outer = membrane(snakes_.outer(), Membrane::kOuter, axis, pixel_size_um);
    if (snakes_.has_inner() && snakes_.inner().score > 0.25)
      out.inner = membrane(snakes_.inner(), Membrane::kInner, axis, pixel_size_um);
    out.center_um = center * pixel_size_um;
    out.rest_outer_radius_um = rest_.outer_radius * pixel_size_um;
    out.rest_inner_radius_um = rest_.inner_radius * pixel_size_um;
    out.axis = axis;
    if (needle_.valid()) fill_needle(out, pixel_size_um);
    if (holder_.valid) fill_holder(out, pixel_size_um);

    // As good as the contours were seen, less where they were suddenly seen worse than before.
    const double sides = std::min(snakes_.outer().score, 0.3 + 0.7 * local_score());
    const double sudden = usual_quality_ > 0.0 ? std::clamp(quality_ / usual_quality_, 0.0, 1.0) : 1.0;
    const double first_sight = rest_.seen_free ? 1.0 : 0.7;
    out.confidence = sides * sudden * sudden * first_sight * detection_score_;
    out.confidence = std::clamp(out.confidence, 0.0, 1.0);
    if (bad_frames_ > 0) out.confidence *= 0.3;
    return out;
  }

  void fill_needle(Observation& out, double pixel_size_um) const {
    const NeedleEstimate& n = needle_.estimate();
    NeedlePose pose;
    pose.tip_um = n.tip * pixel_size_um;
    pose.direction = n.direction;
    pose.tip_radius_um = n.tip_half_width * pixel_size_um;
    pose.confidence = n.confidence;
    pose.tip_sigma_um = n.tip_sigma * pixel_size_um;
    pose.evidence = n.evidence;
    // Tip, one side as far as it was fitted and forward again, then the other side: no line crosses the open shaft.
    const Eigen::Vector2d across(-n.direction.y(), n.direction.x());
    const double length = 80.0;
    const Eigen::Vector2d front = n.tip - n.tip_half_width * n.direction;
    const Eigen::Vector2d back = n.tip - length * n.direction;
    const double back_half_width = n.tip_half_width + n.widening * length;
    Eigen::Matrix2Xd outline(2, 9);
    outline << n.tip, front + n.tip_half_width * across, back + back_half_width * across,
        front + n.tip_half_width * across, n.tip, front - n.tip_half_width * across, back - back_half_width * across,
        front - n.tip_half_width * across, n.tip;
    pose.outline_um = outline * pixel_size_um;
    out.needle = pose;

    // Under the tip the membrane is where the tip is: two measures of one depth, averaged as long as they agree.
    const bool contact = contact_.state() == CellState::kContact;
    const double apart_px = std::abs(tip_depth() - membrane_depth_);
    const double depth_px =
        contact && apart_px < 4.0 ? kTipShare * tip_depth() + (1.0 - kTipShare) * membrane_depth_ : membrane_depth_;
    out.indentation_um = contact_.state() == CellState::kFree ? 0.0 : std::max(0.0, depth_px) * pixel_size_um;
    out.indentation_sigma_um = (rest_.seen_free ? 0.35 : 1.5) * pixel_size_um;
    if (!contact) return;
    const Eigen::Vector2d entry = rest_.entry_point(center_now(), n.tip, n.direction);
    out.dimple_radius_um = pixel_size_um * dimple_radius(snakes_.outer().points, center_now(),
                                                         entry + membrane_depth_ * n.direction, -n.direction);
  }

  void fill_holder(Observation& out, double pixel_size_um) const {
    HolderPose pose;
    const Eigen::Vector2d across(-holder_.direction.y(), holder_.direction.x());
    const double sunk = std::min(0.8 * holder_.half_width, 0.95 * rest_.outer_radius);
    const double distance = std::sqrt(rest_.outer_radius * rest_.outer_radius - sunk * sunk);
    const Eigen::Vector2d mouth = center_now() + distance * holder_.direction + holder_.offset * across;
    pose.mouth_um = mouth * pixel_size_um;
    pose.direction = holder_.direction;
    pose.outer_radius_um = holder_.half_width * pixel_size_um;
    pose.confidence = holder_.confidence;
    const double length = 1.5 * rest_.outer_radius;
    Eigen::Matrix2Xd outline(2, 4);
    outline.col(0) = mouth + length * holder_.direction + holder_.half_width * across;
    outline.col(1) = mouth + holder_.half_width * across;
    outline.col(2) = mouth - holder_.half_width * across;
    outline.col(3) = mouth + length * holder_.direction - holder_.half_width * across;
    pose.outline_um = outline * pixel_size_um;
    out.holder = pose;
  }

  TrackerOptions options_;
  ImageView view_;  // of this frame, as image_
  FrameSampler image_;
  double noise_ = 0.0;
  MembraneSnakes snakes_;
  NeedleTracker needle_;
  RigidMotion rigid_;
  RestGeometry rest_;
  ContactLogic contact_;
  Holder holder_;
  Eigen::Vector2d rigid_shift_ = Eigen::Vector2d::Zero();
  double detection_score_ = 0.0, score_ = 0.0, quality_ = 0.0, usual_quality_ = 0.0, first_quality_ = 0.0,
         membrane_depth_ = 0.0;
  bool has_cell_ = false, ever_ = false, touching_ = false;
  int bad_frames_ = 0, poor_frames_ = 0;
  int frames_since_detection_ = 1 << 20;
};

MembraneTracker::MembraneTracker(TrackerOptions options) {
  check(options);
  impl_ = std::make_unique<Impl>(options);
}
MembraneTracker::~MembraneTracker() = default;
MembraneTracker::MembraneTracker(MembraneTracker&&) noexcept = default;
MembraneTracker& MembraneTracker::operator=(MembraneTracker&&) noexcept = default;

Observation MembraneTracker::process(const ImageView& image, double time_s, long frame_index, const FrameHints&) {
  return impl_->process(image, time_s, frame_index);
}
void MembraneTracker::expect_cell(const CellHint&) {}
void MembraneTracker::reset() {
  impl_ = std::make_unique<Impl>(impl_->options());
}
const TrackerOptions& MembraneTracker::options() const noexcept {
  return impl_->options();
}

}  // namespace pellucida
