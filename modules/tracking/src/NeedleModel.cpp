#include "NeedleModel.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

constexpr double kLineBlurs = 3.0;  // how far a line reaches to either side

}  // namespace

void NeedleLook::resize(double step, double inside, double outside) {
  step_ = step;
  zero_ = static_cast<int>(std::ceil(inside / step));
  const auto count = static_cast<std::size_t>(zero_ + static_cast<int>(std::ceil(outside / step)) + 1);
  for (auto* tables : {&tables_, &sums_, &weights_})
    for (std::vector<float>& table : *tables) table.assign(count, 0.0F);
}

void NeedleLook::reshape(double step, double inside, double outside) {
  const NeedleLook before = *this;
  resize(step, inside, outside);
  for (int side = 0; side < 2; ++side) {
    for (int i = 0; i < count(); ++i)
      tables_[static_cast<std::size_t>(side)][static_cast<std::size_t>(i)] = before.value(side, (i - zero_) * step_);
  }
}

float NeedleLook::slope(int side, double d) const noexcept {
  const float h = static_cast<float>(step_);
  return (value(side, d + step_) - value(side, d - step_)) / (2.0F * h);
}

void NeedleLook::clear_samples() {
  for (int side = 0; side < 2; ++side) {
    std::fill(sums_[static_cast<std::size_t>(side)].begin(), sums_[static_cast<std::size_t>(side)].end(), 0.0F);
    std::fill(weights_[static_cast<std::size_t>(side)].begin(), weights_[static_cast<std::size_t>(side)].end(), 0.0F);
  }
}

void NeedleLook::add_sample(int side, double d, float value, float weight) {
  const double x = d / step_ + zero_;
  const int i = static_cast<int>(std::floor(x));
  const float t = static_cast<float>(x - i);
  auto& sums = sums_[static_cast<std::size_t>(side)];
  auto& weights = weights_[static_cast<std::size_t>(side)];
  const int last = static_cast<int>(sums.size()) - 1;
  if (i >= 0 && i <= last) {
    sums[static_cast<std::size_t>(i)] += weight * (1.0F - t) * value;
    weights[static_cast<std::size_t>(i)] += weight * (1.0F - t);
  }
  if (i + 1 >= 0 && i + 1 <= last) {
    sums[static_cast<std::size_t>(i) + 1] += weight * t * value;
    weights[static_cast<std::size_t>(i) + 1] += weight * t;
  }
}

void NeedleLook::finish(double keep) {
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<float>& table = tables_[side];
    const int n = static_cast<int>(table.size());
    float last = 0.0F;
    bool any = false;
    // From outside in: a place never seen takes what lies next to it further out.
    for (int i = n - 1; i >= 0; --i) {
      const auto k = static_cast<std::size_t>(i);
      if (weights_[side][k] > 1e-3F) {
        const float mean = sums_[side][k] / weights_[side][k];
        last = static_cast<float>(keep) * table[k] + static_cast<float>(1.0 - keep) * mean;
        any = true;
      } else if (keep > 0.0) {
        last = table[k];
      }
      table[k] = last;
    }
    if (!any) continue;
    // The medium is 0 by definition.
    float medium = 0.0F;
    const int outer = std::max(1, n / 10);
    for (int i = n - outer; i < n; ++i) medium += table[static_cast<std::size_t>(i)] / static_cast<float>(outer);
    for (float& value : table) value -= medium;
  }
}

void NeedleLook::shift(int side, double by) {
  // Into the sums, which are free between frames.
  auto& moved = sums_[static_cast<std::size_t>(side)];
  for (int i = 0; i < count(); ++i) moved[static_cast<std::size_t>(i)] = value(side, (i - zero_) * step_ + by);
  tables_[static_cast<std::size_t>(side)].swap(moved);
}

double NeedleLook::mark(int side) const {
  const double sign = depth() < 0.0 ? -1.0 : 1.0;
  const auto height = [&](double d) {
    return is_line_ ? sign * value(side, d) : -sign * (value(side, d + step_) - value(side, d - step_));
  };
  const double reach = std::min(0.6 * std::min(inside(), outside()), 3.0 * step_);
  double best = 0.0;
  for (double d = -reach; d <= reach + 1e-9; d += step_)
    if (height(d) > height(best)) best = d;
  const double a = height(best - step_), b = height(best), c = height(best + step_);
  const double curvature = a - 2.0 * b + c;
  return curvature < 0.0 ? best + step_ * std::clamp(0.5 * (a - c) / curvature, -0.5, 0.5) : best;
}

double NeedleLook::blur() const {
  // How fast the outer flank falls from four fifths to a fifth of its height at the mark.
  const double sign = depth() < 0.0 ? -1.0 : 1.0;
  double top = 0.0;
  for (double d = -inside(); d <= (is_line_ ? 2.0 * step_ : 0.0); d += step_) top = std::max(top, sign * mean_at(d));
  double high = 0.0, low = outside();
  for (double d = outside(); d >= -inside(); d -= 0.25 * step_) {
    const double height = sign * mean_at(d) / std::max(top, 1e-9);
    if (height < 0.2) low = d;
    if (height >= 0.8) {
      high = d;
      break;
    }
  }
  return std::max(0.3, (low - high) / (is_line_ ? 1.126 : 1.683));
}

double NeedleLook::depth() const {
  double depth = 0.0;
  for (double d = -inside(); d <= outside(); d += step_)
    if (std::abs(mean_at(d)) > std::abs(depth)) depth = mean_at(d);
  return depth;
}

double NeedleLook::unevenness() const {
  if (!is_line_ || empty()) return 1.0;
  const double sign = depth() < 0.0 ? -1.0 : 1.0, reach = kLineBlurs * blur();
  double outside_of = 0.0, inside_of = 0.0, apart = 0.0;
  for (double d = 0.5 * step_; d <= reach; d += step_) {
    outside_of += sign * mean_at(d);
    inside_of += sign * mean_at(-d);
    apart += 0.5 * (std::abs(value(0, d) - value(1, d)) + std::abs(value(0, -d) - value(1, -d)));
  }
  const double all = outside_of + inside_of;
  return all > 0.0 ? std::min(1.0, std::max(std::abs(outside_of - inside_of), apart) / all) : 1.0;
}

double NeedleCone::fitted(double behind) const noexcept {
  const double s = std::clamp(behind + shift_, from_, to_);
  const double value = c_[0] + s * (c_[1] + s * (c_[2] + s * c_[3]));
  return value + slope(behind) * (behind + shift_ - s);
}

double NeedleCone::half_width(double behind) const noexcept {
  return std::max(0.3, fitted(behind));
}

double NeedleCone::slope(double behind) const noexcept {
  const double s = std::clamp(behind + shift_, from_, to_);
  return c_[1] + s * (2.0 * c_[2] + 3.0 * s * c_[3]);
}

void NeedleCone::fit(const std::vector<double>& behind, const std::vector<double>& half_width,
                     const std::vector<double>& weight) {
  if (behind.size() < 3) return;
  from_ = behind.front();
  to_ = behind.back();
  shift_ = 0.0;
  const double length = std::max(to_ - from_, 1e-6);
  const int degree = behind.size() >= 48 ? 3 : behind.size() >= 24 ? 2 : 1;
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  double total = 0.0;
  for (double w : weight) total += w;
  for (std::size_t k = 0; k < behind.size(); ++k) {
    const double x = (behind[k] - from_) / length, w = weight[k] / std::max(total, 1e-12);
    const Eigen::Vector4d row(1.0, x, x * x, x * x * x);
    normal += w * row * row.transpose();
    right += w * half_width[k] * row;
  }
  for (int i = 0; i < 4; ++i) {
    normal(i, i) += 1e-7;
    if (i > degree) normal(i, i) += 1e6;
  }
  const Eigen::Vector4d a = normal.ldlt().solve(right);
  // From the unit interval to px about 0.
  const double h = 1.0 / length, f = from_;
  const double b1 = a[1] * h, b2 = a[2] * h * h, b3 = a[3] * h * h * h;
  c_ = {a[0] - b1 * f + b2 * f * f - b3 * f * f * f, b1 - 2.0 * b2 * f + 3.0 * b3 * f * f, b2 - 3.0 * b3 * f, b3};
  find_radius();
}

void NeedleCone::move(double by, double wider) {
  shift_ -= by;
  seen_to_ += by;
  c_[0] += wider;
  find_radius();
}

void NeedleCone::set_roundness(double roundness) {
  roundness_ = roundness;
  find_radius();
}

void NeedleCone::find_radius() {
  radius_ = std::max(0.5, half_width(0.0));
  for (int round = 0; round < 4; ++round) radius_ = std::max(0.5, half_width(roundness_ * radius_));
}

double NeedleCone::fitted_tip_radius() const noexcept {
  double radius = std::max(0.0, fitted(0.0));
  for (int round = 0; round < 4; ++round) radius = std::max(0.0, fitted(roundness_ * radius));
  return radius;
}

// The distance from a rectangle whose corners are rounded off.
void NeedleModel::line(double behind, double beside, double step, int count, float* values) const noexcept {
  const double r = cone.tip_radius(), corner = cone.roundness() * r;
  const double half_width = behind < corner ? r : cone.half_width(behind), ahead = corner - behind;
  for (int j = 0; j < count; ++j) {
    const double v = beside + j * step, side = std::abs(v) - half_width + corner;
    double d = 0.0, part = 0.0;
    if (ahead > 0.0 && side > 0.0) {
      const double distance = std::hypot(ahead, side);
      d = distance - corner;
      part = std::copysign(side / distance, v);
    } else {
      d = std::max(ahead, side) - corner;
      part = ahead > side ? 0.0 : v;
    }
    const float right = static_cast<float>(std::clamp(0.5 + 0.5 * part, 0.0, 1.0));
    values[j] = (1.0F - right) * look.value(0, d) + right * look.value(1, d);
  }
}

}  // namespace pellucida
