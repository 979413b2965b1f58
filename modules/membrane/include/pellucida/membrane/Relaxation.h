#pragma once
#include <vector>

namespace pellucida {

/// A Maxwell arm, spring and damper in line.
struct RelaxationArm {
  double fraction = 0.0;  ///< of the stiffness right after a sudden push, above 0; the arms' sum is below 1
  double time_s = 0.0;    ///< its relaxation time, above 0
};

/// The force in a relaxing membrane from its elastic force: a spring beside Maxwell arms (quasi-linear
/// viscoelasticity),
///
///     F(t) = integral of G(t - s) dFe(s),   G(t) = 1 - sum_k f_k (1 - exp(-t / tau_k)),   G(0) = 1,
///
/// with Fe the elastic force, that of a push too quick to relax. Step by step, exact while Fe is linear between two
/// instants, however far apart they are:
///
///     q_k <- q_k exp(-dt / tau_k) + f_k dFe (1 - exp(-dt / tau_k)) tau_k / dt,   F = (1 - sum f_k) Fe + sum q_k.
///
///     Relaxation relaxation(profile.relaxation_arms);
///     relaxation.start(time_s, 0.0);                                     // at contact
///     const double force_uN = relaxation.advance(time_s, elastic_uN);    // each frame
///
/// `advance` takes two exponentials an arm, allocates nothing and does not throw: suitable for a real-time loop.
/// Without arms F is Fe. One thread at a time.
class Relaxation {
 public:
  /// Throws UsageError unless every fraction and time is above 0 and the fractions' sum is below 1.
  explicit Relaxation(std::vector<RelaxationArm> arms);

  const std::vector<RelaxationArm>& arms() const noexcept { return arms_; }

  /// Starts with an elastic force that has always been `elastic_uN` (all arms relaxed); 0 before a contact.
  void start(double time_s, double elastic_uN = 0.0) noexcept;

  /// Forgets everything: as before the first `start`.
  void reset() noexcept;

  /// The force at `time_s`, uN; the elastic force has changed linearly from its last value to `elastic_uN`. At an
  /// instant not later than the last one the elastic force jumps. Before `start`, the first call starts with 0.
  double advance(double time_s, double elastic_uN) noexcept;

  /// The last result, uN.
  double force_uN() const noexcept;

  /// How fast it would fall from there on if the elastic force stayed, uN/s: - sum q_k / tau_k.
  double rate_uN_per_s() const noexcept;

  /// What would remain of it in the end, uN: the spring's part.
  double relaxed_uN() const noexcept { return spring_fraction_ * elastic_uN_; }

  /// A steady small vibration of angular frequency omega > 0 feels the stiffness k of the elastic force as a spring of
  /// k times `storage_ratio` beside a damper of k times `loss_s`:
  ///     1 - sum f_k / (1 + (omega tau_k)^2),    sum f_k tau_k / (1 + (omega tau_k)^2).
  double storage_ratio(double omega_per_s) const noexcept;
  double loss_s(double omega_per_s) const noexcept;

  /// G(t): what remains of a sudden push `time_s` >= 0 later.
  double modulus_ratio(double time_s) const noexcept;

  /// F / Fe at the end of a steady rise of the elastic force over `ramp_s` from 0: the divisor that turns a force scale
  /// measured in such a ramp into the scale of Fe.
  double ramp_ratio(double ramp_s) const noexcept;

 private:
  std::vector<RelaxationArm> arms_;
  std::vector<double> arm_force_uN_;
  double spring_fraction_ = 1.0;
  double elastic_uN_ = 0.0;
  double time_s_ = 0.0;
  bool started_ = false;
};

}  // namespace pellucida
