#include <algorithm>
#include <cmath>

#include "ContourMath.h"
#include "Median.h"
#include "MembraneSnakes.h"

namespace pellucida {
namespace {

constexpr double kStep = 0.5;                              // px between samples on a normal
constexpr double kLeastWorth = 0.30;                       // agreement times score of a contour that counts
constexpr double kLeastSureness = 0.26;                    // the same of the surer contour, times the detection's score
constexpr double kFinestStep = 0.25, kCoarsestStep = 2.5;  // px between samples of a look

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
  double aligned = 0.0;
  for (int i = 0; i < strip_.rows(); ++i) {
    if (needle && needle->covers(snake.points.col(i), 6.0)) continue;
    row = feature_.row(i).transpose();
    const Peak peak = climb_to_peak(row.data(), strip_.columns(), middle, reach);
    heights.push_back(peak.height);
    if (peak.curvature >= 0.0) continue;
    for (int k = 0; k < kLook; ++k)
      mean_profile[k] += strip_.value(i, peak.position + (k - kLook / 2) * kLookStep / kStep);
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
      for (int k = 0; k < kLook; ++k) own[k] = strip_.value(i, peak.position + (k - kLook / 2) * kLookStep / kStep);
      own.array() -= own.mean();
      const double norm = own.norm();
      alike += norm > 0.0 ? std::max(0.0, own.dot(look) / norm) : 0.0;
      ++rows;
    }
    const double agreement = rows > 0 ? alike / rows : 0.0;
    snake.agreement = snake.strength > 0.0 ? 0.9 * snake.agreement + 0.1 * agreement : agreement;
  }
  const double now = median_of(heights);
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
  settle(image, noise, outer_, needle);
  if (has_inner()) settle(image, noise, inner_, needle);

  // A ring of chance edges is uneven in strength and in look; a membrane is not. The surer of the two must convince,
  // the other one must at least hold out; two that ended on the same line are one.
  const auto worth = [](const SnakeContour& snake) { return snake.agreement * snake.score; };
  if (has_inner()) {
    learn_thickness(needle, 1.0);
    const double apart = thickness_;
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
  learn_looks(image, noise, needle);
  return true;
}

// Learns the look again each time the contour lies better on its edge.
void MembraneSnakes::settle(const FrameSampler& image, double noise, SnakeContour& snake, const NeedleZone* needle) {
  for (int round = 0; round < 4; ++round) {
    rough_round(image, noise, snake, needle, 3.0);
    snake.points = contour::resample(snake.points, options_.contour_point_count);
    snake.strength = 0.0;
    learn_strength(image, snake, needle);
  }
  rough_round(image, noise, snake, needle, 2.0);
}

// One round of a snake that knows no more of its edge than the kind: peaks of the edge filter.
void MembraneSnakes::rough_round(const FrameSampler& image, double noise, SnakeContour& snake, const NeedleZone* needle,
                                 double reach_px) {
  const Eigen::Index n = snake.points.cols();
  const EdgeFilter filter(snake.scale_px, kStep, snake.kind);
  const double margin = reach_px + 4.0 * snake.scale_px;
  snake.confidence.setZero(n);
  snake.sigma_px.resize(n);
  edges_.setZero(n);
  sigmas_.setZero(n);  // here the weights
  rigidity_.setConstant(n, options_.rigidity * (snake.is_soft() ? kSoftRigidity : 1.0));
  contour::outward_normals(snake.points, normals_);
  strip_.sample(image, snake.points, normals_, margin, margin, kStep);
  strip_.features(filter, snake.is_soft() ? 8 : 1, feature_);
  const double noise_feature = noise * filter.noise_gain() * (snake.is_soft() ? 0.37 : 0.61);  // of the smoothing
  const int middle = static_cast<int>(std::lround(strip_.column_of(0.0)));
  const int reach = static_cast<int>(std::ceil(reach_px / kStep));
  Eigen::VectorXf row(strip_.columns());
  double score = 0.0, count = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const bool hidden = needle && needle->covers(snake.points.col(i), kNeedleMargin);
    if (hidden) continue;
    row = feature_.row(i).transpose();
    const Peak peak = climb_to_peak(row.data(), strip_.columns(), middle, reach);
    const double clear = std::clamp((peak.height - 2.0 * noise_feature) / std::max(snake.strength, 1e-6), 0.0, 1.0);
    if (peak.curvature < 0.0) {
      edges_[i] = strip_.offset_of(peak.position) + snake.center_offset_px;
      snake.confidence[i] = std::clamp(1.4 * clear, 0.0, 1.0);
      sigmas_[i] = clear;
    }
    score += snake.confidence[i];
    count += 1.0;
  }
  const Eigen::VectorXd& u = snake_.relax(snake.points, normals_, edges_, sigmas_, rigidity_, options_.elasticity);
  snake.sigma_px = snake_.deviation(edges_);
  snake.score = count > 0.0 ? score / count : 0.0;
  for (Eigen::Index i = 0; i < n; ++i) snake.points.col(i) += std::clamp(u[i], -reach_px, reach_px) * normals_.col(i);
}

// From the kind of edge to the membranes' own looks: learnt on the settled contours, and again on those they find.
void MembraneSnakes::learn_looks(const FrameSampler& image, double noise, const NeedleZone* needle) {
  outer_look_ = {};
  inner_look_ = {};
  frames_ = 0;
  if (has_inner()) learn_thickness(needle, 1.0);
  for (const bool is_outer : {true, false}) {
    if (!is_outer && !has_inner()) break;
    SnakeContour& snake = is_outer ? outer_ : inner_;
    Look& look = is_outer ? outer_look_ : inner_look_;
    look.step_px = std::clamp(0.5 * snake.scale_px, kFinestStep, kCoarsestStep);
    for (int round = 0; round < 4; ++round) {
      if (!learn_look(image, snake, look, needle, 1.0)) break;
      // Samples half the edge's own width apart, so that the window holds the edge and its halo at any magnification.
      if (round == 0 && !snake.is_soft()) {
        look.step_px = std::clamp(0.5 * look.edge.width() * look.step_px, kFinestStep, kCoarsestStep);
        look.edge.reset();
        if (!learn_look(image, snake, look, needle, 1.0)) break;
      }
      fine_round(image, noise, is_outer, needle);
      contour::resample_smooth(snake.points, options_.contour_point_count, 0.0, even_);
      snake.points = even_;
    }
    if (look.edge.valid()) fine_round(image, noise, is_outer, needle);
    look.usual_score = snake.score;
    look.usual_poor_run = look.poor_run;
  }
  if (has_inner()) learn_thickness(needle, 1.0);
}

}  // namespace pellucida
