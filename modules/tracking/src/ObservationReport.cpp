#include "ObservationReport.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ContourMath.h"

namespace pellucida {
namespace {

// The contour rounds a steep dimple a little: what that adds to its sigma at the apex, px.
constexpr double kRounding_px = 0.3;
// More of it where networks read it, px and as a share of the tip's depth. In 961 frames of contact of 36 tuning and
// wide films (306001 to 306030, 307001 to 307030) they had it 0.6 px too shallow in the median, 0.9 px where it was 15
// px deep and more, and four of what they took for its standard deviation off in a third of them; the tip 1.1 of its
// own.
constexpr double kReadRounding_px = 0.6, kReadRounding_ratio = 0.08;
// Networks take their contours for more precise than they are: by this factor in 134 tuning, wide, validation and
// unseen films before the touch; in contact they were 0.3 to 0.46 px off, which this adds, px.
constexpr double kReadSigma_ratio = 2.0, kReadInContact_px = 0.3;
constexpr double kUsualTipSigma_px = 0.35;  // where the needle's tip comes without its own
constexpr double kMostWhenUnseen = 0.5;     // confidence in a frame that shows a dent and not what makes it

// The indentation and its standard deviation. Under the tip the membrane is where the tip is: two measures of one
// depth, weighted by their variances as long as they agree; the resting outline, from which both are taken, adds its
// own.
struct Depth {
  double value_px = 0.0, sigma_px = 0.0;
};
Depth depth_of(const CellFollower& cell) {
  const double seen_sigma = std::hypot(cell.membrane_sigma(), kRounding_px);
  const double reported = cell.needle().estimate().tip_sigma;
  const double tip_sigma = reported > 0.0 ? std::max(reported, 0.05) : kUsualTipSigma_px;
  const double apart = std::abs(cell.tip_depth() - cell.membrane_depth());
  const bool agrees = apart < std::max(4.0, 4.0 * std::hypot(seen_sigma, tip_sigma));
  Depth depth{cell.membrane_depth(), seen_sigma};
  if (cell.state() == CellState::kContact && agrees) {
    const double read = std::hypot(kReadRounding_px, kReadRounding_ratio * cell.tip_depth());
    const double membrane_sigma = cell.is_read() ? std::hypot(seen_sigma, read) : seen_sigma;
    const double tip_weight = 1.0 / (tip_sigma * tip_sigma), rest_weight = 1.0 / (membrane_sigma * membrane_sigma);
    const double share = tip_weight / (tip_weight + rest_weight);
    depth.value_px = share * cell.tip_depth() + (1.0 - share) * cell.membrane_depth();
    depth.sigma_px = std::sqrt(1.0 / (tip_weight + rest_weight));
  }
  depth.sigma_px = std::hypot(depth.sigma_px, cell.rest_sigma());
  return depth;
}

MembraneContour membrane(const CellFollower& cell, const SnakeContour& snake, Membrane which,
                         const Eigen::Vector2d& start_direction, double pixel_size_um) {
  // Begin where the ray from the centre towards the needle crosses; carry sigma and confidence along.
  const Eigen::Index n = snake.points.cols();
  const double arc = std::max(0.0, contour::ray_crossing_arc(snake.points, cell.center_now(), start_direction));
  MembraneContour result;
  result.membrane = which;
  result.points_um = contour::resample(snake.points, n, arc);
  result.points_um *= pixel_size_um;
  result.sigma_um.resize(n);
  result.confidence.resize(n);
  const double ratio = cell.is_read() ? kReadSigma_ratio : 1.0;
  const double more_px = cell.is_read() && cell.state() != CellState::kFree ? kReadInContact_px : 0.0;
  const double spacing = contour::arc_length(snake.points) / static_cast<double>(n);
  const Eigen::Index first = spacing > 0.0 ? static_cast<Eigen::Index>(std::lround(arc / spacing)) : 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index k = contour::wrap(first + i, n);
    result.sigma_um[i] = std::hypot(ratio * snake.sigma_px[k], more_px) * pixel_size_um;
    result.confidence[i] = snake.confidence[k];
  }
  return result;
}

void move_outwards(MembraneContour& contour, double by_um) {
  contour.points_um += by_um * contour::outward_normals(contour.points_um);
}

void fill_needle(const CellFollower& cell, Observation& out, double pixel_size_um) {
  const NeedleEstimate& n = cell.needle().estimate();
  out.needle = needle_pose(n, pixel_size_um);

  const bool contact = cell.state() == CellState::kContact;
  const Depth depth = depth_of(cell);
  out.indentation_um = cell.state() == CellState::kFree ? 0.0 : std::max(0.0, depth.value_px) * pixel_size_um;
  out.indentation_sigma_um = depth.sigma_px * pixel_size_um;
  const Eigen::Vector2d entry = cell.rest().entry_point(cell.center_now(), n.tip, n.direction, cell.motion().angle_rad);
  out.rest_beyond_um = ((entry - cell.center_now()).norm() - cell.rest().outer_radius) * pixel_size_um;
  out.side_bulge_um = cell.side_bulge() * pixel_size_um;
  out.pierced_probability = cell.pierced_probability().value_or(out.pierced_probability);
  if (!contact) return;
  out.dimple_radius_um = pixel_size_um * dimple_radius(cell.snakes().outer().points, cell.center_now(),
                                                       entry + cell.membrane_depth() * n.direction, -n.direction);
}

void fill_holder(const CellFollower& cell, Observation& out, double pixel_size_um) {
  const HolderFit& found = *cell.holder();
  HolderPose pose;
  pose.direction = cell.holder_direction();
  const Eigen::Vector2d mouth = cell.motion().apply(found.mouth);
  const Eigen::Vector2d side = found.half_width * Eigen::Vector2d(-pose.direction.y(), pose.direction.x());
  const Eigen::Vector2d back = mouth + 1.5 * cell.rest().outer_radius * pose.direction;
  pose.mouth_um = mouth * pixel_size_um;
  pose.outer_radius_um = found.half_width * pixel_size_um;
  pose.outer_radius_sigma = found.half_width_sigma;
  pose.confidence = found.confidence;
  Eigen::Matrix<double, 2, 4> outline;
  outline << back + side, mouth + side, mouth - side, back - side;
  pose.outline_um = outline * pixel_size_um;
  out.holder = std::move(pose);
}

}  // namespace

NeedlePose needle_pose(const NeedleEstimate& n, double pixel_size_um) {
  NeedlePose pose;
  pose.tip_um = n.tip * pixel_size_um;
  pose.direction = n.direction;
  pose.tip_radius_um = n.tip_radius * pixel_size_um;
  pose.tip_radius_sigma = n.tip_radius_sigma;
  pose.confidence = n.confidence;
  pose.tip_sigma_um = n.tip_sigma * pixel_size_um;
  pose.evidence = n.evidence;
  // Tip, one side as far as it was fitted and forward again, then the other side: no line crosses the open shaft.
  const Eigen::Vector2d across(-n.direction.y(), n.direction.x());
  const double length = 80.0;
  const Eigen::Vector2d front = n.tip - n.tip_half_width * n.direction;
  const Eigen::Vector2d back = n.tip - length * n.direction;
  const double back_half_width = n.tip_half_width + n.widening * length;
  Eigen::Matrix<double, 2, 9> outline;
  outline << n.tip, front + n.tip_half_width * across, back + back_half_width * across,
      front + n.tip_half_width * across, n.tip, front - n.tip_half_width * across, back - back_half_width * across,
      front - n.tip_half_width * across, n.tip;
  pose.outline_um = outline * pixel_size_um;
  return pose;
}

Observation report(const CellFollower& cell, double pixel_size_um) {
  Observation out;
  out.state = cell.state();
  out.confidence = cell.confidence();
  const Eigen::Vector2d center = cell.center_now();
  Eigen::Vector2d axis = cell.holder() ? Eigen::Vector2d(-cell.holder_direction()) : Eigen::Vector2d::UnitX();
  if (cell.needle().valid()) axis = -cell.needle().estimate().direction;
  out.outer = membrane(cell, cell.snakes().outer(), Membrane::kOuter, axis, pixel_size_um);
  if (cell.snakes().has_inner() && cell.snakes().inner().score > 0.25)
    out.inner = membrane(cell, cell.snakes().inner(), Membrane::kInner, axis, pixel_size_um);
  // A zona that does not lie round the oolemma is none.
  const bool has_zona = cell.zona().valid() && cell.zona().rest_radius() > cell.rest().outer_radius;
  if (has_zona) {
    // The snakes follow the oolemma: the zona's inner edge where it touches, the third membrane where a gap parts them.
    MembraneContour line =
        *std::exchange(out.outer, membrane(cell, cell.zona().outer(), Membrane::kOuter, axis, pixel_size_um));
    line.membrane = cell.zona().has_gap() ? Membrane::kOolemma : Membrane::kInner;
    (cell.zona().has_gap() ? out.oolemma : out.inner) = std::move(line);
    if (cell.zona().has_gap()) out.inner = membrane(cell, cell.zona().gap(), Membrane::kInner, axis, pixel_size_um);
  }
  out.center_um = center * pixel_size_um;
  out.rotation_rad = cell.motion().angle_rad;
  out.rest_outer_radius_um = cell.rest().outer_radius * pixel_size_um;
  out.rest_inner_radius_um = cell.rest().inner_radius * pixel_size_um;
  if (has_zona) {
    out.rest_outer_radius_um = cell.zona().rest_radius() * pixel_size_um;
    out.rest_inner_radius_um = cell.rest().outer_radius * pixel_size_um;
  }
  if (const ReadThickness& read = cell.rest().read_thickness; read.is_read() && !has_zona) {
    const double thickness_um = read.mean_px() * pixel_size_um;
    // Alike all round: the inner boundary is that of each normal by its shape, and by its distance that of them all.
    if (out.inner) move_outwards(*out.inner, cell.snakes().thickness_px() * pixel_size_um - thickness_um);
    out.rest_inner_radius_um = out.rest_outer_radius_um - thickness_um;
    out.rest_thickness_sigma_um = read.log_sigma() * thickness_um;
  } else if (out.rest_inner_radius_um <= 0.0) {
    const ThinZona thin = cell.rest().thin_zona.mean();
    if (thin.thickness_px > 0.0)
      out.rest_inner_radius_um = out.rest_outer_radius_um - thin.thickness_px * pixel_size_um;
    out.rest_thickness_sigma_um = thin.sigma_px * pixel_size_um;
    out.rest_thickness_limit_um = thin.limit_px * pixel_size_um;
  }
  out.axis = axis;
  if (cell.needle().valid()) fill_needle(cell, out, pixel_size_um);
  if (cell.holder()) fill_holder(cell, out, pixel_size_um);
  if (cell.state() == CellState::kFree && cell.is_dented()) {
    // Something pushes, and it isn't where the needle was taken to be, if one was: a contact without a needle.
    out.state = CellState::kContact;
    out.needle.reset();
    out.indentation_um = out.indentation_sigma_um = 0.0;
    out.confidence = std::min(out.confidence, kMostWhenUnseen);
  }
  return out;
}

}  // namespace pellucida
