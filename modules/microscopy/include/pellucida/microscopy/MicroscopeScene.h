#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/microscopy/GlassShape.h"

namespace pellucida {

/// A closed contour that runs clockwise in (x, z), moved `outwards_um` along its normal.
Contour_um offset_contour(const Contour_um& contour, double outwards_um);

/// A round body in the dish: cumulus cell, debris, bubble.
struct SceneBall {
  Eigen::Vector2d center_um = Eigen::Vector2d::Zero();  ///< frame W
  double radius_um = 0.0;
  double index = 0.0;              ///< refractive index less the medium's
  double absorption_per_um = 0.0;  ///< of the light's way through it
};

/// The cell's section, in its own frame: x across, z along the axis to the needle (2 x n, running clockwise).
struct MicroscopeCell {
  Contour_um outer_um, inner_um, ooplasm_um;  ///< the zona's boundaries and the ooplasm's
  Eigen::VectorXd angle_rad;                  ///< (n) rest angles of the material
  double needle_offset_um = 0.0;              ///< of the needle's line from the cell's centre
  Eigen::Vector2d center_um = Eigen::Vector2d::Zero(), axis = Eigen::Vector2d::UnitX(),
                  across = Eigen::Vector2d::UnitY();  ///< the section's place in frame W
  Eigen::Vector2d to_image(const Eigen::Vector2d& p) const { return center_um + p.x() * across + p.y() * axis; }
};

/// A glass tool: where it ends and how it lies, in frame W.
struct MicroscopeTool {
  Eigen::Vector2d end_um = Eigen::Vector2d::Zero();  ///< the needle's tip, or the middle of the mouth
  Eigen::Vector2d back = Eigen::Vector2d::UnitX();   ///< unit, from there along the glass
};

/// What lies under the microscope at one moment; geometry alone, lengths in um.
struct MicroscopeScene {
  long frame_index = 0;
  double time_s = 0.0;
  double lamp_ratio = 1.0;

  std::optional<MicroscopeCell> cell;

  std::optional<MicroscopeTool> needle, holder;
  NeedleShape needle_shape;
  HolderShape holder_shape;
  double needle_out_of_plane_um = 0.0;  ///< of the tip from the focal plane, into the scene

  std::vector<SceneBall> balls;
};

}  // namespace pellucida
