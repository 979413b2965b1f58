#pragma once
#include <type_traits>

#include "pellucida/core/LatestValue.h"
#include "pellucida/haptics/HapticDevice.h"
#include "pellucida/simulation/SimulatedOperator.h"

namespace pellucida {

/// The arm behind the hand: m a = k (x0 - x) + b (v0 - v) + f about the equilibrium x0 that the operator intends, the
/// same in each direction. Defaults: a hand with a stylus, forearm at rest; of the order found by Tsuji et al., Biol.
/// Cybern. 72 (1995), Hasser and Cutkosky, Haptics Symp. (2002) and Fu and Cavusoglu, IEEE Trans. SMC-B 42 (2012); all
/// three report that grip and posture change them by factors.
struct ArmOptions {
  double mass_kg = 0.20;             ///< 0.02..5
  double damping_N_s_per_m = 6.0;    ///< 0.5..100
  double stiffness_N_per_m = 300.0;  ///< 20..5000
};

/// A simulated operator holding a device, as a device: the loop reads the hand's position and writes the force on it;
/// the arm yields and pushes, the operator sees, feels and acts. Between two reads time advances in steps of 1 ms with
/// the force written last. `see` may come from another thread than `read` and `write`; none of them allocates, locks or
/// throws.
///
///     SimulatedHand hand(operator_options, plan, ArmOptions{}, seed);
///     hand.see({time_s, tip_um, true, punctured});     // each picture
///     hand.read(now_s, sample); ...; hand.write(force_N);   // each tick
class SimulatedHand final : public HapticDevice {
 public:
  /// Throws as SimulatedOperator; UsageError when an arm's number is out of range.
  SimulatedHand(const OperatorOptions& options, const OperatorPlan& plan, const ArmOptions& arm, std::uint64_t seed);

  /// Takes what the display shows now.
  void see(const OperatorView& view) noexcept { shown_.publish(view); }

  const DeviceSpecification& specification() const noexcept override { return specification_; }
  /// The hand at `now_s`, which must not go back; position and velocity, and the operator's buttons. After more than a
  /// second without a read the time between is skipped. Always true.
  bool read(double now_s, HandSample& sample) noexcept override;
  /// The force on the hand from now on, limited to the specification. False when it is not finite: the force on the
  /// hand is then released.
  bool write(const PlainVector3& force_N) noexcept override;

  const SimulatedOperator& simulated_operator() const noexcept { return operator_; }

 private:
  void step() noexcept;

  SimulatedOperator operator_;
  ArmOptions arm_;
  double tremor_gain_ = 1.0;  ///< makes the hand, held by the arm alone, tremble by the option's RMS
  DeviceSpecification specification_;
  LatestValue<OperatorView> shown_;
  bool started_ = false;
  double offset_s_ = 0.0;
  PlainVector3 position_m_, velocity_m_per_s_, force_N_, last_tremor_m_;
  bool inject_ = false;
};

}  // namespace pellucida
