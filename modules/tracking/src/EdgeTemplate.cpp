#include "EdgeTemplate.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

constexpr int kHalf = EdgeTemplate::kHalf, kTaps = EdgeTemplate::kTaps;

// Of a profile's mean: no place is taken to be darker, whatever the harmonics have it where no profile was seen.
constexpr float kLeastLight = 0.05F;

// The window's weight of sample k: full in the middle, fading over its ends.
double taper(int k) {
  const double x = std::abs(k) / (kHalf + 1.0);
  return x < 0.5 ? 1.0 : 0.5 + 0.5 * std::cos(2.0 * M_PI * (x - 0.5));
}

// Extremum next to the middle of a curve, by a polynomial of fourth degree through its inner samples; `sign` is that of
// the curvature. The middle itself where there is none.
double extremum(const std::array<double, kTaps>& curve, double sign) {
  constexpr int kReach = 3;
  Eigen::Matrix<double, 2 * kReach + 1, 5> powers;
  Eigen::Matrix<double, 2 * kReach + 1, 1> values;
  for (int k = -kReach; k <= kReach; ++k) {
    double power = 1.0;
    for (int p = 0; p < 5; ++p, power *= k) powers(k + kReach, p) = power;
    values[k + kReach] = curve[static_cast<std::size_t>(k + kHalf)];
  }
  const Eigen::Matrix<double, 5, 1> c = (powers.transpose() * powers).ldlt().solve(powers.transpose() * values);
  double x = 0.0;
  for (int round = 0; round < 8; ++round) {
    const double first = c[1] + x * (2.0 * c[2] + x * (3.0 * c[3] + x * 4.0 * c[4]));
    const double second = 2.0 * c[2] + x * (6.0 * c[3] + x * 12.0 * c[4]);
    if (second * sign <= 0.0) return 0.0;
    x = std::clamp(x - first / second, -2.0, 2.0);
  }
  return x;
}

// Gaussian blur of a curve in place; its ends go on as they are.
void blur(std::array<double, kTaps>& curve, double sigma) {
  const std::array<double, kTaps> sharp = curve;
  for (int k = 0; k < kTaps; ++k) {
    double sum = 0.0, total = 0.0;
    for (int d = -kHalf; d <= kHalf; ++d) {
      const double w = std::exp(-0.5 * d * d / (sigma * sigma));
      sum += w * sharp[static_cast<std::size_t>(std::clamp(k + d, 0, kTaps - 1))];
      total += w;
    }
    curve[static_cast<std::size_t>(k)] = sum / total;
  }
}

}  // namespace

int EdgeTemplate::direction_of(double nx, double ny) noexcept {
  const double turn = std::atan2(ny, nx) * (kDirections / (2.0 * M_PI));
  return (static_cast<int>(std::lround(turn)) + kDirections) % kDirections;
}

bool EdgeTemplate::learn(const float* profiles, const Eigen::Matrix2Xd& normals, const Eigen::VectorXd& weights,
                         EdgeKind kind, double share) {
  const Eigen::Index n = normals.cols();
  weights_.assign(static_cast<std::size_t>(n), 0.0);
  misfits_.resize(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) weights_[static_cast<std::size_t>(i)] = weights[i] > 0.0 ? 1.0 : 0.0;
  Eigen::Matrix<double, kTaps, 3> fitted;
  const auto value = [&](Eigen::Index i, int k) { return double{profiles[i * kTaps + k]}; };
  const auto mean = [&](Eigen::Index i) {
    double sum = 0.0;
    for (int k = 0; k < kTaps; ++k) sum += value(i, k);
    return std::max(sum / kTaps, 1e-3);
  };
  for (int round = 0; round < 3; ++round) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, kTaps> right = Eigen::Matrix<double, 3, kTaps>::Zero();
    for (Eigen::Index i = 0; i < n; ++i) {
      const double w = weights_[static_cast<std::size_t>(i)];
      if (w <= 0.0) continue;
      const Eigen::Vector3d row(1.0, normals(0, i), normals(1, i));
      normal += w * row * row.transpose();
      const double brightness = mean(i);
      for (int k = 0; k < kTaps; ++k) right.col(k) += w * (value(i, k) / brightness - 1.0) * row;
    }
    if (normal(0, 0) < 24.0) return false;
    // Where only one side is seen, the harmonics shrink to nothing instead of running away.
    normal(1, 1) += 0.02 * normal(0, 0);
    normal(2, 2) += 0.02 * normal(0, 0);
    fitted = normal.ldlt().solve(right).transpose();

    // Rows unlike the others (another body's edge, dirt) lose their say.
    order_.clear();
    for (Eigen::Index i = 0; i < n; ++i) {
      double squares = 0.0;
      const double brightness = mean(i);
      for (int k = 0; k < kTaps; ++k) {
        const double model = fitted(k, 0) + normals(0, i) * fitted(k, 1) + normals(1, i) * fitted(k, 2);
        const double off = value(i, k) / brightness - 1.0 - model;
        squares += taper(k - kHalf) * off * off;
      }
      misfits_[static_cast<std::size_t>(i)] = squares;
      if (weights[i] > 0.0) order_.push_back(squares);
    }
    const auto middle = order_.begin() + static_cast<std::ptrdiff_t>(order_.size() / 2);
    std::nth_element(order_.begin(), middle, order_.end());
    const double usual = std::max(*middle, 1e-12);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double ratio = misfits_[static_cast<std::size_t>(i)] / (4.0 * usual);
      if (weights[i] > 0.0) weights_[static_cast<std::size_t>(i)] = 1.0 / (1.0 + ratio * ratio);
    }
  }
  harmonics_ = valid_ ? ((1.0 - share) * harmonics_ + share * fitted).eval() : fitted;
  build(kind);
  return true;
}

void EdgeTemplate::build(EdgeKind kind) {
  valid_ = true;
  // The edge's width: half the way between the steepest places to both sides of a line, the first ones met from its
  // middle, because the other membrane's line may be in the window too.
  const auto mean_slope = [&](int k) { return kind.line * (harmonics_(k + 1, 0) - harmonics_(k - 1, 0)); };
  int left = kHalf - 1, right = kHalf + 1;
  while (left > 1 && mean_slope(left - 1) < mean_slope(left)) --left;
  while (right + 2 < kTaps && mean_slope(right + 1) > mean_slope(right)) ++right;
  width_ = kind.line != 0.0 ? std::max(0.5, 0.5 * (right - left)) : 2.0;
  const bool is_line = kind.line != 0.0;
  for (int b = 0; b < kDirections; ++b) {
    Look& look = looks_[static_cast<std::size_t>(b)];
    const double angle = 2.0 * M_PI * b / kDirections;
    const Eigen::Matrix<double, kTaps, 1> shape = harmonics_ * Eigen::Vector3d(1.0, std::cos(angle), std::sin(angle));
    std::array<double, kTaps> curve{}, slope{};
    for (int k = 0; k < kTaps; ++k) {
      const int before = std::max(0, k - 1), after = std::min(kTaps - 1, k + 1);
      slope[static_cast<std::size_t>(k)] = (shape[after] - shape[before]) / (after - before);
      curve[static_cast<std::size_t>(k)] = shape[k];
    }
    look.center = static_cast<float>(is_line ? extremum(curve, kind.line) : extremum(slope, -kind.step));
    look.center_deviation = 0.0F;
    if (is_line) {
      // Optics and pixels have blurred the line, and with a step beside it that has moved its extremum. How far shows
      // when it is blurred once more, by half the line's own variance: half of that way is taken back, and a fifth is
      // how far it may still be off, because the line's true sharpness is unknown.
      blur(curve, 0.7 * width_);
      const double moved = std::clamp(extremum(curve, kind.line) - double{look.center}, -1.5, 1.5);
      look.center -= static_cast<float>(0.5 * moved);
      look.center_deviation = static_cast<float>(0.20 * std::abs(moved));
    }

    // Least squares of (a, g, b) on (1, T, T'), windowed: two rows of the pseudo-inverse are the filters.
    Eigen::Matrix<double, kTaps, 3> columns;
    Eigen::Matrix<double, kTaps, 1> window;
    double sum = 0.0, weighted = 0.0;
    for (int k = 0; k < kTaps; ++k) {
      window[k] = taper(k - kHalf);
      sum += window[k];
      weighted += window[k] * shape[k];
    }
    for (int k = 0; k < kTaps; ++k)
      columns.row(k) << 1.0, shape[k] - weighted / sum, slope[static_cast<std::size_t>(k)];
    look.level = static_cast<float>(1.0 + weighted / sum);
    const Eigen::Matrix3d normal = columns.transpose() * window.asDiagonal() * columns;
    const Eigen::Matrix3d inverse =
        (normal + 1e-12 * Eigen::Matrix3d::Identity()).ldlt().solve(Eigen::Matrix3d::Identity());
    const Eigen::Matrix<double, 3, kTaps> filters = inverse * columns.transpose() * window.asDiagonal();
    for (int k = 0; k < kTaps; ++k) {
      const auto at = static_cast<std::size_t>(k);
      look.shape[at] = static_cast<float>(columns(k, 1));
      look.slope[at] = static_cast<float>(columns(k, 2));
      look.gain[at] = static_cast<float>(filters(1, k));
      look.shift[at] = static_cast<float>(-filters(2, k));
    }
    look.variance = filters.row(2).squaredNorm();
    look.gain_deviation = filters.row(1).norm();
    look.energy = (window.array() * columns.col(1).array().square()).sum() / sum;
  }
}

EdgeTemplate::Match EdgeTemplate::match(const float* profile, int reach, int direction) const noexcept {
  constexpr int kMost = 2 * kMaxReach + 2;
  const Look& look = looks_[static_cast<std::size_t>(direction)];
  const int places = 2 * reach + 1;
  // Both filters at every place: the loop over places is the inner one, so that it runs four wide.
  float gains[kMost] = {}, shifts[kMost] = {};
  for (int k = 0; k < kTaps; ++k) {
    const float g = look.gain[static_cast<std::size_t>(k)], s = look.shift[static_cast<std::size_t>(k)];
    const float* p = profile + k;
    for (int j = 0; j < places; ++j) {
      gains[j] += g * p[j];
      shifts[j] += s * p[j];
    }
  }
  int j = reach;
  while (j > 0 && gains[j - 1] > gains[j]) --j;
  while (j + 1 < places && gains[j + 1] > gains[j]) ++j;

  Match match;
  float sum = 0.0F;
  for (int k = 0; k < kTaps; ++k) sum += profile[j + k];
  match.mean = std::max(sum / kTaps, 1e-3F);
  match.gain = gains[j] / match.mean;
  match.inside = j > 0 && j + 1 < places && gains[j] > 0.0F;
  float move = 0.0F;
  if (gains[j] > 0.0F) {
    move = std::clamp(shifts[j] / gains[j], -1.0F, 1.0F);
    // Between two places the slope's zero is found exactly, with no bias from the model's being linear.
    const int other = move > 0.0F ? j + 1 : j - 1;
    if (other >= 0 && other < places && gains[other] > 0.0F) {
      const float there = shifts[other] / gains[other];
      if ((there > 0.0F) != (move > 0.0F))
        move *= 1.0F / (std::abs(move) + std::abs(there) + 1e-9F);
      else
        move = 0.5F * (move + static_cast<float>(other - j) + std::clamp(there, -1.0F, 1.0F));
    }
  }
  match.place = static_cast<float>(j - reach) + move + look.center;

  // What the model leaves at the nearest sample.
  const float inverse = 1.0F / match.mean;
  const float bend = -shifts[j] * inverse;
  float squares = 0.0F, offset = 0.0F;
  float left[kTaps];
  for (int k = 0; k < kTaps; ++k) {
    const auto at = static_cast<std::size_t>(k);
    left[k] = profile[j + k] * inverse - match.gain * look.shape[at] - bend * look.slope[at];
    offset += left[k];
  }
  offset /= kTaps;
  for (int k = 0; k < kTaps; ++k) squares += (left[k] - offset) * (left[k] - offset);
  match.residual = squares / (kTaps - 3);
  return match;
}

float EdgeTemplate::relative(float away_px, float step_px, int direction) const noexcept {
  const Look& look = looks_[static_cast<std::size_t>(direction)];
  const float k = std::clamp(away_px / step_px + kHalf + look.center, 0.0F, kTaps - 1.0F);
  const int i = std::min(static_cast<int>(k), kTaps - 2);
  const float t = k - static_cast<float>(i);
  const auto at = static_cast<std::size_t>(i);
  const float here = look.level + (1.0F - t) * look.shape[at] + t * look.shape[at + 1];
  return std::max(here, kLeastLight) / std::max(look.level + look.shape[kTaps - 1], kLeastLight);
}

double EdgeTemplate::asymmetry() const noexcept {
  double odd = 0.0, even = 0.0;
  for (const Look& look : looks_) {
    const double center = kHalf + look.center;
    const int reach = static_cast<int>(std::min(center, kTaps - 1.0 - center));
    const auto at = [&](double k) {
      const int i = std::clamp(static_cast<int>(center + k), 0, kTaps - 2);
      const double t = center + k - i;
      return (1.0 - t) * look.shape[static_cast<std::size_t>(i)] + t * look.shape[static_cast<std::size_t>(i) + 1];
    };
    double mean = 0.0;
    for (int k = 0; k <= reach; ++k) mean += 0.5 * (at(k) + at(-k)) / (reach + 1);
    for (int k = 0; k <= reach; ++k) {
      odd += std::pow(0.5 * (at(k) - at(-k)), 2);
      even += std::pow(0.5 * (at(k) + at(-k)) - mean, 2);
    }
  }
  return std::sqrt(odd / std::max(even, 1e-12));
}

}  // namespace pellucida
