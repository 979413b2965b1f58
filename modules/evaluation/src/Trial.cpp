#include "pellucida/evaluation/Trial.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "TrialDraw.h"
#include "TrialMeter.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/simulation/OperatorPlan.h"
#include "pellucida/simulation/SimulatedTeleoperation.h"
#include "pellucida/simulation/VirtualSpecimen.h"
#include "pellucida/teleoperation/SimulatedInjector.h"

namespace pellucida {
namespace {

// From a command to the motion: the injector's latency, and half the time between two of its turns.
const double kManipulatorLag_s =
    SimulatedInjectorOptions{}.latency_s +
    0.5 * SimulatedTeleoperation::kTick_s * static_cast<double>(SimulatedTeleoperation::kManipulatorTicks);
constexpr double kExpelled_s = 0.6;

bool has_haptics(Modality modality) noexcept {
  return modality == Modality::kSpaceAndHaptics || modality == Modality::kSpaceAndFixture;
}

void check(TrialOptions options) {
  if (const auto fault = range_fault(fields_of(options))) throw UsageError(*fault);
}

Eigen::Vector3d start_of(const InjectionPlan& plan, const Placement& place) {
  const Eigen::Vector3d axis = plan.axis.eigen(), out = Eigen::Vector3d::UnitZ();
  return plan.approach_um.eigen() - place.start_back_um * axis + place.start_across_um * out.cross(axis) +
         place.start_out_um * out;
}

OperatorPlan plan_of(const InjectionPlan& plan, const DrawnOperator& drawn, const TrialOptions& options, double lag_s) {
  OperatorPlan wanted = operator_plan(plan, options.motion_scale_um_per_m, lag_s);
  wanted.inject_s = kExpelled_s;
  wanted.insertion_speed_um_per_s = drawn.insertion_speed_um_per_s;
  return wanted;
}

TeleoperationSettings motion_of(const TrialOptions& options) {
  TeleoperationSettings settings;
  settings.scale_um_per_m = options.motion_scale_um_per_m;
  return settings;
}

HapticSettings haptics_of(const TrialOptions& options, const InjectionPlan& plan, const DeviceSpecification& device,
                          const CellStrength& strength) {
  HapticSettings settings = default_settings(device, options.motion_scale_um_per_m, strength);
  settings.force_scale_N_per_uN = has_haptics(options.modality) ? options.force_scale_N_per_uN : 0.0;
  if (options.modality == Modality::kSpaceAndFixture) {
    RectilinearGuide& guide = settings.fixtures.guide;
    guide.enabled = true;
    guide.entry_um = plan.approach_um;
    guide.axis = plan.axis;
    guide.radius_um = options.guide_radius_um;
    guide.feel.width_um = options.guide_width_um;
  }
  return settings;
}

SimulatedInjectorOptions injector_at(const Eigen::Vector3d& start_um) {
  SimulatedInjectorOptions options;
  options.start_um = start_um;
  return options;
}

ContactCameraOptions camera_of(const TrialOptions& options) {
  ContactCameraOptions camera = options.camera;
  camera.seed = options.seed;
  return camera;
}

}  // namespace

FieldList fields_of(TrialOptions& options) {
  using T = TrialOptions;
  static constexpr Field<T> kOptions[] = {
      {"motion_scale_um_per_m",
       "um/m",
       &T::motion_scale_um_per_m,
       {100.0, 1e5},
       "way of the tip for a way of the hand"},
      {"force_scale_N_per_uN", "N/uN", &T::force_scale_N_per_uN, {0.0, 1.0}, "hand force for a force at the cell"},
      {"approach_distance_um", "um", &T::approach_distance_um, {1.0, 100.0}, "from the approach point to the membrane"},
      {"guide_radius_um", "um", &T::guide_radius_um, {0.0, 20.0}, "free play of the rectilinear guide"},
      {"guide_width_um", "um", &T::guide_width_um, {0.01, 20.0}, "over which its stiffness sets in"},
      {"tolerance_um", "um", &T::tolerance_um, {0.1, 50.0}, "of the deposit about the target"},
      {"max_overshoot_um", "um", &T::max_overshoot_um, {0.0, 50.0}, "of the tip beyond the target"},
      {"least_deposit_ratio", "", &T::least_deposit_ratio, {0.0, 1.0}, "of what was expelled, in the cell"},
      {"time_limit_s", "s", &T::time_limit_s, {1.0, 600.0}, "of the whole trial"},
  };
  return FieldList().add("trial", kOptions, options);
}

TrialScene::TrialScene(const Scenario& scenario) : scenario_(scenario), force_(VirtualSpecimen(scenario).force()) {
  if (!scenario.puncture.enabled)
    throw UsageError("trial: scenario '" + scenario.name + "' has no puncture; set puncture.enabled");
}

SpecimenContact TrialScene::cell(std::uint64_t seed) const {
  const Placement place = draw_placement(seed);
  SpecimenForce::Frame frame = force_.frame();
  const Eigen::AngleAxisd turn(place.turn_deg * std::numbers::pi / 180.0, Eigen::Vector3d::UnitZ());
  frame.center_um.x += place.center_x_um;
  frame.center_um.y += place.center_y_um;
  frame.axis = Eigen::Vector3d(turn * frame.axis.eigen());
  frame.across = Eigen::Vector3d(turn * frame.across.eigen());
  Scenario scenario = scenario_;
  scenario.seed = seed;
  return SpecimenContact(force_.moved_to(frame), scenario);
}

CellStrength TrialScene::strength() const {
  Scenario usual = scenario_;
  usual.puncture.spread_ratio = 0.0;
  CellStrength strength;
  strength.puncture_force_uN = SpecimenContact(force_, usual).puncture_force_uN();
  strength.puncture_depth_um = usual.puncture.indentation_um;
  strength.max_stiffness_uN_per_um = 3.0 * strength.puncture_force_uN / strength.puncture_depth_um;
  return strength;
}

InjectionPlan trial_plan(const TrialOptions& options, const SpecimenForce& cell) {
  CellGeometry geometry;
  geometry.center_um = cell.frame().center_um;
  geometry.outer_radius_um = (cell.tip_at(0.0, 0.0).eigen() - geometry.center_um.eigen()).norm();
  geometry.needle_direction = Eigen::Vector3d(-cell.frame().axis.eigen());
  PlanOptions wanted;
  wanted.approach_distance_um = options.approach_distance_um;
  wanted.path_radius_um = options.guide_radius_um;
  const auto plan = plan_injection(geometry, std::nullopt, wanted);
  if (!plan) throw UsageError("trial: " + to_string(plan.error()));
  return *plan;
}

TrialOutcome run_trial(const TrialScene& scene, const TrialOptions& options) {
  check(options);
  SpecimenContact cell = scene.cell(options.seed);
  DrawnOperator drawn = draw_operator(options.seed, options.modality);
  if (!options.slows_on_force) drawn.options.slowing_N = 0.0;
  const InjectionPlan plan = trial_plan(options, cell.force());

  SimulatedInjector injector(
      injector_at(start_of(plan, draw_placement(options.seed))),
      [&cell](const InjectorPose& pose) { cell.advance(pose.tip_um, pose.time_s, pose.deposited_pl); });
  injector.open();
  cell.advance(injector.pose().tip_um, 0.0);
  SimulatedTeleoperation teleoperation(injector, motion_of(options));
  const double lag_s =
      teleoperation.learnt_lag_s(kManipulatorLag_s, options.camera.delay_s, options.camera.frame_rate_hz);
  teleoperation.start(
      drawn.options, plan_of(plan, drawn, options, lag_s), drawn.arm, options.seed,
      [&](const DeviceSpecification& device) { return haptics_of(options, plan, device, scene.strength()); });
  ContactCamera camera(camera_of(options), cell.force());
  TrialMeter meter(options, plan);

  const long last = std::lround(options.time_limit_s / SimulatedTeleoperation::kTick_s);
  for (long count = 0; count <= last; ++count) {
    const double now_s = teleoperation.begin_tick();
    // Time goes on for the injector, and with it for the needle in the cell.
    injector.state(now_s);
    teleoperation.turn_manipulator();
    if (camera.look(cell.moment(), now_s)) {
      const ContactModel& seen = camera.newest();
      teleoperation.show(seen, {now_s, seen.tip_um, true, seen.state == CellState::kPunctured});
    }
    const HapticRecord& tick = teleoperation.turn_hand();
    while (teleoperation.take_event()) {
    }
    meter.look(cell.moment(), tick, teleoperation.simulated_operator().phase());
    if (teleoperation.simulated_operator().done()) break;
  }
  return meter.outcome();
}

}  // namespace pellucida
