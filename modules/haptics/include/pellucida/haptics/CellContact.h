#pragma once
#include <Eigen/Core>
#include <limits>

#include "pellucida/haptics/CellGuards.h"
#include "pellucida/haptics/ContactPredictor.h"
#include "pellucida/haptics/TipHistory.h"

namespace pellucida {

/// What a hand knows of cell and camera: the contact as of the newest frame, carried on to every tick; how long ago
/// that frame came; when the membrane gave way. It belongs to the cell, not to the hand: the next hand begins with it
/// (`for_next_hand`), so that what protects a cell outlives a change of device or motion scale.
///
/// The 1 kHz thread only. Nothing allocates, locks or throws.
class CellContact {
 public:
  explicit CellContact(const PredictorSettings& settings = {}) noexcept : predictor_(settings) {}

  /// The same knowledge for a hand that feels nothing yet: the force fades in from zero. Call with no thread in the
  /// tick of the hand before.
  CellContact for_next_hand(const PredictorSettings& settings) const noexcept;

  void set(const PredictorSettings& settings) noexcept { predictor_.set(settings); }

  /// A newer frame.
  void see(const ContactModel& model) noexcept;

  /// The pipette was out of our hands and is at `tip_um`: the newest frame's place moves with it, the force stays.
  void place(double now_s, const Eigen::Vector3d& tip_um) noexcept;

  /// The contact in this tick: `pipette_um`, where the pipette was commanded to be; `hand_um`, where the hand has the
  /// tip; `max_stiffness_uN_per_um`, what the device can render (infinite: it renders no contact).
  const ContactForce& update(double now_s, double dt_s, const Eigen::Vector3d& pipette_um, const GuardOutput& hand,
                             double max_stiffness_uN_per_um) noexcept;

  /// As of the last `update`.
  const ContactForce& force() const noexcept { return force_; }
  /// The way the needle pushes; zero: no frame has shown it.
  const Eigen::Vector3d& push() const noexcept { return push_; }
  bool in_contact() const noexcept { return force_.state == ContactState::kContact && push_.squaredNorm() > 0.0; }

  /// The contact has been unknown for too long: no deeper.
  bool is_blind(const CellLimits& limits) const noexcept;
  /// The membrane has just given way: no deeper either.
  bool is_just_punctured(const CellLimits& limits, double now_s) const noexcept {
    return now_s - punctured_s_ < limits.puncture_hold_s;
  }

 private:
  ContactPredictor predictor_;
  TipHistory history_;
  Eigen::Vector3d tip_um_ = Eigen::Vector3d::Zero();  ///< the newest place in the history
  Eigen::Vector3d push_ = Eigen::Vector3d::Zero();
  ContactForce force_;
  double punctured_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace pellucida
