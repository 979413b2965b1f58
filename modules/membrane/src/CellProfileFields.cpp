#include "pellucida/core/FieldTable.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {
namespace profile_tables {

using P = CellProfile;
constexpr FieldNeed kRequired = FieldNeed::kRequired;
constexpr FieldRange kConfiguration{1, 4}, kLength_um = above(0, 1e4), kRatio{0, 10};

constexpr Field<P> kTop[] = {
    {"name", "", &P::name, {}, "of the profile, as in `--profile`", kRequired},
    {"description", "", &P::description, {}, "one line on what the cell is", kRequired},
};

constexpr Field<P> kGeometry[] = {
    {"mid_radius_um", "um", &P::mid_radius_um, kLength_um, "radius of the zona's middle surface", kRequired},
    {"thickness_um", "um", &P::thickness_um, kLength_um, "of the zona, no more than its radius", kRequired},
    {"inner_radius_um", "um", &P::inner_radius_um, kLength_um, "middle radius less half the thickness", kRequired},
};

constexpr Field<P> kMaterial[] = {
    {"young_modulus_kPa", "kPa", &P::young_modulus_kPa, above(0, 1e7),
     "published modulus of the zona, kept for the record", kRequired},
    {"effective_young_modulus_kPa", "kPa", &P::effective_young_modulus_kPa, above(0, 1e7),
     "the force scale: with it configuration 1 passes the puncture point or the measured curve", kRequired},
    {"force_scale_relative_sigma",
     "",
     &P::force_scale_relative_sigma,
     {0, 1},
     "standard deviation of the effective modulus over its value: how well the mean of the kind is known",
     kRequired},
    {"kind_spread_ratio",
     "",
     &P::kind_spread_ratio,
     {0, 2},
     "how single cells of the kind differ: standard deviation of their stiffness over its mean, taken as that of the "
     "logarithm. Enters the interval until this cell's own scale is measured"},
    {"poisson_ratio", "", &P::poisson_ratio, {0, 0.5}, "of the zona", kRequired},
    {"puncture_force_uN", "uN", &P::puncture_force_uN, above(0, 1e6), "measured force that anchors the force scale",
     kRequired},
    {"puncture_indentation_um", "um", &P::puncture_indentation_um, above(0, 2e4),
     "indentation it was measured at, no more than twice the radius", kRequired},
};

constexpr Field<P> kContact[] = {
    {"tip_radius_um", "um", &P::tip_radius_um, kLength_um,
     "of the needle's contact on the outer surface, no more than the cell's", kRequired},
    {"tip_bond_per_um", "1/um", &P::tip_bond_per_um, above(0, 1e6),
     "peak density of the needle's bond over the modulus", kRequired},
    {"holder_ring_um", "um", &P::holder_ring_um, kLength_um,
     "mean radius of the ring of contact with the holder's mouth, no more than the cell's", kRequired},
    {"holder_half_width_um", "um", &P::holder_half_width_um, kLength_um,
     "half the width of that ring, no more than its radius", kRequired},
    {"holder_bond_per_um", "1/um", &P::holder_bond_per_um, above(0, 1e6),
     "peak density of the holder's bond over the modulus", kRequired},
};

constexpr Field<RegionConstants> kRegion[] = {
    {"k2_ratio", "", &RegionConstants::k2_ratio, above(0, 1e3), "K2 / (E h)", kRequired},
    {"k1_over_k2", "", &RegionConstants::k1_over_k2, {-1, 100}, "K1 / K2", kRequired},
    {"hinge_ratio", "", &RegionConstants::hinge_ratio, above(0, 1e3), "hinge rigidity / D", kRequired},
};

constexpr Field<P> kModel[] = {
    {"tip_angle_rad", "rad", &P::tip_angle_rad, above(0, 1.6), "from the needle's axis to the end of the region `tip`",
     kRequired},
    {"holder_angle_rad", "rad", &P::holder_angle_rad, above(0, 1.6),
     "from the holder's axis to the end of the region `holder`", kRequired},
    {"volume_stiffness_ratio", "", &P::volume_stiffness_ratio, above(0, 1e9), "kv / E", kRequired},
    {"damping_uN_s_per_um",
     "uN s/um",
     &P::damping_uN_s_per_um,
     {0, 1e6},
     "of a connector; the quasi-static solution doesn't use it",
     kRequired},
    {"node_mass_kg", "kg", &P::node_mass_kg, above(0, 1), "of a node; likewise", kRequired},
};

constexpr Field<P> kMesh[] = {
    {"frequency", "", &P::mesh_frequency, {2, 40}, "edges into which each edge of the icosahedron is cut", kRequired},
    {"grading",
     "",
     &P::mesh_grading,
     {0.2, 5},
     "how many times closer the nodes lie at the needle than at the equator",
     kRequired},
};

constexpr Field<P> kRelaxation[] = {
    {"relaxation_elastic_ratio",
     "",
     &P::relaxation_elastic_ratio,
     {1, 1e3},
     "force of a sudden push over that of the push the force scale is anchored in",
     kRequired},
    {"relaxation_anchor_ramp_s",
     "s",
     &P::relaxation_anchor_ramp_s,
     {0, 1e9},
     "how long that push took; 0: sudden",
     kRequired},
};

constexpr Field<RelaxationArm> kArm[] = {
    {"fraction", "", &RelaxationArm::fraction, above(0, 1), "of the sudden force that this arm carries", kRequired},
    {"time_s", "s", &RelaxationArm::time_s, above(0, 1e9), "time constant with which it is gone", kRequired},
};

using Reference = ProfileReference;
constexpr Field<Reference> kReference[] = {
    {"configuration", "", &Reference::configuration, kConfiguration, "of needle and holder", kRequired},
    {"holder_angle_deg", "degrees", &Reference::holder_angle_deg, {0, 90}, "between their axes", kRequired},
    {"offset_um", "um", &Reference::offset_um, {-1e4, 1e4}, "of the needle beside the cell's centre", kRequired},
    {"node_count", "", &Reference::node_count, {0, 1e9}, "of the finite-element mesh", kRequired},
    {"to_um", "um", &Reference::to_um, {0, 1e4}, "deepest point", kRequired},
};

using Range = GeometryRange;
constexpr FieldRange kOverRadius = above(0, 2), kSolidScale{0, 1e3};
constexpr Field<Range> kGeometryRange[] = {
    {"thickness_from_ratio", "", &Range::thickness_from_ratio, kOverRadius, "thinnest zona over the radius", kRequired},
    {"thickness_to_ratio", "", &Range::thickness_to_ratio, kOverRadius, "thickest", kRequired},
    {"tip_from_ratio", "", &Range::tip_from_ratio, kOverRadius, "finest tip's radius over the cell's", kRequired},
    {"tip_to_ratio", "", &Range::tip_to_ratio, kOverRadius, "bluntest", kRequired},
    {"holder_from_ratio", "", &Range::holder_from_ratio, kOverRadius, "smallest holder's radius over the cell's",
     kRequired},
    {"holder_to_ratio", "", &Range::holder_to_ratio, kOverRadius, "widest", kRequired},
    {"depth_to_ratio", "", &Range::depth_to_ratio, kOverRadius, "deepest indentation over the radius", kRequired},
    {"cell_count", "", &Range::cell_count, {1, 1e6}, "cells that were computed", kRequired},
    {"spread_ratio", "", &Range::spread_ratio, kRatio,
     "RMS difference of the force's logarithm on cells left out of the fit", kRequired},
    {"pressure_spread_ratio", "", &Range::pressure_spread_ratio, kRatio, "the same of the pressure; 0: not fitted"},
    {"solid_force_ratio", "", &Range::solid_force_ratio, kSolidScale,
     "scale of the solid's force, which counts with the needle opposite the holder; 0: the springs' alone"},
};

using Term = GeometryTerm;
constexpr FieldRange kPower{0, kHighestSizePower}, kDepthPower{0, kHighestDepthPower};
constexpr Field<Term> kGeometryTerm[] = {
    {"thickness", "", &Term::thickness, kPower, "power of ln (h/R over the profile's)", kRequired},
    {"tip", "", &Term::tip, kPower, "power of ln (a/R over the profile's)", kRequired},
    {"holder", "", &Term::holder, kPower, "power of ln (holder's radius/R over the profile's)", kRequired},
    {"depth", "", &Term::depth, kDepthPower, "power of depth/R", kRequired},
    {"coefficient", "", &Term::coefficient, {-1e3, 1e3}, "in ln of the factor on the springs' force", kRequired},
};

constexpr Field<ProfileError> kError[] = {
    {"configuration", "", &ProfileError::configuration, kConfiguration, "of needle and holder", kRequired},
    {"reference", "", &ProfileError::reference, {}, "what the model was compared with", kRequired},
    {"largest_ratio", "", &ProfileError::largest_ratio, kRatio, "largest difference over the force there", kRequired},
    {"largest_of_peak_ratio", "", &ProfileError::largest_of_peak_ratio, kRatio,
     "largest difference over the force at the deepest point", kRequired},
    {"from_um", "um", &ProfileError::from_um, {0, 1e4}, "depths compared: from", kRequired},
    {"to_um", "um", &ProfileError::to_um, {0, 1e4}, "and to", kRequired},
};

}  // namespace profile_tables

FieldList fields_of(CellProfile& p) {
  using namespace profile_tables;
  FieldList fields;
  fields.add("", kTop, p)
      .add("geometry", kGeometry, p)
      .add("material", kMaterial, p)
      .add("contact", kContact, p)
      .add("msd.tip", kRegion, p.tip)
      .add("msd.body", kRegion, p.body)
      .add("msd.holder", kRegion, p.holder)
      .add("msd", kModel, p)
      .add("mesh", kMesh, p);
  return fields;
}

FieldList relaxation_fields_of(CellProfile& p) {
  return FieldList().add("", profile_tables::kRelaxation, p);
}

FieldList fields_of(GeometryRange& range) {
  return FieldList().add("geometry_range", profile_tables::kGeometryRange, range);
}

FieldList fields_of(GeometryTerm& term) {
  return FieldList().add("", profile_tables::kGeometryTerm, term);
}

FieldList fields_of(ProfileReference& reference) {
  return FieldList().add("", profile_tables::kReference, reference);
}

FieldList fields_of(ProfileError& error) {
  return FieldList().add("", profile_tables::kError, error);
}

FieldList fields_of(RelaxationArm& arm) {
  return FieldList().add("", profile_tables::kArm, arm);
}

}  // namespace pellucida
