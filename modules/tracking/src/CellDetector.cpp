#include "CellDetector.h"

#include <cmath>
#include <numbers>

#include "NormalStrip.h"

namespace pellucida {
namespace {

constexpr double kSecondScore = 0.35;
constexpr std::initializer_list<EdgeKind> kAnyKind = {{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}};

// A circle's points, with their radial normals.
void ring(const Eigen::Vector2d& center, double radius, int count, Eigen::Matrix2Xd& points,
          Eigen::Matrix2Xd& normals) {
  points.resize(2, count);
  normals.resize(2, count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    normals.col(i) = Eigen::Vector2d(std::cos(angle), std::sin(angle));
    points.col(i) = center + radius * normals.col(i);
  }
}

// Spread of a feature all over a strip: 1.48 times the median of its magnitude.
double spread_of(const Eigen::MatrixXf& feature) {
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(feature.size() / 3 + 1));
  for (Eigen::Index k = 0; k < feature.size(); k += 3) values.push_back(std::abs(feature.data()[k]));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return 1.4826 * values[values.size() / 2];
}

struct RingEdge {
  FoundEdge edge;
  contour::Circle circle;
  double score = 0.0;
  double amplitude = 0.0;  // mean feature along the edge, grey value
};

// The best closed edge of one kind in a ring round a centre, `radius_from`..`radius_to` px of `image`.
RingEdge closed_edge(const GrayImage& image, const Eigen::Vector2d& center, double radius_from, double radius_to,
                     const EdgeKind& kind, double sigma, double noise, int smoothing) {
  const int count = 96;
  const double step = std::max(0.5, (radius_to - radius_from) / 120.0);
  Eigen::Matrix2Xd points, normals;
  ring(center, radius_from, count, points, normals);
  NormalStrip strip;
  strip.sample(image, points, normals, 0.0, radius_to - radius_from, step);
  const EdgeFilter filter(sigma, step, kind);
  Eigen::MatrixXf feature;
  strip.features(filter, smoothing, feature);
  const double spread = std::max({spread_of(feature), noise * filter.noise_gain() / std::sqrt(1.0 + smoothing), 1e-5});
  // Rewards saturate: a long faint edge beats a short glaring one.
  const Eigen::MatrixXf reward = (feature / static_cast<float>(spread)).cwiseMin(4.0F).cwiseMax(-2.0F);
  const std::vector<int> path = best_closed_path(reward, 2, 0.6F);

  RingEdge found;
  found.edge.kind = kind;
  found.edge.scale_px = sigma;
  found.edge.points.resize(2, count);
  double sum = 0.0;
  int seen = 0, inside = 0, leading = 0;
  for (int i = 0; i < count; ++i) {
    const int j = path[static_cast<std::size_t>(i)];
    const Eigen::Vector2d p = center + (radius_from + j * step) * normals.col(i);
    found.edge.points.col(i) = p;
    if (!image.inside(p, 1.0)) continue;
    ++inside;
    sum += reward(i, j);
    found.amplitude += feature(i, j);
    seen += reward(i, j) > 1.5F ? 1 : 0;
    leading += feature(i, j) > 0.6F * feature.row(i).maxCoeff() ? 1 : 0;
  }
  found.amplitude /= std::max(inside, 1);
  found.edge.coverage = static_cast<double>(seen) / std::max(inside, 1);
  found.edge.contrast = inside > 0 ? sum / inside : 0.0;
  found.circle = contour::fit_circle(found.edge.points, 0.06 * radius_to);
  // Complete, clear against its surroundings, round, and within the image.
  const double round = std::clamp((found.circle.inlier_ratio - 0.45) / 0.3, 0.0, 1.0);
  const double clear = std::clamp((found.edge.contrast - 1.3) / 1.7, 0.0, 1.0);
  const double whole = std::clamp((static_cast<double>(inside) / count - 0.6) / 0.3, 0.0, 1.0);
  // In clutter other edges of the same profile are stronger every now and then; a cell's edge leads nearly everywhere.
  const double leads = std::clamp((static_cast<double>(leading) / std::max(inside, 1) - 0.45) / 0.35, 0.0, 1.0);
  found.score = found.edge.coverage * clear * round * whole * leads;
  return found;
}

// A cell lets light through: a pigmented body (an eye, a speck) does not.
bool translucent(const GrayImage& image, const contour::Circle& circle) {
  std::vector<float> in, out;
  for (int k = 0; k < 64; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 64;
    const Eigen::Vector2d d(std::cos(angle), std::sin(angle));
    for (const double f : {0.25, 0.4, 0.55, 0.7, 0.85})
      in.push_back(image.sample(circle.center + f * circle.radius * d));
    for (const double f : {1.25, 1.4}) {
      const Eigen::Vector2d p = circle.center + f * circle.radius * d;
      if (image.inside(p)) out.push_back(image.sample(p));
    }
  }
  if (out.size() < 16) return true;
  const auto middle = [](std::vector<float>& v) {
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
  };
  const float medium = middle(out);
  const auto black = std::count_if(in.begin(), in.end(), [&](float v) { return v < 0.25F * medium; });
  return middle(in) > 0.35F * medium && static_cast<double>(black) < 0.12 * static_cast<double>(in.size());
}

// Looks in a ring for the best closed edge of any kind, at a fine and a coarse scale.
RingEdge best_in_ring(const GrayImage& image, const Eigen::Vector2d& center, double from, double to,
                      std::initializer_list<double> sigmas, double noise, std::initializer_list<EdgeKind> kinds,
                      int smoothing = 1) {
  RingEdge best;
  if (!(to > from)) return best;
  for (const double sigma : sigmas) {
    for (const EdgeKind& kind : kinds) {
      RingEdge found = closed_edge(image, center, from, to, kind, sigma, noise, smoothing);
      // A dark line has bright fringes and steps beside it: those must do clearly better to be taken for the edge
      // itself.
      if (kind.line <= 0.0) found.score *= 0.75;
      if (found.score > best.score) best = std::move(found);
    }
  }
  return best;
}

// The soft outer edge of a thick zona: a faint step, told from texture by how much stronger the best closed path of one
// polarity is than the best of the other; texture gives both alike.
RingEdge soft_step(const GrayImage& image, const Eigen::Vector2d& center, double from, double to, double sigma,
                   double noise) {
  constexpr int kSmoothing = 10;
  RingEdge best;
  if (!(to > from)) return best;
  for (const double scale : {sigma, 1.6 * sigma}) {
    RingEdge up = closed_edge(image, center, from, to, {0.0, 1.0}, scale, noise, kSmoothing);
    RingEdge down = closed_edge(image, center, from, to, {0.0, -1.0}, scale, noise, kSmoothing);
    RingEdge& strong = up.amplitude > down.amplitude ? up : down;
    const RingEdge& weak = up.amplitude > down.amplitude ? down : up;
    const double ratio = strong.amplitude / std::max(weak.amplitude, 1e-6);
    const double round = std::clamp((strong.circle.inlier_ratio - 0.45) / 0.3, 0.0, 1.0);
    strong.score = round * std::clamp((ratio - 1.0) / 1.5, 0.0, 1.0);
    if (strong.score > best.score) best = strong;
  }
  return best;
}

// Judges a closed path of a strip round `center`: how much of it shows the edge, how clearly, how round it is.
void judge(const GrayImage& image, const Eigen::Vector2d& center, double radius_from, double step,
           const Eigen::Matrix2Xd& normals, const std::vector<int>& path, const Eigen::MatrixXf& feature,
           const Eigen::MatrixXf& reward, RingEdge& found) {
  const Eigen::Index count = normals.cols();
  found.edge.points.resize(2, count);
  found.amplitude = 0.0;
  double sum = 0.0;
  int seen = 0, inside = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const int j = path[static_cast<std::size_t>(i)];
    const Eigen::Vector2d p = center + (radius_from + j * step) * normals.col(i);
    found.edge.points.col(i) = p;
    if (!image.inside(p, 1.0)) continue;
    ++inside;
    sum += reward(i, j);
    seen += reward(i, j) > 1.5F ? 1 : 0;
    found.amplitude += feature(i, j);
  }
  found.amplitude /= std::max(inside, 1);
  found.edge.coverage = static_cast<double>(seen) / static_cast<double>(count);
  found.edge.contrast = sum / static_cast<double>(count);
}

// Two dark lines side by side, found together: a zona whose edges are alike would make a single path hop between them.
std::optional<std::pair<RingEdge, RingEdge>> pair_in_ring(const GrayImage& image, const Eigen::Vector2d& center,
                                                          double radius, double sigma, double noise) {
  const int count = 128;
  const double from = 0.62 * radius, to = 1.4 * radius;
  const double step = std::max(0.5, (to - from) / 110.0);
  Eigen::Matrix2Xd points, normals;
  ring(center, from, count, points, normals);
  NormalStrip strip;
  strip.sample(image, points, normals, 0.0, to - from, step);
  const EdgeFilter filter(sigma, step, {1.0, 0.0});
  Eigen::MatrixXf feature;
  strip.features(filter, 1, feature);
  const double spread = std::max({spread_of(feature), noise * filter.noise_gain(), 1e-5});
  const Eigen::MatrixXf reward = (feature / static_cast<float>(spread)).cwiseMin(4.0F).cwiseMax(-2.0F);
  const int gap_from = std::max(2, static_cast<int>(std::ceil(2.4 * sigma / step)));
  const int gap_to = std::max(gap_from + 2, static_cast<int>(0.3 * radius / step));
  const PathPair paths = best_closed_path_pair(reward, reward, gap_from, gap_to, 0.5F, 0.9F);
  RingEdge outer, inner;
  judge(image, center, from, step, normals, paths.outer, feature, reward, outer);
  judge(image, center, from, step, normals, paths.inner, feature, reward, inner);
  const double least = std::min(outer.edge.coverage, inner.edge.coverage);
  const double faint = std::min(outer.amplitude, inner.amplitude), strong = std::max(outer.amplitude, inner.amplitude);
  if (least < 0.62 || faint < 0.35 * strong) return std::nullopt;
  // Between two lines it is bright; the two shoulders of one broad line have no such valley.
  double between = 0.0;
  for (int i = 0; i < count; ++i) {
    const int middle = (paths.outer[static_cast<std::size_t>(i)] + paths.inner[static_cast<std::size_t>(i)]) / 2;
    between += feature(i, middle) / count;
  }
  if (between > 0.1 * faint) return std::nullopt;
  for (RingEdge* edge : {&outer, &inner}) {
    edge->edge.kind = {1.0, 0.0};
    edge->edge.scale_px = sigma;
    edge->circle = contour::fit_circle(edge->edge.points, 0.06 * radius);
    edge->score = edge->edge.coverage;
  }
  return std::make_pair(outer, inner);
}

}  // namespace

std::optional<DetectedCell> detect_cell(const GrayImage& image, const TrackerOptions& options, const DetectionHint*) {
  // A pyramid of halves, as far as the largest cell needs.
  std::vector<GrayImage> pyramid;
  pyramid.push_back(reduced(image, 1.0, 1));
  while (pyramid.back().width >= 96 && pyramid.back().height >= 96 && pyramid.size() < 5 &&
         20.0 * (1 << pyramid.size()) < options.max_cell_diameter_px) {
    pyramid.push_back(reduced(pyramid.back(), 0.9, 2));
  }
  std::vector<double> noises;
  for (const GrayImage& level : pyramid) noises.push_back(noise_level(level));

  // Judge each proposed centre by the closed edge round it, re-centred twice.
  RingEdge best;
  int best_level = 0;
  for (const CellCandidate& candidate : propose_cells(pyramid, options)) {
    const GrayImage& level = pyramid[static_cast<std::size_t>(candidate.level)];
    const double noise = noises[static_cast<std::size_t>(candidate.level)];
    const double scale = 1 << candidate.level;
    Eigen::Vector2d center = candidate.center / scale;
    double radius = candidate.radius / scale;
    RingEdge here;
    for (int round = 0; round < 3; ++round) {
      RingEdge found = best_in_ring(level, center, 0.55 * radius, 1.5 * radius, {1.3}, noise, kAnyKind);
      if (found.score > here.score) here = std::move(found);
      if (here.score < 0.15 || here.circle.radius < 4.0) break;
      if ((here.circle.center - center).norm() < 0.03 * radius && std::abs(here.circle.radius - radius) < 0.1 * radius)
        break;
      center = here.circle.center;
      radius = here.circle.radius;
    }
    const double diameter = 2.0 * here.circle.radius * scale;
    if (diameter < options.min_cell_diameter_px || diameter > options.max_cell_diameter_px) continue;
    if (here.score > best.score && translucent(level, here.circle)) {
      best = std::move(here);
      best_level = candidate.level;
    }
  }
  if (best.score < options.min_detection_score) return std::nullopt;

  // Down the pyramid: each level centres the ring for the next.
  const double scale = 1 << best_level;
  Eigen::Vector2d center = best.circle.center * scale;
  double radius = best.circle.radius * scale;
  for (int level = best_level - 1; level >= 1; --level) {
    const double here = 1 << level;
    const RingEdge found =
        best_in_ring(pyramid[static_cast<std::size_t>(level)], center / here, 0.72 * radius / here, 1.3 * radius / here,
                     {1.3}, noises[static_cast<std::size_t>(level)], {best.edge.kind, {1.0, 0.0}});
    if (found.score < 0.3) continue;
    center = found.circle.center * here;
    radius = found.circle.radius * here;
  }

  // The same edge at full resolution, in a narrow ring; a dark line where there is one.
  const GrayImage& fine = pyramid.front();
  const double fine_noise = noises.front();
  const double sigma_fine = std::clamp(0.02 * radius, 1.2, 2.5);
  RingEdge first = best_in_ring(fine, center, 0.75 * radius, 1.25 * radius, {sigma_fine, 2.0 * sigma_fine}, fine_noise,
                                {best.edge.kind, {1.0, 0.0}});
  if (first.score < 0.5 * best.score) {
    first = best;
    first.edge.points *= scale;
    first.circle.center *= scale;
    first.circle.radius *= scale;
    first.edge.scale_px *= scale;
  }

  // The second membrane: the better of the rings just outside and just inside.
  const Eigen::Vector2d c = first.circle.center;
  const double r = first.circle.radius;
  const double gap = 1.5 * sigma_fine;
  // A near one must be of the same kind (else it is the first one's halo), and not much fainter (else a fringe); a far
  // one may be the soft outer edge of a thick zona.
  const EdgeKind same = first.edge.kind;
  const auto near_one = [&](double from, double to) {
    RingEdge near = best_in_ring(fine, c, from, to, {sigma_fine}, fine_noise, {same});
    if (near.amplitude < 0.35 * first.amplitude) near.score = 0.0;
    return near;
  };
  RingEdge outside = near_one(r + 2.0 * gap, 1.35 * r);
  RingEdge inside = near_one(0.72 * r, r - 2.0 * gap);
  if (outside.score < kSecondScore && inside.score < kSecondScore && same.line > 0.0) {
    outside = soft_step(fine, c, 1.13 * r, 1.55 * r, 0.025 * r + 1.0, fine_noise);
    if (outside.amplitude < 0.06 * first.amplitude) outside.score = 0.0;
  }

  DetectedCell cell;
  cell.score = best.score * first.edge.coverage;
  if (same.line > 0.0) {
    // Found once, the pair centres its own ring for a second look.
    auto pair = pair_in_ring(fine, c, r, sigma_fine, fine_noise);
    if (pair) {
      const contour::Circle& better = pair->first.circle;
      if (auto again = pair_in_ring(fine, better.center, better.radius, sigma_fine, fine_noise)) pair = again;
    }
    if (pair) {
      cell.outer = pair->first.edge;
      cell.inner = pair->second.edge;
      cell.circle = pair->first.circle;
      return cell;
    }
  }
  cell.outer = first.edge;
  cell.circle = first.circle;
  if (outside.score >= kSecondScore && outside.score >= 0.8 * inside.score) {
    cell.inner = first.edge;
    cell.outer = outside.edge;
    cell.circle = outside.circle;
  } else if (inside.score >= kSecondScore) {
    cell.inner = inside.edge;
  }
  return cell;
}

}  // namespace pellucida
