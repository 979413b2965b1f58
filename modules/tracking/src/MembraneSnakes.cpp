#include "MembraneSnakes.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

constexpr double kStep = 0.5;            // px between samples on a normal
constexpr double kSearchStep = 1.0;      // the same in the search for where an edge roughly is
constexpr double kLeastWorth = 0.30;     // agreement times score of a contour that counts
constexpr double kSoftRigidity = 20.0;   // times the rigidity, for a faint step that single normals see badly
constexpr double kLeastSureness = 0.26;  // the same of the surer contour, times the detection's score
constexpr double kNeedleMargin = 2.5;    // px: half width of the needle's own dark edge, with its halo

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Feature in units of the learnt strength, bounded: a glaring speck counts no more than the membrane itself.
Eigen::MatrixXf as_reward(const Eigen::MatrixXf& feature, double strength) {
  return (feature / static_cast<float>(strength)).cwiseMin(1.3F).cwiseMax(-0.6F);
}

}  // namespace

void MembraneSnakes::learn_strength(const FrameSampler& image, SnakeContour& snake, const NeedleZone* needle) {
  const Eigen::Matrix2Xd normals = contour::outward_normals(snake.points);
  strip_.sample(image, snake.points, normals, 6.0 * snake.scale_px, 6.0 * snake.scale_px, kStep);
  const EdgeFilter filter(snake.scale_px, kStep, snake.kind);
  strip_.features(filter, snake.is_soft() ? 8 : 1, feature_);
  std::vector<double> heights;
  const int middle = static_cast<int>(std::lround(strip_.column_of(0.0))),
            reach = static_cast<int>(std::ceil(2.0 / kStep));
  Eigen::VectorXf row(strip_.columns());
  // The mean profile about the filter's own peak, over the reach of the filter.
  constexpr int kLook = 33;
  const double kLookStep = 0.25 * snake.scale_px;
  Eigen::VectorXd mean_profile = Eigen::VectorXd::Zero(kLook);
  const auto value_at = [&](int i, double column) {
    const int whole = std::clamp(static_cast<int>(column), 0, strip_.columns() - 2);
    const double t = std::clamp(column - whole, 0.0, 1.0);
    return (1.0 - t) * strip_.profile(i)[whole] + t * strip_.profile(i)[whole + 1];
  };
  double aligned = 0.0;
  for (int i = 0; i < strip_.rows(); ++i) {
    if (needle && needle->covers(snake.points.col(i), 6.0)) continue;
    row = feature_.row(i).transpose();
    const Peak peak = climb_to_peak(row.data(), strip_.columns(), middle, reach);
    heights.push_back(peak.height);
    if (peak.curvature >= 0.0) continue;
    for (int k = 0; k < kLook; ++k) mean_profile[k] += value_at(i, peak.position + (k - kLook / 2) * kLookStep / kStep);
    aligned += 1.0;
  }
  if (aligned > 20.0 && snake.kind.step == 0.0) {
    // The line's own centre against the filter's peak, which steps and fringes beside the line pull aside: the extremum
    // of the mean profile, by a parabola through its inner pixels.
    double s2 = 0.0, s4 = 0.0, sv = 0.0, s1v = 0.0, s2v = 0.0;
    const int inner = 3;
    for (int k = -inner; k <= inner; ++k) {
      const double x = kLookStep * k, v = mean_profile[k + kLook / 2] / aligned;
      s2 += x * x;
      s4 += x * x * x * x;
      sv += v;
      s1v += x * v;
      s2v += x * x * v;
    }
    const double count = 2 * inner + 1, quadratic = (s2v - s2 * sv / count) / (s4 - s2 * s2 / count);
    const double linear = s1v / s2;
    if (quadratic * snake.kind.line > 0.0) {
      const double offset = std::clamp(-0.5 * linear / quadratic, -0.8, 0.8);
      snake.center_offset_px = snake.strength > 0.0 ? 0.8 * snake.center_offset_px + 0.2 * offset : offset;
    }
  }
  // How alike the profiles are all round: one membrane has one look, a chance ring of edges has many.
  if (aligned > 20.0) {
    const Eigen::VectorXd look = (mean_profile.array() - mean_profile.mean()).matrix().normalized();
    double alike = 0.0;
    int rows = 0;
    for (int i = 0; i < strip_.rows(); ++i) {
      if (needle && needle->covers(snake.points.col(i), 6.0)) continue;
      row = feature_.row(i).transpose();
      const Peak peak = climb_to_peak(row.data(), strip_.columns(), middle, reach);
      Eigen::VectorXd own(kLook);
      for (int k = 0; k < kLook; ++k) own[k] = value_at(i, peak.position + (k - kLook / 2) * kLookStep / kStep);
      own.array() -= own.mean();
      const double norm = own.norm();
      alike += norm > 0.0 ? std::max(0.0, own.dot(look) / norm) : 0.0;
      ++rows;
    }
    const double agreement = rows > 0 ? alike / rows : 0.0;
    snake.agreement = snake.strength > 0.0 ? 0.9 * snake.agreement + 0.1 * agreement : agreement;
  }
  const double now = median_of(std::move(heights));
  if (now <= 0.0) return;
  snake.strength = snake.strength > 0.0 ? 0.9 * snake.strength + 0.1 * now : now;
}

bool MembraneSnakes::start(const FrameSampler& image, const DetectedCell& cell, double noise,
                           const NeedleZone* needle) {
  const auto take = [&](const FoundEdge& edge, SnakeContour& snake) {
    snake = {};
    snake.kind = edge.kind;
    // A line is followed at the finest scale; a soft step keeps the scale it was found at.
    snake.scale_px = edge.kind.line != 0.0 ? std::min(edge.scale_px, options_.edge_scale_px) : edge.scale_px;
    snake.points = contour::resample(contour::positively_oriented(edge.points), options_.contour_point_count);
    learn_strength(image, snake, needle);
  };
  inner_ = {};
  thickness_ = 0.0;
  take(cell.outer, outer_);
  if (cell.inner) take(*cell.inner, inner_);
  // Learn the look again each time the contour lies better on its edge.
  const auto settle = [&](SnakeContour& snake, bool is_outer) {
    for (int round = 0; round < 4; ++round) {
      refine(image, noise, snake, needle, is_outer, 3.0);
      snake.points = contour::resample(snake.points, options_.contour_point_count);
      snake.strength = 0.0;
      learn_strength(image, snake, needle);
    }
    refine(image, noise, snake, needle, is_outer, 2.0);
  };
  settle(outer_, true);
  if (has_inner()) settle(inner_, false);

  // A ring of chance edges is uneven in strength and in look; a membrane is not. The surer of the two must convince,
  // the other one must at least hold out; two that ended on the same line are one.
  const auto worth = [](const SnakeContour& snake) { return snake.agreement * snake.score; };
  if (has_inner()) {
    const double apart = median_gap();
    if (apart < 2.2 * std::min(outer_.scale_px, inner_.scale_px) || worth(inner_) < kLeastWorth) {
      if (worth(inner_) > worth(outer_)) std::swap(outer_, inner_);
      inner_ = {};
    } else if (worth(outer_) < kLeastWorth) {
      std::swap(outer_, inner_);
      inner_ = {};
    }
  }
  sureness_ = std::max(worth(outer_), has_inner() ? worth(inner_) : 0.0) * cell.score;
  if (sureness_ < kLeastSureness) return false;
  if (has_inner()) thickness_ = median_gap();
  return true;
}

double MembraneSnakes::median_gap() const {
  std::vector<double> gaps;
  for (Eigen::Index i = 0; i < outer_.points.cols(); i += 2)
    gaps.push_back(contour::distance_to(inner_.points, outer_.points.col(i)));
  return median_of(std::move(gaps));
}

void MembraneSnakes::search_pair(const FrameSampler& image, const NeedleZone* needle, double search_px) {
  const Eigen::Matrix2Xd normals = contour::outward_normals(outer_.points);
  const double reach_in = search_px + (has_inner() ? 1.6 * thickness_ : 0.0);
  strip_.sample(image, outer_.points, normals, reach_in + 3.0, search_px + 3.0, kSearchStep);
  strip_.features(EdgeFilter(outer_.scale_px, kSearchStep, outer_.kind), 1, feature_);
  reward_outer_ = as_reward(feature_, outer_.strength);
  if (has_inner()) {
    strip_.features(EdgeFilter(inner_.scale_px, kSearchStep, inner_.kind), 1, feature_);
    reward_inner_ = as_reward(feature_, inner_.strength);
  }
  // The needle's own edges say nothing about a membrane; the tip itself does, once it touches.
  if (needle) {
    for (int i = 0; i < strip_.rows(); ++i) {
      for (int j = 0; j < strip_.columns(); ++j) {
        const Eigen::Vector2d p = outer_.points.col(i) + strip_.offset_of(j) * normals.col(i);
        if (!needle->covers(p, kNeedleMargin)) continue;
        const Eigen::Vector2d d = p - needle->tip;
        const double ahead = d.dot(needle->direction);
        const double across = std::abs(needle->direction.x() * d.y() - needle->direction.y() * d.x());
        reward_outer_(i, j) = 0.0F;
        if (needle->touching && across < needle->tip_half_width) {
          reward_outer_(i, j) = static_cast<float>(1.6 * std::exp(-0.5 * ahead * ahead) - 0.3);
        }
        if (has_inner() && ahead < 1.0) reward_inner_(i, j) = needle->touching ? -0.3F : 0.0F;
      }
    }
  }
  // Not further out or in than asked.
  const int low = static_cast<int>(strip_.column_of(-search_px)), high = static_cast<int>(strip_.column_of(search_px));
  reward_outer_.leftCols(std::max(0, low)).setConstant(-2.0F);
  reward_outer_.rightCols(std::max(0, strip_.columns() - 1 - high)).setConstant(-2.0F);

  constexpr float kSlope = 0.2F, kGap = 0.2F;
  std::vector<int> outer_path, inner_path;
  if (has_inner()) {
    const int gap_from = std::max(2, static_cast<int>(0.45 * thickness_ / kSearchStep));
    const int gap_to = static_cast<int>(std::ceil(1.5 * thickness_ / kSearchStep));
    PathPair pair = best_closed_path_pair(reward_outer_, reward_inner_, gap_from, gap_to, kSlope, kGap);
    outer_path = std::move(pair.outer);
    inner_path = std::move(pair.inner);
  } else {
    outer_path = best_closed_path(reward_outer_, 1, kSlope);
  }
  Eigen::Matrix2Xd outer(2, strip_.rows()), inner(2, strip_.rows());
  for (int i = 0; i < strip_.rows(); ++i) {
    outer.col(i) = outer_.points.col(i) + strip_.offset_of(outer_path[static_cast<std::size_t>(i)]) * normals.col(i);
    if (has_inner())
      inner.col(i) = outer_.points.col(i) + strip_.offset_of(inner_path[static_cast<std::size_t>(i)]) * normals.col(i);
  }
  outer_.points = contour::resample(outer, options_.contour_point_count);
  if (has_inner()) inner_.points = contour::resample(inner, options_.contour_point_count);
}

void MembraneSnakes::refine(const FrameSampler& image, double noise, SnakeContour& snake, const NeedleZone* needle,
                            bool is_outer, double reach_px) {
  const Eigen::Index n = snake.points.cols();
  const EdgeFilter filter(snake.scale_px, kStep, snake.kind);
  const double margin = reach_px + 4.0 * snake.scale_px;
  Eigen::VectorXd edges(n), weights(n), rigidity(n), curvature(n);
  snake.confidence.resize(n);
  snake.sigma_px.resize(n);
  const Eigen::Matrix2Xd normals = contour::outward_normals(snake.points);
  strip_.sample(image, snake.points, normals, margin, margin, kStep);
  strip_.features(filter, snake.is_soft() ? 8 : 1, feature_);
  const double smoothing_gain = snake.is_soft() ? 0.37 : 0.61;  // of (1 2 1) / 4, so many times over
  const double noise_feature = noise * filter.noise_gain() * smoothing_gain;
  const int middle = static_cast<int>(std::lround(strip_.column_of(0.0)));
  const int reach = static_cast<int>(std::ceil(reach_px / kStep));
  Eigen::VectorXf row(strip_.columns());
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d p = snake.points.col(i);
    row = feature_.row(i).transpose();
    const Peak peak = climb_to_peak(row.data(), strip_.columns(), middle, reach);
    edges[i] = strip_.offset_of(peak.position) + snake.center_offset_px;
    const double relative = snake.strength > 0.0 ? peak.height / snake.strength : 0.0;
    const double clear = std::clamp((peak.height - 2.0 * noise_feature) / std::max(snake.strength, 1e-6), 0.0, 1.0);
    weights[i] = peak.curvature < 0.0 ? clear : 0.0;
    snake.confidence[i] = peak.curvature < 0.0 ? std::clamp(1.4 * clear, 0.0, 1.0) : 0.0;
    (void)relative;
    curvature[i] = -peak.curvature / (kStep * kStep);
    snake.sigma_px[i] = curvature[i] > 1e-9
                            ? std::min(reach_px, noise * filter.slope_noise_gain() * smoothing_gain / curvature[i])
                            : reach_px;
    rigidity[i] = options_.rigidity * (snake.is_soft() ? kSoftRigidity : 1.0);
    if (!needle) continue;

    // Softer near the tip, where the dimple is sharp.
    const double reach_of_tip = 6.0 * needle->tip_half_width + 12.0;
    const double distance = (p - needle->tip).norm();
    if (needle->touching && distance < reach_of_tip) {
      const double t = distance / reach_of_tip;
      rigidity[i] = options_.tip_rigidity * std::pow(options_.rigidity / options_.tip_rigidity, t * t);
    }
    if (!needle->covers(p + edges[i] * normals.col(i), kNeedleMargin) && !needle->covers(p, kNeedleMargin)) continue;
    const Eigen::Vector2d d = p - needle->tip;
    const double across = std::abs(needle->direction.x() * d.y() - needle->direction.y() * d.x());
    const double along = normals.col(i).dot(needle->direction);
    if (is_outer && needle->touching && across < needle->tip_half_width && along < -0.5) {
      // Under the tip the membrane is where the tip's front is.
      edges[i] = -d.dot(needle->direction) / along;
      weights[i] = 1.0;
      snake.confidence[i] = 0.8;
      snake.sigma_px[i] = 0.5;
    } else if (is_outer || !needle->touching || d.dot(needle->direction) < 1.0) {
      // On the shaft: hidden. The rigidity bridges the gap.
      weights[i] = 0.0;
      snake.confidence[i] = 0.3;
      snake.sigma_px[i] = 1.5;
    }
  }
  const Eigen::VectorXd& u = snake_.relax(snake.points, normals, edges, weights, rigidity, options_.elasticity);

  // Sigma: noise on one normal, what neighbours disagree, both averaged over the points the rigidity ties together.
  double score = 0.0, count = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    double squares = 0.0, weight = 0.0;
    for (Eigen::Index k = -6; k <= 6; ++k) {
      const Eigen::Index j = contour::wrap(i + k, n);
      squares += weights[j] * (u[j] - edges[j]) * (u[j] - edges[j]);
      weight += weights[j];
    }
    const double scatter = weight > 0.0 ? squares / weight : 1.0;
    const double tied = std::max(1.0, 2.2 * std::pow(rigidity[i], 0.25));
    snake.sigma_px[i] = std::sqrt((snake.sigma_px[i] * snake.sigma_px[i] + scatter) / tied) * 1.3 + 0.07;
    if (!needle || !needle->covers(snake.points.col(i), kNeedleMargin)) {
      score += snake.confidence[i];
      count += 1.0;
    }
  }
  snake.score = count > 0.0 ? score / count : 0.0;
  for (Eigen::Index i = 0; i < n; ++i) snake.points.col(i) += std::clamp(u[i], -reach_px, reach_px) * normals.col(i);
}

double MembraneSnakes::track(const FrameSampler& image, double noise, const Eigen::Vector2d& shift,
                             const Eigen::Vector2d& push, const NeedleZone* needle, double search_px) {
  // Predict: the cell moves with its holder, the dimple with the needle.
  const auto predict = [&](Eigen::Matrix2Xd& points) {
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      Eigen::Vector2d move = shift;
      if (needle && needle->touching) {
        const double reach = 3.0 * needle->tip_half_width + 8.0;
        const double t = (points.col(i) + push - needle->tip).norm() / reach;
        move += std::exp(-0.5 * t * t) * (push - shift);
      }
      points.col(i) += move;
    }
  };
  predict(outer_.points);
  outer_.points = contour::resample(outer_.points, options_.contour_point_count);
  if (has_inner()) predict(inner_.points);

  // A global search of the band, then the snakes to sub-pixel.
  search_pair(image, needle, search_px);
  for (int round = 0; round < options_.snake_iterations; ++round) {
    refine(image, noise, outer_, needle, true, 2.0);
    if (round + 1 < options_.snake_iterations) {
      const Eigen::Matrix2Xd even = contour::resample(outer_.points, options_.contour_point_count);
      outer_.points = even;
    }
    if (!has_inner()) continue;
    refine(image, noise, inner_, needle, false, 2.0);
    if (round + 1 < options_.snake_iterations)
      inner_.points = contour::resample(inner_.points, options_.contour_point_count);
  }
  if (outer_.score > 0.6) {
    learn_strength(image, outer_, needle);
    if (has_inner() && inner_.score > 0.6) learn_strength(image, inner_, needle);
  }
  return outer_.score;
}

}  // namespace pellucida
