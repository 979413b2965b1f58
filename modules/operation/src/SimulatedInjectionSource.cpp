#include "pellucida/operation/SimulatedInjectionSource.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "pellucida/core/ManipulatorTrack.h"
#include "pellucida/operation/VirtualInjectionSetup.h"
#include "pellucida/simulation/OperatorPlan.h"
#include "pellucida/simulation/SimulatedTeleoperation.h"

namespace pellucida {
namespace {

constexpr double kPlanConfidence = 0.8;  // of the frame a plan may rest on
constexpr double kAfter_s = 0.5;         // shown once the operator is done
constexpr double kInjectorLag_s = 0.02;  // latency, and the time between two of its turns

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
        teleoperation_(setup_.injector(), map_settings()) {
    info_.seeds["operator"] = options_.seed;
    // The operator decides when it ends.
    info_.frame_count.reset();
    setup_.injector().open();
  }

  std::optional<Frame> next() {
    const double exposure_s = static_cast<double>(frame_count_) / info_.frame_rate_hz;
    if (exposure_s > options_.max_duration_s || (done_s_ >= 0.0 && exposure_s > done_s_ + kAfter_s))
      return std::nullopt;
    while (now_s() <= exposure_s) tick();
    auto frame = microscope_->next();
    if (frame) {
      frame->manipulator_um = manipulator_.at(frame->time_s);
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
  std::vector<LimitEvent> take_events() { return std::exchange(events_, {}); }

  InjectionOutcome outcome() const {
    InjectionOutcome outcome = outcome_;
    outcome.done = teleoperation_.started() && teleoperation_.simulated_operator().done();
    outcome.duration_s = now_s();
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
    const double lag_s = teleoperation_.learnt_lag_s(kInjectorLag_s, options_.vision_delay_s, info_.frame_rate_hz);
    teleoperation_.start(options_.simulated_operator, operator_plan(*plan_, teleoperation_.scale_um_per_m(), lag_s),
                         ArmOptions{}, options_.seed,
                         [this](const DeviceSpecification& device) { return settings_for(device); });
  }

  HapticSettings settings_for(const DeviceSpecification& device) const {
    const Modality modality = options_.simulated_operator.modality;
    HapticSettings settings = default_settings(device, teleoperation_.scale_um_per_m(), options_.cell);
    settings.predictor.tip_lag_s = kInjectorLag_s;
    if (modality == Modality::kFlatImage || modality == Modality::kSpace) settings.force_scale_N_per_uN = 0.0;
    if (modality == Modality::kSpaceAndFixture) settings = with_plan(settings, *plan_);
    return settings;
  }

  // Of the next tick.
  double now_s() const noexcept {
    return static_cast<double>(teleoperation_.tick_count()) * SimulatedTeleoperation::kTick_s;
  }

  void tick() {
    const double now_s = teleoperation_.begin_tick();
    while (!waiting_.empty() && waiting_.front().due_s <= now_s) {
      land(waiting_.front().contact);
      waiting_.pop_front();
    }
    if (teleoperation_.started()) {
      keep(teleoperation_.turn_hand());
      while (const auto event = teleoperation_.take_event()) events_.push_back(*event);
      if (done_s_ < 0.0 && teleoperation_.simulated_operator().done()) done_s_ = now_s;
    }
    teleoperation_.turn_manipulator();
    const PipetteState report = teleoperation_.reported();
    if (report.known)
      manipulator_.add(report.time_s, report.tip_um.eigen().head<2>(), report.velocity_um_per_s.eigen().head<2>());
  }

  // A frame's measurement is there: the hand feels by it, the operator sees it.
  void land(const ContactModel& contact) {
    OperatorView view;
    view.time_s = contact.time_s;
    view.tip_um = contact.tip_um;
    view.tip_seen = contact.valid;
    view.membrane_closed = contact.state == CellState::kPunctured;
    teleoperation_.show(contact, view);
  }

  void keep(const HapticRecord& record) {
    records_.push_back(record);
    outcome_.peak_hand_force_N = std::max(outcome_.peak_hand_force_N, record.hand_force_N.eigen().norm());
    const OperatorPhase phase = teleoperation_.simulated_operator().phase();
    if (phase != OperatorPhase::kInsert && phase != OperatorPhase::kDeposit) return;
    const Eigen::Vector3d way_um = record.pipette_um.eigen() - plan_->entry_um.eigen();
    const Eigen::Vector3d axis = plan_->axis.eigen();
    lateral_square_um2_ += (way_um - way_um.dot(axis) * axis).squaredNorm();
    ++lateral_count_;
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
  SimulatedTeleoperation teleoperation_;
  ManipulatorTrack manipulator_;
  std::optional<InjectionPlan> plan_;

  std::deque<Measured> waiting_;  // measured, not yet at the hand
  std::vector<HapticRecord> records_;
  std::vector<LimitEvent> events_;
  InjectionOutcome outcome_;
  long frame_count_ = 0;
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
std::vector<LimitEvent> SimulatedInjectionSource::take_events() {
  return impl_->take_events();
}
InjectionOutcome SimulatedInjectionSource::outcome() const {
  return impl_->outcome();
}

}  // namespace pellucida
