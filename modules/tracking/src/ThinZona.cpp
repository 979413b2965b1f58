#include "ThinZona.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "ContourMath.h"
#include "Median.h"
#include "MembraneSnakes.h"

namespace pellucida {
namespace {

constexpr int kSectors = 16;        // of the outline: a tool or debris spoils some of them, not their median
constexpr double kStep_px = 0.25;   // between samples along a normal
constexpr int kIn = 40, kOut = 12;  // samples inwards and outwards: 10 and 3 px
// How far in a second line is looked for: lines further apart are followed, unless they are as blurred as this. So far
// in a minimum may be all kinds of things: behind a line it gets bright again within so many samples, 3 px.
constexpr double kFarthest_px = 6.0, kFarthest_widths = 4.5;
constexpr int kBehindLine = 12;
constexpr int kCount = kIn + 1 + kOut, kFar = kIn - static_cast<int>(kFarthest_px / kStep_px);
constexpr int kNear = 4;  // samples about the outline among which its own line lies
constexpr double kNeedleMargin_px = 6.0;
// Of the outer line's contrast: how much brighter it must be between two lines, and how strong the inner one is.
constexpr double kValley_ratio = 0.08, kInner_ratio = 0.35;
constexpr double kSurest_px = 0.1;     // no thickness is known better
constexpr double kSurely = 3.0;        // standard deviations that tell a valley from noise
constexpr double kApart_widths = 2.6;  // of a line's standard deviation: two whose valley has kValley_ratio

using Profile = std::array<double, kCount>;

// The extremum next to sample k, by a parabola through it and its neighbours.
double peak_at(const Profile& profile, int k) {
  const auto i = static_cast<std::size_t>(k);
  const double a = profile[i - 1], b = profile[i], c = profile[i + 1], bend = a - 2.0 * b + c;
  return bend == 0.0 ? k : k + std::clamp(0.5 * (a - c) / bend, -0.5, 0.5);
}

struct Pair {
  double apart_px = 0.0, valley = 0.0;
};

// The darkest sample of [from, to], the ends being its neighbours' business.
int lowest(const Profile& profile, int from, int to) {
  int best = from;
  for (int k = from; k <= to; ++k)
    if (profile[static_cast<std::size_t>(k)] < profile[static_cast<std::size_t>(best)]) best = k;
  return best;
}

// The outer line and the one next to it inwards, with what lies between them; nothing where there is no second one.
Pair pair_in(const Profile& profile, int innermost, double least_valley, double least_depth) {
  const int outer = lowest(profile, kIn - kNear, kIn + kNear);
  int crest = outer;
  for (int k = outer - 1; k >= innermost; --k) {
    const double here = profile[static_cast<std::size_t>(k)];
    if (here > profile[static_cast<std::size_t>(crest)]) crest = k;
    const bool is_line = here <= profile[static_cast<std::size_t>(k - 1)] &&
                         here < profile[static_cast<std::size_t>(crest)] - least_valley;
    if (!is_line) continue;
    // The crest stands between the two lines, and the inner one goes down from it far enough.
    const double top = profile[static_cast<std::size_t>(crest)], own = profile[static_cast<std::size_t>(outer)];
    if (top - own < least_valley || top - here < std::max(least_valley, 0.0)) return {};
    double out = own;
    for (int j = outer; j < kCount; ++j) out = std::max(out, profile[static_cast<std::size_t>(j)]);
    if (out - here < least_depth) return {};
    if (k < kFar) {
      const auto brightest = std::max_element(profile.begin() + std::max(0, k - kBehindLine), profile.begin() + k);
      if (*brightest - here < least_valley) return {};
    }
    return {kStep_px * (peak_at(profile, outer) - peak_at(profile, k)), std::min(top - own, top - here)};
  }
  return {};
}

}  // namespace

ThinZona ThinZona::read(const FrameSampler& image, const Eigen::Matrix2Xd& outline, EdgeKind kind, double line_width_px,
                        const NeedleZone* needle) {
  if (kind.line == 0.0 || kind.step != 0.0 || line_width_px <= 0.0 || outline.cols() < 4 * kSectors) return {};
  const Eigen::Matrix2Xd normals = contour::outward_normals(outline);
  std::array<Profile, kSectors> sectors{};
  std::array<int, kSectors> counts{};
  std::array<float, kCount> line;
  for (Eigen::Index i = 0; i < outline.cols(); ++i) {
    const Eigen::Vector2d p = outline.col(i), n = normals.col(i);
    if (!image.inside(p, kStep_px * kIn) || (needle && needle->covers(p, kNeedleMargin_px))) continue;
    image.sample_line(p - kStep_px * kIn * n, kStep_px * n, kCount, line.data());
    const auto sector = static_cast<std::size_t>(i * kSectors / outline.cols());
    for (std::size_t k = 0; k < kCount; ++k) sectors[sector][k] += kind.line * line[k];
    ++counts[sector];
  }
  std::vector<std::size_t> full;
  for (std::size_t s = 0; s < kSectors; ++s) {
    if (counts[s] * 2 * kSectors < outline.cols()) continue;
    // How bright the sector is says nothing about its lines.
    const double mean = std::accumulate(sectors[s].begin(), sectors[s].end(), 0.0) / kCount;
    for (double& value : sectors[s]) value = (value - mean) / counts[s];
    full.push_back(s);
  }
  if (full.size() < kSectors / 2) return {};

  // The median over the sectors, and how far they spread.
  Profile middle;
  std::vector<double> values(full.size()), spreads(kCount);
  for (std::size_t k = 0; k < kCount; ++k) {
    for (std::size_t j = 0; j < full.size(); ++j) values[j] = sectors[full[j]][k];
    middle[k] = median_of(values);
    for (double& value : values) value = std::abs(value - middle[k]);
    spreads[k] = 1.48 * median_of(values);
  }
  const int own = lowest(middle, kIn - kNear, kIn + kNear);
  const double contrast = *std::max_element(middle.begin() + own, middle.end()) - middle[static_cast<std::size_t>(own)];
  const double noise = 1.25 * median_of(spreads) / std::sqrt(static_cast<double>(full.size()));
  ThinZona seen;
  if (kSurely * noise > kInner_ratio * contrast) return seen;
  seen.limit_px = kApart_widths * line_width_px;
  const double valley = std::max(kValley_ratio * contrast, kSurely * noise);
  const double farthest_px = std::max(kFarthest_px, kFarthest_widths * line_width_px);
  const int innermost = std::max(1, kIn + 1 - static_cast<int>(farthest_px / kStep_px));
  const Pair pair = pair_in(middle, innermost, valley, kInner_ratio * contrast);
  if (pair.apart_px <= 0.0) return seen;
  seen.thickness_px = pair.apart_px;
  values.clear();
  for (const std::size_t s : full) {
    const Pair one = pair_in(sectors[s], innermost, 0.25 * valley, 0.0);
    if (one.apart_px > 0.0) values.push_back(std::abs(one.apart_px - pair.apart_px));
  }
  const auto alike = static_cast<double>(values.size());
  if (2.0 * alike < static_cast<double>(full.size())) return {0.0, 0.0, seen.limit_px};
  seen.sigma_px = std::hypot(kSurest_px, 1.48 * median_of(values) / std::sqrt(alike));
  return seen;
}

void ThinZonaMean::add(const ThinZona& seen) {
  ++frames_;
  if (seen.thickness_px > 0.0) {
    ++shown_;
    sum_.thickness_px += seen.thickness_px;
    sum_.sigma_px += seen.sigma_px;
  }
  if (seen.limit_px > 0.0) {
    ++judged_;
    sum_.limit_px += seen.limit_px;
  }
}

ThinZona ThinZonaMean::mean() const {
  ThinZona mean;
  if (2 * shown_ > frames_) {
    mean.thickness_px = sum_.thickness_px / shown_;
    mean.sigma_px = sum_.sigma_px / shown_;
  }
  if (2 * judged_ > frames_) mean.limit_px = sum_.limit_px / judged_;
  return mean;
}

}  // namespace pellucida
