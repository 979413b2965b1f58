#pragma once
#include <Eigen/Core>
#include <random>

#include "films/RandomFilm.h"
#include "pellucida/simulation/NeedleDrive.h"

namespace pellucida::test {

/// What a manipulator reports of the needle of a random film, with the errors of one whose calibration nobody has
/// checked. A film's are drawn by its seed: scale (standard deviation 10 %), direction of its axes (5 degrees), delay
/// of the picture behind the report (0 to 1 frame), play of its gears, which it doesn't report (0 to 2 px, 3 um at
/// most), noise of each report (0.1 px). It knows nothing of a scene that drifts.
class FilmManipulator {
 public:
  explicit FilmManipulator(const RandomFilm& film);

  /// Its report for a frame: where it takes the tip to be, um. Times must rise.
  Eigen::Vector2d at(double time_s);

 private:
  std::mt19937_64 dice_;
  ScriptedNeedle needle_;
  Eigen::Matrix2d calibration_;
  double delay_s_ = 0.0, play_um_ = 0.0, noise_um_ = 0.0;
  Eigen::Vector2d heading_ = Eigen::Vector2d::Zero();  // the last that it moved in
};

}  // namespace pellucida::test
