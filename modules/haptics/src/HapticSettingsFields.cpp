#include <limits>

#include "pellucida/core/FieldTable.h"
#include "pellucida/haptics/HapticSettings.h"

namespace pellucida {
namespace hand_tables {

constexpr FieldRange kFlag, kTime_s{0.0, 10.0}, kSome{0.0, 1e9}, kLength_um{1e-3, 1e4}, kAtLeastZero{0.0};

using Settings = HapticSettings;
constexpr Field<Settings> kLoop[] = {
    {"force_scale_N_per_uN", "N/uN", &Settings::force_scale_N_per_uN, kSome,
     "hand force for a force at the cell; 0: the contact isn't felt"},
    {"period_s", "s", &Settings::period_s, {1e-5, 0.1}, "of the loop"},
    {"low_pass_Hz", "Hz", &Settings::low_pass_Hz, {1.0, 1e9}, "of the force on the hand"},
    {"full_scale_time_s", "s", &Settings::full_scale_time_s, kTime_s,
     "the force may change by the device's largest in this time, not faster"},
    {"fade_in_time_s", "s", &Settings::fade_in_time_s, kTime_s,
     "in which the force comes in when the hand takes the pipette"},
    {"clutch_time_s", "s", &Settings::clutch_time_s, kTime_s, "in which it goes when the hand lets go"},
    {"release_time_s", "s", &Settings::release_time_s, kTime_s, "in which it goes on an emergency stop or a loss"},
};

using Predictor = PredictorSettings;
constexpr Field<Predictor> kPredictor[] = {
    {"age_limit_s", "s", &Predictor::age_limit_s, {1e-3, 10.0}, "an older frame counts no more"},
    {"stale_time_s", "s", &Predictor::stale_time_s, kTime_s, "in which the force then goes to zero"},
    {"invalid_time_s", "s", &Predictor::invalid_time_s, kTime_s, "the same after frames without usable numbers"},
    {"release_time_s", "s", &Predictor::release_time_s, kTime_s, "the same after a puncture"},
    {"return_time_s", "s", &Predictor::return_time_s, kTime_s, "in which the force comes back after any of these"},
    {"correction_time_s",
     "s",
     &Predictor::correction_time_s,
     {1e-3, 10.0},
     "time constant with which a frame's correction is taken in"},
    {"correction_slope_uN_per_s", "uN/s", &Predictor::correction_slope_uN_per_s, kSome, "the fastest that may be"},
    {"free_time_s",
     "s",
     &Predictor::free_time_s,
     {1e-4, 10.0},
     "time constant of what is left when a frame shows the needle out of contact"},
    {"tip_lag_s",
     "s",
     &Predictor::tip_lag_s,
     {0.0, 0.9},
     "the tip in a frame is the commanded one of this time before the frame's arrival"},
    {"max_stiffness_uN_per_um", "uN/um", &Predictor::max_stiffness_uN_per_um, kAtLeastZero,
     "of the step from frame to frame"},
    {"max_damping_uN_s_per_um", "uN s/um", &Predictor::max_damping_uN_s_per_um, kAtLeastZero,
     "of the step from frame to frame"},
    {"puncture_drop_ratio",
     "",
     &Predictor::puncture_drop_ratio,
     {0.0, 1.0},
     "a frame with less than this part of the force expected is a puncture"},
    {"puncture_min_uN", "uN", &Predictor::puncture_min_uN, kSome, "if at least this was expected"},
    {"rearm_time_s", "s", &Predictor::rearm_time_s, kTime_s,
     "contact seen for this time after a puncture is a new one"},
};

using Coupling = CouplingSettings;
constexpr Field<Coupling> kCoupling[] = {
    {"stiffness_N_per_m", "N/m", &Coupling::stiffness_N_per_m, kSome,
     "of the link from hand to pipette; up to what the device holds"},
    {"damping_N_s_per_m", "N s/m", &Coupling::damping_N_s_per_m, kSome, "the same"},
    {"width_um", "um", &Coupling::width_um, kSome, "lag over which the damping sets in"},
    {"max_force_N", "N", &Coupling::max_force_N, kSome, "of the link alone"},
};

using Limits = CellLimits;
constexpr Field<Limits> kLimits[] = {
    {"max_depth_um", "um", &Limits::max_depth_um, kSome, "indentation, in contact"},
    {"soft_depth_um", "um", &Limits::soft_depth_um, kSome,
     "before it the push gets slower; as far behind it the pipette is taken back"},
    {"max_force_uN", "uN", &Limits::max_force_uN, kSome, "of the cell on the needle"},
    {"slow_ratio",
     "",
     &Limits::slow_ratio,
     {0.0, 1.0},
     "part of the largest force from which the push gets slower; held at it"},
    {"retract_ratio", "", &Limits::retract_ratio, {1.0, 1e9}, "taken back above this multiple of it"},
    {"retract_speed_um_per_s", "um/s", &Limits::retract_speed_um_per_s, kSome, "of that"},
    {"max_speed_um_per_s", "um/s", &Limits::max_speed_um_per_s, {1e-3, 1e9}, "of the tip"},
    {"max_contact_speed_um_per_s", "um/s", &Limits::max_contact_speed_um_per_s, kSome,
     "of the tip along the push in contact"},
    {"max_lag_um",
     "um",
     &Limits::max_lag_um,
     {1e-3, 1e9},
     "the manipulator may stay this far behind; the tip gets slower beyond, and stops at twice"},
    {"blind_age_s", "s", &Limits::blind_age_s, kAtLeastZero,
     "no deeper when the newest usable frame is older; back is free. At least predictor.age_limit_s; infinite: never"},
    {"puncture_hold_s", "s", &Limits::puncture_hold_s, kTime_s,
     "no deeper for this time after the membrane gave way; back is free"},
    {"max_hand_speed_m_per_s", "m/s", &Limits::max_hand_speed_m_per_s, kSome, "faster is a jump of the reading"},
    {"max_pipette_speed_um_per_s", "um/s", &Limits::max_pipette_speed_um_per_s, kSome,
     "the same for the manipulator's reports"},
    {"pipette_age_limit_s", "s", &Limits::pipette_age_limit_s, kTime_s,
     "without a report for this time the manipulator counts as lost"},
    {"late_tick_s", "s", &Limits::late_tick_s, kTime_s, "a tick later than this ties the motion anew"},
};

constexpr Field<FixtureFeel> kFeel[] = {
    {"stiffness_N_per_m", "N/m", &FixtureFeel::stiffness_N_per_m, kSome, "at the hand; up to what the device holds"},
    {"damping_N_s_per_m", "N s/m", &FixtureFeel::damping_N_s_per_m, kSome,
     "at the hand, against motion into or along the violation's normal; up to what the device holds"},
    {"width_um", "um", &FixtureFeel::width_um, {1e-3, 1e3}, "over which the stiffness sets in"},
};
constexpr Field<RectilinearGuide> kGuide[] = {
    {"enabled", "", &RectilinearGuide::enabled, kFlag, "keeps the tip on the planned line inside the cell"},
    {"radius_um", "um", &RectilinearGuide::radius_um, {0.0, 1e4}, "free play about the line"},
    {"opening_um", "um", &RectilinearGuide::opening_um, kLength_um,
     "before the entry, at s um, the radius has grown by s^2 / (2 opening)"},
};
constexpr Field<ApproachCone> kCone[] = {
    {"enabled", "", &ApproachCone::enabled, kFlag, "funnels the tip to the entry"},
    {"radius_um", "um", &ApproachCone::radius_um, {0.0, 1e4}, "at the entry"},
    {"half_angle_rad", "rad", &ApproachCone::half_angle_rad, {0.0, 1.4}, "of the funnel"},
    {"length_um", "um", &ApproachCone::length_um, kLength_um, "of the funnel"},
    {"opening_um", "um", &ApproachCone::opening_um, kLength_um, "beyond its length, as of the guide"},
};
constexpr Field<DepthStop> kStop[] = {
    {"enabled", "", &DepthStop::enabled, kFlag, "ends the way behind the entry"},
    {"depth_um", "um", &DepthStop::depth_um, {-1e4, 1e4}, "behind the entry along the axis"},
};
constexpr Field<CellBody> kCell[] = {
    {"enabled", "", &CellBody::enabled, kFlag, "forbids the cell's body outside the path"},
    {"radius_um", "um", &CellBody::radius_um, kLength_um, "of the body, a sphere"},
    {"path_radius_um", "um", &CellBody::path_radius_um, {0.0, 1e4}, "of the path, a cylinder about the planned line"},
};
constexpr Field<HolderBody> kHolder[] = {
    {"enabled", "", &HolderBody::enabled, kFlag, "forbids the holding pipette"},
    {"radius_um", "um", &HolderBody::radius_um, kLength_um, "of the pipette, clearance included"},
};
constexpr Field<FixtureSet> kFixtures[] = {
    {"max_force_N", "N", &FixtureSet::max_force_N, kSome, "of all together at the hand"},
};

}  // namespace hand_tables

FieldList fields_of(HapticSettings& s) {
  using namespace hand_tables;
  FixtureSet& fixtures = s.fixtures;
  FieldList fields;
  fields.add("", kLoop, s)
      .add("predictor", kPredictor, s.predictor)
      .add("coupling", kCoupling, s.coupling)
      .add("limits", kLimits, s.limits)
      .add("fixtures", kFixtures, fixtures)
      .add("fixtures.guide", kGuide, fixtures.guide)
      .add("fixtures.guide.feel", kFeel, fixtures.guide.feel)
      .add("fixtures.cone", kCone, fixtures.cone)
      .add("fixtures.cone.feel", kFeel, fixtures.cone.feel)
      .add("fixtures.stop", kStop, fixtures.stop)
      .add("fixtures.stop.feel", kFeel, fixtures.stop.feel)
      .add("fixtures.cell", kCell, fixtures.cell)
      .add("fixtures.cell.feel", kFeel, fixtures.cell.feel)
      .add("fixtures.holder", kHolder, fixtures.holder)
      .add("fixtures.holder.feel", kFeel, fixtures.holder.feel);
  return fields;
}

}  // namespace pellucida
