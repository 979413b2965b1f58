// First sight by outlines instead of a known kind of edge: what lies along them is learnt, whatever it looks like.
#include <algorithm>
#include <cmath>

#include "ContourMath.h"
#include "MembraneSnakes.h"

namespace pellucida {
namespace {

// A look's window reaches EdgeTemplate::kHalf samples: so many of the outline's own errors.
constexpr double kWindowErrors = 3.0;
constexpr double kFinestSpacing_px = 0.25, kCoarsestSpacing_px = 4.0;  // px between samples of a look
constexpr int kRoundsOfAStep = 3;                                      // lessons before the samples are laid finer
constexpr double kSamplesOfWidth = 0.5;                                // of the edge's own width between two samples
constexpr double kLeastScore = 0.25;                                   // mean confidence of a contour that counts
constexpr double kLeastThickness = 2.0;  // widths of the look between two membranes that are two

}  // namespace

// Learns the look, moves the contour on what was learnt, and again, ever finer: the mean of profiles that lie beside
// each other is blurred, and each round takes some of the blur away.
bool MembraneSnakes::learn_along(const FrameSampler& image, double noise, bool is_outer, double error_px,
                                 const NeedleZone* needle) {
  SnakeContour& snake = is_outer ? outer_ : inner_;
  Look& look = is_outer ? outer_look_ : inner_look_;
  look = {};
  look.step_px = std::clamp(kWindowErrors * error_px / EdgeTemplate::kHalf, kFinestSpacing_px, kCoarsestSpacing_px);
  for (bool finest = false;;) {
    for (int round = 0; round < kRoundsOfAStep; ++round) {
      if (!learn_look(image, snake, look, needle, 1.0)) return false;
      fine_round(image, noise, is_outer, needle);
      contour::resample_smooth(snake.points, options_.contour_point_count, 0.0, even_);
      snake.points = even_;
    }
    if (finest) break;
    const double wanted =
        std::clamp(kSamplesOfWidth * look.edge.width() * look.step_px, kFinestSpacing_px, kCoarsestSpacing_px);
    finest = wanted > 0.6 * look.step_px;
    look.step_px = std::max(wanted, 0.5 * look.step_px);
    look.edge.reset();
  }
  look.usual_score = snake.score;
  look.usual_poor_run = look.poor_run;
  return true;
}

// A look by itself doesn't say where in it the boundary lies: the outline does, in the mean over all normals.
void MembraneSnakes::anchor(const FrameSampler& image, double noise, bool is_outer, const Eigen::Matrix2Xd& outline,
                            const NeedleZone* needle) {
  SnakeContour& snake = is_outer ? outer_ : inner_;
  Look& look = is_outer ? outer_look_ : inner_look_;
  contour::outward_normals(snake.points, normals_);
  sorted_.clear();
  for (Eigen::Index i = 0; i < snake.points.cols(); ++i) {
    if (needle && needle->covers(snake.points.col(i), 6.0)) continue;
    const double away = contour::distance_to(outline, snake.points.col(i));
    sorted_.push_back(contour::contains(outline, snake.points.col(i)) ? away : -away);
  }
  if (sorted_.empty()) return;
  const auto middle = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() / 2);
  std::nth_element(sorted_.begin(), middle, sorted_.end());
  snake.points += *middle * normals_;
  look.edge.reset();
  if (learn_look(image, snake, look, needle, 1.0)) fine_round(image, noise, is_outer, needle);
}

bool MembraneSnakes::start(const FrameSampler& image, const OutlineStart& outlines, double noise,
                           const NeedleZone* needle) {
  const auto take = [&](const Eigen::Matrix2Xd& points, SnakeContour& snake) {
    snake = {};
    snake.kind = kLearntEdge;
    snake.scale_px = options_.edge_scale_px;
    if (points.cols() >= 3)
      snake.points = contour::resample(contour::positively_oriented(points), options_.contour_point_count);
  };
  take(outlines.outer, outer_);
  take(outlines.inner, inner_);
  outer_look_ = {};
  inner_look_ = {};
  thickness_ = 0.0;
  frames_ = 0;
  if (outer_.points.cols() == 0) return false;
  if (!learn_along(image, noise, true, outlines.error_px, needle)) return false;
  if (has_inner() && !learn_along(image, noise, false, outlines.error_px, needle)) inner_ = {};
  anchor(image, noise, true, outlines.outer, needle);
  if (has_inner()) anchor(image, noise, false, outlines.inner, needle);
  if (has_inner()) {
    learn_thickness(needle, 1.0);
    const double width =
        std::min(outer_look_.edge.width() * outer_look_.step_px, inner_look_.edge.width() * inner_look_.step_px);
    if (thickness_ < kLeastThickness * width || inner_.score < kLeastScore) {
      inner_ = {};
      thickness_ = 0.0;
    }
  }
  sureness_ = outer_.score * outlines.share;
  return outer_.score >= kLeastScore;
}

// The look's contrast at each place of the strip, as a reward: the edge filter's part where no filter is known.
void MembraneSnakes::reward_by_look(const FrameSampler& image, const Look& look, Eigen::MatrixXf& reward) {
  const double first = strip_.offset_of(0), last = strip_.offset_of(strip_.columns() - 1);
  const int places = static_cast<int>(std::ceil((last - first) / look.step_px)) + 1;
  const int samples = places + EdgeTemplate::kTaps - 1;
  profiles_.resize(static_cast<std::size_t>(samples));
  smoothed_.resize(static_cast<std::size_t>(places));
  reward.resize(strip_.rows(), strip_.columns());
  for (int i = 0; i < strip_.rows(); ++i) {
    image.sample_line(outer_.points.col(i) + (first - EdgeTemplate::kHalf * look.step_px) * normals_.col(i),
                      look.step_px * normals_.col(i), samples, profiles_.data());
    const int direction = EdgeTemplate::direction_of(normals_(0, i), normals_(1, i));
    look.edge.gains(profiles_.data(), places, direction, smoothed_.data());
    // Where the look has no contrast in this direction, a gain is noise and says nothing.
    const auto worth = static_cast<float>(look.edge.worth(direction));
    for (int j = 0; j < strip_.columns(); ++j) {
      const double at = (strip_.offset_of(j) - first) / look.step_px;
      const int whole = std::clamp(static_cast<int>(at), 0, places - 2);
      const auto t = static_cast<float>(at - whole);
      const float gain =
          smoothed_[static_cast<std::size_t>(whole)] * (1.0F - t) + smoothed_[static_cast<std::size_t>(whole + 1)] * t;
      reward(i, j) = worth * std::clamp(gain, -0.6F, 1.3F);
    }
  }
}

}  // namespace pellucida
