#pragma once
#include <cstdint>
#include <optional>

#include "films/RandomFilm.h"
#include "pellucida/core/Observation.h"
#include "pellucida/mechanics/ForceObserver.h"
#include "pellucida/simulation/CellReference.h"

namespace pellucida::test {

/// What a specimen's film says of its force, shares in 0..1, errors in % of the film's largest true force; below 0:
/// not measured.
struct SpecimenResult {
  ReferenceGeometry specimen;
  double deepest_ratio = 0.0;              ///< largest true depth over the middle radius
  double given_percent = -1.0;             ///< RMS over the frames in contact with a force, the modulus known
  double palpated_percent = -1.0;          ///< likewise, the modulus found by a push of 5 %
  double bias_percent = 0.0;               ///< mean of the same differences as `given_percent`
  double in_whole = -1.0, in_wide = -1.0;  ///< frames whose whole interval holds the force: see `SpecimenTrial`
};

/// Follows the force observer through a film of a specimen. The film's cell has the profile's modulus: what a cell of
/// another would show are the same pictures, and all forces times the ratio of the two.
///
/// Whole interval: the ratio drawn 16 times as the profile says that its kind spreads (log-normal), and 16 times evenly
/// in the logarithm over a factor of 10, which no profile says. Palpation: at the first frame 5 um deep, of a cell
/// whose modulus is drawn over a factor of 10: its force with an error of 5 %, and what was read as its depth.
class SpecimenTrial {
 public:
  SpecimenTrial(const RandomFilm& film, const CellProfile& profile);

  void add(const Observation& seen, const ForceEstimate& estimate, bool contact, double true_uN, double true_um);
  SpecimenResult result() const;

 private:
  SpecimenResult result_;
  CellProfile profile_;
  ForceObserver palpated_;
  std::uint64_t seed_;
  double wide_log_ = 0.0, noise_ = 0.0;
  bool is_palpated_ = false;
  double peak_uN_ = 0.0, deepest_um_ = 0.0, scale_ = 1.0;
  double squares_ = 0.0, sum_ = 0.0, palpated_squares_ = 0.0;
  int count_ = 0, palpated_count_ = 0;
  double whole_count_ = 0.0, wide_count_ = 0.0;
};

}  // namespace pellucida::test
