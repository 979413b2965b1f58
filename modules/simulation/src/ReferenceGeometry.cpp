#include "pellucida/simulation/ReferenceGeometry.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldJson.h"
#include "pellucida/core/Resources.h"

namespace pellucida {
namespace {

using Geometry = ReferenceGeometry;
constexpr Field<Geometry> kReferenceGeometry[] = {
    {"middle_radius_um",
     "um",
     &Geometry::middle_radius_um,
     {5, 500},
     "of the zona's middle surface",
     FieldNeed::kRequired},
    {"thickness_um", "um", &Geometry::thickness_um, {0.01, 200}, "of the zona", FieldNeed::kRequired},
    {"tip_radius_um", "um", &Geometry::tip_radius_um, {0.01, 200}, "of the needle's patch", FieldNeed::kRequired},
    {"holder_ring_um",
     "um",
     &Geometry::holder_ring_um,
     {0, 500},
     "mean radius of the holder's ring",
     FieldNeed::kRequired},
    {"holder_half_width_um",
     "um",
     &Geometry::holder_half_width_um,
     {0.01, 500},
     "half that ring's width",
     FieldNeed::kRequired},
    {"young_modulus_kPa", "kPa", &Geometry::young_modulus_kPa, {1e-6, 1e6}, "of the forces", FieldNeed::kRequired},
    {"aspect_ratio", "", &Geometry::aspect_ratio, {0.5, 2}, "length along the needle over that across"},
    {"holder_angle_deg", "degrees", &Geometry::holder_angle_deg, {0, 90}, "between push and holder"},
    {"offset_um", "um", &Geometry::offset_um, {0, 100}, "of the needle's line from the centre"},
    {"suction_kPa", "kPa", &Geometry::suction_kPa, {0, 1000}, "in the holder's mouth"},
    {"stiffening", "", &Geometry::stiffening, {0, 100}, "exponent of the wall's law"},
};

}  // namespace

double ReferenceGeometry::outer_radius_um(double angle_rad) const noexcept {
  if (aspect_ratio == 1.0) return outer_radius_um();
  const double root = std::sqrt(aspect_ratio);
  return middle_radius_um / std::hypot(std::cos(angle_rad) / root, std::sin(angle_rad) * root) + 0.5 * thickness_um;
}

ReferencePlace find_reference(std::string_view cell) {
  const std::filesystem::path path(cell);
  if (path.has_parent_path()) return {path.parent_path(), path.filename().string()};
  return {resource_folder() / "reference", std::string(cell)};
}

ReferenceGeometry load_reference_geometry(std::string_view cell) {
  const std::filesystem::path file = find_reference(cell).file("-geometry.json");
  if (!std::filesystem::exists(file)) {
    throw UsageError("no finite-element reference of a cell '" + std::string(cell) + "': " + file.string() +
                     " is not there");
  }
  ReferenceGeometry geometry;
  FieldList keys;
  keys.add("", kReferenceGeometry, geometry);
  auto fault = read_fields(read_json_object(file), keys);
  if (!fault) fault = range_fault(keys);
  if (fault) throw InputError(file.string() + ": " + *fault);
  return geometry;
}

}  // namespace pellucida
