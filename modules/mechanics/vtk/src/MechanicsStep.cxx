#include "pellucida/mechanics_vtk/MechanicsStep.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <optional>
#include <string>

#include "WarningNews.h"
#include "pellucida/mechanics/ContactModelBuilder.h"
#include "pellucida/mechanics/ForceInterval.h"
#include "pellucida/mechanics/ForceObserver.h"
#include "pellucida/membrane/IndentedSolid.h"

namespace pellucida {
namespace {

template <class... Numbers>
std::string format(const char* pattern, Numbers... numbers) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, numbers...);
  return text;
}

/// How the wall stiffens, as the contours say, with its interval.
void write_stiffening(const SizesByContour& seen, Measurement& row) {
  const double half_width = kSigmas95 * seen.stiffening_effect_sigma;
  row.strain_stiffening = stiffening_of(seen.stiffening_effect);
  row.strain_stiffening_lower = stiffening_of(std::max(0.0, seen.stiffening_effect - half_width));
  row.strain_stiffening_upper = stiffening_of(seen.stiffening_effect + half_width);
}

}  // namespace

class MechanicsStep::Impl {
 public:
  explicit Impl(CellProfile profile) : observer_(std::move(profile)) {}

  ForceObserver& observer() noexcept { return observer_; }

  void set_scale_measurements(std::vector<ScaleMeasurement> measurements) {
    for (const ScaleMeasurement& one : measurements) way_of(one);
    std::lock_guard lock(waiting_mutex_);
    waiting_ = std::move(measurements);
  }

  expected<MeasuredScene, StepFailure> process(const Scene& scene, const SolvedShape* known) {
    if (!scene.observation) return unexpected<StepFailure>({"mechanics: the scene has no observation"});
    if (scene.run_index != run_index_) {
      run_index_ = scene.run_index;
      observer_.reset();
      said_.clear();
      warnings_.clear();
      reported_puncture_ = false;
      told_puncture_uN_ = 0.0;
      told_sizes_ = told_stiffening_ = false;
    }
    take_measurements();
    MeasuredScene measured{.scene = scene, .estimate = observer_.process(*scene.observation, known)};
    Scene& out = measured.scene;
    const ForceEstimate& e = measured.estimate;

    out.contact = contact_model(*scene.observation, e, scene.arrival_s);

    // The row: what is not measured stays empty.
    out.measurement.contact_force_uN = e.contact_force_uN;
    out.measurement.contact_force_lower_uN = e.contact_force_lower_uN;
    out.measurement.contact_force_upper_uN = e.contact_force_upper_uN;
    out.measurement.contact_force_picture_lower_uN = e.by_picture.lower_uN;
    out.measurement.contact_force_picture_upper_uN = e.by_picture.upper_uN;
    out.measurement.contact_force_scale_lower_uN = e.by_scale.lower_uN;
    out.measurement.contact_force_scale_upper_uN = e.by_scale.upper_uN;
    out.measurement.pressure_Pa = e.converged ? e.pressure_Pa : Measurement::kNotMeasured;
    if (std::isnan(out.measurement.volume_um3)) out.measurement.volume_um3 = e.volume_um3;
    out.measurement.lateral_force_uN = e.lateral_force_uN;
    out.measurement.stiffness_uN_per_um = e.stiffness_uN_per_um;
    out.measurement.shape_residual_um = e.shape.residual_rms_um;
    out.measurement.asymmetry_um = e.shape.asymmetry_um;
    out.measurement.model_spread_percent = e.opinions.spread_percent;
    out.measurement.puncture_probability = e.puncture_probability;
    if (e.expected_puncture.force_uN > 0.0) {
      out.measurement.expected_puncture_uN = e.expected_puncture.force_uN;
      out.measurement.expected_puncture_um = e.expected_puncture.depth_um;
    }
    if (e.sizes_by_contour) write_stiffening(*e.sizes_by_contour, out.measurement);
    add_events(e, *scene.observation, out);

    // Why there is no force: with every frame, and once as a note when the reason is new.
    const std::optional<CellState> state = out.measurement.state;
    const bool should_measure =
        state == CellState::kContact || state == CellState::kFree || scene.observation->refused_radius_um > 0.0;
    out.remarks = {.reason = should_measure ? e.reason : std::string(),
                   .warning = describe(e.warnings, observer_.profile().name),
                   .point_load_uN = e.opinions.point_load_uN,
                   .table_uN = e.opinions.table_uN,
                   .scale_ratio = observer_.scale().ratio,
                   .scale_sigma_ratio = observer_.scale().relative_sigma,
                   .has_own_scale = observer_.has_own_scale()};
    if (should_measure && !e.reason.empty() && e.reason != said_) {
      out.events.push_back({scene.observation->time_s, event_kind::kNote, "no force: " + e.reason});
    }
    if (should_measure) said_ = e.reason;
    return measured;
  }

 private:
  void take_measurements() {
    std::lock_guard lock(waiting_mutex_);
    if (!waiting_) return;
    observer_.set_scale_measurements(std::move(*waiting_));
    waiting_.reset();
  }

  /// Events of the contact: a puncture, once; a warning, when it is new; a palpation, when it counts.
  void add_events(const ForceEstimate& e, const Observation& o, Scene& out) {
    out.measurement.state = e.judged_state(o.state);
    // One event a puncture, with its force; none from the tracker, whose word may come late, or be doubted.
    if (e.puncture || e.puncture_doubted || (reported_puncture_ && e.punctured)) {
      std::erase_if(out.events, [](const Event& event) { return event.kind == event_kind::kPuncture; });
    }
    if (e.puncture) {
      const Puncture& p = *e.puncture;
      out.events.push_back({o.time_s, event_kind::kPuncture,
                            format("at %.2f uN and %.1f um, work %.1f uN um; membrane back at %.1f um", p.peak_force_uN,
                                   p.depth_um, p.work_uN_um, o.indentation_um)});
      reported_puncture_ = true;
    }
    if (e.puncture_revoked && reported_puncture_) {
      out.events.push_back(
          {o.time_s, event_kind::kRevoked, format("membrane and tip are together again at %.1f um", o.indentation_um)});
    }
    if (!e.punctured) reported_puncture_ = false;

    const unsigned fresh = warnings_.add(e.warnings, o.time_s);
    if (fresh != 0U) {
      std::string detail = to_string(static_cast<ForceWarning>(fresh));
      detail += format(": contour %.1f um from the model, left and right %.1f um apart beyond it",
                       e.shape.residual_rms_um, e.shape.unexplained_asymmetry_um);
      if (fresh & kNotOfRevolution) detail += format(", which may cost %.2f uN", e.asymmetry_force_uN);
      if (fresh & kSeldomBorne) detail += "; " + describe(kSeldomBorne, observer_.profile().name);
      out.events.push_back({o.time_s, event_kind::kWarning, std::move(detail)});
    }

    note_puncture(e, o, out);
    note_contours(e, o, out);
    const CellScale scale = observer_.scale();
    // A model built anew changes it by a trifle.
    const bool is_news = std::abs(std::log(scale.ratio / reported_scale_.ratio)) > 0.01 ||
                         std::abs(scale.relative_sigma - reported_scale_.relative_sigma) > 0.005;
    if (observer_.has_own_scale() && is_news) {
      reported_scale_ = scale;
      out.events.push_back({o.time_s, event_kind::kPalpation,
                            format("this cell's forces are %.3f times the profile's, +- %.1f %%", scale.ratio,
                                   100.0 * scale.relative_sigma) +
                                far_from_kind(scale)});
    }
  }

  /// Once a cell, as it is touched: that it is expected to give way elsewhere than its kind.
  void note_puncture(const ForceEstimate& e, const Observation& o, Scene& out) {
    const ExpectedPuncture& expected = e.expected_puncture;
    if (o.state != CellState::kContact || !(expected.force_uN > 0.0)) return;
    const CellProfile& kind = observer_.profile();
    constexpr double kNews = 0.2;
    const bool is_told = std::abs(std::log(expected.force_uN / told_puncture_uN_)) < kNews;
    const bool is_usual = std::abs(std::log(expected.force_uN / kind.puncture_force_uN)) < kNews;
    if (is_told || (is_usual && told_puncture_uN_ == 0.0)) return;
    told_puncture_uN_ = expected.force_uN;
    out.events.push_back(
        {o.time_s, event_kind::kNote,
         format("by its sizes and the needle's this cell is expected to give way at %.1f uN and %.0f "
                "um, its kind at %.1f uN and %.0f um",
                expected.force_uN, expected.depth_um, kind.puncture_force_uN, kind.puncture_indentation_um)});
  }

  /// Once a contact each, when there is enough to go by: what its contours said of sizes that the picture left open,
  /// and of a wall that surely stiffens.
  void note_contours(const ForceEstimate& e, const Observation& o, Scene& out) {
    constexpr int kEnough = 3;
    if (o.state == CellState::kFree) told_sizes_ = told_stiffening_ = false;
    if (!e.sizes_by_contour || e.sizes_by_contour->contour_count < kEnough) return;
    const SizesByContour& seen = *e.sizes_by_contour;
    const auto note = [&](std::string text) { out.events.push_back({o.time_s, event_kind::kNote, std::move(text)}); };
    if (seen.sizes_changed && !told_sizes_) {
      told_sizes_ = true;
      note(
          format("by the contours in contact: zona %.1f um +- %.0f %%, tip radius %.1f um +- %.0f %%, holding pipette "
                 "%.1f um +- %.0f %%; the force is %.2f times that by the picture alone",
                 seen.thickness_um, 100.0 * seen.thickness_sigma, seen.tip_radius_um, 100.0 * seen.tip_radius_sigma,
                 seen.holder_radius_um, 100.0 * seen.holder_radius_sigma, seen.force_ratio));
    }
    const double effect = seen.stiffening_effect, sigma = seen.stiffening_effect_sigma;
    if (effect > kSigmas95 * sigma && !told_stiffening_) {
      told_stiffening_ = true;
      note(format(
          "by the contours in contact: the zona stiffens with strain, b = %.2f (68 %%: %.2f to %.2f); the force "
          "is %.2f times that by the picture alone",
          stiffening_of(effect), stiffening_of(effect - sigma), stiffening_of(effect + sigma), seen.force_ratio));
    }
  }

  /// A measured scale that hardly any cell of the kind has.
  std::string far_from_kind(const CellScale& scale) const {
    const double sigmas = std::abs(std::log(scale.ratio)) / scale_before(observer_.profile()).relative_sigma;
    constexpr double kFar = 2.0;
    if (sigmas < kFar) return {};
    return format("; %.1f standard deviations from the kind: check the measurement, and that profile ", sigmas) +
           observer_.profile().name + " is this cell's";
  }

  ForceObserver observer_;
  WarningNews warnings_;
  double told_puncture_uN_ = 0.0;                      // the expected one of the last note; 0: none yet
  bool told_sizes_ = false, told_stiffening_ = false;  // in this contact
  bool reported_puncture_ = false;                     // the state has been punctured since
  CellScale reported_scale_;
  std::mutex waiting_mutex_;
  std::optional<std::vector<ScaleMeasurement>> waiting_;  // measurements for the next frame
  std::string said_;                                      // the last reason given
  long run_index_ = 0;
};

MechanicsStep::MechanicsStep(CellProfile profile) : impl_(std::make_unique<Impl>(std::move(profile))) {}
MechanicsStep::~MechanicsStep() = default;
MechanicsStep::MechanicsStep(MechanicsStep&&) noexcept = default;
MechanicsStep& MechanicsStep::operator=(MechanicsStep&&) noexcept = default;

expected<MeasuredScene, StepFailure> MechanicsStep::process(const Scene& scene, const SolvedShape* known) {
  return impl_->process(scene, known);
}
std::shared_ptr<const SolvedShape> MechanicsStep::solved_shape() const {
  return impl_->observer().solved_shape();
}

void MechanicsStep::set_scale_measurements(std::vector<ScaleMeasurement> measurements) {
  impl_->set_scale_measurements(std::move(measurements));
}
CellScale MechanicsStep::scale() const noexcept {
  return impl_->observer().scale();
}
std::vector<PunctureRisk> MechanicsStep::puncture_risk(double step_um) {
  return impl_->observer().puncture_risk(step_um);
}

}  // namespace pellucida
