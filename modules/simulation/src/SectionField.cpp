#include "SectionField.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pellucida {
namespace {

// Adds `weight` times the displacements from rest of a reference's contour, mirrored where the needle is on the other
// side, to the contour `sum` (2 x n).
void add_displacement(Contour_um& sum, const Contour_um& contour, const Eigen::VectorXd& angle_rad, double radius_um,
                      double weight, bool mirrored) {
  const Eigen::Index n = contour.cols();
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index from = mirrored ? (n - k) % n : k;
    const Eigen::Vector2d rest = radius_um * Eigen::Vector2d(std::sin(angle_rad(from)), std::cos(angle_rad(from)));
    const Eigen::Vector2d moved = contour.col(from) - rest;
    sum.col(k) += weight * Eigen::Vector2d(mirrored ? -moved.x() : moved.x(), moved.y());
  }
}

}  // namespace

SectionField::SectionField(std::string_view cell, int configuration)
    : reference_(CellReference::load(cell, configuration)) {
  const bool has_offset = std::filesystem::exists(find_reference(cell).file("-4-profile.csv"));
  if (configuration == 1 && has_offset) other_ = CellReference::load(cell, 4);
  if (configuration == 4) other_ = CellReference::load(cell, 1);
}

double SectionField::apex_angle_rad(double offset_um) const noexcept {
  return std::asin(std::clamp(offset_um / reference_.outer_radius_um(), -0.9, 0.9));
}

CellReference::Section SectionField::at(double offset_um, double indentation_um) const {
  if (std::abs(offset_um - reference_.offset_um()) < 1e-9) return reference_.section(indentation_um);

  // The sphere at rest, its points counted from where the needle touches.
  const double apex = apex_angle_rad(offset_um);
  const Eigen::VectorXd& angle = reference_.angle_rad();
  const Eigen::Index n = angle.size();
  const double shift = apex - angle(n / 2);
  CellReference::Section section;
  section.outer_um.resize(2, n);
  section.inner_um.resize(2, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Vector2d direction(std::sin(angle(k) + shift), std::cos(angle(k) + shift));
    section.outer_um.col(k) = reference_.outer_radius_um() * direction;
    section.inner_um.col(k) = reference_.inner_radius_um() * direction;
  }
  auto add = [&](const CellReference& from, double weight) {
    if (weight == 0) return;
    const auto moved = from.section(indentation_um);
    const bool mirrored = other_ && offset_um < 0;
    add_displacement(section.outer_um, moved.outer_um, from.angle_rad(), from.outer_radius_um(), weight, mirrored);
    add_displacement(section.inner_um, moved.inner_um, from.angle_rad(), from.inner_radius_um(), weight, mirrored);
  };
  if (!other_) {
    add(reference_, 1.0);
    return section;
  }
  const bool own_is_beside = reference_.offset_um() > 0;
  const CellReference &beside = own_is_beside ? reference_ : *other_, &middle = own_is_beside ? *other_ : reference_;
  const double part = std::min(1.0, std::abs(offset_um) / beside.offset_um()), weight = part * part * (3 - 2 * part);
  add(middle, 1 - weight);
  add(beside, weight);
  return section;
}

}  // namespace pellucida
