#pragma once
#include <cstdint>
#include <vector>

#include "pellucida/membrane/CellProfile.h"

namespace pellucida::test {

/// The force of a specimen that relaxes, by the hereditary integral of its elastic force over the whole past, summed
/// anew each frame. Three arms with strengths and times of its own, drawn by the seed, where the profile has two: a law
/// that the estimate's can't be.
class RelaxingTruth {
 public:
  explicit RelaxingTruth(std::uint64_t seed);

  /// Of the elastic force that finite elements give in this frame. The force falls to 0 where that does.
  double add(double time_s, double elastic_uN);

 private:
  double left_after(double time_s) const;

  struct Arm {
    double fraction, time_s;
  };
  std::vector<Arm> arms_;
  double elastic_ratio_ = 1.0;
  struct Step {
    double time_s, rise_uN;
  };
  std::vector<Step> past_;
  double before_s_ = 0.0, before_uN_ = 0.0;
};

/// The profile with the arms that `identify --relaxation tests/data/oocyte_relaxation/curve_01.csv` finds, rounded.
CellProfile with_relaxation(CellProfile profile);

}  // namespace pellucida::test
