#include "pellucida/mechanics/ForceObserver.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "pellucida/core/Error.h"
#include "pellucida/mechanics/CellPlacement.h"
#include "pellucida/mechanics/DepthFilter.h"
#include "pellucida/mechanics/Indenter.h"
#include "pellucida/mechanics/RevolvedContour.h"

namespace pellucida {
namespace {

/// Noise of the indentation when the tracker gives none: a quarter of a pixel at 0.8 um.
constexpr double kDefaultDepthSigma_um = 0.2;
/// And of the tip along the needle.
constexpr double kDefaultTipSigma_um = 0.4;
/// How deep the risk of puncture is told, in puncture indentations.
constexpr double kRiskDepth_ratio = 1.3;
/// A stiffness' slope by depth is taken over this.
constexpr double kSlopeStep_um = 0.5;
/// Rounds of finding the contour's nearest places again.
constexpr int kProjections = 3;
/// What no filter averages out: the edge's centre line may lie a little beside the membrane, the same in every frame.
constexpr double kEdgeBias_um = 0.12;
/// A profile speaks of cells of its own size: outside this share of its radius it says nothing.
constexpr double kSmallestRatio = 0.6;
constexpr double kLargestRatio = 1.7;
/// The model is built anew when the tracked rest radius or thickness moved by more than this share.
constexpr double kRebuildRatio = 0.004;
/// The turn of the holder, and the change of the needle's offset, that are worth following.
constexpr double kHolderTurn_rad = 0.002;
constexpr double kOffsetStep_um = 0.75;
/// A needle whose line moved by more than this since the contact began has slipped.
constexpr double kSlip_um = 4.0;
/// A resting radius is known to this, um, by a tracker; the force goes with its power -1.9 (method, finite elements).
constexpr double kRadiusSigma_um = 0.2;
constexpr double kRadiusPower = 1.9;
/// What a contour may differ from the model by, um, beside its noise: at rest, and more for each um of depth (the
/// virtual microscope's cells; see the module's README).
constexpr double kUsualMismatch_um = 0.2;
constexpr double kUsualMismatch_ratio = 0.02;
/// Beyond so many times what is usual the shape isn't the model's.
constexpr double kMismatch = 2.5;
/// Half of the spread of the force between needle opposite the holder and beside it, where no holder was seen.
constexpr double kUnknownHolder_ratio = 0.3;

double usual_mismatch_um(const ShapeAudit& shape, double depth_um) {
  return std::hypot(shape.noise_um, kUsualMismatch_um + kUsualMismatch_ratio * depth_um);
}

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
      : profile_(std::move(profile)), options_(options), tables_(profile_.name) {
    if (!(options_.observation_ratio >= 0.0)) throw UsageError("weight of the contour: it must be 0 or above");
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
    std::vector<PunctureRisk> risk;
    if (!indenter_) return risk;
    indenter_->reset();
    for (int k = 1; k * step_um <= kRiskDepth_ratio * profile_.puncture_indentation_um; ++k) {
      const IndentationState state = indenter_->advance_to(k * step_um);
      if (state.report.status != SolveStatus::kConverged) break;
      ForceErrors errors;
      add_model_errors(profile_, state.push_force_uN, rest_stiffness_uN_per_um_, errors);
      const double force_uN = scale_.ratio * state.push_force_uN;
      const double relative = std::hypot(errors.model_ratio, scale_.relative_sigma);
      risk.push_back({k * step_um, force_uN, puncture_probability(profile_, force_uN, relative)});
    }
    indenter_->reset();
    return risk;
  }

  void reset() {
    indenter_.reset();
    placement_.reset();
    end_contact();
  }

  ForceEstimate process(const Observation& o) {
    ForceEstimate estimate;
    estimate.time_s = o.time_s;
    estimate.frame_index = o.frame_index;

    // Nothing to measure.
    if (o.state == CellState::kNoCell || o.state == CellState::kLost || !o.outer) {
      estimate.reason = "no cell to measure";
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
    prepare_model(o, estimate);
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
        if (depth_um > 1.4 * indenter_->model().setup().mid_radius_um) {
          estimate.reason = "the indentation is deeper than the model reaches";
          return estimate;
        }
      }
    }
    estimate.punctured |= o.state == CellState::kPunctured;
    if (estimate.punctured) estimate.puncture = monitor_.take_puncture(o.time_s);
    estimate.work_uN_um = monitor_.work_uN_um();
    if (o.state == CellState::kFree) end_contact();
    if (!contact) {
      filter_.reset();
      estimate.depth_sigma_um = 0.0;
    }
    solve(o, depth_um, contact, estimate);
    return estimate;
  }

 private:
  void end_contact() {
    filter_.reset();
    monitor_.release();
    placement_.end_contact();
  }

  /// A model of this cell's size with needle and holder in place.
  void prepare_model(const Observation& o, ForceEstimate& estimate) {
    double thickness_um = o.rest_outer_radius_um - o.rest_inner_radius_um;
    estimate.thickness_assumed = !(o.rest_inner_radius_um > 0.5 * o.rest_outer_radius_um && thickness_um > 0.0);
    if (estimate.thickness_assumed) thickness_um = profile_.thickness_um;
    thickness_um_ = thickness_um;
    const double mid_radius_um = o.rest_outer_radius_um - 0.5 * thickness_um;

    // The thickness of the force scale is the profile's: a measured one is too coarse for it (the force goes with
    // h^1.2).
    const bool fits = indenter_ &&
                      std::abs(mid_radius_um / indenter_->model().setup().mid_radius_um - 1.0) < kRebuildRatio &&
                      std::abs(placement_.offset_um() - model_offset_um_) < kOffsetStep_um;
    if (!fits) {
      const MembraneSetup setup{mid_radius_um, profile_.thickness_um, placement_.push(), placement_.holder()};
      indenter_ = std::make_unique<Indenter>(profile_, setup);
      auditor_.set_model(indenter_->model().rest());
      rest_stiffness_uN_per_um_ = indenter_->advance_to(0.0).stiffness_uN_per_um;
      model_offset_um_ = placement_.offset_um();
      palpated_ = false;
      outer_radius_um_ = mid_radius_um + 0.5 * thickness_um;
    } else if (indenter_->model().setup().holder.dot(placement_.holder()) < std::cos(kHolderTurn_rad)) {
      indenter_->set_holder(placement_.holder());
    }
  }

  /// The palpation against the model of this cell; anew where the model is. The model is at rest afterwards.
  void palpate() {
    palpated_ = true;
    const double deepest_um = 1.4 * indenter_->model().setup().mid_radius_um;
    const double depth_um = std::min(palpation_->indentation_um, deepest_um);
    const bool by_force = palpation_->known_force_uN > 0.0;
    indenter_->reset();
    const IndentationState before = indenter_->advance_to(std::max(0.0, depth_um - kSlopeStep_um));
    const IndentationState at = indenter_->advance_to(depth_um);
    indenter_->reset();
    if (at.report.status != SolveStatus::kConverged || !(at.push_force_uN > 0.0)) return;
    ForceErrors model;
    add_model_errors(profile_, at.push_force_uN, rest_stiffness_uN_per_um_, model);
    const double relative = std::hypot(model.model_ratio, model.model_uN / at.push_force_uN);
    const double value = by_force ? at.push_force_uN : at.stiffness_uN_per_um;
    const double slope =
        by_force ? at.stiffness_uN_per_um : (at.stiffness_uN_per_um - before.stiffness_uN_per_um) / kSlopeStep_um;
    scale_ = update_scale(scale_before(profile_), *palpation_, value, slope, relative);
  }

  void solve(const Observation& o, double depth_um, bool contact, ForceEstimate& estimate) {
    // Out of contact the shape is known.
    IndentationState state;
    if (contact) {
      // After a failure start from rest, not from a shape that leads nowhere.
      if (start_anew_) indenter_->reset();
      state = indenter_->advance_to(depth_um);
      start_anew_ = state.report.status != SolveStatus::kConverged;
      estimate.converged = state.report.status == SolveStatus::kConverged;
      estimate.iterations = state.report.iterations;
      if (!estimate.converged) {
        estimate.reason = "the model found no equilibrium: " + std::string(to_string(state.report.status));
      }
    } else {
      indenter_->reset();
      estimate.converged = true;
      state.volume_um3 = indenter_->model().volume().rest_volume_um3();
    }
    const MembraneModel& model = indenter_->model();
    const Eigen::Matrix3d& R = estimate.rotation_WC;
    const auto audit = [&] {
      estimate.shape = auditor_.audit(o, indenter_->positions_um(), R, estimate.center_um, thickness_um_);
    };
    audit();

    // A contour that has left the model's shape at once: the membrane is through, the model at rest again.
    if (contact && estimate.converged &&
        monitor_.has_sprung_back(estimate.shape.residual_rms_um, estimate.shape.dimple_residual_um,
                                 usual_mismatch_um(estimate.shape, depth_um))) {
      contact = false;
      estimate.punctured = true;
      estimate.puncture = monitor_.take_puncture(o.time_s);
      filter_.reset();
      estimate.depth_sigma_um = depth_um = 0.0;
      indenter_->reset();
      state = IndentationState{};
      state.volume_um3 = model.volume().rest_volume_um3();
      audit();
    }

    // The contour's weak pull, where it is asked for: its places found again about the shape it led to.
    for (int round = 0; contact && estimate.converged && options_.observation_ratio > 0.0 && round < kProjections;
         ++round) {
      indenter_->observe(observe_revolved(model.rest(), indenter_->positions_um(), auditor_,
                                          options_.observation_ratio * model.force_scale_uN_per_um()));
      state = indenter_->advance_to(depth_um);
      audit();
    }
    const Eigen::Matrix3Xd& x = indenter_->positions_um();

    // The shape, in the world.
    estimate.rest_um = (R * model.rest().points_um).colwise() + estimate.center_um;
    estimate.solved_um = (R * x).colwise() + estimate.center_um;
    estimate.triangles = model.rest().triangles;

    // The force with what makes it uncertain. All forces go with the cell's scale.
    const double scale = scale_.ratio;
    const double push_uN = scale * std::max(0.0, state.push_force_uN);
    const double stiffness_uN_per_um = contact ? scale * std::max(0.0, state.stiffness_uN_per_um) : 0.0;
    if (contact) fill_errors(push_uN, stiffness_uN_per_um, depth_um, estimate);
    const ForceInterval interval = contact ? interval_95(push_uN, estimate.errors) : ForceInterval{};
    fill_nodes(model, x, contact, estimate);

    // The outer surface encloses what it did at rest, but for the little the liquid gives.
    estimate.volume_um3 = sphere_volume_um3(outer_radius_um_) * (state.volume_um3 / model.volume().rest_volume_um3());
    estimate.pressure_Pa = scale * state.pressure_Pa;

    // A model that isn't where the needle is says nothing of its force.
    if (!estimate.converged) return;
    estimate.depth_um = depth_um;
    estimate.stiffness_uN_per_um = stiffness_uN_per_um;
    estimate.damping_uN_s_per_um = contact ? damping(model, x) : 0.0;
    estimate.tip_force_uN = scale * (R * state.tip_force_uN);
    const Eigen::Vector3d across = state.tip_force_uN - state.push_force_uN * model.setup().push;
    estimate.lateral_force_uN = scale * across.norm();
    estimate.contact_force_uN = push_uN;
    estimate.contact_force_lower_uN = interval.lower_uN;
    estimate.contact_force_upper_uN = interval.upper_uN;
    if (palpation_) estimate.puncture_probability = puncture_probability(profile_, push_uN, estimate.errors.relative());
    if (!contact) return;
    monitor_.add(depth_um, push_uN);
    ask_others(o, depth_um, estimate);
    estimate.work_uN_um = monitor_.work_uN_um();
    if (options_.naive_readout)
      estimate.naive_force_uN = scale * naive_force_uN(model, lay_on_contour(model.rest(), x, auditor_));
  }

  /// The other models' forces, for who analyses.
  void ask_others(const Observation& o, double depth_um, ForceEstimate& estimate) const {
    const MembraneSetup& setup = indenter_->model().setup();
    const auto point_load = point_load_force_uN(profile_.young_modulus_kPa, profile_.poisson_ratio, setup.thickness_um,
                                                depth_um, o.dimple_radius_um, profile_.tip_radius_um);
    const double angle_rad = std::acos(std::clamp(setup.push.dot(setup.holder), -1.0, 1.0));
    const auto table = model_offset_um_ == 0.0
                           ? tables_.force_uN(depth_um, angle_rad, setup.mid_radius_um / profile_.mid_radius_um)
                           : std::nullopt;
    if (point_load) estimate.opinions.point_load_uN = scale_.ratio * *point_load;
    if (table) estimate.opinions.table_uN = scale_.ratio * *table;
    estimate.opinions.spread_percent = spread_percent(estimate.contact_force_uN, estimate.opinions);
  }

  /// What the interval is made of, and what is worth a warning.
  void fill_errors(double push_uN, double stiffness_uN_per_um, double depth_um, ForceEstimate& estimate) const {
    ForceErrors& errors = estimate.errors;
    errors.depth_uN = stiffness_uN_per_um * estimate.depth_sigma_um;
    errors.scale_ratio = scale_.relative_sigma;
    const double radius_sigma_um = std::hypot(kRadiusSigma_um, estimate.thickness_assumed ? 0.25 * thickness_um_ : 0.0);
    errors.geometry_ratio = std::hypot(kRadiusPower * radius_sigma_um / indenter_->model().setup().mid_radius_um,
                                       estimate.holder_assumed ? kUnknownHolder_ratio : 0.0);
    add_model_errors(profile_, push_uN / scale_.ratio, rest_stiffness_uN_per_um_, errors);
    errors.model_uN *= scale_.ratio;

    // The contour beside the model: beyond what is usual it counts as a depth that isn't known.
    const ShapeAudit& shape = estimate.shape;
    unsigned warnings = kNoForceWarning;
    if (std::isfinite(shape.residual_rms_um)) {
      const double usual_um = usual_mismatch_um(shape, depth_um);
      const double beyond_um = std::max(0.0, shape.residual_rms_um - usual_um);
      errors.shape_uN = stiffness_uN_per_um * beyond_um;
      if (shape.residual_rms_um > kMismatch * usual_um) warnings |= kShapeMismatch;
      estimate.asymmetry_force_uN = stiffness_uN_per_um * shape.unexplained_asymmetry_um;
      if (shape.unexplained_asymmetry_um > kMismatch * usual_um) warnings |= kNotOfRevolution;
    }
    if (std::abs(placement_.slipped_um()) > kSlip_um) warnings |= kNeedleSlip;
    estimate.warnings = static_cast<ForceWarning>(warnings);
  }

  /// Forces on the nodes; their sigma from the depth's (along the tangent), and the relative errors.
  void fill_nodes(const MembraneModel& model, const Eigen::Matrix3Xd& x, bool contact, ForceEstimate& estimate) const {
    const Eigen::Matrix3Xd force = scale_.ratio * model.elastic_force_uN(x);
    estimate.force_uN = estimate.rotation_WC * force;
    const double relative = estimate.errors.relative();
    estimate.force_sigma_uN = relative * force.colwise().norm().transpose();
    if (contact && estimate.depth_sigma_um > 0.0) {
      constexpr double kProbe_um = 1e-3;
      const Eigen::Matrix3Xd moved = scale_.ratio * model.elastic_force_uN(x + kProbe_um * indenter_->depth_tangent());
      const Eigen::VectorXd by_depth =
          ((moved - force) * (estimate.depth_sigma_um / kProbe_um)).colwise().norm().transpose();
      estimate.force_sigma_uN = (estimate.force_sigma_uN.array().square() + by_depth.array().square()).sqrt().matrix();
    }
    estimate.tension_uN_per_um =
        scale_.ratio * model.springs().tension_uN_per_um(x, node_areas_um2(x, model.rest().triangles));
  }

  /// Of the dampers of eq. (1), felt by a needle that moves along the push: what they dissipate at 1 um/s.
  double damping(const MembraneModel& model, const Eigen::Matrix3Xd& x) const {
    Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, x.cols());
    const Eigen::Matrix3Xd& velocity = indenter_->depth_tangent();
    model.springs().add_damping(x, velocity, profile_.damping_uN_s_per_um, force);
    return -(force.array() * velocity.array()).sum();
  }

  CellProfile profile_;
  ForceOptions options_;
  CellScale scale_;
  ForceTables tables_;
  std::optional<Palpation> palpation_;
  bool palpated_ = false;  // the palpation was held against this model
  std::unique_ptr<Indenter> indenter_;
  bool start_anew_ = false;
  double rest_stiffness_uN_per_um_ = 0.0;
  DepthFilter filter_;
  PunctureMonitor monitor_;
  ShapeAuditor auditor_;
  double outer_radius_um_ = 0.0, thickness_um_ = 0.0;
  CellPlacement placement_;
  double model_offset_um_ = 0.0;
};

std::string to_string(ForceWarning warnings) {
  std::string text;
  const auto add = [&](ForceWarning one, const char* name) {
    if (!(warnings & one)) return;
    text += text.empty() ? "" : "+";
    text += name;
  };
  add(kShapeMismatch, "mismatch");
  add(kNeedleSlip, "slip");
  add(kNotOfRevolution, "asymmetry");
  return text;
}

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
