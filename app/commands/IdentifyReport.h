#pragma once
#include <string>

#include "pellucida/identification/Identification.h"
#include "pellucida/identification/RelaxationFit.h"

namespace pellucida {

/// A record and what was fitted to it.
struct FittedArms {
  RelaxationRecord record;
  RelaxationFit two, one;
};

/// Prints residuals and arms of the fits.
void print_relaxation(const std::string& record_name, const FittedArms& fitted);

/// Prints errors against the finite elements and constants, where they were found anew, and the force scale.
/// `measured`: a measured curve anchors it.
void print_identification(const Identification& result, bool measured);

}  // namespace pellucida
