#pragma once
#include <Eigen/Core>
#include <limits>

#include "pellucida/core/ContactModel.h"
#include "pellucida/haptics/ForceGuards.h"
#include "pellucida/haptics/HapticRecord.h"
#include "pellucida/haptics/TipHistory.h"

namespace pellucida {

/// How the force between two frames is computed. Trivially copyable.
struct PredictorSettings {
  double age_limit_s = 0.1;       ///< a frame older than this is not used
  double stale_time_s = 0.05;     ///< time in which the force then fades to zero
  double invalid_time_s = 0.06;   ///< the same after frames without usable numbers
  double release_time_s = 0.005;  ///< the same after a puncture
  double return_time_s = 0.1;     ///< time in which the force returns after any of these

  double correction_time_s = 0.03;           ///< time constant with which a frame's correction is absorbed
  double correction_slope_uN_per_s = 250.0;  ///< and the fastest it may be
  double free_time_s = 0.008;                ///< time constant of the remaining force when a frame shows no contact
  double tip_lag_s = 0.0;  ///< the tip in a frame is the one commanded this long before the frame's arrival
  double max_stiffness_uN_per_um = std::numeric_limits<double>::infinity();  ///< of the step from frame to frame
  double max_damping_uN_s_per_um = std::numeric_limits<double>::infinity();

  double puncture_drop_ratio = 0.4;  ///< a frame with less than this share of the expected force is a puncture
  double puncture_min_uN = 1.0;      ///< if at least this was expected
  double rearm_time_s = 0.3;         ///< contact reported for this long after a puncture is a new contact
};

/// The contact force of one tick. Frame W.
struct ContactForce {
  Eigen::Vector3d force_uN = Eigen::Vector3d::Zero();  ///< of the cell on the needle; never along the push
  double along_uN = 0.0;                               ///< its component against the push, >= 0
  double depth_um = 0.0;                               ///< extrapolated indentation, >= 0
  double stiffness_uN_per_um = 0.0;                    ///< tangent along the push as of the newest frame
  double age_s = 0.0;                                  ///< age of the frame used; 0 without one
  long frame_index = -1;
  ContactState state = ContactState::kNone;
  bool punctured_now = false;  ///< the membrane gave way in this tick
};

/// The force on the needle at 1 kHz, from the newest frame.
///
/// With F0, k, b the frame's force, tangent stiffness and damping along the push n, and d the distance the tip moved
/// along n since that frame,
///     F(d) = F0 max(0, 1 + d/L)^m,   m = k w / F0 within 1..6, L = m F0 / k,
/// with depth w: the tangent and, for a force that grows with a power of depth, the whole retraction are right, and the
/// force is zero at and beyond the place where contact began. Damping b v adds at most as much again, never below zero.
///
/// When a frame arrives, its difference from the force being felt becomes a correction e, so that nothing steps; e
/// decays with a bounded slope, and fades as the tip draws back out of the contact. No frame for `age_limit_s`, frames
/// without numbers, a puncture (reported by the frame, or seen as a drop of the force that the tip's motion does not
/// explain) fade the force out.
///
/// The 1 kHz thread only. Nothing allocates, locks or throws.
class ContactPredictor {
 public:
  explicit ContactPredictor(const PredictorSettings& settings = {}) noexcept : settings_(settings) {}
  void set(const PredictorSettings& settings) noexcept { settings_ = settings; }

  /// The largest stiffness the device can render from frame to frame; in force until the next `set`.
  void limit_stiffness(double max_stiffness_uN_per_um) noexcept {
    settings_.max_stiffness_uN_per_um = max_stiffness_uN_per_um;
  }

  /// Forgets everything: as before the first frame.
  void clear() noexcept;

  /// Keeps what the frames said and drops the force: it fades in from zero.
  void fade_in() noexcept {
    gain_.set(0.0);
    correction_uN_.setZero();
  }

  /// Shifts the tip's coordinates by this much (a recalibrated manipulator): the force stays.
  void shift(const Eigen::Vector3d& way_um) noexcept {
    frame_.tip_um += way_um;
    next_.tip_um += way_um;
  }

  /// Takes a newer frame; `history` holds the tip as commanded. Used from the next `update` on.
  void see(const ContactModel& model, const TipHistory& history) noexcept;

  /// The force now, with the tip at `tip_um` (where the hand has it, which may be ahead of what was commanded), moving
  /// with `velocity_um_per_s`; `dt_s` since the last call.
  ContactForce update(double now_s, double dt_s, const Eigen::Vector3d& tip_um,
                      const Eigen::Vector3d& velocity_um_per_s) noexcept;

 private:
  // A prepared frame: only numbers that were checked.
  struct Frame {
    double time_s = 0.0;
    long index = -1;
    CellState state = CellState::kNoCell;
    Eigen::Vector3d tip_um = Eigen::Vector3d::Zero();  ///< commanded tip at the frame's time
    Eigen::Vector3d push = Eigen::Vector3d::UnitX();
    Eigen::Vector3d lateral_uN = Eigen::Vector3d::Zero();
    double force_uN = 0.0;  ///< against the push, >= 0
    double stiffness_uN_per_um = 0.0;
    double damping_uN_s_per_um = 0.0;
    double depth_um = 0.0;
  };

  double elastic_uN(const Frame& frame, double way_um) const noexcept;
  double way_out_um(const Frame& frame) const noexcept;
  double correction_part(const Eigen::Vector3d& tip_um) const noexcept;
  Eigen::Vector3d force_of(const Frame& frame, const Eigen::Vector3d& tip_um, const Eigen::Vector3d& velocity_um_per_s,
                           double& elastic_uN_out) const noexcept;
  bool land(const Eigen::Vector3d& tip_um, const Eigen::Vector3d& velocity_um_per_s) noexcept;
  void decay_correction(bool in_contact, double dt_s) noexcept;
  void rearm(double now_s) noexcept;
  double fade_time_s(double now_s, double& goal, ContactState& state) const noexcept;

  PredictorSettings settings_;
  Frame frame_;  ///< in use
  Frame next_;   ///< waits for the next update
  bool has_next_ = false;
  bool invalid_ = false;          ///< the newest frame gave no usable numbers
  bool released_ = false;         ///< punctured, and not in contact again
  double contact_since_s_ = 0.0;  ///< time of the first frame of the present run of frames in contact
  bool in_contact_run_ = false;
  Eigen::Vector3d correction_uN_ = Eigen::Vector3d::Zero();
  double landing_way_um_ = 0.0;  ///< along the push since the frame's time, when it landed
  double fade_way_um_ = 1.0;     ///< way back from there over which the correction fades
  Ramp gain_;
};

}  // namespace pellucida
