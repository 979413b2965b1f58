#include "SceneVerdict.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ContourMath.h"
#include "Median.h"

namespace pellucida {
namespace {

// Outlines of one cell as map and lines have them differ by less than this share of its radius, tips by less than this.
constexpr double kSameCell_ratio = 0.07, kLeastApart_px = 2.5, kSameTip_px = 11.0;
// On 156 first frames of tuning films (seeds 63001 to 63090, in looks of the optical model and as plain drawings):
// where lines had a cell right to 0.2 px, the network read its boundary within 0.0205 of the radius of them in the
// mean, where they were 2 px or more off 0.0215 and more away.
constexpr double kSameOutline_ratio = 0.021, kLeastOutline_px = 0.75;
// So near to each other, of the radius, lines and network have the same outline, and the lines are the finer; a line
// that is about the same on both sides may lie farther from what the network reads. Set on 24 films that lines had
// begun (docs/method.md, 1.6), as the next.
constexpr double kFine_ratio = 0.0065, kFineIfEven_ratio = 0.0095, kFairlyEven = 0.33, kLeastFine_px = 0.3;
// Confidence of lines that noise hides nothing of. Of 10 of these films, whose lines had 0.4 to 0.9, the network had
// the outline better in 9.
constexpr double kClearLines = 0.9;
// A line that is the same on both sides is drawn where the boundary is; what defocus, relief or a halo make of a
// boundary is not. On 177 pictures (tuning and wide looks and plain drawings of seeds 260101 to 269300) that lines and
// network had at the same place, 21 had less than this and were right to 0.4 px; the next, from 0.27 on, were up to 2
// px off.
constexpr double kEvenLine = 0.12;
// Lines that follow the oolemma for the zona's inner boundary, or the other way round: their thickness differs by this
// share and this many px from that of a network whose mean confidence about the inner boundary is above `kSureInner`.
// Set on wide films 179014 and 179020, where the lines had 1.5 and 2 times the network's thickness; no outline of 112
// tuning, wide and plain pictures (173001 to 173225) became worse.
constexpr double kSameInner_ratio = 0.25, kLeastInner_px = 1.2, kSureInner = 0.75;
// Where lines and network have different cells, the network's mean confidence in its own has to be so much above that
// in the lines', and above this: beside a cell it was 0.61 at most (173001 to 173150). On the real stills, which lines
// followed rightly, it was up to 0.07 above; where a network was right alone (wide 179112 to 179134) 0.15 and more.
constexpr double kSurerThanLines = 0.1, kLeastDisputed = 0.63;
// What lines follow is one wall of a needle where, half its length behind the tip, it is thinner than this share of its
// mean width. The map's own pixels widen what it shows, to each side by this share of one: a needle whose whole tapered
// end is as narrow as that would be taken for a wall (half widths of 3.3 px by the map and 1.2 px by right lines).
constexpr double kWall_ratio = 0.4, kWidened_pitches = 0.4;
// Lines are held against a network whose mean confidence is above these. Set on 112 pictures of tuning, wide and plain
// drawings and 60 of another renderer (docs/method.md, 1.6); with 0.04 less of each a picture in 172 is seen better.
// The lines' score is 0.999 for bubbles.
constexpr double kLeastConfidence = 0.8, kKnownScore = 0.82, kBubbleScore = 0.99;
// Of a reading about the lines, holder and needle included: below, the look is strange to the network.
constexpr double kStrangeScore = 0.80;

// Mean distance of an outline's points from the nearest points of a contour, px.
double distance_px(const Eigen::Matrix2Xd& outline, const Eigen::Matrix2Xd& contour) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < outline.cols(); ++i)
    sum += std::sqrt((contour.colwise() - outline.col(i)).colwise().squaredNorm().minCoeff());
  return sum / static_cast<double>(std::max<Eigen::Index>(1, outline.cols()));
}

double radius_px(const Eigen::Matrix2Xd& outline) {
  return std::sqrt(std::abs(contour::signed_area(outline)) / M_PI);
}

bool is_same(const CellFollower& by_lines, const SceneCell& seen) {
  const Eigen::Matrix2Xd& outline = outline_of(by_lines);
  return distance_px(seen.outer, outline) < std::max(kLeastApart_px, kSameCell_ratio * radius_px(outline));
}

// The boundaries as the network reads them about the lines: the outer one's mean distance from them, the median
// distance between the two, and how sure they are in the mean.
struct ReadAbout {
  double apart_px = 0.0, thickness_px = 0.0, confidence = 0.0, inner_confidence = 0.0;
};
ReadAbout read_about(const Eigen::Matrix2Xd& outline, const FrameSampler& image, BoundaryNetwork& boundaries) {
  const BoundaryReading seen = boundaries.read(image, outline);
  const Eigen::VectorXd apart = seen.outer.offset_px - seen.inner.offset_px;
  std::vector<double> thickness(apart.begin(), apart.end());
  const auto sureness = [&](const BoundaryPlaces& places) {
    return confidence_of(places.sigma_px, radius_px(outline)).mean();
  };
  return {seen.outer.offset_px.cwiseAbs().mean(), median_of(thickness), sureness(seen.outer), sureness(seen.inner)};
}

// Whether lines that follow an inner boundary follow the one that the network reads; true where it isn't sure.
bool is_same_inner(const CellFollower& by_lines, const ReadAbout& seen) {
  if (by_lines.zona().valid() || !by_lines.snakes().has_inner() || seen.inner_confidence < kSureInner) return true;
  const double apart_px = std::abs(by_lines.snakes().thickness_px() - seen.thickness_px);
  return apart_px < std::max(kLeastInner_px, kSameInner_ratio * seen.thickness_px);
}

double most_apart_px(const Eigen::Matrix2Xd& outline) {
  return std::max(kLeastOutline_px, kSameOutline_ratio * radius_px(outline));
}

bool is_near(const NeedleTracker& followed, const SceneTool& needle) {
  return followed.valid() &&
         (needle.tip - followed.estimate().tip).norm() < std::max(kSameTip_px, 2.0 * needle.half_width_px);
}

}  // namespace

const Eigen::Matrix2Xd& outline_of(const CellFollower& by_lines) {
  return by_lines.zona().valid() ? by_lines.zona().outer().points : by_lines.snakes().outer().points;
}

bool is_outline_read(const Eigen::Matrix2Xd& outline, const FrameSampler& image, BoundaryNetwork& boundaries) {
  return read_about(outline, image, boundaries).apart_px < most_apart_px(outline);
}

bool is_one_wall(const NeedleEstimate& lines, const SceneTool& needle) {
  const double half_width_px = needle.half_width_px - kWidened_pitches * needle.pitch_px;
  return lines.tip_half_width + 0.5 * needle.length_px * lines.widening < kWall_ratio * half_width_px;
}

bool is_needle_confirmed(const CellFollower& by_lines, const SceneReading& scene) {
  bool has_tip = false;
  for (const SceneTool& needle : scene.needles) {
    if (needle.tip_share < kLeastNeedleTipShare) continue;
    has_tip = true;
    if (is_near(by_lines.needle(), needle) && !is_one_wall(by_lines.needle().estimate(), needle)) return true;
  }
  return !has_tip;
}

LinesVerdict judge_lines(CellFollower& by_lines, const SceneReading& scene, const FrameSampler& image,
                         SceneReader& reader) {
  LinesVerdict verdict;
  bool has_cell = false;
  for (const SceneCell& seen : scene.cells) {
    if (seen.share < kLeastCellShare) continue;
    has_cell = true;
    verdict.is_same_cell = verdict.is_same_cell || is_same(by_lines, seen);
  }
  const ReadAbout seen = read_about(outline_of(by_lines), image, reader.boundaries());
  verdict.is_same_outline = seen.apart_px < most_apart_px(outline_of(by_lines));
  const bool is_even = !by_lines.zona().valid() && by_lines.snakes().asymmetry() < kEvenLine;
  const double fine_ratio = by_lines.snakes().asymmetry() < kFairlyEven ? kFineIfEven_ratio : kFine_ratio;
  verdict.is_fine = seen.apart_px < std::max(kLeastFine_px, fine_ratio * radius_px(outline_of(by_lines))) ||
                    (is_even && verdict.is_same_outline);
  verdict.is_lone_edge = !is_even && !by_lines.zona().valid() && !by_lines.snakes().has_inner();
  verdict.is_soft = by_lines.zona().valid();
  verdict.is_same_inner = is_same_inner(by_lines, seen);
  verdict.confidence = seen.confidence;
  verdict.is_strange = seen.confidence < kStrangeScore;
  const auto whole = std::find_if(scene.needles.begin(), scene.needles.end(), [&](const SceneTool& needle) {
    return is_near(by_lines.needle(), needle) && is_one_wall(by_lines.needle().estimate(), needle);
  });
  if (whole != scene.needles.end()) by_lines.expect_needle_width(whole->half_width_px, image, reader.tips());
  by_lines.take_bevel(image, reader.tips());
  verdict.is_same_needle =
      is_needle_confirmed(by_lines, scene) && by_lines.needle().is_where_read(reader.tips(), image);
  verdict.is_sure = by_lines.membranes_confidence() > kLeastConfidence;
  verdict.is_clear = is_even || by_lines.membranes_confidence() > kClearLines;
  verdict.is_bubble = !has_cell && by_lines.snakes().outer().score > kBubbleScore;
  return verdict;
}

DetectedCell detected(const CellFollower& by_lines) {
  DetectedCell cell;
  cell.outer.points = outline_of(by_lines);
  cell.circle = contour::fit_circle(cell.outer.points, kSameCell_ratio * radius_px(cell.outer.points));
  cell.score = std::min(1.0, by_lines.snakes().outer().score);
  return cell;
}

bool is_known(const CellFollower& by_scene) {
  return by_scene.snakes().outer().score > kKnownScore;
}

bool is_preferred(const CellFollower& by_scene, const LinesVerdict& verdict) {
  const double score = by_scene.snakes().outer().score;
  const bool is_surer = score > verdict.confidence + kSurerThanLines;
  const bool is_disputed = !verdict.is_same() && verdict.is_clear;
  if (is_disputed) return is_known(by_scene) || is_surer;
  return score > MembraneSnakes::kLeastAtFirst || (!verdict.is_same() && is_surer);
}

double least_score(const LinesVerdict& verdict) {
  return verdict.is_same()
             ? MembraneSnakes::kLeastAtFirst
             : std::clamp(verdict.confidence + kSurerThanLines, kLeastDisputed, MembraneSnakes::kLeastAtFirst);
}

bool is_bystander(const contour::Circle& cell, const SceneReading& scene) {
  return scene.has_tools() && !is_worked_on(scene, cell.center, cell.radius);
}

bool is_bystander(const CellFollower& cell, const SceneReading& scene) {
  return is_bystander(cell.circle_now(), scene);
}

}  // namespace pellucida
