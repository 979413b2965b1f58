#include "MembraneSnakes.h"

#include <algorithm>
#include <cmath>

#include "ContourMath.h"

namespace pellucida {
namespace {

constexpr double kSearchStep = 1.0;        // px between samples of the search for where an edge roughly is
constexpr int kSoftSmoothing = 8;          // times neighbouring profiles of a faint step are averaged
constexpr double kReferenceSpacing = 2.0;  // px between points at which an edge known to kReferenceSigma weighs 1
constexpr double kReferenceSigma = 0.4;
constexpr double kUnseenSigma = 40.0;   // px: of an edge not seen
constexpr double kLeastSigma = 0.02;    // px: no single edge is known better
constexpr double kMisfitShare = 2.0;    // of what noise does not explain of a profile's misfit, in the place's variance
constexpr double kAlone_px = 0.023;     // sigma of a contour without a second one
constexpr double kSmoothed = 0.7;       // of the solve's variance that is left after twicing and from frame to frame
constexpr double kUnlike = 3.0;         // how much surer a profile wholly alike is than one wholly unlike
constexpr double kBilinearShare = 0.5;  // of a pixel's variance that bilinear samples keep
constexpr double kSigmaFloor = 0.010;   // px, at a width of 1 px: no point is known better
constexpr double kNarrow = 0.6;         // of that, of a line that is 1 px wide: too few pixels draw it
constexpr double kBroad_px = 2.4;       // width from which on that is a fixed share of it
// Of the zona's thickness: how thin it may be under a tip, and how thick by what was learnt of it. A line further in is
// the oolemma, beyond a perivitelline gap, and often the stronger one.
constexpr double kThinnest_ratio = 0.45, kThickest_ratio = 1.3;
// In the mean round the cell, where another line was found in its stead. Set on plain film 88354.
constexpr double kAnother_ratio = 1.1;
constexpr double kCrowded = 0.258;   // width over thickness at which the doubt about the centre doubles
constexpr int kReach = 6;            // samples to both sides of the prediction
constexpr double kSettled_px = 0.6;  // displacement after which the profiles are not sampled again
constexpr int kMostRounds = 4;
constexpr double kLeastScoreRatio = 0.85;  // of the usual score: below, the contours are sought anew
constexpr double kLooseRatio = 0.08;       // share of edges not found within reach: above, the same
constexpr double kPoorConfidence = 0.5;    // a run of points below, longer by kPoorRun than usual: the same
constexpr int kPoorRun = 3;
// So many frames such a run is borne when a search found it no better: something hides the membrane there.
constexpr int kVainFrames = 4;
constexpr long kFreshFrames = 3;    // first frames, in which a hasty start is mended
constexpr long kLearnInterval = 8;  // frames between lessons of the looks

// Feature in units of the learnt strength, bounded: a glaring speck counts no more than the membrane itself.
void to_reward(const Eigen::MatrixXf& feature, double strength, Eigen::MatrixXf& reward) {
  reward = (feature / static_cast<float>(strength)).cwiseMin(1.3F).cwiseMax(-0.6F);
}

}  // namespace

void MembraneSnakes::sample_profiles(const FrameSampler& image, const Eigen::Matrix2Xd& points, double step_px,
                                     int samples, int smoothing) {
  const Eigen::Index n = points.cols();
  profiles_.resize(static_cast<std::size_t>(n * samples));
  const double first = -0.5 * step_px * (samples - 1);
  for (Eigen::Index i = 0; i < n; ++i)
    image.sample_line(points.col(i) + first * normals_.col(i), step_px * normals_.col(i), samples,
                      profiles_.data() + i * samples);
  for (int round = 0; round < smoothing; ++round) {
    smoothed_.resize(profiles_.size());
    for (Eigen::Index i = 0; i < n; ++i) {
      const float* here = profiles_.data() + i * samples;
      const float* before = profiles_.data() + (i == 0 ? n - 1 : i - 1) * samples;
      const float* after = profiles_.data() + (i + 1 == n ? 0 : i + 1) * samples;
      float* out = smoothed_.data() + i * samples;
      for (int k = 0; k < samples; ++k) out[k] = 0.5F * here[k] + 0.25F * (before[k] + after[k]);
    }
    profiles_.swap(smoothed_);
  }
}

bool MembraneSnakes::learn_look(const FrameSampler& image, const SnakeContour& snake, Look& look,
                                const NeedleZone* needle, double share) {
  contour::outward_normals(snake.points, normals_);
  sample_profiles(image, snake.points, look.step_px, EdgeTemplate::kTaps, snake.is_soft() ? kSoftSmoothing : 0);
  const Eigen::Index n = snake.points.cols();
  edges_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) edges_[i] = needle && needle->covers(snake.points.col(i), 6.0) ? 0.0 : 1.0;
  return look.edge.learn(profiles_.data(), normals_, edges_, snake.kind, share);
}

// Where both contours of a strip of normals roughly are, with no hint but the band.
void MembraneSnakes::search(const FrameSampler& image, const NeedleZone* needle, double search_px) {
  contour::outward_normals(outer_.points, normals_);
  const double reach_in = search_px + (has_inner() ? 1.6 * thickness_ : 0.0);
  strip_.sample(image, outer_.points, normals_, reach_in + 3.0, search_px + 3.0, kSearchStep);
  const auto reward = [&](const SnakeContour& snake, Eigen::MatrixXf& out) {
    strip_.features(EdgeFilter(snake.scale_px, kSearchStep, snake.kind), 1, feature_);
    to_reward(feature_, snake.strength, out);
  };
  reward(outer_, reward_outer_);
  if (has_inner()) reward(inner_, reward_inner_);
  // The needle's own edges say nothing about a membrane; the tip itself does, once it touches.
  if (needle) {
    for (int i = 0; i < strip_.rows(); ++i) {
      const auto place = [&](int j) -> Eigen::Vector2d {
        return outer_.points.col(i) + strip_.offset_of(j) * normals_.col(i);
      };
      if (needle->is_beside(place(0), place(strip_.columns() - 1), kNeedleMargin)) continue;
      for (int j = 0; j < strip_.columns(); ++j) {
        const Eigen::Vector2d p = place(j);
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
  const std::vector<int>*outer_path = nullptr, *inner_path = nullptr;
  if (has_inner()) {
    const int gap_from = std::max(2, static_cast<int>(kThinnest_ratio * thickness_ / kSearchStep));
    const int gap_to = static_cast<int>(std::ceil(kThickest_ratio * thickness_ / kSearchStep));
    const PathPair& pair = path_search_.closed_pair(reward_outer_, reward_inner_, gap_from, gap_to, kSlope, kGap);
    outer_path = &pair.outer;
    inner_path = &pair.inner;
  } else {
    outer_path = &path_search_.closed_path(reward_outer_, 1, kSlope);
  }
  const auto lay = [&](const std::vector<int>& path, SnakeContour& snake) {
    even_.resize(2, strip_.rows());
    for (int i = 0; i < strip_.rows(); ++i)
      even_.col(i) = outer_predicted_.col(i) + strip_.offset_of(path[static_cast<std::size_t>(i)]) * normals_.col(i);
    contour::untie(even_);  // in a deep dimple far-reaching normals cross
    contour::resample_into(even_, options_.contour_point_count, 0.0, snake.points);
  };
  outer_predicted_ = outer_.points;
  lay(*outer_path, outer_);
  if (inner_path) lay(*inner_path, inner_);
}

// Where the template lies on each normal, how surely, and how much of it is to be seen.
void MembraneSnakes::localise(const FrameSampler& image, double noise, bool is_outer, const NeedleZone* needle) {
  SnakeContour& snake = is_outer ? outer_ : inner_;
  Look& look = is_outer ? outer_look_ : inner_look_;
  constexpr int kSamples = EdgeTemplate::kTaps + 2 * kReach;
  const Eigen::Index n = snake.points.cols();
  const bool soft = snake.is_soft();
  contour::outward_normals(snake.points, normals_);
  sample_profiles(image, snake.points, look.step_px, kSamples, soft ? kSoftSmoothing : 0);
  const double spacing = contour::arc_length(snake.points) / static_cast<double>(n);
  // Bilinear samples share pixels: fewer independent ones the finer they lie, along the normal and from row to row.
  const double shared = 0.6 * std::max(1.0, 1.0 / look.step_px) * std::max(1.0, 1.0 / spacing) * (soft ? 0.2 : 1.0);
  edges_.resize(n);
  sigmas_.resize(n);
  rigidity_.setConstant(n, options_.rigidity * (soft ? kSoftRigidity : 1.0));
  shape_share_.setConstant(n, kShapeShare);
  snake.confidence.resize(n);
  double score = 0.0;
  int seen = 0, loose = 0, poor = 0;
  look.poor_run = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const int direction = EdgeTemplate::direction_of(normals_(0, i), normals_(1, i));
    const EdgeTemplate::Match m = look.edge.match(profiles_.data() + i * kSamples, kReach, direction);
    const double pixel_variance = (noise / m.mean) * (noise / m.mean), noise_variance = shared * pixel_variance;
    // What noise does not explain of the misfit is another body's edge or texture, alike over the edge's width.
    const double variance =
        noise_variance + kMisfitShare * std::max(0.0, double{m.residual} - kBilinearShare * pixel_variance);
    const double gain = std::max(double{m.gain}, 0.02);
    const double place_px = look.step_px * std::sqrt(variance * look.edge.place_variance(direction)) / gain;
    const double clear =
        std::clamp(m.gain - 2.0 * std::sqrt(noise_variance) * look.edge.gain_deviation(direction), 0.0, 1.0);
    // The share of the profile's variance that the look explains: another body's edge explains little.
    const double explained = gain * gain * look.edge.energy(direction);
    const double alike = explained / (explained + m.residual);
    edges_[i] = look.step_px * m.place;
    sigmas_[i] = m.inside ? std::min(kUnseenSigma, std::hypot(place_px * (1.0 + kUnlike * (1.0 - alike)), kLeastSigma))
                          : kUnseenSigma;
    snake.confidence[i] = m.inside ? std::clamp(1.4 * clear, 0.0, 1.0) * std::min(1.0, 1.6 * alike) : 0.0;
    if (needle && needle->covers(snake.points.col(i), kNeedleMargin)) continue;
    score += snake.confidence[i];
    ++seen;
    loose += m.inside ? 0 : 1;
    poor = snake.confidence[i] < kPoorConfidence ? poor + 1 : 0;
    look.poor_run = std::max(look.poor_run, poor);
  }
  snake.score = seen > 0 ? score / seen : 0.0;
  look.loose_ratio = seen > 0 ? static_cast<double>(loose) / seen : 1.0;
}

// Near the needle: softer where the dimple is sharp, blind where the shaft hides the membrane, and under the tip the
// membrane is where the tip is.
void MembraneSnakes::use_needle(SnakeContour& snake, bool is_outer, const NeedleZone& needle) {
  const Eigen::Index n = snake.points.cols();
  const double reach_of_tip = 6.0 * needle.tip_half_width + 12.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d p = snake.points.col(i), d = p - needle.tip;
    const double distance = d.norm();
    if (needle.touching && distance < reach_of_tip) {
      const double t = distance / reach_of_tip;
      rigidity_[i] = options_.tip_rigidity * std::pow(options_.rigidity / options_.tip_rigidity, t * t);
    }
    const bool there = std::abs(edges_[i]) < kReach && needle.covers(p + edges_[i] * normals_.col(i), kNeedleMargin);
    if (!there && !needle.covers(p, kNeedleMargin)) continue;
    const double across = std::abs(needle.direction.x() * d.y() - needle.direction.y() * d.x());
    const double along = normals_.col(i).dot(needle.direction);
    if (is_outer && needle.touching && across < needle.tip_half_width && along < -0.5) {
      edges_[i] = -d.dot(needle.direction) / along;
      sigmas_[i] = needle.tip_sigma;
      snake.confidence[i] = 0.8;
    } else if (is_outer || !needle.touching || d.dot(needle.direction) < 1.0) {
      sigmas_[i] = kUnseenSigma;
      snake.confidence[i] = 0.3;
      // Nothing wraps the shaft any more: what it hides is taken to be smooth, not to be as it was.
      if (!needle.touching) shape_share_[i] = 1.0;
    }
  }
}

// One round of one snake: look, solve, move. Returns the largest displacement of an edge that was seen, px.
double MembraneSnakes::fine_round(const FrameSampler& image, double noise, bool is_outer, const NeedleZone* needle) {
  SnakeContour& snake = is_outer ? outer_ : inner_;
  const Look& look = is_outer ? outer_look_ : inner_look_;
  const Eigen::Index n = snake.points.cols();
  localise(image, noise, is_outer, needle);
  if (needle) use_needle(snake, is_outer, *needle);
  const bool inner_known = has_inner() && inner_.sigma_px.size() == inner_.points.cols() && inner_look_.edge.valid();
  if (is_outer && thickness_ > 0.0 && inner_known) use_thickness(needle);
  const double spacing = contour::arc_length(snake.points) / static_cast<double>(n);
  const double reference = kReferenceSigma * spacing / kReferenceSpacing;
  const Eigen::VectorXd& u =
      snake_.relax(snake.points, normals_, edges_, sigmas_, rigidity_, shape_share_, {options_.elasticity, reference});
  const Eigen::VectorXd& deviation = snake_.deviation(edges_);
  snake.sigma_px.resize(n);
  const double bound = kReach * look.step_px, width = look.edge.width() * look.step_px;
  // An edge that is wide against the zona runs into the other one, and its centre is less certain.
  const double crowded = has_inner() && thickness_ > 0.0 ? width / (kCrowded * thickness_) : 0.0;
  const double doubt = 1.0 + std::min(10.0, std::pow(crowded, 8));
  // A line narrower than a pixel is drawn by too few of them; a contour alone has none beside it to be held against.
  const double floor = kSigmaFloor * (width * std::clamp(width, 1.0, kBroad_px) + kNarrow / (width * width)) +
                       (has_inner() ? 0.0 : kAlone_px / std::pow(std::min(1.0, width), 2));
  const double smoothed = has_inner() ? kSmoothed : 1.0;
  double largest = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const int direction = EdgeTemplate::direction_of(normals_(0, i), normals_(1, i));
    const double center = doubt * std::max(look.step_px * look.edge.center_deviation(direction), floor);
    snake.sigma_px[i] = std::sqrt(smoothed * deviation[i] * deviation[i] + center * center);
    const double move = std::clamp(u[i], -bound, bound);
    snake.points.col(i) += move * normals_.col(i);
    largest = std::max(largest, std::abs(move));
  }
  return largest;
}

bool MembraneSnakes::hides(const Look& look) {
  return look.poor_run > look.usual_poor_run + kPoorRun;
}

bool MembraneSnakes::trustworthy(const SnakeContour& snake, const Look& look) const {
  if (snake.score < kLeastScoreRatio * look.usual_score || look.loose_ratio > kLooseRatio) return false;
  if (hides(look) && vain_frames_ == 0) return false;
  // A contour that folds back on itself.
  const Eigen::Index n = snake.points.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d here = snake.points.col(i);
    const Eigen::Vector2d before = here - snake.points.col(i == 0 ? n - 1 : i - 1);
    const Eigen::Vector2d after = snake.points.col(i + 1 == n ? 0 : i + 1) - here;
    if (before.dot(after) < 0.0) return false;
  }
  return true;
}

// Fine rounds from where the contours lie, the inner one first, until nothing moves. False: not to be trusted.
bool MembraneSnakes::follow(const FrameSampler& image, double noise, const NeedleZone* needle, bool give_up_early) {
  bool good = true;
  for (const bool is_outer : {false, true}) {
    if (!is_outer && !has_inner()) continue;
    SnakeContour& snake = is_outer ? outer_ : inner_;
    const Look& look = is_outer ? outer_look_ : inner_look_;
    if (!look.edge.valid()) continue;
    for (int round = 0; round < kMostRounds; ++round) {
      contour::resample_smooth(snake.points, options_.contour_point_count, 0.0, even_);
      snake.points.swap(even_);
      if (fine_round(image, noise, is_outer, needle) < kSettled_px) break;
    }
    good = trustworthy(snake, look) && good;
    if (!good && give_up_early) return false;
  }
  if (!good || !has_inner()) return good;
  // Neither membrane may lie on the other's edge.
  measure_gaps();
  int wrong = 0;
  for (Eigen::Index i = 0; i < gaps_.size(); ++i)
    wrong += gaps_[i] < 0.5 * thickness_ || gaps_[i] > 1.6 * thickness_ ? 1 : 0;
  return wrong < kLooseRatio * static_cast<double>(gaps_.size());
}

// No zona thickens from frame to frame: the inner contour has gone over to the oolemma.
bool MembraneSnakes::is_on_another_line() {
  if (!has_inner()) return false;
  measure_gaps();
  return gaps_.mean() > kAnother_ratio * thickness_;
}

// The cell moves with its holder, the dimple with the needle.
void MembraneSnakes::predict(const Eigen::Vector2d& shift, const Eigen::Vector2d& push, const NeedleZone* needle) {
  for (SnakeContour* snake : {&outer_, &inner_}) {
    for (Eigen::Index i = 0; i < snake->points.cols(); ++i) {
      Eigen::Vector2d move = shift;
      if (needle && needle->touching) {
        const double reach = wrapped_px(needle->tip_half_width);
        const double t = (snake->points.col(i) + push - needle->tip).norm() / reach;
        if (t < 5.0) move += std::exp(-0.5 * t * t) * (push - shift);
      }
      snake->points.col(i) += move;
    }
  }
}

double MembraneSnakes::track(const FrameSampler& image, double noise, const Eigen::Vector2d& shift,
                             const Eigen::Vector2d& push, const NeedleZone* needle, double search_px) {
  predict(shift, push, needle);
  // From the prediction alone, as long as that goes well; else by a search of the whole band.
  const bool fresh = frames_ < kFreshFrames;
  const bool near = search_px <= options_.search_px && !fresh;
  const auto put_back = [&] {
    outer_.points = outer_kept_;
    inner_.points = inner_kept_;
  };
  outer_kept_ = outer_.points;
  inner_kept_ = inner_.points;
  bool good = near && follow(image, noise, needle, true);
  if (near && !good) put_back();
  if (good) {
    vain_frames_ = std::max(0, vain_frames_ - 1);
  } else {
    vain_frames_ = 0;
    search(image, needle, search_px);
    good = follow(image, noise, needle, false);
    if (fresh && search_px <= options_.search_px && is_on_another_line()) {
      put_back();
      good = follow(image, noise, needle, false);
    }
    if (near && !good) vain_frames_ = kVainFrames;
  }
  ++frames_;
  const bool is_hidden = hides(outer_look_) || (has_inner() && hides(inner_look_));
  if ((!good || is_hidden) && !fresh) return outer_.score;

  // Lessons, slowly: light and focus change.
  const double share = fresh ? 0.5 : 0.05;
  for (const bool is_outer : {true, false}) {
    Look& look = is_outer ? outer_look_ : inner_look_;
    look.usual_score += share * ((is_outer ? outer_ : inner_).score - look.usual_score);
    look.usual_poor_run += share * (look.poor_run - look.usual_poor_run);
  }
  if (fresh || frames_ % kLearnInterval == 0) {
    learn_look(image, outer_, outer_look_, needle, fresh ? 0.5 : 0.1);
    if (has_inner()) {
      learn_look(image, inner_, inner_look_, needle, fresh ? 0.5 : 0.1);
      learn_thickness(needle, fresh ? 0.5 : 0.1);
    }
  }
  return outer_.score;
}

}  // namespace pellucida
