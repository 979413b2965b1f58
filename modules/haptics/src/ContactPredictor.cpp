#include "pellucida/haptics/ContactPredictor.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

constexpr double kMinPower = 1.0, kMaxPower = 6.0;
constexpr double kMaxGrowth = 1.5;
constexpr double kSmallForce_uN = 1e-6;
constexpr double kSmallDepth_um = 0.5;
constexpr double kSmallStiffness_uN_per_um = 0.05;

bool usable(const ContactModel& model) noexcept {
  if (!std::isfinite(model.time_s)) return false;
  if (model.state == CellState::kFree || model.state == CellState::kPunctured) return true;
  if (model.state != CellState::kContact || !model.valid) return false;
  const double push_length = model.push.eigen().norm();
  return is_finite(model.force_uN.eigen()) && push_length > 0.5 && push_length < 2.0 &&
         std::isfinite(model.stiffness_uN_per_um) && std::isfinite(model.damping_uN_s_per_um) &&
         std::isfinite(model.depth_um);
}

}  // namespace

void ContactPredictor::clear() noexcept {
  *this = ContactPredictor(settings_);
}

void ContactPredictor::see(const ContactModel& model, const TipHistory& history) noexcept {
  if (!usable(model)) {
    invalid_ = true;
    in_contact_run_ = false;
    return;
  }
  invalid_ = false;
  next_ = Frame{};
  next_.time_s = model.time_s;
  next_.index = model.frame_index;
  next_.state = model.state;
  next_.tip_um = history.at(model.time_s - settings_.tip_lag_s);
  next_.push = frame_.push;
  has_next_ = true;
  if (model.state != CellState::kContact) {
    in_contact_run_ = false;
    return;
  }
  if (!in_contact_run_) contact_since_s_ = model.time_s;
  in_contact_run_ = true;
  next_.push = model.push.eigen().normalized();
  const Eigen::Vector3d force_uN = model.force_uN.eigen();
  next_.force_uN = std::max(0.0, -force_uN.dot(next_.push));
  next_.lateral_uN = force_uN - force_uN.dot(next_.push) * next_.push;
  next_.stiffness_uN_per_um = std::max(0.0, model.stiffness_uN_per_um);
  next_.damping_uN_s_per_um = std::clamp(model.damping_uN_s_per_um, 0.0, settings_.max_damping_uN_s_per_um);
  next_.depth_um = std::max(0.0, model.depth_um);
}

double ContactPredictor::way_out_um(const Frame& frame) const noexcept {
  if (frame.state != CellState::kContact || frame.force_uN <= kSmallForce_uN) return 0.0;
  const double depth_um = std::max(frame.depth_um, kSmallDepth_um);
  const double power = frame.stiffness_uN_per_um * depth_um / frame.force_uN;
  // Without a usable stiffness or depth, a straight line over the depth.
  if (power <= kMinPower) return depth_um;
  return std::min(power, kMaxPower) * frame.force_uN / frame.stiffness_uN_per_um;
}

double ContactPredictor::elastic_uN(const Frame& frame, double way_um) const noexcept {
  if (frame.state != CellState::kContact) return 0.0;
  const double stiffness = std::min(frame.stiffness_uN_per_um, settings_.max_stiffness_uN_per_um);
  if (frame.force_uN <= kSmallForce_uN) return stiffness * std::max(0.0, way_um);
  const double length_um = way_out_um(frame);
  const double power = std::clamp(frame.stiffness_uN_per_um * length_um / frame.force_uN, kMinPower, kMaxPower);
  const auto force_at = [&](double way) {
    return frame.force_uN * std::pow(std::max(0.0, 1.0 + way / length_um), power);
  };
  if (way_um <= 0.0) return force_at(way_um);
  // Pushing on, the slope grows to half as much again, and never beyond what the device holds: straight from there.
  const double steepest = std::min(kMaxGrowth * frame.stiffness_uN_per_um, settings_.max_stiffness_uN_per_um);
  if (power <= kMinPower || steepest <= stiffness) return frame.force_uN + stiffness * way_um;
  const double bend_um = length_um * (std::pow(steepest / frame.stiffness_uN_per_um, 1.0 / (power - 1.0)) - 1.0);
  if (way_um <= bend_um) return force_at(way_um);
  return force_at(bend_um) + steepest * (way_um - bend_um);
}

double ContactPredictor::correction_part(const Eigen::Vector3d& tip_um) const noexcept {
  if (frame_.state != CellState::kContact) return 1.0;
  const double back_um = landing_way_um_ - (tip_um - frame_.tip_um).dot(frame_.push);
  return std::clamp(1.0 - back_um / fade_way_um_, 0.0, 1.0);
}

Eigen::Vector3d ContactPredictor::force_of(const Frame& frame, const Eigen::Vector3d& tip_um,
                                           const Eigen::Vector3d& velocity_um_per_s,
                                           double& elastic_uN_out) const noexcept {
  const double elastic = elastic_uN(frame, (tip_um - frame.tip_um).dot(frame.push));
  elastic_uN_out = elastic;
  if (elastic <= 0.0) return Eigen::Vector3d::Zero();
  const double viscous = std::clamp(frame.damping_uN_s_per_um * velocity_um_per_s.dot(frame.push), -elastic, elastic);
  const double lateral_part = frame.force_uN > kSmallForce_uN ? std::min(1.0, elastic / frame.force_uN) : 0.0;
  return -(elastic + viscous) * frame.push + lateral_part * frame.lateral_uN;
}

bool ContactPredictor::land(const Eigen::Vector3d& tip_um, const Eigen::Vector3d& velocity_um_per_s) noexcept {
  double old_elastic = 0.0, new_elastic = 0.0;
  const Eigen::Vector3d old_uN = force_of(frame_, tip_um, velocity_um_per_s, old_elastic);
  const Eigen::Vector3d new_uN = force_of(next_, tip_um, velocity_um_per_s, new_elastic);
  // A drop that the tip's own motion (which is in the old force) doesn't explain.
  const bool dropped = frame_.state == CellState::kContact && old_elastic >= settings_.puncture_min_uN &&
                       new_elastic <= settings_.puncture_drop_ratio * old_elastic &&
                       next_.time_s - frame_.time_s <= settings_.age_limit_s;
  const bool punctured = !released_ && (next_.state == CellState::kPunctured || dropped);
  if (punctured) {
    // The force stays as it is and fades out; this frame's own force isn't taken in.
    released_ = true;
    in_contact_run_ = next_.state == CellState::kContact;
    contact_since_s_ = next_.time_s;
    frame_.time_s = next_.time_s;
    frame_.index = next_.index;
  } else if (!released_ || gain_.value() <= 0.0) {
    // Nothing is to be kept smooth while there is no force.
    const bool rendered = !released_ && gain_.value() > 0.0;
    correction_uN_ = old_uN + correction_part(tip_um) * correction_uN_ - new_uN;
    if (!rendered) correction_uN_.setZero();
    frame_ = next_;
    // Over the way out of the contact, and so that the fading adds at most a quarter to the stiffness.
    landing_way_um_ = (tip_um - frame_.tip_um).dot(frame_.push);
    const double stiffness = std::max(frame_.stiffness_uN_per_um, kSmallStiffness_uN_per_um);
    fade_way_um_ = std::max({way_out_um(frame_) + landing_way_um_, 1.0, 4.0 * correction_uN_.norm() / stiffness});
  }
  has_next_ = false;
  return punctured;
}

void ContactPredictor::decay_correction(bool in_contact, double dt_s) noexcept {
  const double length = correction_uN_.norm();
  if (length <= 0.0) return;
  const double time_s = in_contact ? settings_.correction_time_s : settings_.free_time_s;
  double taken = length * (1.0 - std::exp(-dt_s / time_s));
  if (in_contact) taken = std::min(taken, settings_.correction_slope_uN_per_s * dt_s);
  correction_uN_ *= std::max(0.0, length - taken - 1e-9) / length;
}

void ContactPredictor::rearm(double now_s) noexcept {
  if (!released_ || gain_.value() > 0.0) return;
  const bool contact_anew = in_contact_run_ && !invalid_ && now_s - contact_since_s_ >= settings_.rearm_time_s;
  if (frame_.state == CellState::kFree || contact_anew) {
    released_ = false;
    correction_uN_.setZero();
  }
}

double ContactPredictor::fade_time_s(double now_s, double& goal, ContactState& state) const noexcept {
  goal = 0.0;
  if (released_) {
    state = ContactState::kPunctured;
    return settings_.release_time_s;
  }
  if (invalid_) {
    state = ContactState::kInvalid;
    return settings_.invalid_time_s;
  }
  if (now_s - frame_.time_s > settings_.age_limit_s) {
    state = ContactState::kStale;
    return settings_.stale_time_s;
  }
  goal = 1.0;
  state = frame_.state == CellState::kContact ? ContactState::kContact : ContactState::kFree;
  return settings_.return_time_s;
}

ContactForce ContactPredictor::update(double now_s, double dt_s, const Eigen::Vector3d& tip_um,
                                      const Eigen::Vector3d& velocity_um_per_s) noexcept {
  ContactForce result;
  if (has_next_) result.punctured_now = land(tip_um, velocity_um_per_s);
  if (frame_.index < 0 && frame_.state == CellState::kNoCell) {
    result.state = invalid_ ? ContactState::kInvalid : ContactState::kNone;
    return result;
  }
  rearm(now_s);

  double elastic = 0.0;
  Eigen::Vector3d force_uN = force_of(frame_, tip_um, velocity_um_per_s, elastic);
  decay_correction(elastic > kSmallForce_uN, dt_s);
  force_uN += correction_part(tip_um) * correction_uN_;
  // The membrane doesn't pull.
  const double along = -force_uN.dot(frame_.push);
  if (along < 0.0) force_uN += along * frame_.push;

  double goal = 0.0;
  const double time_s = fade_time_s(now_s, goal, result.state);
  const double gain = gain_.step(goal, time_s, dt_s);
  result.force_uN = gain * force_uN;
  result.along_uN = gain * std::max(0.0, along);
  result.age_s = std::max(0.0, now_s - frame_.time_s);
  result.frame_index = frame_.index;
  if (frame_.state == CellState::kContact) {
    result.depth_um = std::max(0.0, frame_.depth_um + (tip_um - frame_.tip_um).dot(frame_.push));
    result.stiffness_uN_per_um = frame_.stiffness_uN_per_um;
  }
  return result;
}

}  // namespace pellucida
