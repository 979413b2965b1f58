#include "NeedleTracker.h"

#include <algorithm>
#include <cmath>

#include "pellucida/tracking/EdgeProfile.h"

namespace pellucida {
namespace {

constexpr double kAcrossStep = 0.5;
constexpr double kBehind = 85.0;  // px of the cone looked at behind the tip

double median_of(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// A straight line v = a + b s through points with weights, robust against outliers (Cauchy weights).
bool fit_line(const std::vector<Eigen::Vector3d>& points, double& a, double& b) {
  if (points.size() < 6) return false;
  for (int round = 0; round < 8; ++round) {
    double sw = 0, ss = 0, sv = 0, sss = 0, ssv = 0;
    const double scale = round < 2 ? 4.0 : 0.8;
    for (const Eigen::Vector3d& p : points) {
      const double off = (p.y() - a - b * p.x()) / scale;
      const double w = p.z() / (1.0 + off * off);
      sw += w;
      ss += w * p.x();
      sv += w * p.y();
      sss += w * p.x() * p.x();
      ssv += w * p.x() * p.y();
    }
    const double determinant = sw * sss - ss * ss;
    if (!(determinant > 1e-9 * sw * sss) || !(sw > 0.0)) return false;
    a = (sv * sss - ss * ssv) / determinant;
    b = (sw * ssv - ss * sv) / determinant;
  }
  return std::isfinite(a) && std::isfinite(b);
}

}  // namespace

// The image along the needle: station k at `from + k` px behind the tip, columns across.
struct NeedleTracker::Straightened {
  Eigen::MatrixXf values;  // (columns across x stations): one station is contiguous
  std::vector<bool> inside;
  double from = 0.0, half_across = 0.0;

  void sample(const FrameSampler& image, const NeedleEstimate& needle, double ahead, double behind, double half) {
    const int stations = static_cast<int>(std::floor(ahead + behind)) + 1;
    const int columns = 2 * static_cast<int>(std::ceil(half / kAcrossStep)) + 1;
    from = -ahead;
    half_across = kAcrossStep * (columns / 2);
    values.resize(columns, stations);
    inside.assign(static_cast<std::size_t>(stations), true);
    const Eigen::Vector2d across(-needle.direction.y(), needle.direction.x());
    for (int k = 0; k < stations; ++k) {
      const Eigen::Vector2d middle = needle.tip - (from + k) * needle.direction;
      inside[static_cast<std::size_t>(k)] = image.inside(middle, 3.0);
      for (int j = 0; j < columns; ++j) values(j, k) = image.sample(middle + (j * kAcrossStep - half_across) * across);
    }
  }
  int stations() const { return static_cast<int>(values.cols()); }
  int columns() const { return static_cast<int>(values.rows()); }
  float at(double v, int k) const {
    const double j = std::clamp((v + half_across) / kAcrossStep, 0.0, columns() - 1.001);
    const int whole = static_cast<int>(j);
    const float t = static_cast<float>(j - whole);
    return (1.0F - t) * values(whole, k) + t * values(whole + 1, k);
  }
  float mean(double v_from, double v_to, int k) const {
    float sum = 0.0F;
    int count = 0;
    for (double v = v_from; v <= v_to + 1e-9; v += kAcrossStep, ++count) sum += at(v, k);
    return count > 0 ? sum / static_cast<float>(count) : 0.0F;
  }
  // Grey value of the two edges at a station, and of the medium beside them.
  double edges(double middle, double half_width, int k) const {
    return 0.5 * (mean(middle - half_width - 0.5, middle - half_width + 0.5, k) +
                  mean(middle + half_width - 0.5, middle + half_width + 0.5, k));
  }
  double beside(double middle, double half_width, int k) const {
    return 0.5 * (mean(middle - half_width - 8.0, middle - half_width - 4.0, k) +
                  mean(middle + half_width + 4.0, middle + half_width + 8.0, k));
  }
};

bool NeedleTracker::start(const FrameSampler& image, const FoundTool& tool, const contour::Circle& cell, double noise) {
  valid_ = false;
  cone_frames_ = 0;
  // Look along the tool from the border to beyond the cell's centre.
  const Eigen::Vector2d across(-tool.direction.y(), tool.direction.x());
  NeedleEstimate guess;
  guess.direction = -tool.direction;
  guess.tip = cell.center + tool.offset() * across - 0.7 * cell.radius * tool.direction;
  const double half_width = std::max(2.0, tool.half_width() - 1.5);
  Straightened strip;
  const double length = std::hypot(image.width, image.height);
  strip.sample(image, guess, 0.0, length, half_width + 12.0);

  // Darkness of the best place across, station by station.
  std::vector<double> evidence;
  int last = 0;
  for (int k = 0; k < strip.stations(); ++k) {
    if (!strip.inside[static_cast<std::size_t>(k)]) {
      if (last > 0) break;
      evidence.push_back(0.0);
      continue;
    }
    last = k;
    double best = -1.0;
    for (double v = -half_width - 4.0; v <= half_width + 4.0; v += 1.0) {
      const double beside = 0.5 * (strip.mean(v - 8.0, v - 5.0, k) + strip.mean(v + 5.0, v + 8.0, k));
      best = std::max(best, beside - strip.mean(v - 0.5, v + 0.5, k));
    }
    evidence.push_back(best);
  }
  const double outside_from = 1.15 * cell.radius + 0.7 * cell.radius;
  std::vector<double> shaft;
  for (int k = static_cast<int>(outside_from); k < last; ++k) shaft.push_back(evidence[static_cast<std::size_t>(k)]);
  if (shaft.size() < 12) return false;
  // The strongest third is shaft for sure: the tip may still be far from the cell.
  std::sort(shaft.begin(), shaft.end());
  const double reference = shaft[shaft.size() * 4 / 5];
  if (reference < 3.0 * noise) return false;
  double sum = 0.0, best_sum = 0.0;
  int tip_station = -1;
  // First as if the tip were outside the cell; if it is not, the measurement below goes on inwards.
  const int border = static_cast<int>(1.7 * cell.radius) + 3;
  for (int k = last; k >= std::min(border, last - 12); --k) {
    sum += std::clamp(evidence[static_cast<std::size_t>(k)] / reference, -0.5, 1.2) - 0.5;
    if (sum > best_sum) {
      best_sum = sum;
      tip_station = k;
    }
  }
  if (tip_station < 0 || last - tip_station < 12) return false;
  guess.tip -= tip_station * guess.direction;
  guess.tip_half_width = std::min(half_width, 3.0);
  guess.widening =
      std::clamp((half_width - guess.tip_half_width) / std::max(40.0, double(last - tip_station)), 0.0, 0.15);
  now_ = guess;
  const bool at_border = tip_station < border + 8;
  const double behind = std::clamp(double(last - tip_station), 12.0, kBehind);
  for (int round = 0; round < 4; ++round) {
    const double ahead = at_border ? (round == 0 ? 3.0 : 1.4 * cell.radius) : 12.0;
    if (!measure(image, noise, ahead, behind, round < 2 ? 7.0 : 3.0)) return false;
  }
  motion_.setZero();
  valid_ = now_.confidence > 0.2;
  return valid_;
}

bool NeedleTracker::track(const FrameSampler& image, double noise, const NeedleCue& cue) {
  if (!valid_) return false;
  const NeedleEstimate before = now_;
  now_.tip += motion_;
  bool seen = measure(image, noise, cue.reach_px, kBehind, 3.0);
  if (seen) seen = measure(image, noise, 8.0, kBehind, 2.5);
  if (!seen) {
    now_ = before;
    now_.confidence *= 0.5;
    motion_.setZero();
    return false;
  }
  motion_ = now_.tip - before.tip;
  if (cue.in_the_clear) learn_cone();
  return true;
}

void NeedleTracker::take_dimple(const Eigen::Vector2d&, double) {}

void NeedleTracker::learn_cone() {
  cone_frames_ = std::min(cone_frames_ + 1, 30);
  cone_half_width_ += (now_.tip_half_width - cone_half_width_) / cone_frames_;
  cone_widening_ += (now_.widening - cone_widening_) / cone_frames_;
}

bool NeedleTracker::measure(const FrameSampler& image, double noise, double ahead_px, double behind_px,
                            double edge_reach_px) {
  Straightened strip;
  const double widest = now_.tip_half_width + now_.widening * behind_px;
  strip.sample(image, now_, ahead_px, behind_px, widest + 14.0);
  const int columns = strip.columns();

  // Each station's two dark edges near where they are expected.
  const EdgeFilter filter(1.3, kAcrossStep, {1.0, 0.0});
  std::vector<float> feature(static_cast<std::size_t>(columns));
  std::vector<Eigen::Vector3d> left, right, middle_points;
  const double least = 2.0 * noise * filter.noise_gain();
  for (int k = 0; k < strip.stations(); ++k) {
    const double s = strip.from + k;
    if (s < (cone_frames_ > 2 ? 12.0 : 6.0) || !strip.inside[static_cast<std::size_t>(k)]) continue;
    const double half_width = now_.tip_half_width + now_.widening * s;
    filter.apply(strip.values.col(k).data(), columns, feature.data());
    const auto edge = [&](double v) {
      // The highest maximum within reach, not just the nearest.
      const int start = static_cast<int>(std::lround((v + strip.half_across) / kAcrossStep));
      const int reach = static_cast<int>(std::ceil(std::min(edge_reach_px, half_width * 0.9 + 1.0) / kAcrossStep));
      int best = std::clamp(start, 0, columns - 1);
      for (int j = std::max(0, start - reach); j <= std::min(columns - 1, start + reach); ++j)
        if (feature[static_cast<std::size_t>(j)] > feature[static_cast<std::size_t>(best)]) best = j;
      Peak peak = climb_to_peak(feature.data(), columns, best, 2);
      peak.position = peak.position * kAcrossStep - strip.half_across;
      return peak;
    };
    const Peak l = edge(-half_width), r = edge(half_width);
    if (l.curvature < 0.0 && l.height > least) left.push_back({s, l.position, std::min(1.0, l.height / (4 * least))});
    if (r.curvature < 0.0 && r.height > least) right.push_back({s, r.position, std::min(1.0, r.height / (4 * least))});
  }
  double la = -now_.tip_half_width, lb = -now_.widening, ra = now_.tip_half_width, rb = now_.widening;
  const bool has_left = fit_line(left, la, lb), has_right = fit_line(right, ra, rb);
  if (!has_left || !has_right) return false;
  const double half_width = 0.5 * (ra - la), widening = 0.5 * (rb - lb);
  if (half_width + widening * 60.0 < 0.5 || widening > 0.4 || widening < -0.1) return false;

  // The axis runs midway between the edges.
  const Eigen::Vector2d across(-now_.direction.y(), now_.direction.x());
  const double axis_offset = 0.5 * (ra + la), axis_slope = 0.5 * (rb + lb);
  if (std::abs(axis_slope) > 0.3) return false;

  // Evidence of a shaft, station by station along the new axis: how much darker its edges are than the medium. Near the
  // tip the medium's grey value is carried on from further back: a membrane that wraps the tip would darken it.
  std::vector<double> evidence(static_cast<std::size_t>(strip.stations()), 0.0), full, medium;
  for (int k = 0; k < strip.stations(); ++k) {
    const double s = strip.from + k;
    const double w = std::max(0.8, half_width + widening * s);
    if (s > 10.0 && s < 40.0 && strip.inside[static_cast<std::size_t>(k)])
      medium.push_back(strip.beside(axis_offset + axis_slope * s, w, k));
  }
  const double medium_near_tip = median_of(medium);
  for (int k = 0; k < strip.stations(); ++k) {
    const double s = strip.from + k;
    const double w = std::max(0.8, half_width + widening * s), v = axis_offset + axis_slope * s;
    const bool near = s < 12.0 && !medium.empty();
    evidence[static_cast<std::size_t>(k)] = (near ? medium_near_tip : strip.beside(v, w, k)) - strip.edges(v, w, k);
    if (s > 8.0 && strip.inside[static_cast<std::size_t>(k)]) full.push_back(evidence[static_cast<std::size_t>(k)]);
  }
  const double reference = median_of(full);
  if (reference < 1.5 * noise) return false;
  double sum = 0.0, best_sum = -1e9;
  int first = strip.stations() - 1;
  for (int k = strip.stations() - 1; k >= 0; --k) {
    if (!strip.inside[static_cast<std::size_t>(k)]) continue;
    sum += std::clamp(evidence[static_cast<std::size_t>(k)] / reference, -0.5, 1.1) - 0.5;
    if (sum > best_sum) {
      best_sum = sum;
      first = k;
    }
  }
  // Half height between the last station that has it and the one before.
  double tip_station = strip.from + first;
  if (first > 0) {
    const double here = evidence[static_cast<std::size_t>(first)] / reference;
    const double before = evidence[static_cast<std::size_t>(first - 1)] / reference;
    if (here > 0.5 && before < 0.5) tip_station -= (here - 0.5) / std::max(here - before, 1e-3);
  }
  // The evidence falls to its half about one blur radius before the tip's own line.
  tip_station += 1.0;

  // Where the shaft's width says the tip is. A dimple that hides the end moves the evidence, not the width.
  bool by_cone = false;
  if (cone_frames_ > 2 && cone_widening_ > 0.015) {
    double s_mean = 0.0;
    for (const Eigen::Vector3d& p : left) s_mean += p.x();
    for (const Eigen::Vector3d& p : right) s_mean += p.x();
    s_mean /= static_cast<double>(left.size() + right.size());
    const double width = half_width + widening * s_mean;
    const double cone_station = s_mean - (width - cone_half_width_) / cone_widening_;
    if (std::abs(cone_station - tip_station) > 2.5) {
      tip_station = cone_station;
      by_cone = true;
    }
  }

  now_.tip = now_.tip - tip_station * now_.direction + (axis_offset + axis_slope * tip_station) * across;
  now_.direction = (now_.direction - axis_slope * across).normalized();
  now_.tip_half_width = by_cone ? cone_half_width_ : std::max(0.8, half_width + widening * tip_station);
  now_.widening = by_cone ? cone_widening_ : std::clamp(widening, 0.0, 0.3);
  const double clear = std::clamp(reference / (6.0 * std::max(noise, 1e-6)), 0.0, 1.0);
  const double supported = std::clamp(static_cast<double>(std::min(left.size(), right.size())) / 40.0, 0.0, 1.0);
  now_.confidence = clear * supported * (by_cone ? 0.7 : 1.0);
  now_.evidence = kShaftEdges | (by_cone ? kKnownCone : kTipEnd);
  return true;
}

}  // namespace pellucida
