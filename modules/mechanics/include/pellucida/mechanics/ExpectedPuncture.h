#pragma once
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/MembraneGeometry.h"

namespace pellucida {

/// Spread of puncture forces about what is expected (Table I gives one number and no spread): assumed.
constexpr double kPunctureSpread_ratio = 0.3;

/// Where the membrane of one cell is expected to give way under one needle.
struct ExpectedPuncture {
  double force_uN = 0.0;     ///< the median; log-normal
  double sigma_ratio = 0.0;  ///< of its logarithm: how cells differ, and what another needle or zona leaves open
  double depth_um = 0.0;     ///< indentation at which this cell bears that force
};

/// The profile's measured puncture carried over to a cell and tools of other sizes: the wall gives way at one stress
/// over its section round the tip's rim, F / (2 pi a h), as rubber sheets under blunt pins do, so that F goes with a h.
/// How far that holds for zonae isn't measured: half of the logarithm of that ratio is part of `sigma_ratio`. The depth
/// follows from the powers of the force (docs/method.md, 3.8). `scale_ratio` (> 0): this cell's stiffness over its
/// kind's; it moves the depth alone. Precondition: all lengths above 0.
ExpectedPuncture expected_puncture(const CellProfile& profile, const MembraneGeometry& geometry,
                                   double scale_ratio = 1.0) noexcept;

/// The probability that a membrane under this force, known to `force_relative_sigma`, gives way:
/// Phi(ln(F / Fp) / sqrt(sF^2 + sp^2)); 0 at and below 0.
double puncture_probability(const ExpectedPuncture& expected, double force_uN, double force_relative_sigma) noexcept;

}  // namespace pellucida
