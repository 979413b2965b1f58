#pragma once
#include <array>
#include <cstdint>
#include <type_traits>

#include "pellucida/core/PlainVector.h"

namespace pellucida {

/// What the operator sees and feels.
enum class Modality {
  kFlatImage,        ///< the microscope's image: depth only from blur
  kSpace,            ///< a view in three dimensions beside it
  kSpaceAndHaptics,  ///< and the force on the hand
  kSpaceAndFixture   ///< and a rectilinear guide, which the hand feels as any force
};

/// The operator's goals, as positions. Frame W, um.
struct OperatorPlan {
  PlainVector3 approach_um;     ///< before the cell, on the line of entry: reached fast, and exactly
  PlainVector3 entry_um;        ///< where the line meets the membrane
  PlainVector3 target_um;       ///< where to deposit
  PlainVector3 removal_um;      ///< where the tip should be in the end
  double inject_s = 1.0;        ///< how long the deposit button is held
  double scale_um_per_m = 1e4;  ///< tip motion for hand motion, as the operator has learnt it: position control
  double insertion_speed_um_per_s = 40.0;  ///< from the approach point to the target
  double deepest_push_um = 75.0;           ///< past the entry point: beyond it the membrane is taken as broken
  /// 0..0.5: how far the tip in a picture lags the hand (filter, manipulator, camera), as the operator has learnt it:
  /// commands given within it are still under way, and are not repeated. Miall and others, J. Motor Behav. 25 (1993).
  double lag_s = 0.0;
};

/// The numbers of a simulated operator; defaults are those of a practised person. The sources given support their order
/// of magnitude: people differ.
struct OperatorOptions {
  Modality modality = Modality::kSpace;
  double visual_delay_s = 0.20;  ///< Keele and Posner, J. Exp. Psychol. 77 (1968): 190 to 260 ms
  double haptic_delay_s = 0.12;  ///< Chernikoff and Taylor, J. Exp. Psychol. 43 (1952): 112 to 129 ms
  double tremor_rms_m = 100e-6;  ///< 50e-6..200e-6, length of the vector; Elble, Handb. Clin. Neurophysiol. 1 (2003)
  double tremor_Hz = 10.0;       ///< 8..12
  /// Standard deviation of a position as seen, um at the specimen: in the image plane, and along its depth with a flat
  /// image and with a view in three dimensions.
  double lateral_noise_um = 1.0, flat_depth_noise_um = 8.0, space_depth_noise_um = 2.5;
  double noise_memory = 0.6;        ///< 0..1: share of a visual error that persists at the next glance
  double motor_noise_ratio = 0.05;  ///< of a submovement's length; Meyer et al., Psychol. Rev. 95 (1988)
  double look_interval_s = 0.25;    ///< between two decisions
  double tolerance_um = 3.0;        ///< seen error at which a point counts as reached; visual noise is added
  double fitts_offset_s = 0.15, fitts_slope_s = 0.12;  ///< time of an aimed move: offset + slope log2(1 + A / 3 um)
  double drop_ratio = 0.5;    ///< a felt force below this share of its peak means that the membrane gave way
  double just_felt_N = 0.05;  ///< smallest peak that is felt
  /// A felt resistance F lowers the planned speed of insertion to v / (1 + F / slowing_N); 0: it does not. People push
  /// more slowly and softly when they feel the resistance, as observed by Ammi and others in cell injection (section IV
  /// of the paper this project follows) and Wagner and others, Presence 16 (2007), in dissection; the amount is
  /// assumed.
  double slowing_N = 0.4;
};

/// The operator's activity.
enum class OperatorPhase : std::uint8_t { kLook, kApproach, kInsert, kDeposit, kRemove, kDone };
const char* to_string(OperatorPhase phase) noexcept;

/// What the operator is shown at one moment: once per image, on the run's clock. Trivially copyable.
struct OperatorView {
  double time_s = -1.0;
  PlainVector3 tip_um;  ///< the tip in the image; frame W
  bool tip_seen = false;
  bool membrane_closed = false;  ///< the image shows the membrane broken and closed around the shaft
};
static_assert(std::is_trivially_copyable_v<OperatorView>);

/// Where the operator wants the hand. Frame H.
struct OperatorIntent {
  PlainVector3 position_m;  ///< the hand's equilibrium, from where it was at the start
  PlainVector3 velocity_m_per_s;
  bool inject = false;
};

/// A simulated operator at the workstation, as a servo that looks from time to time and aims with minimum-jerk moves
///
///     x(t) = A (10 u^3 - 15 u^4 + 6 u^5),  u = t/D        Flash and Hogan, J. Neurosci. 5 (1985)
///
/// that overlap (Flash and Henis, J. Cogn. Neurosci. 3 (1991)); each glance plans one submovement from the position
/// seen a reaction time ago, plus the motion commanded since, to the goal. Vision has noise by modality, motion has
/// noise by its length. From the approach point the hand moves along the line of entry at a steady speed, whatever the
/// tip meets, slower against a felt resistance, until a felt drop of the force or an image of the closed membrane ends
/// the push; then it aims at the target, deposits, and goes to the point of removal. Only the part of the force against
/// the line of entry counts: a guide pushes from the side. Seeded and deterministic; `tick` runs at fixed steps of 1 ms
/// and neither allocates nor throws.
class OperatorModel {
 public:
  static constexpr double kStep_s = 1e-3;

  /// Throws UsageError when an option or the plan's scale is out of range.
  OperatorModel(const OperatorOptions& options, const OperatorPlan& plan, std::uint64_t seed);

  /// Takes an image; the newest counts once it is `visual_delay_s` old. Times rise.
  void see(const OperatorView& view) noexcept;
  /// The next millisecond, with the force the hand feels now, N.
  const OperatorIntent& tick(const PlainVector3& force_N) noexcept;

  OperatorPhase phase() const noexcept { return phase_; }
  bool done() const noexcept { return phase_ == OperatorPhase::kDone; }
  double time_s() const noexcept { return static_cast<double>(tick_) * kStep_s; }
  /// When the operator noticed that the membrane had given way; below 0: not yet.
  double noticed_puncture_s() const noexcept { return noticed_s_; }
  int submovement_count() const noexcept { return submovement_count_; }

  /// Tremor of this tick, frame H, m, added by the muscles to the equilibrium. RMS of the vector as in the options.
  const PlainVector3& tremor_m() const noexcept { return tremor_m_; }

 private:
  struct Submovement {
    double start_s = 0.0, duration_s = 0.0;
    PlainVector3 way_m;
  };
  struct Seen {
    OperatorView view;
    PlainVector3 intended_m;  ///< the equilibrium that it shows the outcome of
  };

  double normal() noexcept;
  PlainVector3 normals() noexcept;
  void shake() noexcept;
  void feel(const PlainVector3& force_N) noexcept;
  bool newest_seen(Seen& seen) const noexcept;
  void notice(const Seen& seen) noexcept;
  void decide(const Seen& seen) noexcept;
  void aim(const PlainVector3& way_um, double least_duration_s) noexcept;
  void halt() noexcept;
  void enter(OperatorPhase phase) noexcept;
  PlainVector3 goal_um() const noexcept;

  OperatorOptions options_;
  OperatorPlan plan_;
  bool haptics_;
  double depth_noise_um_;
  std::array<std::uint64_t, 4> random_{};
  bool spare_known_ = false;
  double spare_ = 0.0;

  long tick_ = 0;
  OperatorPhase phase_ = OperatorPhase::kLook;
  double next_look_s_ = 0.0, noticed_s_ = -1.0, inject_until_s_ = 0.0;
  int submovement_count_ = 0, reached_looks_ = 0;
  PlainVector3 sight_error_um_;  ///< of the last look, unit deviation times its noise

  PlainVector3 base_m_, drift_m_per_s_;  ///< ended submovements; what is left of a halted one's speed
  std::array<Submovement, 16> moves_{};
  int move_count_ = 0;
  OperatorIntent intent_;

  std::array<Seen, 64> seen_{};
  int seen_count_ = 0, seen_next_ = 0;
  std::array<PlainVector3, 512> intended_m_{};  ///< ring, one a tick
  std::array<double, 512> felt_N_{};            ///< ring, one a tick
  double felt_peak_N_ = 0.0;
  double felt_late_N_ = 0.0;  ///< what was felt a reaction time ago
  double felt_now_N_ = 0.0;
  PlainVector3 against_;  ///< unit, frame H: against the line of entry; 0 where the plan has none

  double tremor_pole_ = 0.0, tremor_turn_ = 0.0, tremor_gain_m_ = 0.0;
  std::array<PlainVector3, 2> tremor_state_{};
  PlainVector3 tremor_m_;
};

}  // namespace pellucida
