#include "CellDetector.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "LevelSetOutline.h"
#include "RingSearch.h"
#include "ZonaSearch.h"

namespace pellucida {
namespace {

constexpr double kSecondScore = 0.35;                    // a second dark line that counts
constexpr double kFarScore = 0.6, kFarAmplitude = 0.35;  // a third one, further out; of the fainter of the two, its own
constexpr double kFaintest = 0.1;      // of the line's contrast: what counts as grain in looking for a border
constexpr double kBroadLine_px = 1.2;  // standard deviation of a broad line: nearer than 3 of them lies its own flank
constexpr double kWidest_ratio = 1.5;  // a zona's outer line over its inner one, of an oval cell with a thick zona
constexpr double kFinest_px = 0.7;     // finest scale of the lines: two that lie 2 px apart must not melt into one
constexpr double kHintShare = 0.5;     // of the score needed, where a person says there is a cell
constexpr double kSameEdge = 0.1;      // of the radius: a dark body's border this near to a line is that line's
// A drawn outline: of its radius, how near an edge is the one that was meant, and where else it is looked for; a point
// this near to the circle through an outline belongs to its undeformed part.
constexpr double kDrawnNear = 0.12, kDrawnFar = 0.35, kDrawnTolerance = 0.06;
constexpr double kUnsureShare = 0.4;  // of the score needed: below, there is nothing for a level set to start from

// The image at all scales, each level half the size of the one before.
struct Pyramid {
  Pyramid(const GrayImage& image, const TrackerOptions& options) {
    levels.push_back(reduced(image, 1.0, 1));
    while (levels.back().width >= 96 && levels.back().height >= 96 && levels.size() < 5 &&
           20.0 * (1 << levels.size()) < options.max_cell_diameter_px) {
      levels.push_back(reduced(levels.back(), 0.9, 2));
    }
    for (const GrayImage& level : levels) noises.push_back(noise_level(level));
  }
  std::vector<GrayImage> levels;
  std::vector<double> noises;
};

// The closed edge of a candidate, in px of its level.
struct Judged {
  RingEdge ring;
  int level = 0;
  bool from_outline = false;  // along a drawn outline or a level set's, else round a centre
  double scale() const noexcept { return 1 << level; }
};

// The best closed edge round a proposed centre, re-centred twice.
Judged judge(const Pyramid& pyramid, const CellCandidate& candidate) {
  Judged best;
  best.level = candidate.level;
  const GrayImage& level = pyramid.levels[static_cast<std::size_t>(candidate.level)];
  const double noise = pyramid.noises[static_cast<std::size_t>(candidate.level)];
  Eigen::Vector2d center = candidate.center / best.scale();
  double radius = candidate.radius_px / best.scale();
  for (int round = 0; round < 3; ++round) {
    RingEdge found = best_in_ring(level, center, 0.55 * radius, 1.5 * radius, {1.3}, noise, kAnyEdgeKind, 64);
    if (found.score > best.ring.score) best.ring = std::move(found);
    const contour::Circle& circle = best.ring.circle;
    if (best.ring.score < 0.15 || circle.radius < 4.0) break;
    if ((circle.center - center).norm() < 0.03 * radius && std::abs(circle.radius - radius) < 0.1 * radius) break;
    center = circle.center;
    radius = circle.radius;
  }
  return best;
}

// Whether an edge, in px of `level`, can be a cell's at all: size, transparency, and the point a person clicked on.
bool acceptable(const Pyramid& pyramid, const Judged& judged, const TrackerOptions& options,
                const std::optional<Eigen::Vector2d>& inside) {
  const contour::Circle& circle = judged.ring.circle;
  const double diameter = 2.0 * circle.radius * judged.scale();
  if (diameter < options.min_cell_diameter_px || diameter > options.max_cell_diameter_px) return false;
  if (inside && !contour::contains(judged.ring.edge.points, *inside / judged.scale())) return false;
  return translucent(pyramid.levels[static_cast<std::size_t>(judged.level)], circle);
}

// Rings of every size round a click, which is somewhere near the cell's middle.
void add_click(const Pyramid& pyramid, const Eigen::Vector2d& inside, const TrackerOptions& options,
               std::vector<CellCandidate>& candidates) {
  for (int level = 0; level < static_cast<int>(pyramid.levels.size()); ++level) {
    for (const double radius : {11.0, 16.0, 23.0}) {
      const double full = radius * (1 << level);
      if (2.0 * full < options.min_cell_diameter_px || 2.0 * full > options.max_cell_diameter_px) continue;
      candidates.push_back({inside, full, level, 0.0});
    }
  }
}

// The best of all proposals; with `inside`, of those that hold that point; not within `elsewhere`.
Judged best_candidate(const Pyramid& pyramid, const TrackerOptions& options,
                      const std::optional<Eigen::Vector2d>& inside, const contour::Circle* elsewhere) {
  Judged best;
  double best_votes = 0.0;
  std::vector<contour::Circle> known;
  std::vector<CellCandidate> candidates = propose_cells(pyramid.levels, options);
  if (elsewhere != nullptr) {
    std::erase_if(candidates, [&](const CellCandidate& candidate) {
      return (candidate.center - elsewhere->center).norm() < elsewhere->radius;
    });
  }
  if (inside) {
    std::erase_if(candidates, [&](const CellCandidate& candidate) {
      return (candidate.center - *inside).norm() > 1.1 * candidate.radius_px;
    });
    add_click(pyramid, *inside, options, candidates);
  }
  for (const CellCandidate& candidate : candidates) {
    // Neighbouring levels and bands propose the same ring again.
    const bool again = std::any_of(known.begin(), known.end(), [&](const contour::Circle& circle) {
      return (circle.center - candidate.center).norm() < 0.2 * circle.radius &&
             std::abs(circle.radius - candidate.radius_px) < 0.3 * circle.radius;
    });
    if (again) continue;
    // A clear cell is found; what has far fewer votes won't be clearer.
    if (best.ring.score > 0.85 && candidate.votes < 0.5 * best_votes) break;
    Judged here = judge(pyramid, candidate);
    const contour::Circle& circle = here.ring.circle;
    if (here.ring.score > 0.3) known.push_back({circle.center * here.scale(), circle.radius * here.scale(), 1.0, 0.0});
    if (here.ring.score <= best.ring.score || !acceptable(pyramid, here, options, inside)) continue;
    best = std::move(here);
    best_votes = candidate.votes;
  }
  return best;
}

// The level on which an outline of `radius` px is a small part of the image, yet shows its line.
int level_for(const Pyramid& pyramid, double radius) {
  int level = 0;
  while (level + 1 < static_cast<int>(pyramid.levels.size()) && radius / (1 << level) > 48.0) ++level;
  return level;
}

// The closed edge along an outline (full image px), by the same measure as those round a centre.
Judged judge_along(const Pyramid& pyramid, const Eigen::Matrix2Xd& outline, double reach_ratio) {
  const double radius = std::sqrt(std::abs(contour::signed_area(outline)) / std::numbers::pi);
  Judged result;
  result.level = level_for(pyramid, radius);
  result.from_outline = true;
  const double reach = reach_ratio * radius / result.scale();
  result.ring = best_along(pyramid.levels[static_cast<std::size_t>(result.level)],
                           contour::positively_oriented(outline) / result.scale(), reach, reach, {1.3},
                           pyramid.noises[static_cast<std::size_t>(result.level)], kAnyEdgeKind);
  return result;
}

// The edge along a drawn outline: the one that was meant, near it, before a stronger one further away.
Judged judge_drawn(const Pyramid& pyramid, const Eigen::Matrix2Xd& outline, double needed) {
  Judged near = judge_along(pyramid, outline, kDrawnNear);
  return near.ring.score >= needed ? near : judge_along(pyramid, outline, kDrawnFar);
}

// Of a cell's edges the one that was drawn is the outer one; what lies outside of it was not meant.
void take_drawn(const Eigen::Matrix2Xd& outline, DetectedCell& cell) {
  const auto radius_of = [](const Eigen::Matrix2Xd& points) {
    return std::sqrt(std::abs(contour::signed_area(points)));
  };
  const auto apart = [&](const FoundEdge& edge) { return std::abs(radius_of(edge.points) - radius_of(outline)); };
  while (cell.inner && apart(*cell.inner) < apart(cell.outer)) {
    cell.outer = std::move(*cell.inner);
    cell.inner = std::exchange(cell.oolemma, std::nullopt);
    cell.circle = contour::fit_circle(cell.outer.points, kDrawnTolerance * cell.circle.radius);
  }
}

// A level set from a rough outline into the edges near by, judged like any other edge.
Judged settle(const Pyramid& pyramid, const Eigen::Matrix2Xd& outline) {
  const auto refined = refine_by_level_set(pyramid.levels.front(), outline);
  return refined ? judge_along(pyramid, *refined, 0.3) : Judged{};
}

RingEdge at_scale(RingEdge ring, double scale) {
  ring.edge.points *= scale;
  ring.circle.center *= scale;
  ring.circle.radius *= scale;
  ring.edge.scale_px *= scale;
  return ring;
}

// The same edge at full resolution, in a narrow ring; a dark line where there is one.
RingEdge at_full_resolution(const Pyramid& pyramid, const Judged& coarse, double sigma_ratio) {
  Eigen::Vector2d center = coarse.ring.circle.center * coarse.scale();
  double radius = coarse.ring.circle.radius * coarse.scale();
  if (coarse.from_outline) {
    const double sigma = std::clamp(sigma_ratio * radius, kFinest_px, 2.5);
    const RingEdge fine =
        best_along(pyramid.levels.front(), coarse.ring.edge.points * coarse.scale(), 0.12 * radius, 0.12 * radius,
                   {sigma, 2.0 * sigma}, pyramid.noises.front(), {coarse.ring.edge.kind, {1.0, 0.0}});
    if (fine.score >= 0.5 * coarse.ring.score) return fine;
    return at_scale(coarse.ring, coarse.scale());
  }
  // Each level centres the ring for the next.
  for (int level = coarse.level - 1; level >= 1; --level) {
    const double scale = 1 << level;
    const RingEdge found = best_in_ring(
        pyramid.levels[static_cast<std::size_t>(level)], center / scale, 0.72 * radius / scale, 1.3 * radius / scale,
        {1.3}, pyramid.noises[static_cast<std::size_t>(level)], {coarse.ring.edge.kind, {1.0, 0.0}});
    if (found.score < 0.3) continue;
    center = found.circle.center * scale;
    radius = found.circle.radius * scale;
  }
  const double sigma = std::clamp(sigma_ratio * radius, kFinest_px, 2.5);
  const RingEdge fine = best_in_ring(pyramid.levels.front(), center, 0.75 * radius, 1.25 * radius, {sigma, 2.0 * sigma},
                                     pyramid.noises.front(), {coarse.ring.edge.kind, {1.0, 0.0}});
  if (fine.score >= 0.5 * coarse.ring.score) return fine;
  return at_scale(coarse.ring, coarse.scale());
}

// One more line of the kind round a pair: the two were the zona's inner edge and the oolemma. As far outside as the two
// lie apart it may be fainter; further out, under a thick zona, it must be as clear as a line that is looked for first.
std::optional<RingEdge> line_round(const GrayImage& image, const std::pair<RingEdge, RingEdge>& pair, double sigma,
                                   double noise) {
  const contour::Circle& circle = pair.first.circle;
  const double thick = circle.radius - pair.second.circle.radius;
  const double faint = std::min(pair.first.amplitude, pair.second.amplitude);
  const auto best = [&](double to) {
    return best_in_ring(image, circle.center, circle.radius + 0.6 * thick, to, {sigma}, noise, {pair.first.edge.kind});
  };
  RingEdge near = best(circle.radius + 1.6 * thick);
  if (near.score >= kSecondScore && near.amplitude >= 0.5 * faint) return near;
  RingEdge far = best(kWidest_ratio * circle.radius);
  if (far.score >= kFarScore && far.amplitude >= kFarAmplitude * faint) return far;
  return std::nullopt;
}

// The second membrane, and the third: what lies beside the edge found first.
DetectedCell with_second_membrane(const Pyramid& pyramid, const RingEdge& first, double sigma) {
  const GrayImage& image = pyramid.levels.front();
  const double noise = pyramid.noises.front();
  DetectedCell cell;
  cell.outer = first.edge;
  cell.circle = first.circle;
  const Eigen::Vector2d center = first.circle.center;
  const double radius = first.circle.radius;
  const EdgeKind kind = first.edge.kind;

  // Two dark lines; found once, the pair centres its own ring for a second look. Where a dark body's border was found
  // first, one of them must lie on it: the zona's inner edge, or its outer one.
  const auto is_on_first = [&](const RingEdge& line) {
    return std::abs(line.circle.radius - radius) < kSameEdge * radius;
  };
  if (kind.line > 0.0 || kind.step > 0.0) {
    auto pair = pair_in_ring(image, center, radius, sigma, noise);
    if (pair && (kind.line > 0.0 || is_on_first(pair->first) || is_on_first(pair->second))) {
      const contour::Circle better = pair->first.circle;
      const std::pair known{better.radius, pair->second.circle.radius};
      if (auto again = pair_in_ring(image, better.center, better.radius, sigma, noise, &known)) pair = std::move(again);
      cell.outer = pair->first.edge;
      cell.inner = pair->second.edge;
      cell.circle = pair->first.circle;
      if (auto third = line_round(image, *pair, sigma, noise)) {
        cell.oolemma = std::exchange(cell.inner, std::exchange(cell.outer, std::move(third->edge)));
        cell.circle = third->circle;
      }
      return cell;
    }
  }

  // The better of the rings just outside and just inside: of the same kind (else it is the first one's halo), and not
  // much fainter (else a fringe).
  const auto near_one = [&](double from, double to) {
    RingEdge near = best_in_ring(image, center, from, to, {sigma}, noise, {kind});
    if (near.amplitude < 0.35 * first.amplitude) near.score = 0.0;
    return near;
  };
  const double apart = 3.0 * std::max(sigma, kBroadLine_px);
  RingEdge outside = near_one(radius + apart, 1.35 * radius);
  if (outside.score < kSecondScore) {
    // Further out a line counts that is the stronger one: the first was an oval cell's inner edge under a thick zona.
    RingEdge further = near_one(radius + apart, kWidest_ratio * radius);
    if (further.amplitude > first.amplitude) outside = std::move(further);
  }
  RingEdge inside = near_one(0.72 * radius, radius - apart);
  if (outside.score >= kSecondScore && outside.score >= 0.8 * inside.score) {
    cell.inner = first.edge;
    cell.outer = outside.edge;
    cell.circle = outside.circle;
    return cell;
  }
  if (inside.score >= kSecondScore) {
    cell.inner = inside.edge;
    return cell;
  }

  // An oolemma alone: the soft outer edge of a thick zona, and the gap between the two.
  // A difference far below the line's own contrast is a halo's tail or a stain, not a border.
  if (kind.line <= 0.0) return cell;
  const double least_contrast = std::hypot(noise, kFaintest * first.amplitude);
  if (auto soft = find_soft_outer_edge(image, first.edge, first.circle, least_contrast)) {
    cell.outer = std::move(*soft);
    cell.inner = first.edge;
    cell.circle = contour::fit_circle(cell.outer.points, 0.06 * radius);
    if (auto gap = find_gap_edge(image, first.edge, first.circle, cell.outer, least_contrast)) {
      cell.oolemma = std::move(cell.inner);
      cell.inner = std::move(gap);
    }
  }
  return cell;
}

}  // namespace

bool can_be_a_cell(const GrayImage& image, const Eigen::Matrix2Xd& outline) {
  const double area = std::abs(contour::signed_area(outline)), side = image.width + image.height;
  return area > 1.0 && area < side * side && outline.cwiseAbs().maxCoeff() < 2.0 * side;
}

std::optional<DetectedCell> detect_cell(const GrayImage& image, const TrackerOptions& options,
                                        const DetectionHint* hint, const contour::Circle* elsewhere) {
  const Pyramid pyramid(image, options);
  const bool drawn = hint != nullptr && hint->is_drawn();
  if (drawn && !can_be_a_cell(pyramid.levels.front(), hint->outline)) return std::nullopt;
  const std::optional<Eigen::Vector2d> inside = hint != nullptr && !drawn ? std::optional(hint->inside) : std::nullopt;
  // A person has said that there is a cell: less evidence will do.
  const double needed = (hint != nullptr ? kHintShare : 1.0) * options.min_detection_score;

  Judged best =
      drawn ? judge_drawn(pyramid, hint->outline, needed) : best_candidate(pyramid, options, inside, elsewhere);
  if (drawn && !acceptable(pyramid, best, options, inside)) best = {};

  // Unsure, or time does not count: a level set from the best guess, which may do better.
  const bool unsure = best.ring.score < needed && best.ring.score >= kUnsureShare * needed;
  if (unsure || drawn || options.quality == TrackerOptions::Quality::kHigh) {
    const Eigen::Matrix2Xd start = drawn ? hint->outline : at_scale(best.ring, best.scale()).edge.points;
    Judged settled = settle(pyramid, start);
    if (settled.ring.score > best.ring.score && acceptable(pyramid, settled, options, inside))
      best = std::move(settled);
  }
  if (best.ring.score < needed) return std::nullopt;

  constexpr double kSigmaRatio = 0.02;  // of the radius
  const RingEdge first = at_full_resolution(pyramid, best, kSigmaRatio);
  const double sigma = std::clamp(kSigmaRatio * first.circle.radius, kFinest_px, 2.5);
  DetectedCell cell = with_second_membrane(pyramid, first, sigma);
  if (drawn) take_drawn(hint->outline, cell);
  cell.score = best.ring.score * first.edge.coverage;
  return cell;
}

}  // namespace pellucida
