#pragma once
#include <Eigen/Core>
#include <random>

#include "pellucida/membrane/CellProfile.h"

namespace pellucida::testing {

/// The shipped oocyte on a coarser mesh: quick, and the same code.
inline CellProfile coarse_profile() {
  CellProfile profile = load_profile("mouse-oocyte");
  profile.mesh_frequency = 4;
  return profile;
}

/// `points` with each coordinate moved by a normal deviate of `sigma`.
inline Eigen::Matrix3Xd shaken(const Eigen::Matrix3Xd& points, double sigma, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> deviate(0.0, sigma);
  Eigen::Matrix3Xd moved = points;
  for (Eigen::Index k = 0; k < moved.size(); ++k) moved.data()[k] += deviate(generator);
  return moved;
}

}  // namespace pellucida::testing
