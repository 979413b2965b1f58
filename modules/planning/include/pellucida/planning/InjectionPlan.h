#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "pellucida/core/ContactModel.h"
#include "pellucida/core/Expected.h"
#include "pellucida/haptics/HapticSettings.h"

namespace pellucida {

/// What is known about cell and tools when a path is planned. Frame W, um.
struct CellGeometry {
  PlainVector3 center_um;         ///< of the outer membrane at rest
  double outer_radius_um = 0.0;   ///< above 0
  double inner_radius_um = 0.0;   ///< 0: not known
  PlainVector3 needle_direction;  ///< unit vector from the shaft to the tip: a needle enters along its own axis
  bool holder_known = false;      ///< the two below are valid
  PlainVector3 holder_mouth_um;
  PlainVector3 holder_direction;  ///< unit vector from the cell's centre to the mouth
};

/// The geometry in a frame's contact model; nothing while the cell is not seen.
std::optional<CellGeometry> geometry_of(const ContactModel& model) noexcept;

struct PlanOptions {
  double approach_distance_um = 30.0;  ///< from the approach point to the entry, above 0
  double overshoot_um = 10.0;   ///< the tip may go this far beyond the target, so that the membrane gives way, >= 0
  double path_radius_um = 1.0;  ///< free play about the line, >= 0
  double needle_clearance_um = 5.0;        ///< the cell's body begins this far from the line, above the path's radius
  double holder_radius_um = 45.0;          ///< of the holding pipette with clearance, above 0
  double cone_half_angle_rad = 0.35;       ///< 0 .. 1.4
  double approach_speed_um_per_s = 500.0;  ///< above 0, as the two below
  double insertion_speed_um_per_s = 200.0;
  double removal_speed_um_per_s = 100.0;
};

/// A straight path into a cell and out again. Frame W, um.
struct InjectionPlan {
  CellGeometry cell;
  PlanOptions options;
  PlainVector3 target_um;    ///< where to deposit
  PlainVector3 axis;         ///< unit vector of the path inwards
  PlainVector3 entry_um;     ///< where the line meets the outer membrane at rest
  PlainVector3 approach_um;  ///< where the tip waits before the entry
  double depth_um = 0.0;     ///< from entry to target
};

/// Why there is no path.
enum class PlanFault {
  kNotFinite,        ///< a number is not finite, or a radius, distance or speed is not above 0
  kNoDirection,      ///< the needle's direction is unknown
  kTargetOutside,    ///< the target lies outside the inner membrane (the outer one if that is unknown)
  kOvershootTooFar,  ///< the tip might leave the cell on the other side
  kThroughHolder     ///< entry or approach lie in the holding pipette
};
/// One line: what is wrong, and how to correct it.
std::string to_string(PlanFault fault);

/// The path along the needle's own direction through the target or, without one, through the cell's centre. The entry
/// is where it first meets the sphere of the outer membrane.
expected<InjectionPlan, PlanFault> plan_injection(const CellGeometry& cell,
                                                  const std::optional<PlainVector3>& target_um = std::nullopt,
                                                  const PlanOptions& options = {}) noexcept;

/// The settings with the plan's fixtures (all enabled, each with the feel given in the settings) and its speeds.
HapticSettings with_plan(HapticSettings settings, const InjectionPlan& plan) noexcept;

/// A plan as JSON (schema `pellucida-injection-plan`), and back. Reading recomputes axis, entry, approach and depth and
/// throws InputError if `what` (a file's name, for the text) holds no plan or one with a fault.
std::string to_json(const InjectionPlan& plan);
InjectionPlan plan_from_json(std::string_view json, const std::string& what);

/// The same in a file. Throw OutputError, InputError.
void write_plan(const InjectionPlan& plan, const std::filesystem::path& file);
InjectionPlan read_plan(const std::filesystem::path& file);

}  // namespace pellucida
