#include "pellucida/evaluation/Trial.h"

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "SimulatedOperator.h"
#include "TrialMeter.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/haptics/HapticServo.h"
#include "pellucida/simulation/OperatorPlan.h"
#include "pellucida/simulation/SimulatedHand.h"
#include "pellucida/simulation/VirtualSpecimen.h"
#include "pellucida/teleoperation/ManipulatorStage.h"
#include "pellucida/teleoperation/SimulatedInjector.h"
#include "pellucida/teleoperation/TeleoperationMap.h"

namespace pellucida {
namespace {

constexpr double kTick_s = 1e-3;
constexpr long kCommandTicks = 10;  // 100 Hz
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

OperatorPlan plan_of(const InjectionPlan& plan, const SimulatedOperator& person, const TrialOptions& options,
                     double lag_s) {
  OperatorPlan wanted = operator_plan(plan, options.motion_scale_um_per_m, lag_s);
  wanted.inject_s = kExpelled_s;
  wanted.insertion_speed_um_per_s = person.insertion_speed_um_per_s;
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

/// What a practised person knows of the chain: map's filter, injector and half a command's time, camera and half a
/// frame.
double learnt_lag_s(const TrialOptions& options, const TeleoperationMap& map) noexcept {
  return map.lag_s() + SimulatedInjectorOptions{}.latency_s + 0.5 * kTick_s * static_cast<double>(kCommandTicks) +
         options.camera.delay_s + 0.5 / options.camera.frame_rate_hz;
}

/// All the parts of a trial, put together as a workstation's are, turned by one clock.
class Workplace {
 public:
  Workplace(const TrialOptions& options, const SpecimenContact& cell, const CellStrength& strength,
            const InjectionPlan& plan, const SimulatedOperator& person)
      : cell_(cell),
        injector_(injector_at(start_of(plan, placement_of(options.seed))),
                  [this](const InjectorPose& pose) { cell_.advance(pose.tip_um, pose.time_s, pose.deposited_pl); }),
        stage_(injector_, clock_),
        map_(motion_of(options)),
        hand_(person.sight_and_skill, plan_of(plan, person, options, learnt_lag_s(options, map_)), person.arm,
              options.seed),
        servo_(hand_, map_, {contacts_, stage_.states(), stage_.commands()},
               haptics_of(options, plan, hand_.specification(), strength)),
        camera_(camera_of(options), cell.force()) {
    injector_.open();
    cell_.advance(injector_.pose().tip_um, 0.0);
  }

  void tick(long count) {
    const double now_s = kTick_s * static_cast<double>(count);
    clock_.set(now_s);
    // Time goes on for the injector, and with it for the needle in the cell.
    injector_.state(now_s);
    if (count % kCommandTicks == 0) stage_.turn();
    if (camera_.look(cell_.moment(), now_s)) {
      const ContactModel& seen = camera_.newest();
      contacts_.publish(seen);
      hand_.see({now_s, seen.tip_um, true, seen.state == CellState::kPunctured});
    }
    servo_.turn(now_s);
    servo_.newest().refresh();
    while (servo_.records().pop()) {
    }
    while (servo_.events().pop()) {
    }
  }

  const SpecimenMoment& moment() const noexcept { return cell_.moment(); }
  const HapticRecord& record() noexcept { return servo_.newest().value(); }
  const OperatorModel& person() const noexcept { return hand_.person(); }

 private:
  ManualClock clock_;
  SpecimenContact cell_;
  SimulatedInjector injector_;
  ManipulatorStage stage_;
  TeleoperationMap map_;
  SimulatedHand hand_;
  LatestValue<ContactModel> contacts_;
  HapticServo servo_;
  ContactCamera camera_;
};

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
  const Placement place = placement_of(seed);
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
  const SpecimenContact cell = scene.cell(options.seed);
  SimulatedOperator person = person_of(options.seed, options.modality);
  if (!options.slows_on_force) person.sight_and_skill.slowing_N = 0.0;
  const InjectionPlan plan = trial_plan(options, cell.force());
  const auto workplace = std::make_unique<Workplace>(options, cell, scene.strength(), plan, person);
  TrialMeter meter(options, plan);

  const long last = std::lround(options.time_limit_s / kTick_s);
  for (long count = 0; count <= last; ++count) {
    workplace->tick(count);
    meter.look(workplace->moment(), workplace->record(), workplace->person().phase());
    if (workplace->person().done()) break;
  }
  return meter.outcome();
}

const char* name_of(Modality modality) noexcept {
  switch (modality) {
    case Modality::kFlatImage:
      return "2-D image";
    case Modality::kSpace:
      return "3-D view";
    case Modality::kSpaceAndHaptics:
      return "3-D + haptics";
    case Modality::kSpaceAndFixture:
      return "3-D + haptics + guide";
  }
  return "";
}

}  // namespace pellucida
