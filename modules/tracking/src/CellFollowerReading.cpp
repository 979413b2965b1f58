// The boundaries of a cell that networks read, in a frame: from where they are expected, from where they were, and from
// the resting outline, should the membrane have sprung back or nothing push it.
#include <algorithm>
#include <iterator>
#include <span>

#include "CellFollower.h"
#include "Dimple.h"

namespace pellucida {
namespace {

// Rounds of reading a frame, live and where time does not count; quality of a reading that may have begun in the wrong
// place.
constexpr int kRoundsLive = 1, kRoundsHigh = 2;
constexpr double kPoorReading = 0.6;
// Frames at most, of one cell that is pushed and of another, that go on with what was read last; the first ones are all
// read, for the mean thickness. Px, and of the radius: a reading that moves the contour by more (RMS) has not got to
// where it leads, as in a dimple that deepens fast.
constexpr int kMostGoneOnPushed = 5, kMostGoneOn = 7, kFirstReadings = 12;
constexpr double kSettledReading_px = 0.25, kSettledReading_ratio = 0.003;
// Of the radius: a membrane so far ahead of the tip is not pushed by it.
constexpr double kBeyondTip_ratio = 0.06;
// Of the radius: half the width of the dimples, none included, that a needle past the outline may have made before the
// first sight.
constexpr double kDimples_ratio[] = {0.0, 0.4, 0.8};
// Of the tip's depth: flanks as deep as this are pushed, and the membrane then lies at the tip, at least so deep. On 47
// tuning and wide pictures of contact (173001 to 173150) outlines that cut across the dimple had flanks of 0.14 to 0.4.
constexpr double kDimpleFlank_ratio = 0.12, kReached_ratio = 0.8;
// Of the radius, and px: an outline that runs otherwise about the tip than a membrane can (`Dimple`) by more than this
// has gone astray; where it is begun anew, half the width of the dimple, and how many of these are tried for one that
// is only seen poorly.
constexpr double kOdd_ratio = 0.04, kOdd_px = 2.0;
constexpr double kNewDimples_ratio[] = {0.6, 0.35, 0.9};
constexpr std::size_t kTriesIfPoor = 1;
// What that takes from an outline's quality, beside itself as a share of the radius.
constexpr double kOddCosts = 0.15;
// Of the radius: what is read farther from such a dimple is another edge.
constexpr double kTrusted_ratio = 0.06;

}  // namespace

// Both boundaries as the network sees them, from where they are expected; or, should the cell not have moved as was
// thought, from where they were.
void CellFollower::read_boundaries(const FrameInput& frame, const NeedleZone* needle, const Eigen::Vector2d& shift) {
  snakes_.predict(shift, tip_way(), needle);
  if (go_on(frame, needle)) return;
  frames_since_reading_ = 0;
  const bool is_live = options_.quality == TrackerOptions::Quality::kLive;
  snakes_.read(frame.image, frame.reader->boundaries(), needle, is_live ? kRoundsLive : kRoundsHigh);
  moved_by_reading_px_ = snakes_.moved_px();
  quality_ = quality_now();
  if (needle && touching_ && needle_.is_clear()) read_sprung_back(frame, *needle);
  const bool has_given_way = contact_.state() == CellState::kPunctured;
  if (needle == nullptr || has_given_way ||
      measure_membrane_depth() - tip_depth() > kBeyondTip_ratio * rest_.outer_radius)
    read_unpushed(frame, needle);
  if (quality_ < kPoorReading) read_where_it_was(frame, needle);
  if (needle && touching_ && is_pushed()) mend_dimple(frame, *needle);
  snakes_.keep_reading(frame.image);
}

// By what was read last and has moved since, where that was seen well and shows where it is. The membrane may have
// given way meanwhile.
bool CellFollower::go_on(const FrameInput& frame, const NeedleZone* needle) {
  const int most = contact_.state() == CellState::kContact ? kMostGoneOnPushed : kMostGoneOn;
  const bool is_settled =
      quality_ >= kPoorReading &&
      moved_by_reading_px_ < std::max(kSettledReading_px, kSettledReading_ratio * rest_.outer_radius);
  const bool is_due = frames_since_reading_ >= most || frames_followed_ <= kFirstReadings;
  if (is_due || !is_settled || options_.quality == TrackerOptions::Quality::kHigh) return false;
  if (!snakes_.go_on(frame.image, frame.noise, needle)) return false;
  ++frames_since_reading_;
  if (touching_ && needle_.is_clear() && read_sprung_back(frame, *needle)) snakes_.keep_reading(frame.image);
  return true;
}

void CellFollower::read_where_it_was(const FrameInput& frame, const NeedleZone* needle) {
  const SnakeContour outer = snakes_.outer(), inner = snakes_.inner();
  const double quality = quality_;
  snakes_.restore(outer_before_, inner_before_);
  snakes_.read(frame.image, frame.reader->boundaries(), needle, kRoundsHigh);
  quality_ = quality_now();
  if (quality_ > quality) return;
  snakes_.restore(outer, inner);
  quality_ = quality;
}

// A contour that is held to the tip stays there when the membrane gives way: where the picture about the tip shows it
// through, both boundaries once more, from the resting outline and with nothing that wraps the tip. That counts if it
// is seen better, and the cell's shape does not say that it is pushed.
bool CellFollower::read_sprung_back(const FrameInput& frame, const NeedleZone& needle) {
  if (!is_seen_through() || measure_membrane_depth() < kOnTip_ratio * tip_depth()) return false;
  const SnakeContour outer = snakes_.outer(), inner = snakes_.inner();
  NeedleZone loose = needle;
  loose.touching = false;
  const double tied_score = local_score();
  snakes_.restore(at_rest(outer, rest_.outer_radius), at_rest(inner, rest_.inner_radius));
  snakes_.read(frame.image, frame.reader->boundaries(), &loose, kRoundsHigh);
  if (local_score() > tied_score && !is_shape_pushed()) {
    quality_ = quality_now();
    return true;
  }
  snakes_.restore(outer, inner);
  return false;
}

// A dimple that no tip is at the bottom of may be one that the contour has stayed in: once more from the resting
// outline. Where the membrane has given way, that counts if it is seen about as well.
void CellFollower::read_unpushed(const FrameInput& frame, const NeedleZone* needle) {
  measure_dent();
  if (new_dent_ratio() < kUnpushedDent_ratio) return;
  const SnakeContour outer = snakes_.outer(), inner = snakes_.inner();
  snakes_.restore(at_rest(outer, rest_.outer_radius), at_rest(inner, rest_.inner_radius));
  snakes_.read(frame.image, frame.reader->boundaries(), needle, kRoundsHigh);
  const double least = contact_.state() == CellState::kPunctured ? kAsWell_ratio * quality_ : quality_;
  if (quality_now() > least) {
    quality_ = quality_now();
  } else {
    snakes_.restore(outer, inner);
  }
}

double CellFollower::oddness() const {
  const NeedleEstimate& n = needle_.estimate();
  return Dimple::of(snakes_.outer().points, center_now(), rest_.outer_radius, n.tip, n.direction).worst_px();
}

// Normals of an outline that is kinked show nothing that would straighten it: it is begun anew from smooth dimples at
// the tip, and so is one that is seen poorly. What is seen best, and runs as a membrane can, counts.
void CellFollower::mend_dimple(const FrameInput& frame, const NeedleZone& needle) {
  const double odd = oddness(), most = std::max(kOdd_px, kOdd_ratio * rest_.outer_radius);
  if (odd < most && quality_ >= kPoorReading) return;
  NeedleZone strict = needle;
  strict.trust_px = kTrusted_ratio * rest_.outer_radius;
  const SnakeContour outer = snakes_.outer(), inner = snakes_.inner();
  SnakeContour best_outer = outer, best_inner = inner;
  const auto judged = [&](double off) {
    return quality_now() - off / rest_.outer_radius - (off < most ? 0.0 : kOddCosts);
  };
  double best = judged(odd);
  for (const double width :
       std::span(kNewDimples_ratio).first(odd < most ? kTriesIfPoor : std::size(kNewDimples_ratio))) {
    SnakeContour smooth = outer;
    smooth.points = with_smooth_dimple(outer.points, needle.tip, needle.direction, width * rest_.outer_radius);
    snakes_.restore(smooth, inner);
    snakes_.read(frame.image, frame.reader->boundaries(), &strict, kRoundsHigh);
    const double score = judged(oddness());
    if (score <= best) continue;
    best = score;
    best_outer = snakes_.outer();
    best_inner = snakes_.inner();
  }
  snakes_.restore(best_outer, best_inner);
  quality_ = quality_now();
}

// A needle that is past the outline at first sight: normals of an outline without a dimple do not cross one, and those
// of a dimple not what is none. So both are read, with nothing held to the tip. What is seen best beside it counts, of
// those that a membrane can be: one whose flanks are pushed is not away from what pushes it.
void CellFollower::read_dimples(const FrameInput& frame) {
  const NeedleZone loose = zone();
  SnakeContour best_outer = snakes_.outer(), best_inner = snakes_.inner();
  const SnakeContour outer = at_rest(best_outer, rest_.outer_radius), inner = at_rest(best_inner, rest_.inner_radius);
  const auto judged = [&] {
    const double depth_px = tip_depth();
    const bool cuts =
        flank_depth() > kDimpleFlank_ratio * depth_px && measure_membrane_depth() < kReached_ratio * depth_px;
    return local_score() - (cuts ? 1.0 : 0.0);
  };
  double best = judged();
  for (const double width : kDimples_ratio) {
    snakes_.restore(dimpled(outer, width * rest_.outer_radius), dimpled(inner, width * rest_.outer_radius));
    snakes_.read(frame.image, frame.reader->boundaries(), &loose, kRoundsHigh);
    const double score = judged();
    if (score <= best) continue;
    best = score;
    best_outer = snakes_.outer();
    best_inner = snakes_.inner();
  }
  snakes_.restore(best_outer, best_inner);
}

// A resting contour pushed in by the needle as far as the outer one has to be to reach the tip, over `reach_px` to
// either side of its axis.
SnakeContour CellFollower::dimpled(SnakeContour snake, double reach_px) const {
  const NeedleEstimate& needle = needle_.estimate();
  const double depth_px = tip_depth();
  for (Eigen::Index i = 0; i < snake.points.cols(); ++i) {
    const Eigen::Vector2d d = snake.points.col(i) - needle.tip;
    const double across = std::abs(needle.direction.x() * d.y() - needle.direction.y() * d.x());
    if (across >= reach_px || (snake.points.col(i) - center_now()).dot(needle.direction) > 0.0) continue;
    const double share = 1.0 - across / reach_px;
    snake.points.col(i) += depth_px * share * share * needle.direction;
  }
  return snake;
}

}  // namespace pellucida
