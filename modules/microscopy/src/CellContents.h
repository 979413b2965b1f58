#pragma once
#include <cstdint>
#include <vector>

#include "OpticalPath.h"
#include "pellucida/microscopy/OoplasmFlow.h"

namespace pellucida {

/// What lies in and on the cell and moves with its material: granules, lipid droplets, nucleus, polar body, cumulus
/// cells. Seeded.
class CellContents {
 public:
  CellContents(const Look::Cell& look, double cell_radius_um, double pixel_size_um, std::uint64_t seed);

  /// Adds them to the path.
  void add(OpticalPath& path, const MicroscopeCell& cell);

 private:
  // In the ooplasm: rest coordinates of OoplasmFlow, depth from the focal plane.
  struct Grain {
    float ratio, angle, sigma_um, phase_rad;
  };
  struct Droplet {
    float ratio, angle, radius_um, blur_um;
  };
  // On the zona: a place round it, and what part of its radius the body lies from the cell's middle.
  struct Cumulus {
    double angle_rad, ratio, radius_um, index, blur_um;
  };
  Eigen::Vector2d contour_place(const MicroscopeCell& cell, const Contour_um& contour, double angle_rad) const;
  void add_grain(cv::Mat1f& phase_rad, const Eigen::Vector2d& place_px, float sigma_px, float phase) const;

  Look::Cell look_;
  double pixel_size_um_;
  std::vector<Grain> grains_;
  std::vector<Droplet> droplets_;
  std::vector<Cumulus> cumulus_;
  Eigen::Vector2f nucleus_;  // ratio and angle
  OoplasmFlow flow_;
};

}  // namespace pellucida
