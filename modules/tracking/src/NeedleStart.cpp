#include "NeedleStart.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace pellucida {
namespace {

constexpr double kChance = 0.55;  // likeness a place without a needle may have

// The mean cross-section of a block of the tool's length, relative to the medium on its two sides.
struct CrossSection {
  double step = 0.5, half_across = 0.0;
  std::vector<float> values;
  double medium = 0.0, noise = 0.0;

  int count() const { return static_cast<int>(values.size()); }
  double place(int j) const { return j * step - half_across; }
  float at(double v) const {
    const double x = std::clamp((v + half_across) / step, 0.0, count() - 1.001);
    const int i = static_cast<int>(x);
    const float t = static_cast<float>(x - i);
    return values[static_cast<std::size_t>(i)] * (1.0F - t) + values[static_cast<std::size_t>(i) + 1] * t;
  }
};

struct Outline {
  double middle = 0.0, half_width = 0.0;
};

void sample(const FrameSampler& image, const Eigen::Vector2d& entry, const Eigen::Vector2d& inwards, double from,
            double length, double middle, double noise, CrossSection& section) {
  const Eigen::Vector2d across(-inwards.y(), inwards.x());
  const int count = 2 * static_cast<int>(section.half_across / section.step) + 1;
  section.half_across = section.step * (count / 2);
  section.values.assign(static_cast<std::size_t>(count), 0.0F);
  std::vector<float> line(static_cast<std::size_t>(count));
  const int lines = std::max(1, static_cast<int>(length));
  for (int k = 0; k < lines; ++k) {
    image.sample_line(entry + (from + k) * inwards + (middle - section.half_across) * across, section.step * across,
                      count, line.data());
    for (int j = 0; j < count; ++j)
      section.values[static_cast<std::size_t>(j)] += line[static_cast<std::size_t>(j)] / static_cast<float>(lines);
  }
  section.noise = noise / std::sqrt(static_cast<double>(lines));
}

// Divides by the medium: a straight line through the medians of both flanks.
void normalise(CrossSection& section, double flank) {
  const auto median = [&](double from, double to) {
    std::vector<float> part;
    for (int j = 0; j < section.count(); ++j)
      if (section.place(j) >= from && section.place(j) <= to)
        part.push_back(section.values[static_cast<std::size_t>(j)]);
    if (part.empty()) return 0.0F;
    std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2), part.end());
    return part[part.size() / 2];
  };
  const double left = median(-section.half_across, -flank), right = median(flank, section.half_across);
  const double apart = 0.5 * (section.half_across + flank);
  section.medium = std::max(1e-4, 0.5 * (left + right));
  for (int j = 0; j < section.count(); ++j) {
    const double medium = section.medium + 0.5 * (right - left) * std::clamp(section.place(j) / apart, -1.0, 1.0);
    float& value = section.values[static_cast<std::size_t>(j)];
    value = value / static_cast<float>(std::max(1e-4, medium)) - 1.0F;
  }
  section.noise /= section.medium;
}

// The two edges of what differs from the medium: the lines' own extremum where the inside recovers, else the place of
// half height.
bool find_outline(const CrossSection& section, double reach, Outline& outline, bool& is_line, double& blur) {
  double depth = 0.0;
  for (int j = 0; j < section.count(); ++j)
    if (std::abs(section.place(j)) < reach && std::abs(section.values[static_cast<std::size_t>(j)]) > std::abs(depth))
      depth = section.values[static_cast<std::size_t>(j)];
  // A bright halo does not make a dark needle a bright one.
  double darkest = 0.0;
  for (int j = 0; j < section.count(); ++j)
    if (std::abs(section.place(j)) < reach)
      darkest = std::min(darkest, double{section.values[static_cast<std::size_t>(j)]});
  if (depth > 0.0 && -darkest > 0.5 * depth) depth = darkest;
  if (std::abs(depth) < 4.0 * section.noise) return false;
  const double sign = depth < 0.0 ? -1.0 : 1.0;
  const auto height = [&](double v) { return sign * section.at(v); };
  const double top = std::abs(depth), step = 0.5 * section.step;
  // From outside inwards: a fifth, a half, four fifths, and on to the first extremum.
  struct Flank {
    double half = 0.0, low = 0.0, high = 0.0, extremum = 0.0, peak = 0.0;
    bool found = false;
  };
  const auto flank = [&](double from, double direction) {
    Flank f;
    for (double v = from; std::abs(v - from) < 2.0 * std::abs(from); v += direction * step) {
      const double h = height(v);
      if (h < 0.15 * top) f.low = v;
      if (h >= 0.5 * top && !f.found) {
        f.half = v;
        f.found = true;
      }
      if (f.found) {
        if (h > f.peak) {
          f.peak = h;
          f.extremum = v;
        }
        if (h < f.peak - std::max(0.1 * top, 3.0 * section.noise)) break;
      }
    }
    if (!f.found) return f;
    f.low = f.half;
    while (std::abs(f.low) < section.half_across && height(f.low) > 0.2 * f.peak) f.low -= direction * step;
    f.high = f.half;
    while (std::abs(f.high - f.half) < std::abs(2.0 * from) && height(f.high) < 0.8 * f.peak)
      f.high += direction * step;
    return f;
  };
  const Flank left = flank(-reach, 1.0), right = flank(reach, -1.0);
  if (!left.found || !right.found || left.half >= right.half) return false;
  double core = 1e9;
  for (double v = left.extremum; v <= right.extremum; v += step) core = std::min(core, height(v));
  const double lower_peak = std::min(left.peak, right.peak);
  is_line = right.extremum - left.extremum > 2.0 * section.step && core < 0.8 * lower_peak - section.noise;
  const double spread = 0.5 * ((left.high - left.low) + (right.low - right.high));
  blur = std::max(0.4, spread / (is_line ? 1.126 : 1.683));
  const double a = is_line ? left.extremum : left.half, b = is_line ? right.extremum : right.half;
  outline = {0.5 * (a + b), 0.5 * (b - a)};
  return outline.half_width > 0.3;
}

void learn(const CrossSection& section, const Outline& outline, double keep, NeedleLook& look) {
  look.clear_samples();
  for (int j = 0; j < section.count(); ++j) {
    const double v = section.place(j) - outline.middle;
    look.add_sample(v < 0.0 ? 0 : 1, std::abs(v) - outline.half_width, section.values[static_cast<std::size_t>(j)],
                    1.0F);
  }
  look.finish(keep);
}

// How well a cross-section can be made to look like the needle.
struct Likeness {
  double medium = 1.0;       // grey value beside it
  double gain = 0.0;         // contrast over the learnt one; 0: no fit
  double correlation = 0.0;  // of cross-section and look, 0..1; what the noise alone would spoil is not held against it
};

// Fits medium, contrast, shift and width.
Likeness fit(const CrossSection& section, const NeedleLook& look, Outline& outline) {
  Likeness like;
  const double blur = look.blur();
  for (int round = 0; round < 4; ++round) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    const double reach = outline.half_width + look.outside(), core = outline.half_width - look.inside();
    int used = 0;
    double sum = 0.0, squares = 0.0;
    for (int j = 0; j < section.count(); ++j) {
      const double v = section.place(j) - outline.middle, away = std::abs(v);
      if (away > reach || away < core) continue;
      const int side = v < 0.0 ? 0 : 1;
      const double slope = look.slope(side, away - outline.half_width);
      const Eigen::Vector4d row(1.0, look.value(side, away - outline.half_width), v < 0.0 ? slope : -slope, -slope);
      normal += row * row.transpose();
      const double value = section.values[static_cast<std::size_t>(j)];
      right += value * row;
      sum += value;
      squares += value * value;
      ++used;
    }
    if (used < 8) return {};
    const double stiff = 1e-3 * normal.trace() / (1.0 + blur * blur);
    normal(2, 2) += stiff;
    normal(3, 3) += stiff;
    const Eigen::Vector4d x = normal.ldlt().solve(right);
    like.medium = x[0];
    like.gain = x[1] / std::max(x[0], 1e-6);
    if (!(like.gain > 0.1)) return {};
    const double all = squares - sum * sum / used, unexplained = squares - x.dot(right);
    const double noise = used * section.noise * section.noise;
    like.correlation = std::sqrt(std::clamp(1.0 - (unexplained - noise) / std::max(all - noise, 1e-12), 0.0, 1.0));
    const double limit = 0.7 * blur + 0.5;
    outline.middle += std::clamp(x[2] / x[1], -limit, limit);
    outline.half_width = std::max(0.4, outline.half_width + std::clamp(x[3] / x[1], -limit, limit));
  }
  return like;
}

// A straight line through (x, y), robust.
void fit_line(const std::vector<double>& x, const std::vector<double>& y, double& a, double& b) {
  double scale = 4.0;
  a = b = 0.0;
  for (int round = 0; round < 8; ++round) {
    double sw = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double off = round == 0 ? 0.0 : (y[k] - a - b * x[k]) / scale;
      const double w = 1.0 / (1.0 + off * off);
      sw += w;
      sx += w * x[k];
      sy += w * y[k];
      sxx += w * x[k] * x[k];
      sxy += w * x[k] * y[k];
    }
    const double determinant = sw * sxx - sx * sx;
    if (!(determinant > 1e-9)) return;
    a = (sy * sxx - sx * sxy) / determinant;
    b = (sw * sxy - sx * sy) / determinant;
    scale = std::max(0.3, 0.6 * scale);
  }
}

}  // namespace

std::optional<NeedleGuess> guess_needle(const FrameSampler& image, const FoundTool& tool, double noise, double skip_px,
                                        const ExpectedTip* expected) {
  const Eigen::Vector2d inwards = -tool.direction, across(-inwards.y(), inwards.x());
  const Eigen::Vector2d on_line =
      tool.origin + tool.offset() * Eigen::Vector2d(-tool.direction.y(), tool.direction.x());
  const double diagonal = std::hypot(image.width, image.height), broad = std::max(2.0, tool.half_width());
  // Out along the tool to the border; then in until the whole cross-section lies in the image.
  double out = 0.0;
  if (!image.inside(on_line, 1.0)) return std::nullopt;
  while (out < diagonal && image.inside(on_line + (out + 1.0) * tool.direction, 1.0)) out += 1.0;
  const auto whole = [&](double t, double middle, double half) {
    const Eigen::Vector2d p = on_line + (out - t) * tool.direction + middle * across;
    return image.inside(p + half * across, 1.0) && image.inside(p - half * across, 1.0);
  };
  double begin = skip_px;
  while (begin < skip_px + 0.5 * out && !whole(begin, 0.0, broad + 2.0)) begin += 1.0;
  const Eigen::Vector2d entry = on_line + out * tool.direction;
  const double expected_end = expected ? (expected->place - entry).dot(inwards) : 0.0;

  // What it looks like where it comes in.
  CrossSection section;
  section.step = std::clamp(broad / 24.0, 0.5, 2.0);
  const double block = std::clamp(broad, 8.0, 40.0);
  Outline outline;
  bool is_line = true, seen = false;
  double blur = 1.0;
  for (int attempt = 0; attempt < 4 && !seen; ++attempt, begin += block) {
    section.half_across = 1.6 * broad + 14.0;
    sample(image, entry, inwards, begin, block, 0.0, noise, section);
    normalise(section, broad + 5.0);
    seen = find_outline(section, 1.15 * broad + 5.0, outline, is_line, blur);
  }
  if (!seen) return std::nullopt;
  begin -= block;

  NeedleGuess guess;
  NeedleLook& look = guess.model.look;
  look.set_line(is_line);
  // The tables follow the blur: out of focus at the border, the needle may be in focus at its tip.
  const auto shape = [&] {
    guess.model.unit_px = std::clamp(blur / 1.2, 1.0, 8.0);
    look.reshape(0.5 * guess.model.unit_px, 4.0 * blur + 1.0, std::max(4.0, 4.5 * blur + 1.0));
  };
  look.resize(0.5, 1.0, 1.0);
  shape();
  learn(section, outline, 0.0, look);

  // Inwards, block by block. The needle ends where going on no longer pays: where the sum of the blocks' likeness, less
  // what chance would bring, is largest.
  std::vector<double> way, middle, half_width;
  double last_good = begin, middle_slope = 0.0, width_slope = 0.0, sum = 0.0, best_sum = 0.0, end = begin;
  std::size_t count_at_end = 0;
  Outline last = outline;
  for (double t = begin; image.inside(entry + (t + block) * inwards + last.middle * across, 1.0); t += 0.5 * block) {
    if (expected && t + 0.5 * block > expected_end + expected->reach_px) break;
    const double since = t - last_good;
    Outline here{last.middle + middle_slope * since, std::max(0.6, last.half_width + width_slope * since)};
    section.half_across = std::max(here.half_width + look.outside() + 2.0, 6.0);
    const double centre = here.middle, likely = here.half_width;
    sample(image, entry, inwards, t, block, centre, noise, section);
    here.middle = 0.0;
    const Likeness like = fit(section, look, here);
    here.middle += centre;
    const bool near = std::abs(here.middle - centre) < 1.5 * blur + 0.05 * since + 0.5 &&
                      std::abs(here.half_width - likely) < 1.5 * blur + 0.5 + 0.1 * likely;
    const double alike = near ? like.correlation * std::min(like.gain, 1.5 / std::max(like.gain, 0.5)) : 0.0;
    sum += std::clamp(alike, 0.0, 1.0) - kChance;
    if (sum > best_sum) {
      best_sum = sum;
      end = t + 0.5 * block;
      count_at_end = way.size() + 1;
    }
    if (!expected && sum < best_sum - 4.0) break;
    if (alike < kChance) continue;
    way.push_back(t + 0.5 * block);
    middle.push_back(here.middle);
    half_width.push_back(here.half_width);
    if (way.size() >= 4) {
      // Slopes from the last blocks.
      const auto from = static_cast<std::ptrdiff_t>(way.size() > 12 ? way.size() - 12 : 0);
      const std::vector<double> x(way.begin() + from, way.end());
      double a = 0.0;
      fit_line(x, {middle.begin() + from, middle.end()}, a, middle_slope);
      here.middle = a + middle_slope * (t + 0.5 * block);
      fit_line(x, {half_width.begin() + from, half_width.end()}, a, width_slope);
      width_slope = std::clamp(width_slope, -0.2, 0.05);
      here.half_width = std::max(0.6, a + width_slope * (t + 0.5 * block));
    }
    // The look follows slowly: out of focus it changes along the shaft.
    if (alike > 0.85) {
      for (float& value : section.values) value = value / static_cast<float>(like.medium) - 1.0F;
      learn(section, {here.middle - centre, here.half_width}, 0.85, look);
      // The outline stays where the look has its mark.
      const double mark = std::clamp(0.5 * (look.mark(0) + look.mark(1)), -0.1 * blur, 0.1 * blur);
      look.shift(0, mark);
      look.shift(1, mark);
      here.half_width = std::max(0.6, here.half_width + mark);
      half_width.back() += mark;
      if (const double sharper = look.blur(); sharper < 0.85 * blur) {
        blur = sharper;
        shape();
      }
    }
    last = here;
    last_good = t;
  }
  if (expected && end < expected_end - expected->reach_px) {
    end = expected_end;
    count_at_end = way.size();
  }
  count_at_end = std::min(count_at_end, way.size());
  way.resize(count_at_end);
  middle.resize(count_at_end);
  half_width.resize(count_at_end);
  guess.length_px = end - begin;
  guess.strength = guess.length_px * std::abs(look.depth());
  if (way.size() < 3 || guess.length_px < 12.0) return std::nullopt;

  // Axis and cone from the stretch next to the tip.
  const double stretch = std::max(6.0 * block, 85.0 * guess.model.unit_px);
  std::vector<double> near_way, near_middle, behind, near_width, weight;
  for (std::size_t k = way.size(); k-- > 0;) {
    if (end - way[k] > stretch && near_way.size() >= 4) break;
    near_way.push_back(way[k]);
    near_middle.push_back(middle[k]);
    behind.push_back(end - way[k]);
    near_width.push_back(half_width[k]);
    weight.push_back(1.0);
  }
  double a = 0.0, b = 0.0;
  fit_line(near_way, near_middle, a, b);
  guess.axis.direction = (inwards + b * across).normalized();
  guess.axis.tip = entry + end * inwards + (a + b * end) * across;
  guess.model.cone.fit(behind, near_width, weight);
  return guess;
}

}  // namespace pellucida
