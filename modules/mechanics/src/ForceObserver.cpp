#include "pellucida/mechanics/ForceObserver.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "CellModelCache.h"
#include "CellPlacement.h"
#include "ContactSight.h"
#include "ErrorBudget.h"
#include "ForceReport.h"
#include "ObservationCheck.h"
#include "PunctureVerdict.h"
#include "SizesCorrector.h"
#include "pellucida/core/DepthFilter.h"
#include "pellucida/core/Error.h"
#include "pellucida/mechanics/RevolvedContour.h"

namespace pellucida {
namespace {

/// Rounds of finding the contour's nearest places again.
constexpr int kProjections = 3;
/// What no filter averages out: the edge's centre line may lie a little beside the membrane, the same in every frame.
constexpr double kEdgeBias_um = 0.12;
/// A contact is confirmed over some frames. So deep, um, it is by then: a needle that is seen deeper in an untouched
/// cell isn't in its plane.
constexpr double kLateContact_um = 3.0;
/// A tip known less surely (standard deviation) has faded from view, as that of a needle that leaves its plane: what
/// that takes from its depth, in what is left of its standard deviation.
constexpr double kVagueTip_um = 1.0, kVagueTip_sigmas = 2.0;

}  // namespace

class ForceObserver::Impl {
 public:
  Impl(CellProfile profile, const ForceOptions& options)
      : profile_(std::move(profile)), options_(checked(options)), cell_(profile_), report_(profile_, options_) {
    scale_ = scale_before(profile_);
  }

  const CellProfile& profile() const noexcept { return profile_; }

  void set_scale(const CellScale& scale) {
    if (!(scale.ratio > 0.0) || !std::isfinite(scale.ratio) || !(scale.relative_sigma >= 0.0)) {
      throw UsageError("a cell's scale: its ratio must be above 0, its sigma 0 or above");
    }
    scale_ = scale;
    measurements_.clear();
    counted_ = 0;
    has_own_scale_ = false;
  }

  void set_scale_measurements(std::vector<ScaleMeasurement> measurements) {
    for (const ScaleMeasurement& one : measurements) {
      const bool lacks =
          way_of(one) == ScaleWay::kAspiration &&
          !(one.modulus_kPa > 0.0 && one.modulus_sigma_percent > 0.0 && one.modulus_of_profile_ratio > 0.0);
      if (lacks) throw UsageError("scale of the cell: the aspiration's modulus has not been computed");
    }
    std::stable_sort(measurements.begin(), measurements.end(),
                     [](const auto& a, const auto& b) { return a.since_s < b.since_s; });
    measurements_ = std::move(measurements);
    counted_ = 0;
    has_own_scale_ = false;
    scale_ = scale_before(profile_);
  }

  CellScale scale() const noexcept { return scale_; }
  bool has_own_scale() const noexcept { return has_own_scale_; }

  std::vector<PunctureRisk> puncture_risk(double step_um) {
    if (!(step_um > 0.0)) throw UsageError("risk of puncture: the step must be above 0 um");
    return cell_.exists() ? cell_.puncture_risk(step_um, scale_) : std::vector<PunctureRisk>{};
  }

  void reset() {
    cell_.forget();
    placement_.reset();
    report_.forget();
    sizes_.forget();
    end_contact();
  }

  ForceEstimate process(const Observation& o, const SolvedShape* known) {
    ForceEstimate estimate;
    known_ = options_.observation_ratio > 0.0 ? nullptr : known;
    pressed_.reset();
    estimate.time_s = o.time_s;
    estimate.frame_index = o.frame_index;
    estimate.reason = why_not_measured(o, profile_);
    if (!estimate.reason.empty()) {
      // A cell that is lost goes on relaxing; another one has no past.
      if (o.state == CellState::kNoCell) {
        report_.forget();
        sizes_.forget();
      }
      if (!has_cell(o)) end_contact();
      return estimate;
    }
    place(o, estimate);
    estimate.work_uN_um = verdict_.work_uN_um();
    const std::optional<double> depth_um = look(o, estimate);
    if (!estimate.reason.empty()) return estimate;

    SolvedFrame frame = solve(o, depth_um, estimate);
    report_.write(frame, estimate);
    if (!estimate.converged) return estimate;
    if (has_own_scale()) {
      estimate.puncture_probability =
          puncture_probability(estimate.expected_puncture, estimate.contact_force_uN, estimate.errors.relative());
    }
    if (!frame.contact) return estimate;
    verdict_.add(frame.depth_um, estimate.contact_force_uN);
    estimate.work_uN_um = verdict_.work_uN_um();
    return estimate;
  }

  std::shared_ptr<const SolvedShape> solved_shape() const {
    return pressed_ ? std::make_shared<const SolvedShape>(cell_.indenter().shape(*pressed_)) : nullptr;
  }

 private:
  static const ForceOptions& checked(const ForceOptions& options) {
    if (!(options.observation_ratio >= 0.0)) throw UsageError("weight of the contour: it must be 0 or above");
    if (!(options.hand_frequency_Hz > 0.0)) throw UsageError("frequency of the hand: it must be above 0 Hz");
    return options;
  }

  void end_contact() {
    filter_.reset();
    verdict_.release();
    placement_.end_contact();
  }

  /// Where the cell is, how thick, how it is held and pushed.
  void place(const Observation& o, ForceEstimate& estimate) {
    placement_.update(o);
    estimate.rotation_WC = placement_.rotation_WC();
    estimate.center_um = placement_.center_um();
    estimate.holder_assumed = placement_.holder_assumed();
    if (cell_.fit(o, placement_)) {
      auditor_.set_model(cell_.model().rest());
      counted_ = 0;
      sizes_.clear();
    }
    if (o.state == CellState::kFree) sizes_.add_rest(o, placement_);
    estimate.thickness_assumed = cell_.geometry().thickness_assumed();
    measure_scale(o.time_s);
    estimate.expected_puncture = expected_puncture(profile_, cell_.built_geometry(), scale_.ratio);
  }

  /// What counts by now against the model of this cell; anew where the model is. The model is at rest afterwards.
  void measure_scale(double time_s) {
    std::size_t count = 0;
    while (count < measurements_.size() && measurements_[count].since_s <= time_s) ++count;
    if (count == counted_) return;
    counted_ = count;
    const auto scale = cell_.scale_after(std::span(measurements_).first(count));
    has_own_scale_ = count > 0 && scale;
    if (scale) scale_ = *scale;
  }

  /// How deep the needle pushes, filtered; nothing out of contact or where the membrane is through. Writes `reason`
  /// where a contact can't be measured.
  std::optional<double> look(const Observation& o, ForceEstimate& estimate) {
    if (o.state == CellState::kFree) {
      end_contact();
      verdict_.watch(sight_of(o, placement_.contact()));
      leave(o, estimate);
      return std::nullopt;
    }
    const MembraneGeometry& built = cell_.built_geometry();
    if (placement_.enters_at_holder(built.holder_radius_um, built.tip_radius_um, cell_.outer_radius_um())) {
      estimate.reason = "contact, but what was taken for the needle comes from where the cell is held";
      return std::nullopt;
    }
    const PunctureVerdict::Sight sight = sight_of(o, placement_.contact());
    const bool is_through = verdict_.judge(sight);
    estimate.puncture_revoked = verdict_.is_revoked();
    if (is_through) {
      puncture(o, estimate);
      return std::nullopt;
    }
    estimate.puncture_doubted = verdict_.is_doubted();
    estimate.flanks_pushed = verdict_.is_pushed();
    if (!sight.has_depths) {
      estimate.reason = "contact, but the needle was not seen";
      return std::nullopt;
    }
    // The membrane lies on the tip that pushes it: a contour short of that tip cuts across the dimple of a fine needle.
    // Far short of it, or far beyond, one of the two is not where it seems: the one counts that goes on as before. And
    // where the flanks have come back the contour may only be tied to the tip: in doubt the depth is between them.
    // A tip that has faded from view holds nothing up.
    const double vague_um = kVagueTip_sigmas * std::max(0.0, sight.tip_sigma_um - kVagueTip_um);
    const double by_contour_um = std::max(0.0, o.indentation_um), by_tip_um = std::max(0.0, sight.tip_um - vague_um);
    double depth_um = std::max(by_contour_um, by_tip_um), other_um = depth_um;
    if (PunctureVerdict::is_apart(sight) || PunctureVerdict::lies_beyond_tip(sight)) {
      other_um = std::min(by_contour_um, by_tip_um);
      const std::optional<double> expected_um = filter_.expected_um(o.time_s);
      const bool may_choose = expected_um && depth_um <= cell_.deepest_um() && !verdict_.is_doubted();
      if (may_choose && *expected_um - other_um < depth_um - *expected_um) std::swap(depth_um, other_um);
    }
    if (verdict_.is_doubted()) other_um = std::min(other_um, verdict_.depth_by_flanks_um());
    const double half_gap_um = 0.5 * std::abs(depth_um - other_um);
    const double doubt_um = verdict_.is_doubted() && !verdict_.is_pushed() ? half_gap_um : 0.0;
    // What lasts over the frames, such as where the cell is seated, is no noise: a filter that took it for noise would
    // go on where the needle halts. A membrane on the tip moves as the tip does, and is seen as well.
    const double noise_um = std::min(sight.membrane_sigma_um, sight.tip_sigma_um);
    const double lasting_um = std::sqrt(std::pow(sight.membrane_sigma_um, 2) - noise_um * noise_um);
    const auto filtered = filter_.update(o.time_s, depth_um - doubt_um, std::hypot(noise_um, doubt_um));
    estimate.depth_sigma_um = std::hypot(std::hypot(filtered.sigma_um, lasting_um), kEdgeBias_um, half_gap_um);
    // No needle goes deeper than the model can follow.
    if (filtered.depth_um > cell_.deepest_um()) estimate.reason = "the indentation is deeper than the model reaches";
    // While a puncture is in doubt a membrane on its way back bears no more than before it went.
    if (verdict_.is_doubted() && o.indentation_um < verdict_.last_depth_um()) {
      return std::min(filtered.depth_um, verdict_.last_depth_um());
    }
    return filtered.depth_um;
  }

  /// The membrane has given way: what it took, once, and nothing on the needle.
  void puncture(const Observation& o, ForceEstimate& estimate) {
    estimate.punctured = true;
    estimate.puncture_doubted = estimate.flanks_pushed = false;
    estimate.puncture = verdict_.take_puncture(o.time_s);
    leave(o, estimate);
  }

  /// The needle carries nothing in this frame.
  void leave(const Observation& o, ForceEstimate& estimate) {
    filter_.reset();
    report_.rest(o.time_s);
    estimate.depth_sigma_um = 0.0;
  }

  /// How deep the needle may be in a cell that counts as free, as its tip's place leaves open; 0: it is away, or
  /// passes.
  double possible_touch_um(const Observation& o) const {
    if (!o.needle || !o.needle->tip_um.allFinite()) return 0.0;
    const double tip_um = placement_.contact().tip_depth_um;
    if (!(tip_um < kLateContact_um)) return 0.0;
    return std::max(0.0, tip_um + kSigmas95 * std::hypot(o.needle->tip_sigma_um, kEdgeBias_um));
  }

  IndentationState press(double depth_um) {
    return options_.observation_ratio > 0.0 ? cell_.press_solved(depth_um) : cell_.press(depth_um, known_);
  }

  /// The model pressed to `depth_um`, or at rest without one, or where its contour shows that it is.
  SolvedFrame solve(const Observation& o, std::optional<double> depth_um, ForceEstimate& estimate) {
    SolvedFrame frame{.observation = o,
                      .cell = cell_,
                      .placement = placement_,
                      .scale = scale_,
                      .auditor = auditor_,
                      .state = depth_um ? press(*depth_um) : cell_.release(),
                      .depth_um = depth_um.value_or(0.0),
                      .contact = depth_um.has_value(),
                      .touch_um = o.state == CellState::kFree ? possible_touch_um(o) : 0.0};
    estimate.iterations = frame.state.report.iterations;
    estimate.converged = !frame.contact || frame.state.report.status == SolveStatus::kConverged;
    if (!estimate.converged) {
      estimate.reason = "the model found no equilibrium: " + std::string(to_string(frame.state.report.status));
    }
    if (frame.contact) pressed_ = frame.state.report;
    audit(o, estimate);
    if (!frame.contact || !estimate.converged) return frame;

    const ShapeAudit& shape = estimate.shape;
    const PunctureVerdict::Shape seen{.residual_um = shape.residual_rms_um,
                                      .dimple_residual_um = shape.dimple_residual_um,
                                      .usual_um = usual_mismatch_um(shape, frame.depth_um)};
    const bool has_sprung = verdict_.judge(seen);
    estimate.puncture_doubted = verdict_.is_doubted();
    if (has_sprung) {
      puncture(o, estimate);
      pressed_.reset();
      frame.contact = false;
      frame.depth_um = 0.0;
      frame.state = cell_.release();
      audit(o, estimate);
      return frame;
    }
    follow_contour(frame, estimate);
    if (frame.depth_um > 0.0) {
      frame.sizes =
          sizes_.follow(o, placement_, cell_, frame.depth_um, estimate.depth_sigma_um, verdict_.is_doubted(), scale_);
      estimate.sizes_by_contour = sizes_.sizes();
    }
    return frame;
  }

  /// The contour's weak pull, where it is asked for: its places found again about the shape it led to.
  void follow_contour(SolvedFrame& frame, ForceEstimate& estimate) {
    if (!(options_.observation_ratio > 0.0)) return;
    const MembraneModel& model = cell_.model();
    for (int round = 0; round < kProjections; ++round) {
      cell_.indenter().observe(observe_revolved(model.rest(), cell_.indenter().positions_um(), auditor_,
                                                options_.observation_ratio * model.force_scale_uN_per_um()));
      frame.state = cell_.indenter().advance_to(frame.depth_um);
      audit(frame.observation, estimate);
    }
  }

  void audit(const Observation& o, ForceEstimate& estimate) {
    estimate.shape = auditor_.audit(o, cell_.indenter().positions_um(), estimate.rotation_WC, estimate.center_um,
                                    cell_.geometry().thickness_um());
  }

  CellProfile profile_;
  ForceOptions options_;
  CellScale scale_;
  std::vector<ScaleMeasurement> measurements_;  // by the time they count from
  std::size_t counted_ = 0;                     // of them, in `scale_`, for this model
  bool has_own_scale_ = false;
  CellModelCache cell_;
  ForceReport report_;
  DepthFilter filter_;
  PunctureVerdict verdict_;
  ShapeAuditor auditor_;
  CellPlacement placement_;
  SizesCorrector sizes_;
  const SolvedShape* known_ = nullptr;  // during a frame
  std::optional<SolveReport> pressed_;  // the last frame's model is pressed
};

ForceObserver::ForceObserver(CellProfile profile, ForceOptions options)
    : impl_(std::make_unique<Impl>(std::move(profile), options)) {}
ForceObserver::~ForceObserver() = default;
ForceObserver::ForceObserver(ForceObserver&&) noexcept = default;
ForceObserver& ForceObserver::operator=(ForceObserver&&) noexcept = default;

const CellProfile& ForceObserver::profile() const noexcept {
  return impl_->profile();
}
void ForceObserver::set_scale(const CellScale& scale) {
  impl_->set_scale(scale);
}
void ForceObserver::set_scale_measurements(std::vector<ScaleMeasurement> measurements) {
  impl_->set_scale_measurements(std::move(measurements));
}
std::vector<PunctureRisk> ForceObserver::puncture_risk(double step_um) {
  return impl_->puncture_risk(step_um);
}
CellScale ForceObserver::scale() const noexcept {
  return impl_->scale();
}
bool ForceObserver::has_own_scale() const noexcept {
  return impl_->has_own_scale();
}
ForceEstimate ForceObserver::process(const Observation& observation, const SolvedShape* known) {
  return impl_->process(observation, known);
}
std::shared_ptr<const SolvedShape> ForceObserver::solved_shape() const {
  return impl_->solved_shape();
}
void ForceObserver::reset() {
  impl_->reset();
}

}  // namespace pellucida
