#include "RigidMotion.h"

#include <Eigen/Dense>
#include <algorithm>

namespace pellucida {
namespace {

constexpr std::size_t kMostPixels = 640;
constexpr int kReferenceFrames = 16;    // the reference is the mean of that many
constexpr double kJumpStep_px = 3.0;    // between the starts about a jump
constexpr double kLeastContrast = 0.4;  // of the reference's, for a fit to be one
// Along the walls, between the starts beside the expected place, and how many to each side; a fit is tried from all of
// them in so many frames at first, and where it leaves so many times what is usual. One farther away has to be so much
// better.
constexpr double kBeside_px = 1.5;
constexpr int kStartsBeside = 2, kFirstFrames = 4;
constexpr double kUnusual_ratio = 1.2, kBetter_ratio = 0.7;
constexpr double kSame_px = 0.1;  // a fit that comes so near to another one will end there
// A fit that leaves so many times what is usual is none; the longer there is none, the more may be left.
constexpr double kNone_ratio = 2.5, kMissed_ratio = 1.2;
// How the usual residual, the steady motion and what differs from it follow, per frame. No frame counts as farther off
// than this, px.
constexpr double kUsual = 0.2, kSteady = 0.3, kUnrest = 0.3, kMostUnrest_px = 3.0;
constexpr double kTellable_px = 0.1;  // a motion counts as determined when its standard deviation is below this

// Central differences over three rows: pixel noise makes no gradient of its own.
Eigen::Vector2d smooth_gradient(const FrameSampler& image, const Eigen::Vector2d& p) {
  Eigen::Vector2d g = Eigen::Vector2d::Zero();
  for (int k = -1; k <= 1; ++k) {
    const double weight = k == 0 ? 0.25 : 0.125;
    g.x() += weight * (image.sample(p.x() + 1, p.y() + k) - image.sample(p.x() - 1, p.y() + k));
    g.y() += weight * (image.sample(p.x() + k, p.y() + 1) - image.sample(p.x() + k, p.y() - 1));
  }
  return g;
}

}  // namespace

void RigidMotion::reset() {
  pixels_.clear();
  motion_ = {};
  velocity_.setZero();
  frames_averaged_ = 1;
  frames_followed_ = 0;
  usual_residual_ = 0.0;
  unrest_.setZero();
}

bool RigidMotion::learn(const FrameSampler& image, const std::vector<Eigen::Vector2d>& candidates,
                        const Eigen::Vector2d& pivot, double noise) {
  reset();
  motion_.pivot = pivot;
  Eigen::Matrix2d all = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& p : candidates) {
    if (!image.inside(p, 4.0)) continue;
    Pixel pixel{p - pivot, smooth_gradient(image, p), 0.0, image.sample(p)};
    pixel.turn = pixel.gradient.y() * pixel.place.x() - pixel.gradient.x() * pixel.place.y();
    all += pixel.gradient * pixel.gradient.transpose();
    pixels_.push_back(pixel);
  }
  // Half of those kept are the most informative along the worst-determined direction, the others in any.
  const Eigen::Vector2d worst = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(all).eigenvectors().col(0);
  const std::size_t kept = std::min(kMostPixels, pixels_.size()), half = kept / 2;
  std::sort(pixels_.begin(), pixels_.end(), [&](const Pixel& a, const Pixel& b) {
    return std::abs(a.gradient.dot(worst)) > std::abs(b.gradient.dot(worst));
  });
  std::sort(pixels_.begin() + static_cast<std::ptrdiff_t>(half), pixels_.end(),
            [](const Pixel& a, const Pixel& b) { return a.gradient.squaredNorm() > b.gradient.squaredNorm(); });
  pixels_.resize(kept);

  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double sum = 0.0, squares = 0.0, farthest = 0.0;
  for (const Pixel& pixel : pixels_) {
    const Eigen::Vector3d row(pixel.gradient.x(), pixel.gradient.y(), pixel.turn);
    information += row * row.transpose();
    sum += pixel.value;
    squares += pixel.value * pixel.value;
    farthest = std::max(farthest, pixel.place.norm());
  }
  const double n = static_cast<double>(pixels_.size());
  const Eigen::Matrix2d shifts = information.topLeftCorner<2, 2>();
  const Eigen::Vector2d strength = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(shifts).eigenvalues();
  // Both directions need structure: one edge alone slides along itself.
  if (n < 60 || !(strength[0] > 0.0) || noise / std::sqrt(strength[0]) > kTellable_px ||
      strength[0] < 1e-4 * strength[1]) {
    reset();
    return false;
  }
  noise_ = noise;
  spread_ = std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n)));
  shift_covariance_ = noise * noise * shifts.inverse();
  along_ = worst;
  // What is left of a turn's information once the shifts are free.
  const Eigen::Vector2d mixed = information.topRightCorner<2, 1>();
  const double alone = information(2, 2) - mixed.dot(shifts.inverse() * mixed);
  turns_ = alone > 0.0 && farthest * noise / std::sqrt(alone) < kTellable_px;
  if (!(spread_ > 0.0)) reset();
  return valid();
}

double RigidMotion::sigma_px(const Eigen::Vector2d& direction) const noexcept {
  return valid() ? std::sqrt(std::max(0.0, direction.dot((shift_covariance_ + unrest_) * direction))) : 0.0;
}

RigidMotion::Fit RigidMotion::refine(const FrameSampler& image, RigidMove move, const RigidMove* known) const {
  Fit fit;
  // A lamp turned up or down must not make every pixel an outlier: begin with the brightness as it is now.
  double then = 0.0, now = 0.0;
  for (const Pixel& pixel : pixels_) {
    then += pixel.value;
    now += image.sample(move.apply(move.pivot + pixel.place));
  }
  const double brighter = now / std::max(then, 1e-9);
  double gain = brighter - 1.0, offset = 0.0;
  for (int round = 0; round < 14; ++round) {
    // Pixels that something else covers now (a membrane that bulges beside the rim) must not pull: tolerant at first,
    // then strict.
    const double scale = std::max(3.0 * noise_, (round < 3 ? 0.5 : 0.12) * spread_);
    const double c = std::cos(move.angle_rad), s = std::sin(move.angle_rad);
    const Eigen::Vector2d origin = move.pivot + move.shift;
    Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
    Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
    double weight = 0.0, rest = 0.0;
    int seen = 0;
    for (const Pixel& pixel : pixels_) {
      const double px = pixel.place.x(), py = pixel.place.y();
      const Eigen::Vector2d p(origin.x() + c * px - s * py, origin.y() + s * px + c * py);
      if (!image.inside(p, 2.0)) continue;
      const double gx = pixel.gradient.x(), gy = pixel.gradient.y();
      const double off = image.sample(p) - pixel.value;
      const double left = off - gain * pixel.value - offset;
      const double r = left / scale;
      const double w = 1.0 / ((1.0 + r * r) * (1.0 + r * r));
      const Eigen::Matrix<double, 5, 1> row(c * gx - s * gy, s * gx + c * gy, pixel.turn, -pixel.value, -1.0);
      normal.selfadjointView<Eigen::Lower>().rankUpdate(row, w);
      right -= w * off * row;
      weight += w;
      rest += std::min(std::abs(left), spread_);
      ++seen;
    }
    if (weight < 40.0) return fit;
    fit.residual = rest / seen;
    if (!turns_) {
      normal.row(2).head<2>().setZero();
      normal.col(2).tail<2>().setZero();
      normal(2, 2) = 1.0;
      right[2] = 0.0;
    }
    const Eigen::Matrix<double, 5, 1> step = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    if (!step.allFinite()) return fit;
    const Eigen::Vector2d way = step.head<2>().cwiseMin(2.0).cwiseMax(-2.0);
    move.shift += way;
    move.angle_rad += std::clamp(step[2], -0.05, 0.05);
    gain = step[3];
    offset = step[4];
    if (known && (move.shift - known->shift).norm() < kSame_px) return fit;
    if (way.norm() < 0.004 && std::abs(step[2]) < 1e-4 && round > 3) break;
  }
  fit.move = move;
  // A flat grey fits anything with its contrast taken away.
  fit.good = fit.residual < 0.6 * spread_ && 1.0 + gain > kLeastContrast * brighter;
  return fit;
}

bool RigidMotion::track(const FrameSampler& image, double reach_px, const Eigen::Vector2d& jump) {
  if (!valid()) return false;
  RigidMove best = motion_;
  double least = 0.35 * spread_ + noise_;
  if (frames_followed_ >= kFirstFrames) least = std::min(least, kNone_ratio * usual_residual_);
  bool found = false;
  const auto attempt = [&](const Eigen::Vector2d& way, double better_ratio) {
    RigidMove start = motion_;
    start.shift += way;
    const Fit fit = refine(image, start, found && better_ratio < 1.0 ? &best : nullptr);
    const bool is_near = (fit.move.shift - motion_.shift).norm() <= reach_px;
    if (!fit.good || !is_near || fit.residual >= (found ? better_ratio : 1.0) * least) return;
    best = fit.move;
    least = fit.residual;
    found = true;
  };
  if (jump.isZero()) {
    attempt(jump, 1.0);
    // The walls fit nearly as well beside their place along themselves; only the rim shows that they don't belong
    // there.
    const bool is_doubtful = frames_followed_ < kFirstFrames || least > kUnusual_ratio * usual_residual_;
    if (is_doubtful) attempt(velocity_, kBetter_ratio);
    for (int k = 1; k <= kStartsBeside && found && is_doubtful; ++k) {
      attempt(velocity_ + k * kBeside_px * along_, kBetter_ratio);
      attempt(velocity_ - k * kBeside_px * along_, kBetter_ratio);
    }
  } else {
    // The long walls fit anywhere along themselves: where a jump ended shows at the rim only, so the best of several
    // starts is taken.
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) attempt(jump + kJumpStep_px * Eigen::Vector2d(i, j), 1.0);
    }
  }
  // Nothing near: starts round about.
  for (double radius = 6.0; radius <= reach_px && !found; radius += 6.0) {
    for (int k = 0; k < 12; ++k) attempt(radius * Eigen::Vector2d(std::cos(k * M_PI / 6), std::sin(k * M_PI / 6)), 1.0);
  }
  if (!found) {
    usual_residual_ *= kMissed_ratio;
    return false;
  }
  const Eigen::Vector2d way = best.shift - motion_.shift;
  if (jump.isZero() && frames_followed_ > 1) {
    Eigen::Vector2d off = way - velocity_;
    off *= std::min(1.0, kMostUnrest_px / std::max(off.norm(), kMostUnrest_px));
    // Two places make the difference.
    unrest_ += kUnrest * (0.5 * off * off.transpose() - unrest_);
  }
  if (jump.isZero()) velocity_ += (frames_followed_ == 0 ? 1.0 : kSteady) * (way - velocity_);
  usual_residual_ += (frames_followed_ == 0 ? 1.0 : kUsual) * (least - usual_residual_);
  ++frames_followed_;
  motion_ = best;
  if (frames_averaged_ < kReferenceFrames) average_in(image);
  return true;
}

bool RigidMotion::correct(const FrameSampler& image, const Eigen::Vector2d& shift) {
  RigidMove start = motion_;
  start.shift = shift;
  const Fit there = refine(image, start);
  if (!there.good || (there.move.shift - shift).norm() >= kJumpStep_px) return false;
  // Two places along the walls may fit as usual: which it is the other evidence says.
  if (there.residual > kUnusual_ratio * usual_residual_) {
    const Fit here = refine(image, motion_);
    if (here.good && there.residual > here.residual) return false;
  }
  motion_ = there.move;
  return true;
}

// The reference's own noise falls with the frames it is the mean of.
void RigidMotion::average_in(const FrameSampler& image) {
  double mean_then = 0.0, mean_now = 0.0;
  const double part = 1.0 / ++frames_averaged_;
  for (const Pixel& pixel : pixels_) {
    mean_then += pixel.value;
    mean_now += image.sample(motion_.apply(motion_.pivot + pixel.place));
  }
  const double brighter = mean_now / std::max(mean_then, 1e-9);
  for (Pixel& pixel : pixels_) {
    const double now = image.sample(motion_.apply(motion_.pivot + pixel.place)) / std::max(brighter, 1e-3);
    // What differs by more than noise and the edge's own sway is something else in the way.
    if (std::abs(now - pixel.value) < 4.0 * noise_ + 0.1 * spread_) pixel.value += part * (now - pixel.value);
  }
}

}  // namespace pellucida
