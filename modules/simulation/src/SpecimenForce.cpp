#include "pellucida/simulation/SpecimenForce.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "Interpolation.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/simulation/CellReference.h"

namespace pellucida {

SpecimenForce SpecimenForce::load(std::string_view cell, int configuration, const Frame& frame) {
  const CellReference reference = CellReference::load(cell, configuration);
  SpecimenForce field;
  field.frame_ = frame;
  // Out of round the needle stays on the axis.
  field.radius_um_ = reference.offset_um() > 0.0 ? reference.outer_radius_um() : reference.apex_z_um();
  field.max_depth_um_ = reference.max_indentation_um();
  field.symmetric_ = reference.holder_angle_rad() == 0.0;

  // The needle through the centre, and beside it; configuration 4 is configuration 1 with the needle moved.
  const std::string stem = "-" + std::to_string(configuration == 4 ? 1 : configuration);
  const ReferencePlace place = find_reference(cell);
  const Table middle = Table::read(place.file(stem + "-force.csv"));
  // Without a table of offsets the needle has to stay on the cell's axis.
  const std::filesystem::path field_file = place.file(stem + "-field.csv");
  const bool has_field = std::filesystem::exists(field_file);
  Eigen::VectorXd offset, beside_depth, beside_force;
  if (has_field) {
    const Table beside = Table::read(field_file);
    offset = beside.column("offset_um");
    beside_depth = beside.column("indentation_um");
    beside_force = beside.column("force_uN");
  } else {
    field.max_offset_um_ = reference.offset_um() + kOnAxis_um;
  }

  auto fill = [&](Curve& curve, const std::vector<double>& depth_um, const std::vector<double>& force_uN) {
    const auto n = static_cast<Eigen::Index>(depth_um.size());
    if (n < 3 || n > kMaxKnots)
      throw InputError(field_file.string() + ": " + std::to_string(n) + " depths at an offset; 3 to 64 are allowed");
    const Eigen::VectorXd depth = Eigen::Map<const Eigen::VectorXd>(depth_um.data(), n);
    const Eigen::VectorXd force = Eigen::Map<const Eigen::VectorXd>(force_uN.data(), n);
    const Eigen::VectorXd slope = monotone_slopes(depth, force);
    curve.count = static_cast<int>(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      curve.depth_um[k] = depth(i);
      curve.force_uN[k] = force(i);
      curve.slope[k] = slope(i);
      // The integral of a cubic: the trapezium and what its end slopes add.
      if (i == 0) continue;
      const double h = depth(i) - depth(i - 1);
      curve.energy[k] =
          curve.energy[k - 1] + h * (force(i) + force(i - 1)) / 2 + h * h * (slope(i - 1) - slope(i)) / 12;
    }
  };
  for (int c = 0; c < kCurves; ++c) {
    Curve& curve = field.curves_[static_cast<std::size_t>(c)];
    double wanted_um = kOffsetStep_um * (c - kCurves / 2);
    std::vector<double> depths, forces;
    if (wanted_um == 0.0 || !has_field) {
      const Eigen::VectorXd d = middle.column("indentation_um"), f = middle.column("force_uN");
      depths.assign(d.data(), d.data() + d.size());
      forces.assign(f.data(), f.data() + f.size());
    } else {
      // Both sides are alike about the holder's axis.
      if (field.symmetric_) wanted_um = std::abs(wanted_um);
      for (Eigen::Index i = 0; i < offset.size(); ++i) {
        if (offset(i) != wanted_um) continue;
        depths.push_back(beside_depth(i));
        forces.push_back(beside_force(i));
      }
    }
    fill(curve, depths, forces);
  }
  return field;
}

SpecimenForce::Value SpecimenForce::value_of(const Curve& curve, double depth_um) noexcept {
  const auto last = static_cast<std::size_t>(curve.count - 1);
  // Past the last knot the force grows on with its slope there.
  if (depth_um >= curve.depth_um[last]) {
    const double past = depth_um - curve.depth_um[last], slope = curve.slope[last];
    return {curve.energy[last] + past * (curve.force_uN[last] + past * slope / 2), curve.force_uN[last] + past * slope,
            slope};
  }
  const auto first = curve.depth_um.begin();
  const auto upper = std::upper_bound(first, first + curve.count, depth_um) - first;
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(upper - 1, 0));
  const double h = curve.depth_um[i + 1] - curve.depth_um[i], t = (depth_um - curve.depth_um[i]) / h;
  const double f0 = curve.force_uN[i], f1 = curve.force_uN[i + 1], m0 = h * curve.slope[i], m1 = h * curve.slope[i + 1];
  // f = f0 + m0 t + a t^2 + b t^3
  const double a = 3 * (f1 - f0) - 2 * m0 - m1, b = 2 * (f0 - f1) + m0 + m1;
  return {curve.energy[i] + h * t * (f0 + t * (m0 / 2 + t * (a / 3 + t * b / 4))), f0 + t * (m0 + t * (a + t * b)),
          (m0 + t * (2 * a + t * 3 * b)) / h};
}

SpecimenReply SpecimenForce::at(const PlainVector3& tip_um) const noexcept {
  // Into the reference's size, along across, out of the plane and the needle's axis.
  const double scale = frame_.size_scale;
  const Eigen::Vector3d axis = frame_.axis.eigen(), across = frame_.across.eigen();
  const Eigen::Vector3d from = (tip_um.eigen() - frame_.center_um.eigen()) / scale;
  const double s = from.dot(across), t = from.z(), z = from.dot(axis);
  const double away2 = s * s + t * t, away = std::sqrt(away2);

  SpecimenReply reply;
  reply.offset_um = scale * s;
  reply.out_of_plane_um = scale * t;
  const double rest_z = std::sqrt(std::max(0.0, radius_um_ * radius_um_ - away2)), depth = rest_z - z;
  reply.depth_um = scale * depth;
  if (max_depth_um_ <= 0 || depth <= 0) return reply;
  if (away >= kGone_um) {
    // Beside the cell: nothing is touched.
    reply.depth_um = std::min(reply.depth_um, 0.0);
    return reply;
  }
  reply.in_range = away <= max_offset_um_ && depth <= max_depth_um_;

  // Energy, force along and stiffness at the five offsets, joined by cubics with the slopes of their neighbours.
  const double place = symmetric_ ? away : s;
  const double clamped = std::clamp(place, -kMaxOffset_um, kMaxOffset_um);
  const int cell = std::clamp(static_cast<int>(std::floor(clamped / kOffsetStep_um)) + kCurves / 2, 0, kCurves - 2);
  std::array<Value, 4> value{};
  for (int k = 0; k < 4; ++k) {
    const int c = std::clamp(cell - 1 + k, 0, kCurves - 1);
    value[static_cast<std::size_t>(k)] = value_of(curves_[static_cast<std::size_t>(c)], depth);
  }
  const double u = (clamped - kOffsetStep_um * (cell - kCurves / 2)) / kOffsetStep_um, u2 = u * u, u3 = u2 * u;
  const double h0 = 2 * u3 - 3 * u2 + 1, h1 = 3 * u2 - 2 * u3, g0 = u3 - 2 * u2 + u, g1 = u3 - u2;
  const double d0 = 6 * (u2 - u), e0 = 3 * u2 - 4 * u + 1, e1 = 3 * u2 - 2 * u;
  // At the outermost curves the slope is the one-sided one.
  const double left = cell == 0 ? 1.0 : 0.5, right = cell == kCurves - 2 ? 1.0 : 0.5;
  auto join = [&](double Value::*part, double& slope) {
    const double v0 = value[1].*part, v1 = value[2].*part;
    const double m0 = left * (v1 - value[0].*part), m1 = right * (value[3].*part - v0);
    slope = (d0 * (v0 - v1) + e0 * m0 + e1 * m1) / kOffsetStep_um;
    return h0 * v0 + h1 * v1 + g0 * m0 + g1 * m1;
  };
  double energy_slope, force_slope, stiffness_slope;
  double energy = join(&Value::energy, energy_slope), force = join(&Value::force, force_slope);
  const double stiffness = join(&Value::slope, stiffness_slope), beyond = place - clamped;
  energy += beyond * energy_slope;
  force += beyond * force_slope;

  // The needle slips off towards the side.
  double fade = 1.0, fade_slope = 0.0;
  if (away > kMaxOffset_um) {
    const double way = (away - kMaxOffset_um) / (kGone_um - kMaxOffset_um);
    fade = 1 - way * way * (3 - 2 * way);
    fade_slope = -6 * way * (1 - way) / (kGone_um - kMaxOffset_um);
  }

  // -grad U; the resting surface falls off to the sides.
  const double axial = fade * force;
  const double side = symmetric_ ? (away > 0 ? energy_slope / away : 0.0) : 0.0;
  const double spread = (away > 0 ? fade_slope * energy / away : 0.0) + fade * side - axial / rest_z;
  const double gradient_s = spread * s + (symmetric_ ? 0.0 : fade * energy_slope), gradient_t = spread * t;
  const double units = scale * scale * frame_.stiffness_ratio;
  reply.axial_force_uN = units * axial;
  reply.lateral_force_uN = units * gradient_s;
  reply.force_uN =
      Eigen::Vector3d(units * (axial * axis - gradient_s * across - gradient_t * Eigen::Vector3d::UnitZ()));
  reply.indentation_um = scale * fade * std::min(depth, max_depth_um_);
  reply.energy_uN_um = units * scale * fade * energy;
  reply.stiffness_uN_per_um = frame_.stiffness_ratio * scale * fade * (stiffness + beyond * stiffness_slope);
  return reply;
}

PlainVector3 SpecimenForce::tip_at(double offset_um, double depth_um) const noexcept {
  const double radius_um = frame_.size_scale * radius_um_;
  const double rest_um = std::sqrt(std::max(0.0, radius_um * radius_um - offset_um * offset_um));
  return Eigen::Vector3d(frame_.center_um.eigen() + offset_um * frame_.across.eigen() +
                         (rest_um - depth_um) * frame_.axis.eigen());
}

}  // namespace pellucida
