#include "ZonaSearch.h"

#include <cmath>
#include <numbers>

#include "RegionBorder.h"

namespace pellucida {
namespace {

constexpr int kRays = 120;
constexpr float kLeastEvidence = 0.25F;   // nats per sample, above what texture alone brings about
constexpr double kLeastZona_ratio = 0.2;  // of the oolemma's radius: thinner zonas show two lines
constexpr double kLeastZona_px = 12.0;    // as far as a dark line's own halo reaches
constexpr double kLeastCoherence = 0.55;  // of a border: of those among debris nine in ten have less
constexpr double kMoreCoherence = 0.35;   // needed, times the share that is out of the image: short arcs fit any specks
constexpr float kEnough = 1.0F;           // rewards saturate: a long faint border beats a short glaring one

// Where the ray at `angle` from `center` leaves the outline.
double outline_radius(const Eigen::Matrix2Xd& outline, const Eigen::Vector2d& center,
                      const Eigen::Vector2d& direction) {
  double best = 0.0;
  for (Eigen::Index i = 0; i < outline.cols(); ++i) {
    const Eigen::Vector2d a = outline.col(i) - center, b = outline.col(i + 1 == outline.cols() ? 0 : i + 1) - center;
    const double sa = direction.x() * a.y() - direction.y() * a.x();
    const double sb = direction.x() * b.y() - direction.y() * b.x();
    if ((sa <= 0.0) == (sb <= 0.0)) continue;
    best = std::max(best, direction.dot(a + sa / (sa - sb) * (b - a)));
  }
  return best;
}

struct Border {
  FoundEdge edge;
  contour::Circle circle;
  std::vector<int> path;
};

// The unrolled surroundings of an outline, and the borders in them.
class Surroundings {
 public:
  Surroundings(const GrayImage& image, const Eigen::Vector2d& center, double radius, double from, double to,
               double noise)
      : center_(center), radius_(radius), from_(from), step_(std::max(0.5, radius / 90.0)), noise_(noise) {
    Eigen::Matrix2Xd points(2, kRays);
    normals_.resize(2, kRays);
    for (int i = 0; i < kRays; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kRays;
      normals_.col(i) = Eigen::Vector2d(std::cos(angle), std::sin(angle));
      points.col(i) = center + from * normals_.col(i);
    }
    border_.sample(image, points, normals_, 0.0, to - from, step_, kWindow_ratio * radius);
    border_.evidence(kRays / 24, noise, evidence_, &brightness_, &texture_);
  }

  // The best closed border beyond `least_radius` (one value a ray); nothing where it is not clear, closed and round.
  std::optional<Border> best_beyond(const Eigen::VectorXd& least_radius) const {
    Eigen::MatrixXf reward(border_.rows(), border_.columns());
    for (int i = 0; i < border_.rows(); ++i)
      for (int j = 0; j < border_.columns(); ++j)
        reward(i, j) = from_ + j * step_ < least_radius[i] ? -2.0F
                       : border_.inside(i, j)              ? std::min(evidence_(i, j), kEnough) - kLeastEvidence
                                                           : 0.0F;
    Border found;
    found.path = best_closed_path(reward, 1, 0.15F);
    found.edge.points.resize(2, kRays);
    int seen = 0, visible = 0;
    double sum = 0.0;
    std::vector<Eigen::Vector2d> shown;
    for (int i = 0; i < kRays; ++i) {
      const int j = found.path[static_cast<std::size_t>(i)];
      found.edge.points.col(i) = center_ + (from_ + j * step_) * normals_.col(i);
      if (!border_.inside(i, j)) continue;
      ++visible;
      if (reward(i, j) > 0.0F) {
        ++seen;
        shown.push_back(found.edge.points.col(i));
      }
      sum += evidence_(i, j);
    }
    found.edge.is_border = true;
    found.edge.kind = {0.0, 1.0};
    found.edge.scale_px = kWindow_ratio * radius_ / 3.0;
    found.edge.coverage = static_cast<double>(seen) / std::max(visible, 1);
    found.edge.contrast = sum / std::max(visible, 1);
    if (visible < 0.4 * kRays || found.edge.coverage < 0.7 || found.edge.contrast < 0.55) return std::nullopt;
    const double hidden = 1.0 - static_cast<double>(visible) / kRays;
    if (coherence(found.path) < kLeastCoherence + kMoreCoherence * hidden) return std::nullopt;
    Eigen::Matrix2Xd clear(2, static_cast<Eigen::Index>(shown.size()));
    for (std::size_t k = 0; k < shown.size(); ++k) clear.col(static_cast<Eigen::Index>(k)) = shown[k];
    found.circle = contour::fit_circle(clear, 0.06 * radius_);
    if (found.circle.inlier_ratio < 0.6) return std::nullopt;
    return found;
  }

  // How much of a path's evidence is of one sign all round, or goes from one to the other across the cell, as relief
  // does. Specks on either side of a path are evidence of either sign.
  double coherence(const std::vector<int>& path) const {
    double explained = 0.0, whole = 0.0;
    for (const Eigen::MatrixXf* part : {&brightness_, &texture_}) {
      Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
      Eigen::Vector3d right = Eigen::Vector3d::Zero();
      for (int i = 0; i < kRays; ++i) {
        const int j = path[static_cast<std::size_t>(i)];
        if (!border_.inside(i, j)) continue;
        const Eigen::Vector3d shape(1.0, normals_(0, i), normals_(1, i));
        const double value = (*part)(i, j);
        normal += shape * shape.transpose();
        right += value * shape;
        whole += value * value;
      }
      explained += right.dot(normal.ldlt().solve(right));
    }
    return whole > 0.0 ? explained / whole : 0.0;
  }

  // Moves a border to where it splits its neighbourhood best; outside the image it runs on evenly.
  void settle(Border& border) const {
    const int reach = static_cast<int>(std::lround(kWindow_ratio * radius_ / step_));
    Eigen::MatrixXf likelihood;
    border_.split(border.path, reach, kRays / 24, noise_, likelihood);
    likelihood = likelihood.cwiseMax(-1.0F);
    const std::vector<int> offsets = best_closed_path(likelihood, 1, 0.02F);
    std::vector<int> seen;
    for (int i = 0; i < kRays; ++i) {
      const int j = border.path[static_cast<std::size_t>(i)];
      if (!border_.inside(i, j)) continue;
      seen.push_back(i);
      border.edge.points.col(i) += (offsets[static_cast<std::size_t>(i)] - reach) * step_ * normals_.col(i);
    }
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const int first = seen[k], last = k + 1 < seen.size() ? seen[k + 1] : seen.front() + kRays;
      const double a = (border.edge.points.col(first) - center_).norm();
      const double b = (border.edge.points.col(last % kRays) - center_).norm();
      for (int i = first + 1; i < last; ++i)
        border.edge.points.col(i % kRays) =
            center_ + (a + (b - a) * (i - first) / (last - first)) * normals_.col(i % kRays);
    }
  }

  double radius_at(int column) const noexcept { return from_ + column * step_; }
  const Eigen::Matrix2Xd& directions() const noexcept { return normals_; }

  static constexpr double kWindow_ratio = 0.09;  // of the radius

 private:
  Eigen::Vector2d center_;
  double radius_, from_, step_, noise_;
  Eigen::Matrix2Xd normals_;
  RegionBorder border_;
  Eigen::MatrixXf evidence_, brightness_, texture_;
};

}  // namespace

std::optional<FoundEdge> find_soft_outer_edge(const GrayImage& image, const FoundEdge& oolemma,
                                              const contour::Circle& circle, double noise) {
  Eigen::Vector2d center = circle.center;
  const double r = circle.radius;
  std::optional<Border> best;
  for (int round = 0; round < 2; ++round) {
    // First round the oolemma, then round the border itself, which need not be concentric with it.
    const double to = round == 0 ? 1.85 * r : std::min(1.85 * r, 1.15 * best->circle.radius);
    const double from = round == 0 ? r : std::max(r, 0.85 * best->circle.radius);
    const Surroundings around(image, center, r, from, to, noise);
    Eigen::VectorXd least(kRays);
    for (int i = 0; i < kRays; ++i)
      least[i] = outline_radius(oolemma.points, center, around.directions().col(i)) +
                 std::max(kLeastZona_ratio * r, kLeastZona_px);
    // The outermost clear border is the zona's end: gap, halo and grain lie within.
    std::optional<Border> outermost;
    while (std::optional<Border> further = around.best_beyond(least)) {
      for (int i = 0; i < kRays; ++i)
        least[i] = around.radius_at(further->path[static_cast<std::size_t>(i)]) + 1.3 * Surroundings::kWindow_ratio * r;
      outermost = std::move(further);
    }
    if (!outermost) return best ? std::optional(best->edge) : std::nullopt;
    best = std::move(outermost);
    around.settle(*best);
    center = best->circle.center;
  }
  return best->edge;
}

std::optional<FoundEdge> find_gap_edge(const GrayImage& image, const FoundEdge& oolemma, const contour::Circle& circle,
                                       const FoundEdge& outer, double noise) {
  const double r = circle.radius, step = std::max(0.5, r / 90.0), window = 0.05 * r, give = 0.05 * r;
  const Eigen::Matrix2Xd base = contour::resample(contour::positively_oriented(oolemma.points), kRays);
  const Eigen::Matrix2Xd normals = contour::outward_normals(base);

  // A zona is a shell of even thickness: what it measures where the oolemma touches it, it measures everywhere.
  Eigen::VectorXd room(kRays);
  for (int i = 0; i < kRays; ++i) room[i] = contour::distance_to(outer.points, base.col(i));
  std::vector<double> sorted(room.begin(), room.end());
  const auto low = sorted.begin() + kRays / 6;
  std::nth_element(sorted.begin(), low, sorted.end());
  const double thickness = *low;

  // Column 0 is the oolemma itself, where the zona touches it; a gap must be wider than the oolemma's own halo.
  RegionBorder border;
  border.sample(image, base, normals, 0.0, std::max(4.0 * step, room.maxCoeff() - 0.7 * thickness), step, window);
  Eigen::MatrixXf evidence;
  border.evidence(2, noise, evidence);
  const int least = std::min(border.columns(), static_cast<int>(std::ceil(0.07 * r / step)));
  // The oolemma's halo follows it all round; only what stands out from that is a gap's edge.
  std::vector<float> column(kRays);
  for (int j = 0; j < border.columns() && border.offset_of(j) < 0.15 * r; ++j) {
    for (int i = 0; i < kRays; ++i) column[static_cast<std::size_t>(i)] = evidence(i, j);
    std::nth_element(column.begin(), column.begin() + kRays / 2, column.end());
    evidence.col(j).array() -= column[kRays / 2];
  }
  Eigen::MatrixXf reward(border.rows(), border.columns());
  for (int i = 0; i < border.rows(); ++i) {
    for (int j = 0; j < border.columns(); ++j) {
      const double off = (border.offset_of(j) - std::max(0.0, room[i] - thickness)) / give;
      const float even = static_cast<float>(-0.1 * std::min(off * off, 20.0));
      const float seen = border.inside(i, j) ? std::min(evidence(i, j), kEnough) : kLeastEvidence;
      reward(i, j) = even + (j == 0 ? kLeastEvidence : j < least ? -1.0F : seen);
    }
  }
  const std::vector<int> path = best_closed_path(reward, least + 1, 0.05F);
  FoundEdge gap;
  gap.is_border = true;
  gap.kind = {0.0, 1.0};
  gap.scale_px = window / 3.0;
  gap.points = base;
  int open = 0;
  for (int i = 0; i < kRays; ++i) {
    const int j = path[static_cast<std::size_t>(i)];
    if (j < least) continue;
    ++open;
    gap.coverage += evidence(i, j) > kLeastEvidence ? 1.0 : 0.0;
    gap.contrast += evidence(i, j);
    gap.points.col(i) += border.offset_of(j) * normals.col(i);
  }
  if (open < kRays / 10) return std::nullopt;
  gap.coverage /= open;
  gap.contrast /= open;
  return gap;
}

}  // namespace pellucida
