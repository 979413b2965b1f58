#include "ShaftFit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "Median.h"

namespace pellucida {
namespace {

// Errors of a station that more light would not cure, in units of the blur.
constexpr double kStationFloor = 0.02;
// How far the width of the whole shaft may be wrong although the noise is nothing: blur and light change it.
constexpr double kWidthFloor = 0.009;
// A shaft with less contrast than the learnt one is out of focus: of its blur, how far its width may be wrong by then.
constexpr double kWidthOfContrast = 0.3, kSameContrast = 0.05;
// Samples closer than a pixel share its noise.
double shared_noise(double step) {
  return std::max(1.0, 1.0 / step);
}

}  // namespace

void ShaftFit::prepare(const NeedleModel& model, double behind_px) {
  unit_ = model.unit_px;
  behind_px_ = behind_px;
  step_ = model.look.step();
  lines_ = std::clamp(static_cast<int>(std::lround(unit_)), 1, 4);
  blur_ = model.look.blur();
  seen_to_ = model.cone.seen_to();
  const double begin = model.cone.tip_radius() + 2.0 * unit_;
  const int count = std::max(1, static_cast<int>((behind_px - begin) / unit_) + 1);
  const double widest = std::max(model.cone.half_width(begin), model.cone.half_width(behind_px));
  columns_ = 2 * static_cast<int>(std::ceil((widest + model.look.outside() + 1.0) / step_)) + 1;
  half_across_ = step_ * (columns_ / 2);
  stations_.resize(static_cast<std::size_t>(count));
  solve_.resize(4 * columns_, count);
  profile_.setZero(columns_, count);  // beyond a station's own reach it stays 0
  values_.resize(columns_, count);
  solve_.setZero();
  for (int k = 0; k < count; ++k) {
    Station& station = stations_[static_cast<std::size_t>(k)];
    station.s = begin + k * unit_;
    station.half_width = model.cone.half_width(station.s);
    station.widening = model.cone.slope(station.s);
    const double reach = station.half_width + model.look.outside();
    station.first = std::max(0, static_cast<int>(std::ceil((half_across_ - reach) / step_)));
    station.count = columns_ - 2 * station.first;
    // The inner part of a broad needle says nothing.
    const double core = station.half_width - model.look.inside();
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    float* basis = solve_.col(k).data();
    float* looks = profile_.col(k).data();
    model.line(station.s, station.first * step_ - half_across_, step_, station.count, looks + station.first);
    for (int j = station.first; j < station.first + station.count; ++j) {
      const double v = j * step_ - half_across_, d = std::abs(v) - station.half_width;
      const int side = v < 0.0 ? 0 : 1;
      if (std::abs(v) < core) continue;
      const float slope = model.look.slope(side, d);
      const Eigen::Vector4d row(1.0, looks[j], v < 0.0 ? slope : -slope, -slope);
      normal += row * row.transpose();
      for (int i = 0; i < 4; ++i) basis[4 * j + i] = static_cast<float>(row[i]);
    }
    // A little stiffness keeps what can't be separated from diverging.
    normal += 1e-4 * normal.trace() * Eigen::Vector4d(1e-3, 1e-3, 1.0, 1.0).asDiagonal().toDenseMatrix() /
              (1.0 + blur_ * blur_);
    const Eigen::Matrix4d inverse = normal.inverse();
    station.shift_variance = inverse(2, 2) * shared_noise(step_);
    station.width_variance = inverse(3, 3) * shared_noise(step_);
    const Eigen::Matrix4f solver = inverse.cast<float>();
    for (int j = station.first; j < station.first + station.count; ++j) {
      Eigen::Map<Eigen::Vector4f> column(basis + 4 * j);
      const Eigen::Vector4f solved = solver * column;
      column = solved;
    }
  }
}

// The mean of lines spread over a unit, so that a coarse spacing wastes no light.
void ShaftFit::sample_station(const FrameSampler& image, const NeedleAxis& axis, const Station& station,
                              float* values) {
  const Eigen::Vector2d step = step_ * axis.across();
  const double v = station.first * step_ - half_across_;
  const auto place = [&](int l) { return axis.at(station.s + (l - 0.5 * (lines_ - 1)) / lines_ * unit_, v); };
  image.sample_line(place(0), step, station.count, values + station.first);
  if (lines_ < 2) return;
  wide_.resize(std::max(wide_.size(), static_cast<std::size_t>(columns_)));
  for (int l = 1; l < lines_; ++l) {
    image.sample_line(place(l), step, station.count, wide_.data());
    for (int j = 0; j < station.count; ++j) values[station.first + j] += wide_[static_cast<std::size_t>(j)];
  }
  for (int j = 0; j < station.count; ++j) values[station.first + j] /= static_cast<float>(lines_);
}

ShaftResult ShaftFit::measure(const FrameSampler& image, const NeedleAxis& axis, double noise) {
  ShaftResult result;
  int inside = 0;
  for (std::size_t k = 0; k < stations_.size(); ++k) {
    Station& station = stations_[k];
    station.inside = image.inside(axis.at(station.s, station.half_width), 1.0) &&
                     image.inside(axis.at(station.s, -station.half_width), 1.0);
    station.seen = false;
    if (!station.inside) continue;
    ++inside;
    float* values = values_.col(static_cast<Eigen::Index>(k)).data();
    sample_station(image, axis, station, values);
    Eigen::Vector4f solution = Eigen::Vector4f::Zero();
    const float* rows = solve_.col(static_cast<Eigen::Index>(k)).data();
    for (int j = station.first; j < station.first + station.count; ++j)
      solution += values[j] * Eigen::Map<const Eigen::Vector4f>(rows + 4 * j);
    station.medium = solution[0];
    station.contrast = solution[1];
    // Contrast counts relative to the medium; shift and width relative to the contrast.
    const double gain = station.contrast / std::max(station.medium, 1e-6);
    if (gain < 0.3 || gain > 2.5) continue;
    station.shift = solution[2] / station.contrast;
    station.wider = solution[3] / station.contrast;
    station.seen = std::abs(station.shift) < 2.0 * blur_ + 1.0 && std::abs(station.wider) < 2.0 * blur_ + 1.0;
  }
  if (inside < 6) return result;
  int seen = 0;
  scratch_.clear();
  for (const Station& station : stations_) {
    if (!station.seen) continue;
    ++seen;
    scratch_.push_back(station.contrast / station.medium);
  }
  result.support = static_cast<double>(seen) / inside;
  result.stations = seen;
  if (seen < 6) return result;
  result.gain = median_of(scratch_);
  scratch_.clear();
  for (const Station& station : stations_)
    if (station.seen && scratch_.size() < 16) scratch_.push_back(station.medium);
  result.medium = median_of(scratch_);
  const double relative_noise = noise / std::sqrt(double(lines_)) / std::max(result.medium * result.gain, 1e-6);
  fit_axis(relative_noise, result);
  if (result.found) fit_cone(relative_noise, result);
  return result;
}

void ShaftFit::fit_axis(double noise, ShaftResult& result) {
  double a = 0.0, b = 0.0;
  const double floor = kStationFloor * blur_;
  // The median first, so that a crossing membrane does not turn the line.
  scratch_.clear();
  for (const Station& station : stations_)
    if (station.seen) scratch_.push_back(station.shift);
  a = median_of(scratch_);
  double scale = 2.0 * blur_;
  double determinant = 0.0, sw = 0.0, ss = 0.0, sss = 0.0, agreeing = 0.0;
  for (int round = 0; round < 8; ++round) {
    sw = ss = sss = agreeing = 0.0;
    double sv = 0.0, ssv = 0.0, squares = 0.0, count = 0.0;
    for (const Station& station : stations_) {
      if (!station.seen) continue;
      const double variance = station.shift_variance * noise * noise + floor * floor;
      const double off = station.shift - a - b * station.s;
      const double robust = 1.0 / (1.0 + off * off / (scale * scale + 4.0 * variance));
      const double w = robust / variance;
      sw += w;
      ss += w * station.s;
      sss += w * station.s * station.s;
      sv += w * station.shift;
      ssv += w * station.s * station.shift;
      squares += robust * std::min(off * off, 9.0 * scale * scale);
      count += robust;
      agreeing += robust > 0.3 ? 1.0 : 0.0;
    }
    determinant = sw * sss - ss * ss;
    if (!(determinant > 1e-9 * sw * sss)) return;
    a = (sv * sss - ss * ssv) / determinant;
    b = (sw * ssv - ss * sv) / determinant;
    scale = std::clamp(2.0 * std::sqrt(squares / std::max(count, 1.0)), 0.15 * blur_, 2.0 * blur_);
  }
  if (!std::isfinite(a) || !std::isfinite(b) || std::abs(b) > 0.3 || agreeing < 6.0) return;
  // Stations that disagree with the line are not this needle.
  for (Station& station : stations_) {
    const double limit = 3.0 * std::sqrt(station.shift_variance) * noise + std::max(2.0 * scale, 0.3 * blur_);
    station.seen = station.seen && std::abs(station.shift - a - b * station.s) < limit;
  }
  result.offset = offset_ = a;
  result.slope = slope_ = b;
  result.offset_sigma = std::sqrt(sss / determinant);
  result.found = true;
}

void ShaftFit::fit_cone(double noise, ShaftResult& result) {
  const double floor = kStationFloor * blur_;
  double ahead = 0.0, information = 0.0, slopes = 0.0, weights = 0.0, scale = 1.5 * blur_;
  for (int round = 0; round < 6; ++round) {
    double right = 0.0, squares = 0.0, count = 0.0;
    information = slopes = weights = 0.0;
    for (const Station& station : stations_) {
      if (!station.seen || station.s > seen_to_) continue;
      const double variance = station.width_variance * noise * noise + floor * floor;
      const double off = station.wider - station.widening * ahead;
      const double robust = 1.0 / (1.0 + off * off / (scale * scale + 4.0 * variance));
      const double w = robust / variance;
      right += w * station.widening * station.wider;
      information += w * station.widening * station.widening;
      slopes += w * station.widening;
      weights += w;
      squares += robust * std::min(off * off, 9.0 * scale * scale);
      count += robust;
    }
    if (!(information > 0.0)) break;
    ahead = right / information;
    scale = std::clamp(2.0 * std::sqrt(squares / std::max(count, 1.0)), 0.1 * blur_, 1.5 * blur_);
  }
  const double mean_slope = weights > 0.0 ? slopes / weights : 0.0;
  if (!(information > 0.0) || mean_slope < 0.008) {
    result.ahead_sigma = 1e3;
    return;
  }
  const double lost_contrast = std::max(0.0, 1.0 - result.gain - kSameContrast);
  const double bias = (kWidthFloor + kWidthOfContrast * lost_contrast) * blur_ / mean_slope;
  result.ahead = ahead;
  result.ahead_sigma = std::sqrt(1.0 / information + bias * bias);
}

void ShaftFit::learn(NeedleModel& model, double ahead, double weight) {
  // The cone first; it keeps what it knew where this frame shows nothing.
  learn_s_.clear();
  learn_width_.clear();
  learn_weight_.clear();
  for (const Station& station : stations_) {
    const double wider = station.wider - station.widening * ahead, share = station.s > seen_to_ ? 1.0 : weight;
    learn_s_.push_back(station.s);
    learn_width_.push_back(station.half_width + (station.seen ? share * wider : 0.0));
    learn_weight_.push_back((station.seen ? 1.0 : 0.2) / (station.width_variance + 1e-6));
  }
  model.cone.fit(learn_s_, learn_width_, learn_weight_);
  for (const Station& station : stations_)
    if (station.seen) model.cone.see_to(station.s);

  // Then the look: every station's samples, centred on the fitted axis.
  model.look.clear_samples();
  for (std::size_t k = 0; k < stations_.size(); ++k) {
    const Station& station = stations_[k];
    if (!station.seen || !(station.medium > 1e-6)) continue;
    const double middle = offset_ + slope_ * station.s, half_width = model.cone.half_width(station.s + ahead);
    const float* values = values_.col(static_cast<Eigen::Index>(k)).data();
    const float medium = static_cast<float>(station.medium);
    for (int j = station.first; j < station.first + station.count; ++j) {
      const double v = j * step_ - half_across_ - middle;
      model.look.add_sample(v < 0.0 ? 0 : 1, std::abs(v) - half_width, values[j] / medium - 1.0F, 1.0F);
    }
  }
  model.look.finish(1.0 - weight);
}

double ShaftFit::find_beside(const FrameSampler& image, const NeedleAxis& axis, double reach_px, double& correlation) {
  // Mean cross-section of image and look, then their best normalised correlation.
  const int extra = static_cast<int>(std::ceil(reach_px / step_)), wide = columns_ + 2 * extra;
  mean_.assign(static_cast<std::size_t>(columns_), 0.0F);
  wide_.assign(static_cast<std::size_t>(2 * wide), 0.0F);
  float* sum = wide_.data();
  float* line = wide_.data() + wide;
  const std::size_t every = std::max<std::size_t>(1, stations_.size() / 24);
  int used = 0;
  for (std::size_t k = stations_.size() / 8; k < stations_.size(); k += every) {
    const Station& station = stations_[k];
    if (!image.inside(axis.at(station.s, 0.0), 1.0)) continue;
    image.sample_line(axis.at(station.s, -half_across_ - extra * step_), step_ * axis.across(), wide, line);
    for (int j = 0; j < wide; ++j) sum[j] += line[j];
    for (int j = 0; j < columns_; ++j) mean_[static_cast<std::size_t>(j)] += profile_(j, static_cast<Eigen::Index>(k));
    ++used;
  }
  correlation = 0.0;
  if (used < 4) return 0.0;
  float profile_mean = 0.0F, profile_square = 0.0F;
  for (float p : mean_) profile_mean += p / static_cast<float>(columns_);
  for (float& p : mean_) {
    p -= profile_mean;
    profile_square += p * p;
  }
  double best = 0.0;
  for (int shift = 0; shift <= 2 * extra; ++shift) {
    float product = 0.0F, mean = 0.0F, square = 0.0F;
    for (int j = 0; j < columns_; ++j) mean += sum[shift + j] / static_cast<float>(columns_);
    for (int j = 0; j < columns_; ++j) {
      const float value = sum[shift + j] - mean;
      product += value * mean_[static_cast<std::size_t>(j)];
      square += value * value;
    }
    const double alike = product / std::sqrt(std::max(1e-12F, square * profile_square));
    if (alike > correlation) {
      correlation = alike;
      best = (shift - extra) * step_;
    }
  }
  return best;
}

}  // namespace pellucida
