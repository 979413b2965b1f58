#include "pellucida/operation/OperatorConsole.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Demonstration.h"
#include "HandCatalog.h"
#include "HandEngagement.h"
#include "HomingHand.h"
#include "InjectionGuide.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/NewCellNote.h"
#include "pellucida/operation/ProfileStrength.h"

namespace pellucida {
namespace {

constexpr double kOut_um = 15.0;  // before the entry: the needle is out of the cell
// A tip this far before or behind the image plane is too blurred to be found.
constexpr double kBlurred_um = 30.0;
constexpr double kStrengthStep_ratio = 0.03;  // in such steps the limits follow a cell's sizes
constexpr double kHome_um = 2.0;              // the needle is back
constexpr double kLongestWayHome_s = 15.0;

constexpr std::array kScales_um_per_m{kCoarseScale_um_per_m, kFineScale_um_per_m, kFinestScale_um_per_m};

void require_index(const char* what, int index, std::size_t count) {
  if (index >= 0 && index < static_cast<int>(count)) return;
  throw UsageError(std::string(what) + " " + std::to_string(index) + ": there are " + std::to_string(count));
}

double scale_um_per_m(int index) {
  return kScales_um_per_m[static_cast<std::size_t>(index)];
}

}  // namespace

OperatorConsole::OperatorConsole(LiveRun& run, Manipulator& manipulator, CommandedNeedle* needle)
    : OperatorConsole(run, manipulator, needle, Options{}) {}

OperatorConsole::OperatorConsole(LiveRun& run, Manipulator& manipulator, CommandedNeedle* needle,
                                 const Options& options)
    : run_(run),
      needle_(needle),
      catalog_(std::make_unique<HandCatalog>(needle != nullptr)),
      guide_(std::make_unique<InjectionGuide>()),
      demonstration_(std::make_unique<Demonstration>(options.seed, options.rest_s)),
      hand_(std::make_unique<HandEngagement>(run, manipulator, options.loop)) {}

OperatorConsole::~OperatorConsole() = default;

const std::vector<std::string>& OperatorConsole::hands() const noexcept {
  return catalog_->names();
}

std::optional<int> OperatorConsole::find_hand(std::string_view start) const noexcept {
  return catalog_->find(start);
}

bool OperatorConsole::is_demonstration() const noexcept {
  return chosen_ >= 0 && catalog_->is_demonstration(chosen_);
}

bool OperatorConsole::is_mouse() const noexcept {
  return hand_->device() && hand_->device()->mouse();
}

const std::vector<std::string>& OperatorConsole::scales() {
  static const std::vector<std::string> names{"Coarse 100:1", "Fine 500:1", "Finest 2000:1"};
  return names;
}

void OperatorConsole::choose(int index) {
  require_index("hand", index, hands().size());
  homing_ = nullptr;
  hand_->set_device(nullptr);
  trouble_.clear();
  inject_ = retract_ = grip_ = renewing_ = false;
  chosen_ = index;
  scale_ = is_demonstration() ? 0 : 1;
  open();
  // A demonstration begins outside the cell.
  if (is_demonstration() && plan()) new_cell();
}

void OperatorConsole::scale(int index) {
  require_index("scale", index, kScales_um_per_m.size());
  if (index == scale_) return;
  scale_ = index;
  if (homing_) return;
  if (is_demonstration()) {
    open();
  } else if (hand_->device()) {
    engage();
  }
}

// The hand that was chosen; a demonstration begins with a plan.
void OperatorConsole::open() {
  if (chosen_ < 0) return;
  try {
    if (!is_demonstration()) {
      hand_->set_device(catalog_->open(chosen_));
    } else if (plan()) {
      hand_->set_device(demonstration_->next_operator(*plan(), scale_um_per_m(scale_), modality()));
    } else {
      hand_->set_device(nullptr);
      return;
    }
  } catch (const Error& error) {
    trouble_ = error.what();
    return;
  }
  engage();
}

void OperatorConsole::engage() {
  TeleoperationSettings motion = at_scale({}, scale_um_per_m(scale_));
  if (catalog_->springs_back(chosen_)) {
    motion.control = TeleoperationSettings::Control::kRate;
    motion.self_centring = true;
  }
  try {
    set_buttons();
    hand_->engage(motion, settings());
  } catch (const Error& error) {
    trouble_ = error.what();
  }
}

HapticSettings OperatorConsole::settings() const {
  HapticSettings settings = default_settings(hand_->device()->specification(), scale_um_per_m(scale_), strength());
  if (is_demonstration()) {
    settings.force_scale_N_per_uN = std::min(settings.force_scale_N_per_uN, kDemonstrationScale_N_per_uN);
  }
  if (!haptics_) settings.force_scale_N_per_uN = 0.0;
  return guide_->apply(settings);
}

void OperatorConsole::apply_settings() {
  if (!hand_->engaged()) return;
  try {
    hand_->set(settings());
  } catch (const UsageError& error) {
    trouble_ = error.what();
  }
}

Modality OperatorConsole::modality() const noexcept {
  if (!haptics_) return Modality::kSpace;
  return guided() ? Modality::kSpaceAndFixture : Modality::kSpaceAndHaptics;
}

void OperatorConsole::guide(bool on) {
  guide_->guide(on);
  apply_settings();
}

bool OperatorConsole::guided() const noexcept {
  return guide_->guided();
}

void OperatorConsole::depth_stop_um(double depth_um) {
  guide_->depth_stop_um(depth_um);
  apply_settings();
}

void OperatorConsole::haptics(bool on) {
  haptics_ = on;
  apply_settings();
}

double OperatorConsole::depth_stop_um() const noexcept {
  return guide_->depth_stop_um();
}

const std::optional<InjectionPlan>& OperatorConsole::plan() const noexcept {
  return guide_->plan();
}

std::optional<std::string> OperatorConsole::set_target(double x_um, double y_um) {
  if (auto objection = guide_->set_target(x_um, y_um)) return objection;
  if (!may_replan()) return "the target applies from the next cell on";
  make_plan(run_.scenes()->peek()->contact);
  return std::nullopt;
}

bool OperatorConsole::may_replan() const {
  const auto scene = run_.scenes()->peek();
  if (!plan() || renewing_ || !scene || scene->contact.state != CellState::kFree) return false;
  const ConsoleDevice* device = hand_->device();
  return !is_demonstration() || !device || device->phase() <= OperatorPhase::kApproach;
}

void OperatorConsole::set_buttons() noexcept {
  if (!hand_->device()) return;
  const bool paused = run_.paused(), out = retract_ || (renewing_ && !homing_);
  std::uint32_t held = 0, withheld = 0;
  if (inject_) held |= kInject;
  if (paused || (is_mouse() && !grip_)) held |= kClutch;
  if (paused) withheld |= kInject;
  // Taking the pipette out needs no hand that leads.
  if (out && !paused) {
    held |= kRetract;
    withheld |= kInject | kClutch;
  }
  hand_->device()->set_buttons(held, withheld);
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
  grip_ = held && is_mouse();
  set_buttons();
}

void OperatorConsole::release_all() noexcept {
  inject_ = retract_ = grip_ = false;
  if (is_mouse()) hand_->device()->mouse()->release_all();
  set_buttons();
}

void OperatorConsole::move_px(double dx, double dy) noexcept {
  if (is_mouse() && grip_) hand_->device()->mouse()->move_px(dx, dy);
}

void OperatorConsole::turn_wheel(double notches) noexcept {
  if (is_mouse() && grip_) hand_->device()->mouse()->turn_wheel(notches);
}

void OperatorConsole::new_cell() {
  if (!needle_) return;
  renewing_ = true;
  demonstration_->begin_anew();
  set_buttons();
}

void OperatorConsole::emergency_stop() noexcept {
  hand_->emergency_stop();
}

void OperatorConsole::release_emergency_stop() noexcept {
  hand_->release_emergency_stop();
}

void OperatorConsole::update() {
  set_buttons();
  look();
  show_operator();
  if (renewing_) renew();
  repeat_demonstration();
  if (hand_->engaged() && hand_->device()->cue()) {
    hand_->device()->cue()->show(haptics_ ? touch_cue(hand_->status().tick) : TouchCue{});
  }
}

void OperatorConsole::look() {
  const auto scene = run_.scenes()->peek();
  if (!scene || scene->contact.frame_index == frame_index_) return;
  frame_index_ = scene->contact.frame_index;
  broken_ = scene->contact.state == CellState::kPunctured;
  follow_strength(scene->measurement);
  if (guide_->see(scene->contact) && !plan() && !renewing_) make_plan(scene->contact);
}

// The limits stay where they are while the needle is at the cell.
void OperatorConsole::follow_strength(const Measurement& seen) {
  if (seen.state == CellState::kContact || seen.state == CellState::kPunctured) return;
  const CellStrength now = strength_of(run_.profile(), seen), used = strength();
  const auto moved = [&](double CellStrength::*part) {
    return std::abs(now.*part / used.*part - 1.0) > kStrengthStep_ratio;
  };
  if (!moved(&CellStrength::puncture_force_uN) && !moved(&CellStrength::puncture_depth_um)) return;
  strength_ = now;
  apply_settings();
}

void OperatorConsole::make_plan(const ContactModel& contact) {
  if (const auto objection = guide_->make(contact)) {
    trouble_ = *objection;
    return;
  }
  trouble_.clear();
  run_.set_plan(to_json(*plan()));
  if (is_demonstration()) {
    open();
  } else {
    apply_settings();
  }
}

// The tip as it lies under the eyes, whether or not it was measured; the membrane as it was.
void OperatorConsole::show_operator() {
  if (!hand_->engaged() || !hand_->device()->simulated_hand()) return;
  const PipetteState pipette = hand_->status().pipette;
  if (pipette.known) {
    hand_->device()->simulated_hand()->see({pipette.time_s, pipette.tip_um, true, broken_});
  }
}

bool OperatorConsole::tip_is_out() {
  if (!plan() || !hand_->engaged()) return true;
  const PipetteState pipette = hand_->status().pipette;
  if (!pipette.known) return false;
  return (pipette.tip_um.eigen() - plan()->entry_um.eigen()).dot(plan()->axis.eigen()) < -kOut_um;
}

void OperatorConsole::renew() {
  if (homing_ ? !follow_home() : (!tip_is_out() || lead_home())) return;
  needle_->renew();
  run_.add_event({run_.clock().now_s() - run_.session_lag_s(), event_kind::kNote, std::string(kNewCellNote)});
  renewing_ = false;
  guide_->drop();
  set_buttons();
}

bool OperatorConsole::is_out_of_view(const PlainVector3& tip_um) const noexcept {
  const SourceInfo& source = run_.source_info();
  const auto outside = [&](double place_um, int edge_px) {
    return place_um < 0.0 || place_um > edge_px * source.pixel_size_um;
  };
  return outside(tip_um.x, source.width_px) || outside(tip_um.y, source.height_px) || std::abs(tip_um.z) > kBlurred_um;
}

// True where the needle is out of view, and on its way back. No plan and no guide lead it there: they belong to the
// cell that is left.
bool OperatorConsole::lead_home() {
  if (!hand_->engaged()) return false;
  const PipetteState pipette = hand_->status().pipette;
  if (!pipette.known || !is_out_of_view(pipette.tip_um)) return false;
  auto homing = std::make_unique<HomingHand>(needle_->start_um(), kCoarseScale_um_per_m);
  homing_ = homing.get();
  homing_since_s_ = run_.clock().now_s();
  guide_->drop();
  hand_->set_device(std::move(homing));
  try {
    set_buttons();
    hand_->engage(at_scale({}, kCoarseScale_um_per_m),
                  default_settings(hand_->device()->specification(), kCoarseScale_um_per_m, strength()));
  } catch (const Error& error) {
    trouble_ = error.what();
  }
  return true;
}

// True once the needle is back, and with the hand that was chosen again.
bool OperatorConsole::follow_home() {
  const HandStatus status = hand_->status();
  if (status.pipette.known) homing_->see(status.pipette.tip_um);
  const bool is_home =
      status.pipette.known && (status.pipette.tip_um.eigen() - needle_->start_um().eigen()).norm() < kHome_um;
  // A stop holds the needle where it is, and the way back waits for its release.
  const bool is_late =
      run_.clock().now_s() - homing_since_s_ > kLongestWayHome_s && status.tick.hand_state != HandState::kStopped;
  if (hand_->engaged() && !is_home && !is_late) return false;
  homing_ = nullptr;
  open();
  return true;
}

void OperatorConsole::repeat_demonstration() {
  if (!hand_->engaged() || !is_demonstration() || renewing_ || !plan()) {
    demonstration_->begin_anew();
  } else if (demonstration_->rested(hand_->device()->phase(), run_.clock().now_s())) {
    new_cell();
  }
}

CellStrength OperatorConsole::strength() const noexcept {
  return strength_ ? *strength_ : strength_of(run_.profile());
}

CellLimits OperatorConsole::limits() const {
  return hand_->engaged() ? settings().limits : limits_of(strength());
}

HandStatus OperatorConsole::status() {
  HandStatus status = hand_->status();
  if (!hand_->engaged() && chosen_ >= 0) status.device = hands()[static_cast<std::size_t>(chosen_)];
  if (!status.fault && !trouble_.empty()) status.fault = trouble_;
  return status;
}

std::string OperatorConsole::doing() const {
  if (homing_) return "Bringing the needle back into view";
  if (renewing_) return "Taking the needle out for a new cell";
  if (!plan()) return "Waiting for an untouched cell";
  return is_demonstration() && hand_->device() ? doing_words(hand_->device()->phase()) : "";
}

}  // namespace pellucida
