#include "pellucida/mechanics/ForceObserver.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "CellModelCache.h"
#include "CellPlacement.h"
#include "DepthFilter.h"
#include "ErrorBudget.h"
#include "NodalField.h"
#include "RelaxingContact.h"
#include "RevolvedContour.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

/// Noise of the indentation when the tracker gives none: a quarter of a pixel at 0.8 um.
constexpr double kDefaultDepthSigma_um = 0.2;
/// And of the tip along the needle.
constexpr double kDefaultTipSigma_um = 0.4;
/// Rounds of finding the contour's nearest places again.
constexpr int kProjections = 3;
/// What no filter averages out: the edge's centre line may lie a little beside the membrane, the same in every frame.
constexpr double kEdgeBias_um = 0.12;
/// A profile speaks of cells of its own size: outside this share of its radius it says nothing.
constexpr double kSmallestRatio = 0.6;
constexpr double kLargestRatio = 1.7;

double sphere_volume_um3(double radius_um) {
  return 4.0 / 3.0 * std::numbers::pi * std::pow(radius_um, 3);
}

std::string whole(double value) {
  return std::to_string(std::lround(value));
}

}  // namespace

class ForceObserver::Impl {
 public:
  Impl(CellProfile profile, const ForceOptions& options)
      : profile_(std::move(profile)),
        options_(checked(options)),
        tables_(profile_.name),
        cell_(profile_),
        relaxing_(profile_, options.hand_frequency_Hz) {
    scale_ = {1.0, profile_.force_scale_relative_sigma};
  }

  const CellProfile& profile() const noexcept { return profile_; }

  void set_scale(const CellScale& scale) {
    if (!(scale.ratio > 0.0) || !std::isfinite(scale.ratio) || !(scale.relative_sigma >= 0.0)) {
      throw UsageError("a cell's scale: its ratio must be above 0, its sigma 0 or above");
    }
    scale_ = scale;
    palpation_.reset();
  }

  void set_palpation(const Palpation& palpation) {
    validate(palpation);
    palpation_ = palpation;
    palpated_ = false;
  }

  CellScale scale() const noexcept { return scale_; }

  std::vector<PunctureRisk> puncture_risk(double step_um) {
    if (!(step_um > 0.0)) throw UsageError("risk of puncture: the step must be above 0 um");
    return cell_.exists() ? cell_.puncture_risk(step_um, scale_) : std::vector<PunctureRisk>{};
  }

  void reset() {
    cell_.forget();
    placement_.reset();
    relaxing_.forget();
    end_contact();
  }

  ForceEstimate process(const Observation& o) {
    ForceEstimate estimate;
    estimate.time_s = o.time_s;
    estimate.frame_index = o.frame_index;

    // Nothing to measure. A cell that is lost goes on relaxing; another one has no past.
    if (o.state == CellState::kNoCell || o.state == CellState::kLost || !o.outer) {
      estimate.reason = "no cell to measure";
      if (o.state == CellState::kNoCell) relaxing_.forget();
      end_contact();
      return estimate;
    }
    if (!o.center_um.allFinite() || !std::isfinite(o.rest_outer_radius_um) || o.rest_outer_radius_um <= 0.0) {
      estimate.reason = "the cell's rest shape is not known";
      return estimate;
    }
    const double outer_ratio = o.rest_outer_radius_um / (profile_.mid_radius_um + 0.5 * profile_.thickness_um);
    if (outer_ratio < kSmallestRatio || outer_ratio > kLargestRatio) {
      estimate.reason = "no cell of profile " + profile_.name + ": its radius is " + whole(o.rest_outer_radius_um) +
                        " um, the profile's " + whole(profile_.mid_radius_um) +
                        " um; check the pixel size, or give another profile";
      return estimate;
    }

    // Where the cell is, how thick, how it is held and pushed.
    placement_.update(o);
    estimate.rotation_WC = placement_.rotation_WC();
    estimate.center_um = placement_.center_um();
    estimate.holder_assumed = placement_.holder_assumed();
    if (cell_.fit(o, placement_)) {
      auditor_.set_model(cell_.model().rest());
      palpated_ = false;
    }
    estimate.thickness_assumed = cell_.thickness_assumed();
    if (palpation_ && !palpated_) palpate();

    // Contact: the filtered depth, unless the membrane has just left the tip; otherwise the cell is at rest.
    double depth_um = 0.0;
    bool contact = o.state == CellState::kContact;
    if (contact) {
      if (!o.needle || !std::isfinite(o.indentation_um)) {
        estimate.reason = "contact, but the needle was not seen";
        return estimate;
      }
      const bool has_sigma = std::isfinite(o.indentation_sigma_um) && o.indentation_sigma_um > 0.0;
      const double sigma_um = has_sigma ? o.indentation_sigma_um : kDefaultDepthSigma_um;
      const double tip_sigma_um = o.needle->tip_sigma_um > 0.0 ? o.needle->tip_sigma_um : kDefaultTipSigma_um;
      if (monitor_.is_through({placement_.contact().tip_depth_um, tip_sigma_um, o.indentation_um, sigma_um})) {
        contact = false;
        estimate.punctured = true;
      } else {
        const auto filtered = filter_.update(o.time_s, std::max(0.0, o.indentation_um), sigma_um);
        depth_um = filtered.depth_um;
        estimate.depth_sigma_um = std::hypot(filtered.sigma_um, kEdgeBias_um);
        // No needle goes deeper than the model can follow.
        if (depth_um > cell_.deepest_um()) {
          estimate.reason = "the indentation is deeper than the model reaches";
          return estimate;
        }
      }
    }
    estimate.punctured |= o.state == CellState::kPunctured;
    if (estimate.punctured) estimate.puncture = monitor_.take_puncture(o.time_s);
    estimate.work_uN_um = monitor_.work_uN_um();
    if (o.state == CellState::kFree) end_contact();
    if (!contact) leave(o, estimate);
    solve(o, depth_um, contact, estimate);
    return estimate;
  }

 private:
  static const ForceOptions& checked(const ForceOptions& options) {
    if (!(options.observation_ratio >= 0.0)) throw UsageError("weight of the contour: it must be 0 or above");
    if (!(options.hand_frequency_Hz > 0.0)) throw UsageError("frequency of the hand: it must be above 0 Hz");
    return options;
  }

  void end_contact() {
    filter_.reset();
    monitor_.release();
    placement_.end_contact();
  }

  /// The needle carries nothing in this frame.
  void leave(const Observation& o, ForceEstimate& estimate) {
    filter_.reset();
    relaxing_.rest(o.time_s);
    estimate.depth_sigma_um = 0.0;
  }

  /// The palpation against the model of this cell; anew where the model is. The model is at rest afterwards.
  void palpate() {
    palpated_ = true;
    if (const auto scale = cell_.scale_after(*palpation_)) scale_ = *scale;
  }

  void solve(const Observation& o, double depth_um, bool contact, ForceEstimate& estimate) {
    // Out of contact the shape is known.
    IndentationState state = contact ? cell_.press(depth_um) : cell_.release();
    estimate.converged = !contact || state.report.status == SolveStatus::kConverged;
    estimate.iterations = state.report.iterations;
    if (!estimate.converged) {
      estimate.reason = "the model found no equilibrium: " + std::string(to_string(state.report.status));
    }
    const Eigen::Matrix3d& R = estimate.rotation_WC;
    const auto audit = [&] {
      estimate.shape = auditor_.audit(o, cell_.indenter().positions_um(), R, estimate.center_um, cell_.thickness_um());
    };
    audit();

    // A contour that has left the model's shape at once: the membrane is through, the model at rest again.
    if (contact && estimate.converged &&
        monitor_.has_sprung_back(estimate.shape.residual_rms_um, estimate.shape.dimple_residual_um,
                                 usual_mismatch_um(estimate.shape, depth_um))) {
      contact = false;
      estimate.punctured = true;
      estimate.puncture = monitor_.take_puncture(o.time_s);
      leave(o, estimate);
      depth_um = 0.0;
      state = cell_.release();
      audit();
    }

    // The contour's weak pull, where it is asked for: its places found again about the shape it led to.
    const MembraneModel& model = cell_.model();
    for (int round = 0; contact && estimate.converged && options_.observation_ratio > 0.0 && round < kProjections;
         ++round) {
      cell_.indenter().observe(observe_revolved(model.rest(), cell_.indenter().positions_um(), auditor_,
                                                options_.observation_ratio * model.force_scale_uN_per_um()));
      state = cell_.indenter().advance_to(depth_um);
      audit();
    }
    const Eigen::Matrix3Xd& x = cell_.indenter().positions_um();

    // The shape, in the world.
    estimate.rest_um = (R * model.rest().points_um).colwise() + estimate.center_um;
    estimate.solved_um = (R * x).colwise() + estimate.center_um;
    estimate.triangles = model.rest().triangles;

    // The force with what makes it uncertain. All forces go with the cell's scale, and with what relaxation leaves.
    RelaxingContact::Force force;
    if (contact) {
      const double push_uN = scale_.ratio * std::max(0.0, state.push_force_uN);
      const double stiffness_uN_per_um = scale_.ratio * std::max(0.0, state.stiffness_uN_per_um);
      force.force_uN = push_uN;
      force.stiffness_uN_per_um = stiffness_uN_per_um;
      if (estimate.converged) force = relaxing_.advance(o.time_s, push_uN, stiffness_uN_per_um);
      const double model_uN = push_uN / scale_.ratio;
      fill_errors({profile_, cell_, placement_, scale_, depth_um, model_uN, force}, estimate);
    }
    const double scale = scale_.ratio * force.ratio;
    const ForceInterval interval = contact ? interval_95(force.force_uN, estimate.errors) : ForceInterval{};
    fill_nodes(cell_.indenter(), scale, contact, estimate);

    // The outer surface encloses what it did at rest, but for the little the liquid gives.
    estimate.volume_um3 =
        sphere_volume_um3(cell_.outer_radius_um()) * (state.volume_um3 / model.volume().rest_volume_um3());
    estimate.pressure_Pa = scale * state.pressure_Pa;

    // A model that isn't where the needle is says nothing of its force.
    if (!estimate.converged) return;
    estimate.depth_um = depth_um;
    estimate.stiffness_uN_per_um = force.stiffness_uN_per_um;
    estimate.damping_uN_s_per_um =
        contact ? force.damping_uN_s_per_um + damping_uN_s_per_um(cell_.indenter(), profile_.damping_uN_s_per_um) : 0.0;
    estimate.force_rate_uN_per_s = force.rate_uN_per_s;
    estimate.relaxed_force_uN = force.relaxed_uN;
    estimate.tip_force_uN = scale * (R * state.tip_force_uN);
    const Eigen::Vector3d across = state.tip_force_uN - state.push_force_uN * model.setup().push;
    estimate.lateral_force_uN = scale * across.norm();
    estimate.contact_force_uN = force.force_uN;
    estimate.contact_force_lower_uN = interval.lower_uN;
    estimate.contact_force_upper_uN = interval.upper_uN;
    if (palpation_) {
      estimate.puncture_probability = puncture_probability(profile_, force.force_uN, estimate.errors.relative());
    }
    if (!contact) return;
    monitor_.add(depth_um, force.force_uN);
    ask_others(o, depth_um, scale, estimate);
    estimate.work_uN_um = monitor_.work_uN_um();
    if (options_.naive_readout)
      estimate.naive_force_uN = scale * naive_force_uN(model, lay_on_contour(model.rest(), x, auditor_));
  }

  /// The other models' forces, for who analyses.
  void ask_others(const Observation& o, double depth_um, double scale, ForceEstimate& estimate) const {
    const MembraneSetup& setup = cell_.model().setup();
    const auto point_load = point_load_force_uN(profile_.young_modulus_kPa, profile_.poisson_ratio, setup.thickness_um,
                                                depth_um, o.dimple_radius_um, profile_.tip_radius_um);
    const double angle_rad = std::acos(std::clamp(setup.push.dot(setup.holder), -1.0, 1.0));
    const auto table = cell_.offset_um() == 0.0
                           ? tables_.force_uN(depth_um, angle_rad, setup.mid_radius_um / profile_.mid_radius_um)
                           : std::nullopt;
    if (point_load) estimate.opinions.point_load_uN = scale * *point_load;
    if (table) estimate.opinions.table_uN = scale * *table;
    estimate.opinions.spread_percent = spread_percent(estimate.contact_force_uN, estimate.opinions);
  }

  CellProfile profile_;
  ForceOptions options_;
  CellScale scale_;
  ForceTables tables_;
  std::optional<Palpation> palpation_;
  bool palpated_ = false;  // the palpation was held against this model
  CellModelCache cell_;
  RelaxingContact relaxing_;
  DepthFilter filter_;
  PunctureMonitor monitor_;
  ShapeAuditor auditor_;
  CellPlacement placement_;
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
void ForceObserver::set_palpation(const Palpation& palpation) {
  impl_->set_palpation(palpation);
}
std::vector<PunctureRisk> ForceObserver::puncture_risk(double step_um) {
  return impl_->puncture_risk(step_um);
}
CellScale ForceObserver::scale() const noexcept {
  return impl_->scale();
}
ForceEstimate ForceObserver::process(const Observation& observation) {
  return impl_->process(observation);
}
void ForceObserver::reset() {
  impl_->reset();
}

}  // namespace pellucida
