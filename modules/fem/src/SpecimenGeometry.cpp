#include "SpecimenGeometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

void require(bool holds, const std::string& message) {
  if (!holds) throw UsageError("finite elements: " + message);
}

}  // namespace

ShellContact contact_for_configuration(int configuration, double offset_um) {
  ShellContact contact;
  switch (configuration) {
    case 1:
      return contact;
    case 2:
      contact.holder_angle_rad = 0.25 * std::numbers::pi;
      return contact;
    case 3:
      contact.holder_angle_rad = 0.5 * std::numbers::pi;
      return contact;
    case 4:
      contact.lateral_offset_um = offset_um;
      return contact;
    default:
      throw UsageError("configuration " + std::to_string(configuration) + ": give 1, 2, 3 or 4");
  }
}

void check_geometry(const ShellSpecimen& specimen, const ShellContact& contact) {
  const double radius = specimen.mid_radius_um, outer = outer_radius_um(specimen);
  require(radius > 0.0, "the radius must be above 0 um");
  require(specimen.thickness_um >= 0.01 * radius && specimen.thickness_um <= 0.4 * radius,
          "the thickness must be between 0.01 and 0.4 of the radius");
  require(specimen.young_modulus_kPa > 0.0, "Young's modulus must be above 0 kPa");
  require(specimen.poisson_ratio > 0.0 && specimen.poisson_ratio <= 0.5, "Poisson's ratio must be above 0, up to 0.5");
  require(specimen.bulk_modulus_ratio > 0.0, "the liquid's bulk modulus must be above 0");
  require(contact.tip_radius_um > 0.0 && contact.tip_radius_um < 0.5 * radius,
          "the tip's radius must be above 0 and below half the cell's");
  require(contact.tip_bond_per_um > 0.0 && contact.holder_bond_per_um > 0.0, "both bonds must be above 0");
  require(contact.holder_half_width_um > 0.0 && contact.holder_ring_um >= 0.0, "the holder's ring must have a width");
  require(contact.holder_ring_um + contact.holder_half_width_um < outer, "the holder's ring must fit on the cell");
  require(contact.holder_angle_rad >= 0.0 && contact.holder_angle_rad <= 0.5 * std::numbers::pi,
          "the holder's angle must be between 0 and 90 degrees");

  // Tool against tool, along the sphere.
  require(std::abs(contact.lateral_offset_um) < 0.8 * outer, "the needle must meet the cell: offset below 0.8 radii");
  const double between = std::numbers::pi - contact.holder_angle_rad - std::asin(contact.lateral_offset_um / outer);
  const double reach = std::asin((contact.holder_ring_um + contact.holder_half_width_um) / outer) +
                       2.0 * std::asin(0.5 * contact.tip_radius_um / outer);
  require(std::min(between, 2.0 * std::numbers::pi - between) > reach,
          "tip and holder bear on the same place; turn the holder away");
}

void check_options(double edge_length_ratio, int max_iterations) {
  require(edge_length_ratio >= 0.2 && edge_length_ratio <= 3.0, "the edge length ratio must be between 0.2 and 3");
  require(max_iterations > 0, "an equilibrium takes at least one iteration");
}

double outer_radius_um(const ShellSpecimen& specimen) {
  return specimen.mid_radius_um + 0.5 * specimen.thickness_um;
}

double young_modulus_uN_per_um2(const ShellSpecimen& specimen) {
  return 1e-3 * specimen.young_modulus_kPa;
}

Eigen::Vector3d contact_direction(const ShellSpecimen& specimen, const ShellContact& contact) {
  const double sine = contact.lateral_offset_um / outer_radius_um(specimen);
  return {sine, 0.0, std::sqrt(1.0 - sine * sine)};
}

Eigen::Vector3d holder_direction(const ShellContact& contact) {
  return {std::sin(contact.holder_angle_rad), 0.0, -std::cos(contact.holder_angle_rad)};
}

double edge_length_um(const ShellSpecimen& specimen, const ShellContact& contact, double from_tip_rad,
                      double from_holder_rad) {
  constexpr double kGrowth = 0.131;
  const double radius = specimen.mid_radius_um, ratio = radius / outer_radius_um(specimen);
  const double tip_reach = ratio * contact.tip_radius_um;
  const double ring_reach =
      radius * std::asin((contact.holder_ring_um + contact.holder_half_width_um) / outer_radius_um(specimen));
  const double near_tip = 0.275 * tip_reach + kGrowth * std::max(0.0, radius * from_tip_rad - tip_reach);
  const double near_ring =
      0.72 * ratio * contact.holder_half_width_um + kGrowth * std::max(0.0, radius * from_holder_rad - ring_reach);
  const double body = std::min(0.45 * std::sqrt(radius * specimen.thickness_um), 0.2 * radius);
  return std::min({body, near_tip, near_ring});
}

}  // namespace pellucida
