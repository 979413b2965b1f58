#include "RingSearch.h"

#include <cmath>
#include <numbers>

namespace pellucida {
namespace {

constexpr double kLeastSpread = 0.125;  // of what the feature reaches
constexpr float kShows = 1.5F;          // an edge shows where its feature is that many times the ring's own spread

// A circle's points, and what points away from its centre there.
void circle_points(const Eigen::Vector2d& center, double radius, int count, Eigen::Matrix2Xd& points,
                   Eigen::Matrix2Xd& normals) {
  points.resize(2, count);
  normals.resize(2, count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    normals.col(i) = Eigen::Vector2d(std::cos(angle), std::sin(angle));
    points.col(i) = center + radius * normals.col(i);
  }
}

// A ring unrolled: row i is a ray from base point i outwards, column j the distance j step along it.
class Ring {
 public:
  Ring(const GrayImage& image, Eigen::Matrix2Xd base, Eigen::Matrix2Xd directions, double width, int most_columns)
      : image_(image),
        step_(std::max(0.5, width / most_columns)),
        base_(std::move(base)),
        directions_(std::move(directions)) {
    const int columns = static_cast<int>(std::floor(width / step_)) + 1;
    values_.resize(base_.cols(), columns);
    std::vector<float> profile(static_cast<std::size_t>(columns));
    for (int i = 0; i < rays(); ++i) {
      image.sample_line(base_.col(i), step_ * directions_.col(i), columns, profile.data());
      for (int j = 0; j < columns; ++j) values_(i, j) = profile[static_cast<std::size_t>(j)];
    }
  }

  int rays() const noexcept { return static_cast<int>(values_.rows()); }
  int columns() const noexcept { return static_cast<int>(values_.cols()); }
  double step() const noexcept { return step_; }
  Eigen::Vector2d point(int ray, int column) const { return base_.col(ray) + column * step_ * directions_.col(ray); }
  bool inside(const Eigen::Vector2d& p) const noexcept { return image_.inside(p, 1.0); }

  // The feature everywhere, smoothed once over neighbouring rays; the border value continues outside.
  void features(const EdgeFilter& filter, Eigen::MatrixXf& out) const {
    const std::vector<float>& kernel = filter.kernel();
    const int half = static_cast<int>(kernel.size() / 2), last = columns() - 1, n = rays();
    Eigen::MatrixXf sharp = Eigen::MatrixXf::Zero(n, columns());
    for (int j = 0; j <= last; ++j)
      for (int k = -half; k <= half; ++k)
        sharp.col(j) += kernel[static_cast<std::size_t>(k + half)] * values_.col(std::clamp(j + k, 0, last));
    out = 0.5F * sharp;
    out.topRows(n - 1) += 0.25F * sharp.bottomRows(n - 1);
    out.bottomRows(n - 1) += 0.25F * sharp.topRows(n - 1);
    out.row(0) += 0.25F * sharp.row(n - 1);
    out.row(n - 1) += 0.25F * sharp.row(0);
  }

 private:
  const GrayImage& image_;
  double step_;
  Eigen::Matrix2Xd base_, directions_;
  Eigen::MatrixXf values_;  // (rays x columns): filters run over whole columns
};

// Spread of a feature all over a ring: 1.48 times the median of its magnitude.
double spread_of(const Eigen::MatrixXf& feature) {
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(feature.size() / 3 + 1));
  for (Eigen::Index k = 0; k < feature.size(); k += 3) values.push_back(std::abs(feature.data()[k]));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return 1.4826 * values[values.size() / 2];
}

// What a feature reaches on half the rays.
double usual_peak(const Eigen::MatrixXf& feature) {
  std::vector<float> peaks(static_cast<std::size_t>(feature.rows()));
  for (Eigen::Index i = 0; i < feature.rows(); ++i)
    peaks[static_cast<std::size_t>(i)] = feature.row(i).cwiseAbs().maxCoeff();
  std::nth_element(peaks.begin(), peaks.begin() + static_cast<std::ptrdiff_t>(peaks.size() / 2), peaks.end());
  return peaks[peaks.size() / 2];
}

// Rewards saturate: a long faint edge beats a short glaring one.
Eigen::MatrixXf reward_of(const Eigen::MatrixXf& feature, double spread) {
  return (feature / static_cast<float>(spread)).cwiseMin(4.0F).cwiseMax(-2.0F);
}

// Judges one closed path of a ring.
RingEdge judge(const Ring& ring, const std::vector<int>& path, const Eigen::MatrixXf& feature,
               const Eigen::MatrixXf& reward, double tolerance, bool shape_known) {
  const int count = ring.rays();
  RingEdge found;
  found.edge.points.resize(2, count);
  double sum = 0.0;
  int seen = 0, inside = 0, leading = 0;
  for (int i = 0; i < count; ++i) {
    const int j = path[static_cast<std::size_t>(i)];
    const Eigen::Vector2d p = ring.point(i, j);
    found.edge.points.col(i) = p;
    if (!ring.inside(p)) continue;
    ++inside;
    sum += reward(i, j);
    found.amplitude += feature(i, j);
    seen += reward(i, j) > kShows ? 1 : 0;
    leading += feature(i, j) > 0.6F * feature.row(i).maxCoeff() ? 1 : 0;
  }
  const int visible = std::max(inside, 1);
  found.amplitude /= visible;
  found.edge.coverage = static_cast<double>(seen) / visible;
  found.edge.contrast = sum / visible;
  found.circle = contour::fit_circle(found.edge.points, tolerance);
  // Complete, clear against its surroundings, round, and within the image.
  const double round = shape_known ? 1.0 : std::clamp((found.circle.inlier_ratio - 0.45) / 0.3, 0.0, 1.0);
  const double clear = std::clamp((found.edge.contrast - 1.3) / 1.7, 0.0, 1.0);
  const double whole = std::clamp((static_cast<double>(inside) / count - 0.6) / 0.3, 0.0, 1.0);
  // In clutter other edges of the same profile are stronger every now and then; a cell's edge leads nearly everywhere.
  const double leads = std::clamp((static_cast<double>(leading) / visible - 0.45) / 0.35, 0.0, 1.0);
  found.score = found.edge.coverage * clear * round * whole * leads;
  return found;
}

// The best closed edge of the kinds and scales given.
RingEdge best_of(const Ring& ring, std::initializer_list<double> sigmas, double noise,
                 std::initializer_list<EdgeKind> kinds, double tolerance, bool shape_known) {
  RingEdge best;
  Eigen::MatrixXf feature, signed_feature, reward;
  for (const double sigma : sigmas) {
    EdgeKind filtered{0.0, 0.0};
    double spread = 0.0;
    for (const EdgeKind& kind : kinds) {
      // A kind and its negative share one filtering.
      const bool same = kind.line == filtered.line && kind.step == filtered.step;
      const bool negative = kind.line == -filtered.line && kind.step == -filtered.step;
      if (!same && !negative) {
        const EdgeFilter filter(sigma, ring.step(), kind);
        ring.features(filter, feature);
        // On a plain background rewards would saturate all across a clear edge, and the path cut its corners.
        spread = std::max({spread_of(feature), noise * filter.noise_gain() / std::sqrt(2.0),
                           kLeastSpread * usual_peak(feature), 1e-5});
        filtered = kind;
      }
      signed_feature = negative ? Eigen::MatrixXf(-feature) : feature;
      reward = reward_of(signed_feature, spread);
      RingEdge found = judge(ring, best_closed_path(reward, 2, 0.6F), signed_feature, reward, tolerance, shape_known);
      found.edge.kind = kind;
      found.edge.scale_px = sigma;
      // A dark line has bright fringes and steps beside it: those must do clearly better to be taken for the edge
      // itself.
      if (kind.line <= 0.0) found.score *= 0.75;
      if (found.score > best.score) best = std::move(found);
    }
  }
  return best;
}

}  // namespace

RingEdge best_in_ring(const GrayImage& image, const Eigen::Vector2d& center, double from, double to,
                      std::initializer_list<double> sigmas, double noise, std::initializer_list<EdgeKind> kinds,
                      int rays) {
  if (!(to > from)) return {};
  Eigen::Matrix2Xd points, normals;
  circle_points(center, from, rays, points, normals);
  return best_of(Ring(image, std::move(points), std::move(normals), to - from, 120), sigmas, noise, kinds, 0.06 * to,
                 false);
}

RingEdge best_along(const GrayImage& image, const Eigen::Matrix2Xd& outline, double inward, double outward,
                    std::initializer_list<double> sigmas, double noise, std::initializer_list<EdgeKind> kinds,
                    int rays) {
  Eigen::Matrix2Xd points = contour::resample(outline, rays);
  const double tolerance = 0.06 * std::sqrt(std::max(0.0, contour::signed_area(points)) / std::numbers::pi);
  Eigen::Matrix2Xd normals = contour::outward_normals(points);
  points -= inward * normals;
  return best_of(Ring(image, std::move(points), std::move(normals), inward + outward, 120), sigmas, noise, kinds,
                 tolerance, true);
}

std::optional<std::pair<RingEdge, RingEdge>> pair_in_ring(const GrayImage& image, const Eigen::Vector2d& center,
                                                          double radius, double sigma, double noise,
                                                          const std::pair<double, double>* known) {
  // A first look is coarse; a second one round what is known is fine.
  const double from = known ? known->second - 0.12 * radius : 0.62 * radius;
  const double to = known ? known->first + 0.12 * radius : 1.4 * radius;
  Eigen::Matrix2Xd points, normals;
  circle_points(center, from, 128, points, normals);
  const Ring ring(image, std::move(points), std::move(normals), to - from, 110);
  const EdgeFilter filter(sigma, ring.step(), {1.0, 0.0});
  Eigen::MatrixXf feature;
  ring.features(filter, feature);
  const Eigen::MatrixXf reward = reward_of(feature, std::max({spread_of(feature), noise * filter.noise_gain(), 1e-5}));
  const int gap_from = std::max(2, static_cast<int>(std::ceil(2.4 * sigma / ring.step())));
  const double widest = known ? 1.5 * (known->first - known->second) : 0.3 * radius;
  int gap_to = std::max(gap_from + 2, static_cast<int>(widest / ring.step()));
  RingEdge outer, inner;
  for (bool found = false; !found;) {
    const PathPair paths = best_closed_path_pair(reward, reward, gap_from, gap_to, 0.5F, 0.9F);
    outer = judge(ring, paths.outer, feature, reward, 0.06 * radius, false);
    inner = judge(ring, paths.inner, feature, reward, 0.06 * radius, false);
    const double least = std::min(outer.edge.coverage, inner.edge.coverage);
    const double faint = std::min(outer.amplitude, inner.amplitude);
    // The best path through pixel noise alone reaches about twice its standard deviation.
    if (least < 0.62 || faint < 0.35 * std::max(outer.amplitude, inner.amplitude) ||
        faint < 2.5 * noise * filter.noise_gain())
      return std::nullopt;
    // Between two lines it is bright; the two shoulders of one broad line have no such valley.
    double between = 0.0, gap = 0.0;
    for (int i = 0; i < ring.rays(); ++i) {
      const int from_column = paths.inner[static_cast<std::size_t>(i)],
                to_column = paths.outer[static_cast<std::size_t>(i)];
      between += feature(i, (from_column + to_column) / 2) / ring.rays();
      gap += static_cast<double>(to_column - from_column) / ring.rays();
    }
    found = between <= 0.1 * faint;
    if (found) break;
    // A third line between them (a perivitelline gap): the two that are neighbours.
    const int nearer = static_cast<int>(0.75 * gap);
    if (between < 0.35 * faint || nearer <= gap_from || nearer >= gap_to) return std::nullopt;
    gap_to = nearer;
  }
  for (RingEdge* edge : {&outer, &inner}) {
    edge->edge.kind = {1.0, 0.0};
    edge->edge.scale_px = sigma;
    edge->score = edge->edge.coverage;
  }
  return std::make_pair(std::move(outer), std::move(inner));
}

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

}  // namespace pellucida
