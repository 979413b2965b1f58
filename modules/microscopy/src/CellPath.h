#pragma once
#include <opencv2/core.hpp>
#include <vector>

#include "OpticalPath.h"

namespace pellucida {

/// The optical path of zona and ooplasm. At each place along the axis the cross-section is one or more rings, read from
/// where the section's contours cross it; each adds 2 (sqrt(rho2^2 - v^2) - sqrt(rho1^2 - v^2)), v from the axis. Each
/// side of the axis has its own rings, blended near it. The axis is the needle's line, and runs to the cell's centre
/// on the far side.
class CellPath {
 public:
  CellPath(const Look::Cell& look, double pixel_size_um);

  /// Adds the cell to the path.
  void add(OpticalPath& path, const MicroscopeCell& cell);

 private:
  // A contour's crossing of a place along the axis: distance from it, and whether material begins inwards (+1) there.
  struct Crossing {
    float radius_um, sign;
  };
  struct Row {
    std::vector<Crossing> side[2];  // x below the axis, above it
  };
  void cross(const Contour_um& contour);
  void add_thickness(const Contour_um& contour, float weight, cv::Mat1f& thickness_um);
  double axis_x_um(double z_um) const noexcept;

  Look::Cell look_;
  double pixel_size_um_, step_um_;
  double x0_um_ = 0, z0_um_ = 0, offset_um_ = 0, radius_um_ = 1;
  std::vector<Row> rows_;
  std::vector<float> chord_, other_;
  cv::Mat1f zona_um_, ooplasm_um_, phase_, loss_, drawn_;
};

}  // namespace pellucida
