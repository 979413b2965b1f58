#include "pellucida/operation/OperatorConsole.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ConsoleDevice.h"
#include "pellucida/core/Error.h"
#include "pellucida/simulation/OperatorPlan.h"
#include "pellucida/teleoperation/GamepadHand.h"
#include "pellucida/teleoperation/OpenHapticsHand.h"
#include "pellucida/teleoperation/SpaceMouseHand.h"

namespace pellucida {
namespace {

constexpr int kFreeFrames = 3;           // in a row, before a plan is made
constexpr double kSureConfidence = 0.6;  // of each of them
constexpr double kOut_um = 15.0;         // before the entry: the needle is out of the cell
constexpr double kLearntLag_s = 0.05;    // the pipette's report behind the hand: injector, its turns, the window's tick

// A demonstration is slow enough to be followed with the eye.
constexpr double kInsertionSpeed_um_per_s = 14.0;
constexpr double kInject_s = 1.5;
constexpr double kDemonstrationScale_N_per_uN = 0.08;  // 0.6 N at a puncture of 7.5 uN

constexpr std::array kScales_um_per_m{kCoarseScale_um_per_m, kFineScale_um_per_m, kFinestScale_um_per_m};
constexpr double kRateOfScale_per_s = 2.0;  // tip speed of a stick's deflection, for the same scale

OperatorPlan demonstration(const InjectionPlan& plan, double scale_um_per_m) {
  OperatorPlan way = operator_plan(plan, scale_um_per_m, kLearntLag_s);
  way.inject_s = kInject_s;
  way.insertion_speed_um_per_s = kInsertionSpeed_um_per_s;
  return way;
}

bool needle_seen(const ContactModel& contact) noexcept {
  return contact.push.eigen().squaredNorm() > 0.25;
}

}  // namespace

OperatorConsole::OperatorConsole(LiveRun& run, Manipulator& manipulator, CommandedNeedle* needle)
    : OperatorConsole(run, manipulator, needle, Options{}) {}

OperatorConsole::OperatorConsole(LiveRun& run, Manipulator& manipulator, CommandedNeedle* needle,
                                 const Options& options)
    : run_(run), manipulator_(manipulator), needle_(needle), options_(options), contacts_(tap_contacts(run)) {
  if (needle_) add("Demonstration", {});
  add("Mouse and keyboard", {[] { return std::make_unique<MouseHand>(); }});
  find_devices();
}

OperatorConsole::~OperatorConsole() {
  set_down();
}

void OperatorConsole::add(std::string name, Choice choice) {
  names_.push_back(std::move(name));
  choices_.push_back(std::move(choice));
}

void OperatorConsole::find_devices() {
  if (open_haptics_trouble().empty()) {
    add("OpenHaptics device", {[] { return std::make_unique<OpenHapticsHand>(); }});
  }
  if (space_mouse_trouble().empty()) add("SpaceMouse", {[] { return std::make_unique<SpaceMouseHand>(); }, true});
  try {
    for (const GamepadInfo& pad : gamepads()) {
      add(pad.name, {[name = pad.name] { return std::make_unique<GamepadHand>(GamepadOptions{.name = name}); }, true});
    }
  } catch (const DeviceError&) {
    // No gamepad can be chosen; `pellucida devices` says why.
  }
}

std::optional<int> OperatorConsole::find_hand(std::string_view start) const noexcept {
  for (std::size_t k = 0; k < names_.size(); ++k) {
    if (std::string_view(names_[k]).starts_with(start)) return static_cast<int>(k);
  }
  return std::nullopt;
}

bool OperatorConsole::is_demonstration() const noexcept {
  return chosen_ >= 0 && !choices_[static_cast<std::size_t>(chosen_)].open;
}

const std::vector<std::string>& OperatorConsole::scales() {
  static const std::vector<std::string> names{"Coarse 100:1", "Fine 500:1", "Finest 2000:1"};
  return names;
}

void OperatorConsole::choose(int index) {
  if (index < 0 || index >= static_cast<int>(names_.size())) {
    throw UsageError("hand " + std::to_string(index) + ": there are " + std::to_string(names_.size()));
  }
  set_down();
  device_.reset();
  mouse_ = nullptr;
  trouble_.clear();
  inject_ = retract_ = grip_ = renewing_ = false;
  chosen_ = index;
  scale_ = is_demonstration() ? 0 : 1;
  open_device();
  // A demonstration begins outside the cell.
  if (is_demonstration() && plan_) new_cell();
}

void OperatorConsole::scale(int index) {
  if (index < 0 || index >= static_cast<int>(kScales_um_per_m.size())) {
    throw UsageError("scale " + std::to_string(index) + ": there are " + std::to_string(kScales_um_per_m.size()));
  }
  if (index == scale_) return;
  scale_ = index;
  set_down();
  if (is_demonstration()) {
    open_device();
  } else if (device_) {
    start_rig();
  }
}

// Releases the hand; a stop requested by the device itself stays.
void OperatorConsole::set_down() {
  if (!rig_) return;
  stopped_ = stopped_ || rig_->status().tick.hand_state == HandState::kStopped;
  rig_.reset();
}

void OperatorConsole::open_device() {
  if (chosen_ < 0) return;
  const Choice& choice = choices_[static_cast<std::size_t>(chosen_)];
  try {
    if (choice.open) {
      auto device = choice.open();
      mouse_ = dynamic_cast<MouseHand*>(device.get());
      device_ = std::make_unique<ConsoleDevice>(std::move(device));
    } else {
      if (!plan_) return;  // the person begins with the plan
      OperatorOptions person;
      person.modality = guided_ ? Modality::kSpaceAndFixture : Modality::kSpaceAndHaptics;
      const auto way = demonstration(*plan_, kScales_um_per_m[static_cast<std::size_t>(scale_)]);
      device_ = std::make_unique<ConsoleDevice>(
          std::make_unique<SimulatedHand>(person, way, ArmOptions{}, options_.seed + person_count_++));
    }
    start_rig();
  } catch (const Error& error) {
    trouble_ = error.what();
  }
}

void OperatorConsole::start_rig() {
  const bool rate = choices_[static_cast<std::size_t>(chosen_)].springs_back;
  TeleoperationSettings motion;
  motion.scale_um_per_m = kScales_um_per_m[static_cast<std::size_t>(scale_)];
  motion.control = rate ? TeleoperationSettings::Control::kRate : TeleoperationSettings::Control::kPosition;
  motion.rate_um_per_s_per_m = kRateOfScale_per_s * motion.scale_um_per_m;
  motion.self_centring = rate;
  try {
    map_ = std::make_unique<TeleoperationMap>(motion);
    set_buttons();
    rig_ = std::make_unique<TeleoperationRun>(run_, *contacts_, *device_, *map_, manipulator_,
                                              TeleoperationRun::Options{settings(), options_.loop, {}});
    if (stopped_) rig_->emergency_stop();
    rig_->start();
  } catch (const Error& error) {
    rig_.reset();
    trouble_ = error.what();
  }
}

HapticSettings OperatorConsole::settings() const {
  HapticSettings settings =
      default_settings(device_->specification(), kScales_um_per_m[static_cast<std::size_t>(scale_)]);
  if (is_demonstration()) {
    settings.force_scale_N_per_uN = std::min(settings.force_scale_N_per_uN, kDemonstrationScale_N_per_uN);
  }
  if (!plan_) return settings;
  settings = with_plan(settings, *plan_);
  settings.fixtures.stop.depth_um = depth_stop_um();
  if (!guided_)
    settings.fixtures.guide.enabled = settings.fixtures.cone.enabled = settings.fixtures.cell.enabled = false;
  return settings;
}

void OperatorConsole::apply_settings() {
  if (!rig_) return;
  try {
    rig_->set(settings());
  } catch (const UsageError& error) {
    trouble_ = error.what();
  }
}

void OperatorConsole::guide(bool on) {
  guided_ = on;
  apply_settings();
}

void OperatorConsole::depth_stop_um(double depth_um) {
  if (!(depth_um > 0.0) || !std::isfinite(depth_um)) {
    throw UsageError("depth stop: " + std::to_string(depth_um) + " um must be above 0");
  }
  depth_stop_um_ = depth_um;
  apply_settings();
}

double OperatorConsole::depth_stop_um() const noexcept {
  if (depth_stop_um_) return *depth_stop_um_;
  return plan_ ? plan_->depth_um + plan_->options.overshoot_um : 0.0;
}

std::optional<std::string> OperatorConsole::set_target(double x_um, double y_um) {
  if (!plan_) return "no cell has been seen yet; the target can be set once there is a plan";
  const PlainVector3 target_um{x_um, y_um, plan_->cell.center_um.z};
  const auto trial = plan_injection(plan_->cell, target_um, plan_->options);
  if (!trial) return to_string(trial.error());
  target_offset_um_ = Eigen::Vector3d(target_um.eigen() - plan_->cell.center_um.eigen());
  const auto scene = run_.scenes()->peek();
  if (!scene || scene->contact.state != CellState::kFree) return "the target applies from the next cell on";
  if (is_demonstration() && device_ && device_->phase() > OperatorPhase::kApproach) {
    return "the target applies from the next cell on";
  }
  make_plan(scene->contact);
  return std::nullopt;
}

void OperatorConsole::set_buttons() noexcept {
  if (!device_) return;
  const bool paused = run_.paused(), out = retract_ || renewing_;
  std::uint32_t held = 0, withheld = 0;
  if (inject_) held |= kInject;
  if (paused || (mouse_ && !grip_)) held |= kClutch;
  if (paused) withheld |= kInject;
  // Taking the pipette out needs no hand that leads.
  if (out && !paused) {
    held |= kRetract;
    withheld |= kInject | kClutch;
  }
  device_->set_buttons(held, withheld);
}

void OperatorConsole::inject(bool held) noexcept {
  inject_ = held;
  set_buttons();
}

void OperatorConsole::retract(bool held) noexcept {
  retract_ = held;
  set_buttons();
}

void OperatorConsole::grip(bool held) noexcept {
  grip_ = held && mouse_;
  set_buttons();
}

void OperatorConsole::release_all() noexcept {
  inject_ = retract_ = grip_ = false;
  if (mouse_) mouse_->release_all();
  set_buttons();
}

void OperatorConsole::move_px(double dx, double dy) noexcept {
  if (mouse_ && grip_) mouse_->move_px(dx, dy);
}

void OperatorConsole::turn_wheel(double notches) noexcept {
  if (mouse_ && grip_) mouse_->turn_wheel(notches);
}

void OperatorConsole::new_cell() {
  if (!needle_) return;
  renewing_ = true;
  ended_s_.reset();
  set_buttons();
}

void OperatorConsole::emergency_stop(bool on) noexcept {
  stopped_ = on;
  if (!rig_) return;
  if (on) {
    rig_->emergency_stop();
  } else {
    rig_->release_emergency_stop();
  }
}

void OperatorConsole::update() {
  set_buttons();
  look();
  show_person();
  if (renewing_) renew();
  repeat_demonstration();
  if (rig_ && device_->cue()) device_->cue()->show(touch_cue(rig_->status().tick));
}

void OperatorConsole::look() {
  const auto scene = run_.scenes()->peek();
  if (!scene || scene->contact.frame_index == frame_index_) return;
  const ContactModel& contact = scene->contact;
  frame_index_ = contact.frame_index;
  const bool untouched = contact.state == CellState::kFree && contact.cell_seen && needle_seen(contact) &&
                         contact.confidence >= kSureConfidence;
  free_count_ = untouched ? free_count_ + 1 : 0;
  if (!plan_ && !renewing_ && free_count_ >= kFreeFrames) make_plan(contact);
  broken_ = contact.state == CellState::kPunctured;
}

void OperatorConsole::make_plan(const ContactModel& contact) {
  const auto cell = geometry_of(contact);
  if (!cell) return;
  std::optional<PlainVector3> target_um;
  if (target_offset_um_) target_um = Eigen::Vector3d(cell->center_um.eigen() + target_offset_um_->eigen());
  const auto plan = plan_injection(*cell, target_um);
  if (!plan) {
    trouble_ = "No plan: " + to_string(plan.error());
    return;
  }
  trouble_.clear();
  plan_ = *plan;
  run_.set_plan(to_json(*plan_));
  if (is_demonstration()) {
    set_down();
    open_device();
  } else {
    apply_settings();
  }
}

// The tip as it lies under the eyes, whether or not it was measured; the membrane as it was.
void OperatorConsole::show_person() {
  if (!rig_ || !device_->person()) return;
  const PipetteState pipette = rig_->status().pipette;
  if (pipette.known) device_->person()->see({pipette.time_s, pipette.tip_um, true, broken_});
}

bool OperatorConsole::tip_is_out() {
  if (!plan_ || !rig_) return true;
  const PipetteState pipette = rig_->status().pipette;
  if (!pipette.known) return false;
  return (pipette.tip_um.eigen() - plan_->entry_um.eigen()).dot(plan_->axis.eigen()) < -kOut_um;
}

void OperatorConsole::renew() {
  if (!tip_is_out()) return;
  needle_->renew();
  renewing_ = false;
  plan_.reset();
  free_count_ = 0;
  set_buttons();
}

void OperatorConsole::repeat_demonstration() {
  if (!rig_ || !device_->person() || renewing_ || !plan_ || device_->phase() != OperatorPhase::kDone) {
    ended_s_.reset();
    return;
  }
  const double now_s = run_.clock().now_s();
  if (!ended_s_) ended_s_ = now_s;
  if (now_s - *ended_s_ >= options_.rest_s) new_cell();
}

HandStatus OperatorConsole::status() {
  HandStatus status;
  if (rig_) {
    status = rig_->status();
  } else {
    if (chosen_ >= 0) status.device = names_[static_cast<std::size_t>(chosen_)];
    status.tick.hand_state = stopped_ ? HandState::kStopped : HandState::kWaiting;
  }
  if (!status.fault && !trouble_.empty()) status.fault = trouble_;
  return status;
}

std::string OperatorConsole::doing() const {
  if (renewing_) return "Taking the needle out for a new cell";
  if (!plan_) return "Waiting for an untouched cell";
  if (!device_ || !device_->person()) return {};
  switch (device_->phase()) {
    case OperatorPhase::kLook:
      return "Looking";
    case OperatorPhase::kApproach:
      return "Approaching";
    case OperatorPhase::kInsert:
      return "Inserting";
    case OperatorPhase::kDeposit:
      return "Depositing";
    case OperatorPhase::kRemove:
      return "Taking the needle out";
    case OperatorPhase::kDone:
      return "Done; a new cell follows";
  }
  return {};
}

}  // namespace pellucida
