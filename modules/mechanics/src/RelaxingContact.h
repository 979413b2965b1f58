#pragma once
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/Relaxation.h"

namespace pellucida {

/// The force of a contact in a membrane that relaxes, frame by frame, from the force that the profile's modulus gives.
/// Without arms it is that force. One thread at a time.
class RelaxingContact {
 public:
  /// `hand_frequency_Hz` > 0: the frequency for which stiffness and damping are given.
  RelaxingContact(const CellProfile& profile, double hand_frequency_Hz);

  /// Out of contact: what comes begins from 0 here.
  void rest(double time_s) noexcept { relaxation_.start(time_s); }
  /// Nothing is known of what was before: the next force comes suddenly.
  void forget() noexcept { relaxation_.reset(); }

  struct Force {
    double force_uN = 0.0;
    double ratio = 1.0;                ///< force over what the profile's modulus gives; >= 0
    double stiffness_uN_per_um = 0.0;  ///< for a hand of that frequency: spring,
    double damping_uN_s_per_um = 0.0;  ///< and damper beside it, of the arms alone
    double rate_uN_per_s = 0.0;        ///< of the force while the needle rests
    double relaxed_uN = 0.0;           ///< what it comes down to then
    double sigma_uN = 0.0;             ///< of the force, by what is not known of the arms
  };
  /// `force_uN` >= 0 and its slope by depth, as the profile's modulus gives them at `time_s`.
  Force advance(double time_s, double force_uN, double stiffness_uN_per_um) noexcept;

 private:
  Relaxation relaxation_;
  double elastic_ratio_ = 1.0;
  double storage_ratio_ = 1.0;
  double loss_s_ = 0.0;
};

}  // namespace pellucida
