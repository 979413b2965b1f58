#include "pellucida/operation/SimulatedInjectionSource.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "pellucida/core/Clock.h"
#include "pellucida/haptics/HapticServo.h"
#include "pellucida/operation/LimitDigest.h"
#include "pellucida/operation/VirtualInjectionSetup.h"
#include "pellucida/simulation/OperatorPlan.h"
#include "pellucida/simulation/SimulatedHand.h"
#include "pellucida/teleoperation/ManipulatorStage.h"
#include "pellucida/teleoperation/TeleoperationMap.h"

namespace pellucida {
namespace {

constexpr double kTick_s = 1e-3;
constexpr int kManipulatorTicks = 10;    // between two turns of the manipulator's stage
constexpr double kPlanConfidence = 0.8;  // of the frame a plan may rest on
constexpr double kAfter_s = 0.5;         // shown once the operator is done
constexpr double kInjectorLag_s = 0.02;  // latency, and half the time between two of its turns

TeleoperationSettings map_settings() {
  TeleoperationSettings settings;
  settings.scale_um_per_m = kCoarseScale_um_per_m;
  return settings;
}

}  // namespace

class SimulatedInjectionSource::Impl {
 public:
  explicit Impl(const SimulatedInjectionOptions& options)
      : options_(options),
        setup_(options.scenario),
        microscope_(setup_.make_microscope(Pace::kAsFastAsPossible)),
        info_(microscope_->info()),
        map_(map_settings()),
        stage_(setup_.injector(), clock_) {
    // The operator decides when it ends.
    info_.frame_count.reset();
    setup_.injector().open();
  }

  std::optional<Frame> next() {
    const double exposure_s = static_cast<double>(frame_count_) / info_.frame_rate_hz;
    if (exposure_s > options_.max_duration_s || (done_s_ >= 0.0 && exposure_s > done_s_ + kAfter_s))
      return std::nullopt;
    while (static_cast<double>(tick_count_) * kTick_s <= exposure_s) tick();
    auto frame = microscope_->next();
    if (frame) {
      ++frame_count_;
      watch(microscope_->truth(), frame->time_s);
    }
    return frame;
  }

  void see(const Scene& measured) {
    waiting_.push_back({measured.measurement.time_s + options_.vision_delay_s, measured.contact});
    ContactModel& contact = waiting_.back().contact;
    contact.time_s = measured.measurement.time_s;
    if (!plan_ && contact.valid && contact.state == CellState::kFree && contact.confidence >= kPlanConfidence) {
      begin(contact);
    }
  }

  const SourceInfo& info() const noexcept { return info_; }
  const std::optional<InjectionPlan>& plan() const noexcept { return plan_; }

  std::vector<HapticRecord> take_records() { return std::exchange(records_, {}); }
  std::vector<Event> take_events() { return done_s_ < 0.0 ? limits_.take(clock_.now_s(), 0.0) : limits_.finish(0.0); }

  InjectionOutcome outcome() const {
    InjectionOutcome outcome = outcome_;
    outcome.done = hand_ && hand_->person().done();
    outcome.duration_s = static_cast<double>(tick_count_) * kTick_s;
    if (lateral_count_ > 0)
      outcome.lateral_rms_um = std::sqrt(lateral_square_um2_ / static_cast<double>(lateral_count_));
    return outcome;
  }

 private:
  struct Measured {
    double due_s;
    ContactModel contact;
  };

  // From the first good frame: the plan, and with it operator and hand.
  void begin(const ContactModel& contact) {
    const auto geometry = geometry_of(contact);
    if (!geometry) return;
    const auto plan = plan_injection(*geometry);
    if (!plan) return;
    plan_ = *plan;
    const double learnt_lag_s = map_.lag_s() + kInjectorLag_s + options_.vision_delay_s + 0.5 / info_.frame_rate_hz;
    hand_.emplace(options_.person, operator_plan(*plan_, map_.scale_um_per_m(), learnt_lag_s), ArmOptions{},
                  options_.seed);
    HapticSettings settings = default_settings(hand_->specification(), map_.scale_um_per_m(), options_.cell);
    settings.predictor.tip_lag_s = kInjectorLag_s;
    if (options_.person.modality == Modality::kFlatImage || options_.person.modality == Modality::kSpace) {
      settings.force_scale_N_per_uN = 0.0;
    }
    if (options_.person.modality == Modality::kSpaceAndFixture) settings = with_plan(settings, *plan_);
    servo_.emplace(*hand_, map_, HapticPorts{contacts_, stage_.states(), stage_.commands()}, settings);
  }

  void tick() {
    const double now_s = static_cast<double>(tick_count_) * kTick_s;
    clock_.set(now_s);
    while (!waiting_.empty() && waiting_.front().due_s <= now_s) {
      land(waiting_.front().contact);
      waiting_.pop_front();
    }
    if (servo_) {
      servo_->turn(now_s);
      collect();
      if (done_s_ < 0.0 && hand_->person().done()) done_s_ = now_s;
    }
    if (tick_count_ % kManipulatorTicks == 0) stage_.turn();
    ++tick_count_;
  }

  // A frame's measurement is there: the hand feels by it, the operator sees it.
  void land(const ContactModel& contact) {
    contacts_.publish(contact);
    if (!hand_) return;
    OperatorView view;
    view.time_s = contact.time_s;
    view.tip_um = contact.tip_um;
    view.tip_seen = contact.valid;
    view.membrane_closed = contact.state == CellState::kPunctured;
    hand_->see(view);
  }

  void collect() {
    while (const auto record = servo_->records().pop()) {
      records_.push_back(*record);
      outcome_.peak_hand_force_N = std::max(outcome_.peak_hand_force_N, record->hand_force_N.eigen().norm());
      const OperatorPhase phase = hand_->person().phase();
      if (phase != OperatorPhase::kInsert && phase != OperatorPhase::kDeposit) continue;
      const Eigen::Vector3d way_um = record->pipette_um.eigen() - plan_->entry_um.eigen();
      const Eigen::Vector3d axis = plan_->axis.eigen();
      lateral_square_um2_ += (way_um - way_um.dot(axis) * axis).squaredNorm();
      ++lateral_count_;
    }
    while (const auto event = servo_->events().pop()) limits_.add(*event);
  }

  void watch(const Truth& truth, double time_s) {
    outcome_.deposited_pL = truth.deposited_pL;
    if (outcome_.puncture_s >= 0.0) return;
    if (truth.observation.state == CellState::kPunctured) {
      outcome_.puncture_s = time_s;
      outcome_.puncture_force_uN = setup_.needle().puncture_force_uN();
      return;
    }
    outcome_.puncture_depth_um = std::max(outcome_.puncture_depth_um, truth.observation.indentation_um);
  }

  SimulatedInjectionOptions options_;
  VirtualInjectionSetup setup_;
  std::unique_ptr<VirtualMicroscope> microscope_;
  SourceInfo info_;
  ManualClock clock_;
  TeleoperationMap map_;
  ManipulatorStage stage_;
  LatestValue<ContactModel> contacts_;
  std::optional<InjectionPlan> plan_;
  std::optional<SimulatedHand> hand_;
  std::optional<HapticServo> servo_;

  std::deque<Measured> waiting_;  // measured, not yet at the hand
  std::vector<HapticRecord> records_;
  LimitDigest limits_;
  InjectionOutcome outcome_;
  long frame_count_ = 0;
  long tick_count_ = 0;
  double done_s_ = -1.0;
  double lateral_square_um2_ = 0.0;
  long lateral_count_ = 0;
};

SimulatedInjectionSource::SimulatedInjectionSource(const SimulatedInjectionOptions& options)
    : impl_(std::make_unique<Impl>(options)) {}
SimulatedInjectionSource::~SimulatedInjectionSource() = default;

const SourceInfo& SimulatedInjectionSource::info() const noexcept {
  return impl_->info();
}
std::optional<Frame> SimulatedInjectionSource::next() {
  return impl_->next();
}
void SimulatedInjectionSource::see(const Scene& measured) {
  impl_->see(measured);
}
const std::optional<InjectionPlan>& SimulatedInjectionSource::plan() const noexcept {
  return impl_->plan();
}
std::vector<HapticRecord> SimulatedInjectionSource::take_records() {
  return impl_->take_records();
}
std::vector<Event> SimulatedInjectionSource::take_events() {
  return impl_->take_events();
}
InjectionOutcome SimulatedInjectionSource::outcome() const {
  return impl_->outcome();
}

}  // namespace pellucida
