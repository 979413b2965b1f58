#include "pellucida/haptics/Fixtures.h"

#include <algorithm>
#include <cmath>

#include "pellucida/haptics/ForceGuards.h"

namespace pellucida {
namespace {

constexpr double kTiny_um = 1e-9;

/// c(p): the softened violation.
double softened_um(double violation_um, double width_um) noexcept {
  if (violation_um <= 0.0) return 0.0;
  if (violation_um < width_um) return violation_um * violation_um / (2.0 * width_um);
  return violation_um - 0.5 * width_um;
}

// A place beside a line: how far along it, how far from it, and the unit vector away from it.
struct BesideLine {
  double along_um = 0.0;
  double radius_um = 0.0;
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();
};
BesideLine beside_line(const Eigen::Vector3d& tip_um, const PlainVector3& origin, const PlainVector3& axis) noexcept {
  const Eigen::Vector3d direction = axis.eigen(), from_origin = tip_um - origin.eigen();
  BesideLine place;
  place.along_um = from_origin.dot(direction);
  const Eigen::Vector3d across = from_origin - place.along_um * direction;
  place.radius_um = across.norm();
  if (place.radius_um > kTiny_um) place.outward = across / place.radius_um;
  return place;
}

// The way back into a body of revolution r <= allowed(along), with the profile's slope d allowed / d along.
Eigen::Vector3d into_profile(const BesideLine& place, const Eigen::Vector3d& axis, double allowed_um, double slope,
                             double width_um) noexcept {
  const double steepness = std::sqrt(1.0 + slope * slope);
  const double violation_um = (place.radius_um - allowed_um) / steepness;
  return -softened_um(violation_um, width_um) / steepness * (place.outward - slope * axis);
}

// Two ways out of a forbidden body, of lengths a and b: the violation is their smooth minimum (a^-4 + b^-4)^(-1/4), and
// the way out its gradient, so that nothing jumps where one gets shorter than the other.
Eigen::Vector3d out_of(double a_um, const Eigen::Vector3d& a_way, double b_um, const Eigen::Vector3d& b_way,
                       double width_um) noexcept {
  if (a_um <= kTiny_um || b_um <= kTiny_um) return Eigen::Vector3d::Zero();
  const double least = std::min(a_um, b_um);
  const double a_ratio = std::pow(least / a_um, 4), b_ratio = std::pow(least / b_um, 4);
  const double smooth_um = least * std::pow(a_ratio + b_ratio, -0.25);
  const double a_weight = std::pow(smooth_um / a_um, 5), b_weight = std::pow(smooth_um / b_um, 5);
  return softened_um(smooth_um, width_um) * (a_weight * a_way + b_weight * b_way);
}

}  // namespace

Eigen::Vector3d correction_um(const RectilinearGuide& guide, const Eigen::Vector3d& tip_um) noexcept {
  const BesideLine place = beside_line(tip_um, guide.entry_um, guide.axis);
  const double before_um = std::max(0.0, -place.along_um);
  const double allowed_um = guide.radius_um + before_um * before_um / (2.0 * guide.opening_um);
  return into_profile(place, guide.axis.eigen(), allowed_um, -before_um / guide.opening_um, guide.feel.width_um);
}

Eigen::Vector3d correction_um(const ApproachCone& cone, const Eigen::Vector3d& tip_um) noexcept {
  const BesideLine place = beside_line(tip_um, cone.entry_um, cone.axis);
  const double before_um = -place.along_um;
  const double tangent = std::tan(cone.half_angle_rad);
  double allowed_um = cone.radius_um, growth = 0.0;
  if (before_um >= 0.0) {
    // The cone's slope sets in over the opening, and goes on until its length; from there it opens as a trumpet.
    const double in_um = std::min(before_um, cone.opening_um);
    allowed_um += tangent * (in_um * in_um / (2.0 * cone.opening_um) + (before_um - in_um));
    growth = tangent * in_um / cone.opening_um;
    const double past_um = std::max(0.0, before_um - cone.length_um);
    allowed_um += past_um * past_um / (2.0 * cone.opening_um);
    growth += past_um / cone.opening_um;
  } else {
    // Inside the cell the cone opens away: the guide leads there.
    allowed_um += before_um * before_um / (2.0 * cone.opening_um);
    growth = before_um / cone.opening_um;
  }
  return into_profile(place, cone.axis.eigen(), allowed_um, -growth, cone.feel.width_um);
}

Eigen::Vector3d correction_um(const DepthStop& stop, const Eigen::Vector3d& tip_um) noexcept {
  const Eigen::Vector3d axis = stop.axis.eigen();
  const double violation_um = (tip_um - stop.entry_um.eigen()).dot(axis) - stop.depth_um;
  return -softened_um(violation_um, stop.feel.width_um) * axis;
}

Eigen::Vector3d correction_um(const CellBody& body, const Eigen::Vector3d& tip_um) noexcept {
  const Eigen::Vector3d from_center = tip_um - body.center_um.eigen();
  const double distance_um = from_center.norm();
  const BesideLine place = beside_line(tip_um, body.entry_um, body.axis);
  const Eigen::Vector3d outward =
      distance_um > kTiny_um ? Eigen::Vector3d(from_center / distance_um) : Eigen::Vector3d::Zero();
  return out_of(body.radius_um - distance_um, outward, place.radius_um - body.path_radius_um, -place.outward,
                body.feel.width_um);
}

Eigen::Vector3d correction_um(const HolderBody& holder, const Eigen::Vector3d& tip_um) noexcept {
  const BesideLine place = beside_line(tip_um, holder.mouth_um, holder.direction);
  // On its axis there is no way sideways that is better than the others: it sets in with the distance from there.
  const Eigen::Vector3d sideways = smooth_step(2.0 * place.radius_um / holder.radius_um) * place.outward;
  return out_of(place.along_um, -holder.direction.eigen(), holder.radius_um - place.radius_um, sideways,
                holder.feel.width_um);
}

FixtureResult apply(const FixtureSet& set, const Eigen::Vector3d& wanted_um, const Eigen::Vector3d& velocity_um_per_s,
                    double scale_um_per_m, double part) noexcept {
  FixtureResult result;
  result.allowed_um = wanted_um;
  const auto take = [&](const auto& fixture, FixtureBit bit) {
    if (!fixture.enabled || part <= 0.0) return;
    const Eigen::Vector3d correction = part * correction_um(fixture, result.allowed_um);
    const double length_um = correction.norm();
    if (length_um <= kTiny_um) return;
    result.acting |= bit;
    result.allowed_um += correction;
    // Damping along the correction, setting in with it.
    const Eigen::Vector3d along = correction / length_um;
    const double weight = smooth_step(length_um / fixture.feel.width_um);
    const double rate_um_per_s = velocity_um_per_s.dot(along);
    result.force_N += saturate((fixture.feel.stiffness_N_per_m * correction -
                                fixture.feel.damping_N_s_per_m * weight * rate_um_per_s * along) /
                                   scale_um_per_m,
                               set.max_force_N);
  };
  take(set.guide, kGuideBit);
  take(set.cone, kConeBit);
  take(set.stop, kStopBit);
  take(set.cell, kCellBit);
  take(set.holder, kHolderBit);
  result.force_N = saturate(result.force_N, set.max_force_N);
  return result;
}

}  // namespace pellucida
