#pragma once
#include <cstdint>

#include "pellucida/core/PlainVector.h"
#include "pellucida/simulation/NormalNoise.h"
#include "pellucida/simulation/OperatorMotion.h"
#include "pellucida/simulation/OperatorOptions.h"
#include "pellucida/simulation/OperatorPerception.h"
#include "pellucida/simulation/OperatorPlan.h"

namespace pellucida {

/// The operator's activity.
enum class OperatorPhase : std::uint8_t { kLook, kApproach, kInsert, kDeposit, kRemove, kDone };
const char* to_string(OperatorPhase phase) noexcept;

/// Where the operator wants the hand. Frame H.
struct OperatorIntent {
  PlainVector3 position_m;  ///< the hand's equilibrium, from where it was at the start
  PlainVector3 velocity_m_per_s;
  bool inject = false;
};

/// A simulated operator at the workstation, as a servo that looks from time to time: each glance plans one submovement
/// (`OperatorMotion`) from the position seen a reaction time ago (`OperatorPerception`), plus the motion commanded
/// since, to the goal. From the approach point the hand moves along the line of entry at a steady speed, whatever the
/// tip meets, slower against a felt resistance, until a felt drop of the force or an image of the closed membrane ends
/// the push; then it aims at the target, deposits, and goes to the point of removal. Only the part of the force against
/// the line of entry counts: a guide pushes from the side. Seeded and deterministic; `tick` runs at fixed steps of 1 ms
/// and neither allocates nor throws.
class SimulatedOperator {
 public:
  static constexpr double kStep_s = kOperatorStep_s;

  /// Throws UsageError when an option or the plan's scale is out of range.
  SimulatedOperator(const OperatorOptions& options, const OperatorPlan& plan, std::uint64_t seed);

  /// Takes an image; the newest counts once it is `visual_delay_s` old. Times rise.
  void see(const OperatorView& view) noexcept;
  /// The next millisecond, with the force the hand feels now, N.
  const OperatorIntent& tick(const PlainVector3& force_N) noexcept;

  OperatorPhase phase() const noexcept { return phase_; }
  bool done() const noexcept { return phase_ == OperatorPhase::kDone; }
  double time_s() const noexcept { return static_cast<double>(tick_) * kStep_s; }
  /// When the operator noticed that the membrane had given way; below 0: not yet.
  double noticed_puncture_s() const noexcept { return noticed_s_; }
  int submovement_count() const noexcept { return motion_.submovement_count(); }

  /// Tremor of this tick, frame H, m, added by the muscles to the equilibrium. RMS of the vector as in the options.
  const PlainVector3& tremor_m() const noexcept { return tremor_.position_m(); }

 private:
  void notice_puncture() noexcept;
  void decide(const OperatorPerception::Seen& seen) noexcept;
  void push_on(const Eigen::Vector3d& seen_um, const Eigen::Vector3d& way_um) noexcept;
  void arrive() noexcept;
  void enter(OperatorPhase phase) noexcept;
  const PlainVector3& goal_um() const noexcept;

  OperatorOptions options_;
  OperatorPlan plan_;
  NormalNoise noise_;
  OperatorTremor tremor_;
  OperatorPerception perception_;
  OperatorMotion motion_;

  long tick_ = 0;
  OperatorPhase phase_ = OperatorPhase::kLook;
  double next_look_s_ = 0.0, noticed_s_ = -1.0, inject_until_s_ = 0.0;
  int reached_looks_ = 0;
  OperatorIntent intent_;
};

}  // namespace pellucida
