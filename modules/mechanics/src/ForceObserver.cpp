#include "pellucida/mechanics/ForceObserver.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "pellucida/mechanics/DepthFilter.h"
#include "pellucida/mechanics/Indenter.h"

namespace pellucida {
namespace {

/// Noise of the indentation when the tracker gives none: a quarter of a pixel at 0.8 um.
constexpr double kDefaultDepthSigma_um = 0.2;
/// What no filter averages out: the edge's centre line may lie a little beside the membrane, the same in every frame.
constexpr double kEdgeBias_um = 0.12;
/// A profile speaks of cells of its own size: outside this share of its radius it says nothing.
constexpr double kSmallestRatio = 0.6;
constexpr double kLargestRatio = 1.7;
/// The model is built anew when the tracked rest radius or thickness moved by more than this share.
constexpr double kRebuildRatio = 0.004;
/// How fast the holder's direction follows the tracker, per frame, and the turn that is worth following.
constexpr double kHolderFollow = 0.2;
constexpr double kHolderTurn_rad = 0.002;
/// Two-sided 95 % of a normal distribution.
constexpr double kInterval = 1.96;

/// Standard deviation of the force that the model itself may be wrong by: the largest error the profile admits to at
/// this force, as a share of it or of the peak, whichever is less, taken as two standard deviations.
double model_sigma_uN(const CellProfile& profile, double force_uN) {
  double worst_uN = 0.0;
  for (const auto& error : profile.errors) {
    worst_uN = std::max(
        worst_uN, std::min(error.largest_ratio * force_uN, error.largest_of_peak_ratio * profile.puncture_force_uN));
  }
  return 0.5 * worst_uN;
}

double sphere_volume_um3(double radius_um) {
  return 4.0 / 3.0 * std::numbers::pi * std::pow(radius_um, 3);
}

std::string whole(double value) {
  return std::to_string(std::lround(value));
}

Eigen::Vector3d in_plane(const Eigen::Vector2d& v) {
  return {v.x(), v.y(), 0.0};
}

}  // namespace

class ForceObserver::Impl {
 public:
  explicit Impl(CellProfile profile) : profile_(std::move(profile)) {}

  const CellProfile& profile() const noexcept { return profile_; }

  void reset() {
    indenter_.reset();
    filter_.reset();
    holder_W_.reset();
  }

  ForceEstimate process(const Observation& o) {
    ForceEstimate estimate;

    // Nothing to measure.
    if (o.state == CellState::kNoCell || o.state == CellState::kLost || !o.outer) {
      estimate.reason = "no cell to measure";
      filter_.reset();
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

    // Where the cell is, how thick, how it is held.
    place(o, estimate);
    prepare_model(o, estimate);

    // Contact: the filtered depth; otherwise the cell is at rest.
    double depth_um = 0.0;
    const bool contact = o.state == CellState::kContact;
    if (contact) {
      if (!o.needle || !std::isfinite(o.indentation_um)) {
        estimate.reason = "contact, but the needle was not seen";
        return estimate;
      }
      const bool has_sigma = std::isfinite(o.indentation_sigma_um) && o.indentation_sigma_um > 0.0;
      const auto filtered = filter_.update(o.time_s, std::max(0.0, o.indentation_um),
                                           has_sigma ? o.indentation_sigma_um : kDefaultDepthSigma_um);
      depth_um = filtered.depth_um;
      estimate.depth_sigma_um = std::hypot(filtered.sigma_um, kEdgeBias_um);
      // No needle goes deeper than the model can follow.
      const double deepest_um = 1.4 * indenter_->model().setup().mid_radius_um;
      if (depth_um > deepest_um) {
        estimate.reason = "the indentation is deeper than the model reaches";
        return estimate;
      }
    } else {
      filter_.reset();
      estimate.depth_sigma_um = 0.0;
    }
    solve(depth_um, contact, estimate);
    return estimate;
  }

 private:
  /// The cell frame: z towards the needle, y out of the image plane, so that the image plane is the mesh's mirror.
  void place(const Observation& o, ForceEstimate& estimate) {
    Eigen::Vector2d axis = o.needle && o.axis.allFinite() && o.axis.norm() > 0.5 ? o.axis.normalized() : last_axis_;
    last_axis_ = axis;
    const Eigen::Vector3d z = in_plane(axis);
    const Eigen::Vector3d y = Eigen::Vector3d::UnitZ();
    estimate.rotation_WC.col(0) = y.cross(z);
    estimate.rotation_WC.col(1) = y;
    estimate.rotation_WC.col(2) = z;
    estimate.center_um = in_plane(o.center_um);

    // The holder: smoothed while seen, remembered while hidden, else assumed opposite the needle.
    if (o.holder && o.holder->direction.allFinite() && o.holder->direction.norm() > 0.5) {
      const Eigen::Vector2d seen = o.holder->direction.normalized();
      const Eigen::Vector2d mixed =
          holder_W_ ? Eigen::Vector2d((1.0 - kHolderFollow) * *holder_W_ + kHolderFollow * seen) : seen;
      holder_W_ = mixed.norm() > 0.1 ? Eigen::Vector2d(mixed.normalized()) : seen;
    }
    estimate.holder_assumed = !holder_W_;
  }

  /// A model of this cell's size with the holder in place.
  void prepare_model(const Observation& o, ForceEstimate& estimate) {
    double thickness_um = o.rest_outer_radius_um - o.rest_inner_radius_um;
    estimate.thickness_assumed = !(o.rest_inner_radius_um > 0.5 * o.rest_outer_radius_um && thickness_um > 0.0);
    if (estimate.thickness_assumed) thickness_um = profile_.thickness_um;
    const double mid_radius_um = o.rest_outer_radius_um - 0.5 * thickness_um;
    const Eigen::Vector3d holder = holder_W_ ? Eigen::Vector3d(estimate.rotation_WC.transpose() * in_plane(*holder_W_))
                                             : -Eigen::Vector3d::UnitZ();

    // The thickness of the force scale is the profile's: a measured one is too coarse for it (the force goes with
    // h^1.2).
    const bool fits =
        indenter_ && std::abs(mid_radius_um / indenter_->model().setup().mid_radius_um - 1.0) < kRebuildRatio;
    if (!fits) {
      const MembraneSetup setup{mid_radius_um, profile_.thickness_um, -Eigen::Vector3d::UnitZ(), holder};
      indenter_ = std::make_unique<Indenter>(profile_, setup);
      outer_radius_um_ = mid_radius_um + 0.5 * thickness_um;
    } else if (indenter_->model().setup().holder.dot(holder) < std::cos(kHolderTurn_rad)) {
      indenter_->set_holder(holder);
    }
  }

  void solve(double depth_um, bool contact, ForceEstimate& estimate) {
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
    const Eigen::Matrix3Xd& x = indenter_->positions_um();

    // The shape, in the world.
    const Eigen::Matrix3d& R = estimate.rotation_WC;
    estimate.rest_um = (R * model.rest().points_um).colwise() + estimate.center_um;
    estimate.solved_um = (R * x).colwise() + estimate.center_um;
    estimate.triangles = model.rest().triangles;

    // Forces on the nodes; their sigma from the depth's (along the tangent), the profile's scale and the model's own
    // error.
    const double depth_sigma_um = estimate.depth_sigma_um;
    const double push_uN = std::max(0.0, state.push_force_uN);
    const double profile_sigma_uN =
        std::hypot(profile_.force_scale_relative_sigma * push_uN, model_sigma_uN(profile_, push_uN));
    const double relative_sigma = push_uN > 0.0 ? profile_sigma_uN / push_uN : 0.0;
    const Eigen::Matrix3Xd force = model.elastic_force_uN(x);
    estimate.force_uN = R * force;
    estimate.force_sigma_uN = relative_sigma * force.colwise().norm().transpose();
    if (contact && depth_sigma_um > 0.0) {
      constexpr double kProbe_um = 1e-3;
      const Eigen::Matrix3Xd moved = model.elastic_force_uN(x + kProbe_um * indenter_->depth_tangent());
      const Eigen::VectorXd by_depth = ((moved - force) * (depth_sigma_um / kProbe_um)).colwise().norm().transpose();
      estimate.force_sigma_uN = (estimate.force_sigma_uN.array().square() + by_depth.array().square()).sqrt().matrix();
    }
    estimate.tension_uN_per_um = model.springs().tension_uN_per_um(x, node_areas_um2(x, model.rest().triangles));

    // The outer surface encloses what it did at rest, but for the little the liquid gives.
    estimate.volume_um3 = sphere_volume_um3(outer_radius_um_) * (state.volume_um3 / model.volume().rest_volume_um3());
    estimate.pressure_Pa = state.pressure_Pa;

    // A model that isn't where the needle is says nothing of its force.
    if (!estimate.converged) return;
    estimate.depth_um = depth_um;
    estimate.stiffness_uN_per_um = contact ? std::max(0.0, state.stiffness_uN_per_um) : 0.0;
    estimate.tip_force_uN = R * state.tip_force_uN;
    estimate.contact_force_uN = push_uN;
    const double sigma_uN = contact ? std::hypot(estimate.stiffness_uN_per_um * depth_sigma_um, profile_sigma_uN) : 0.0;
    estimate.contact_force_lower_uN = std::max(0.0, estimate.contact_force_uN - kInterval * sigma_uN);
    estimate.contact_force_upper_uN = estimate.contact_force_uN + kInterval * sigma_uN;
  }

  CellProfile profile_;
  std::unique_ptr<Indenter> indenter_;
  bool start_anew_ = false;
  DepthFilter filter_;
  double outer_radius_um_ = 0.0;
  std::optional<Eigen::Vector2d> holder_W_;
  Eigen::Vector2d last_axis_ = Eigen::Vector2d::UnitX();
};

ForceObserver::ForceObserver(CellProfile profile) : impl_(std::make_unique<Impl>(std::move(profile))) {}
ForceObserver::~ForceObserver() = default;
ForceObserver::ForceObserver(ForceObserver&&) noexcept = default;
ForceObserver& ForceObserver::operator=(ForceObserver&&) noexcept = default;

const CellProfile& ForceObserver::profile() const noexcept {
  return impl_->profile();
}
ForceEstimate ForceObserver::process(const Observation& observation) {
  return impl_->process(observation);
}
void ForceObserver::reset() {
  impl_->reset();
}

}  // namespace pellucida
