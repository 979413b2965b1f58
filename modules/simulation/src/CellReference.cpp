#include "pellucida/simulation/CellReference.h"

#include <cmath>
#include <numbers>

#include "Interpolation.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Resources.h"
#include "pellucida/core/Table.h"
#include "pellucida/microscopy/MicroscopeScene.h"

namespace pellucida {
namespace {

constexpr int kPointCount = 400;
constexpr double kOffset_um = 10.0;  // of the needle in configuration 4

// Rows of one depth step of a profile file.
struct Step {
  double depth_um;
  Eigen::Index first, count;
};

std::vector<Step> steps_of(const Eigen::VectorXd& depth_um) {
  std::vector<Step> steps;
  for (Eigen::Index i = 0; i < depth_um.size(); ++i) {
    if (steps.empty() || steps.back().depth_um != depth_um(i)) steps.push_back({depth_um(i), i, 0});
    ++steps.back().count;
  }
  return steps;
}

// Material angles of the contour points: even, but 3.5 times as dense under the tip, where the dimple is sharp.
Eigen::VectorXd material_angles(double apex_rad) {
  constexpr int kFine = 20000;
  auto density = [](double angle) { return 1.0 + 2.5 * std::exp(-angle * angle / (2 * 0.3 * 0.3)); };
  Eigen::VectorXd cumulative(kFine + 1);
  cumulative(0) = 0;
  for (int i = 0; i < kFine; ++i)
    cumulative(i + 1) = cumulative(i) + density(-std::numbers::pi + 2 * std::numbers::pi * (i + 0.5) / kFine);

  Eigen::VectorXd angles(kPointCount);
  int cell = 0;
  for (int k = 0; k < kPointCount; ++k) {
    const double target = cumulative(kFine) * k / kPointCount;
    while (cumulative(cell + 1) < target) ++cell;
    const double part = (target - cumulative(cell)) / (cumulative(cell + 1) - cumulative(cell));
    angles(k) = -std::numbers::pi + 2 * std::numbers::pi * (cell + part) / kFine;
  }
  // The apex itself is a material point.
  angles(kPointCount / 2) = 0.0;
  return angles.array() + apex_rad;
}

// A surface's displacement (2 x n) at the material angles, from scattered nodes on a sphere of radius `radius_um`.
// The mesh's last corners under the tip are rounded off over about 1 um, so that the surfaces 2.5 um to both sides have
// no folds; the apex keeps its depth. The tip touches at the middle one of the angles.
Contour_um smooth_surface(const Eigen::VectorXd& node_angle, const Eigen::VectorXd& node_x,
                          const Eigen::VectorXd& node_z, double radius_um, double apex_z_um,
                          const Eigen::VectorXd& angles) {
  const Eigen::VectorXd ux = node_x.array() - radius_um * node_angle.array().sin();
  const Eigen::VectorXd uz = node_z.array() - radius_um * node_angle.array().cos();
  const PeriodicSpline across(node_angle, ux, 2 * std::numbers::pi), along(node_angle, uz, 2 * std::numbers::pi);

  // Local average of a spline with a Gaussian that fades with the distance from the apex.
  const double apex = angles(angles.size() / 2);
  auto average = [apex](const PeriodicSpline& spline, double angle) {
    const double away = angle - apex, sigma = 0.030 * std::exp(-away * away / (2 * 0.16 * 0.16)) + 0.004;
    double sum = 0, weight_sum = 0;
    for (int j = -8; j <= 8; ++j) {
      const double t = j * 0.3, weight = std::exp(-t * t / 2);
      sum += weight * spline(angle + sigma * t);
      weight_sum += weight;
    }
    return sum / weight_sum;
  };
  const double lift = apex_z_um - (radius_um * std::cos(apex) + average(along, apex));
  const double shift = -average(across, apex);

  Contour_um surface(2, angles.size());
  for (Eigen::Index k = 0; k < angles.size(); ++k) {
    const double a = angles(k), away = a - apex, near_tip = std::exp(-away * away / (2 * 0.12 * 0.12));
    surface(0, k) = radius_um * std::sin(a) + average(across, a) + shift * near_tip;
    surface(1, k) = radius_um * std::cos(a) + average(along, a) + lift * near_tip;
  }
  return surface;
}

// A half-profile (r, z) from pole to pole, mirrored to a whole section with rising angles.
void mirror_half(const Eigen::VectorXd& angle, const Eigen::VectorXd& r, const Eigen::VectorXd& z,
                 Eigen::VectorXd& whole_angle, Eigen::VectorXd& whole_x, Eigen::VectorXd& whole_z) {
  const Eigen::Index n = angle.size(), total = 2 * n - 2;
  whole_angle.resize(total);
  whole_x.resize(total);
  whole_z.resize(total);
  for (Eigen::Index i = 0; i < total; ++i) {
    // From -pi (the far pole) through 0 (the apex) to just before +pi.
    const Eigen::Index source = std::abs(i - (n - 1));
    const double side = i < n - 1 ? -1.0 : 1.0;
    const bool pole = source == 0 || source == n - 1;
    whole_angle(i) = side * (source == n - 1 ? std::numbers::pi : angle(source));
    whole_x(i) = pole ? 0.0 : side * r(source);
    whole_z(i) = z(source);
  }
}

}  // namespace

CellReference CellReference::load(std::string_view cell, int configuration) {
  const ReferencePlace place = find_reference(cell);
  const std::string stem = "-" + std::to_string(configuration);
  if (!std::filesystem::exists(place.file(stem + "-profile.csv"))) {
    std::string known;
    for (const auto& name : list_resources("reference", ".csv"))
      if (name.ends_with("-profile")) known += (known.empty() ? "" : ", ") + name.substr(0, name.size() - 8);
    throw UsageError("no finite-element reference for cell '" + std::string(cell) + "' in configuration " +
                     std::to_string(configuration) + "; there are: " + known);
  }

  CellReference reference;
  reference.geometry_ = load_reference_geometry(cell);
  const double middle_um = reference.geometry_.middle_radius_um, half_um = 0.5 * reference.geometry_.thickness_um;
  // Configuration 4 is configuration 1 with the needle moved sideways.
  reference.holder_angle_rad_ = configuration == 4 ? 0.0 : (configuration - 1) * std::numbers::pi / 4;
  reference.offset_um_ = configuration == 4 ? kOffset_um : 0.0;
  if (configuration == 1) {
    reference.holder_angle_rad_ = reference.geometry_.holder_angle_deg * std::numbers::pi / 180;
    reference.offset_um_ = reference.geometry_.offset_um;
  }
  const double apex_rad = std::asin(reference.offset_um_ / reference.outer_radius_um());
  reference.angle_rad_ = material_angles(apex_rad);
  const Eigen::Index n = reference.angle_rad_.size();

  // Force and pressure against depth.
  const Table force = Table::read(place.file(stem + "-force.csv"));
  reference.force_depth_um_ = force.column("indentation_um");
  reference.force_uN_ = force.column("force_uN");
  reference.pressure_Pa_ = 1e3 * force.column("pressure_kPa");
  reference.force_slope_ = monotone_slopes(reference.force_depth_um_, reference.force_uN_);
  reference.pressure_slope_ = monotone_slopes(reference.force_depth_um_, reference.pressure_Pa_);
  const bool sideways = force.has("lateral_force_uN");
  reference.lateral_uN_ = sideways ? force.column("lateral_force_uN") : Eigen::VectorXd::Zero(force.rows());
  reference.lateral_slope_ = monotone_slopes(reference.force_depth_um_, reference.lateral_uN_);

  // Shapes: the shell gives the middle surface, the solid both faces as half-profiles.
  const Table profile = Table::read(place.file(stem + "-profile.csv"));
  const bool solid = profile.has("outer_r_um");
  const Eigen::VectorXd angle = profile.column("theta0_rad");
  const auto steps = steps_of(profile.column("indentation_um"));
  reference.apex_z_um_ = reference.outer_radius_um() * std::cos(apex_rad);
  // Out of round, or sucked into the holder: where the table has it at rest.
  const bool is_sphere = reference.geometry_.aspect_ratio == 1.0 && reference.geometry_.suction_kPa == 0.0;
  if (solid && !is_sphere) reference.apex_z_um_ = profile.column("outer_z_um")(0);
  reference.depth_um_.resize(static_cast<Eigen::Index>(steps.size()));
  for (std::size_t s = 0; s < steps.size(); ++s) {
    const auto& step = steps[s];
    reference.depth_um_(static_cast<Eigen::Index>(s)) = step.depth_um;
    auto rows = [&](const char* name) -> Eigen::VectorXd {
      return profile.column(name).segment(step.first, step.count);
    };
    const Eigen::VectorXd step_angle = angle.segment(step.first, step.count);
    Contour_um outer, inner;
    if (solid) {
      Eigen::VectorXd a, x, z;
      mirror_half(step_angle, rows("outer_r_um"), rows("outer_z_um"), a, x, z);
      outer = smooth_surface(a, x, z, reference.outer_radius_um(), reference.apex_z_um_ - step.depth_um,
                             reference.angle_rad_);
      mirror_half(step_angle, rows("inner_r_um"), rows("inner_z_um"), a, x, z);
      inner = smooth_surface(a, x, z, reference.inner_radius_um(), rows("inner_z_um")(0), reference.angle_rad_);
    } else {
      const Contour_um middle = smooth_surface(step_angle, rows("x_mid_um"), rows("z_mid_um"), middle_um,
                                               middle_um * std::cos(apex_rad) - step.depth_um, reference.angle_rad_);
      outer = offset_contour(middle, half_um);
      inner = offset_contour(middle, -half_um);
    }
    Eigen::VectorXd shape(4 * n);
    shape << outer.row(0).transpose(), outer.row(1).transpose(), inner.row(0).transpose(), inner.row(1).transpose();
    reference.shape_.push_back(std::move(shape));
  }

  // Slopes by depth, a monotone cubic for each coordinate.
  const auto step_count = static_cast<Eigen::Index>(steps.size());
  reference.shape_slope_.assign(steps.size(), Eigen::VectorXd(4 * n));
  Eigen::VectorXd values(step_count);
  for (Eigen::Index i = 0; i < 4 * n; ++i) {
    for (Eigen::Index s = 0; s < step_count; ++s) values(s) = reference.shape_[static_cast<std::size_t>(s)](i);
    const Eigen::VectorXd slopes = monotone_slopes(reference.depth_um_, values);
    for (Eigen::Index s = 0; s < step_count; ++s) reference.shape_slope_[static_cast<std::size_t>(s)](i) = slopes(s);
  }
  return reference;
}

CellReference::Section CellReference::section(double indentation_um) const {
  const auto w = hermite_weights(depth_um_, indentation_um);
  const auto i = static_cast<std::size_t>(w.cell);
  const Eigen::VectorXd shape =
      w.y0 * shape_[i] + w.y1 * shape_[i + 1] + w.m0 * shape_slope_[i] + w.m1 * shape_slope_[i + 1];
  const Eigen::Index n = angle_rad_.size();
  Section section;
  section.outer_um.resize(2, n);
  section.inner_um.resize(2, n);
  section.outer_um.row(0) = shape.segment(0, n).transpose();
  section.outer_um.row(1) = shape.segment(n, n).transpose();
  section.inner_um.row(0) = shape.segment(2 * n, n).transpose();
  section.inner_um.row(1) = shape.segment(3 * n, n).transpose();
  return section;
}

namespace {

double cubic(const Eigen::VectorXd& depth_um, const Eigen::VectorXd& value, const Eigen::VectorXd& slope,
             double indentation_um) {
  const auto w = hermite_weights(depth_um, indentation_um);
  return w.y0 * value(w.cell) + w.y1 * value(w.cell + 1) + w.m0 * slope(w.cell) + w.m1 * slope(w.cell + 1);
}

}  // namespace

double CellReference::force_uN(double indentation_um) const {
  return cubic(force_depth_um_, force_uN_, force_slope_, indentation_um);
}

double CellReference::lateral_force_uN(double indentation_um) const {
  return cubic(force_depth_um_, lateral_uN_, lateral_slope_, indentation_um);
}

double CellReference::pressure_Pa(double indentation_um) const {
  return cubic(force_depth_um_, pressure_Pa_, pressure_slope_, indentation_um);
}

double CellReference::max_indentation_um() const noexcept {
  return depth_um_(depth_um_.size() - 1);
}

std::vector<std::string> reference_cells() {
  return {"mouse-embryo", "mouse-oocyte"};
}

}  // namespace pellucida
