#pragma once
#include <Eigen/Core>
#include <array>

namespace pellucida {

/// Logarithms of a cell's and its tools' sizes over the zona's outer radius: of its thickness, of the needle's tip
/// radius, of the holder's outer radius.
using LogSizes = Eigen::Vector3d;

/// What the solid depends on beside the depth: `LogSizes`, then `stiffening_effect` of its wall, and the logarithm of
/// its length (along the needle) over its width at rest.
inline constexpr int kParameters = 5;
using SolidParameters = Eigen::Vector<double, kParameters>;
inline constexpr int kStiffening = 3, kElongation = 4;  ///< their places

/// What a wall does that stiffens with strain by the law mu/(2 b) (exp(b (I1 - 3)) - 1), b the stiffening: forces and
/// shapes change about evenly with ln(1 + b / 0.3). 0: neo-Hookean.
double stiffening_effect(double stiffening) noexcept;
/// The inverse.
double stiffening_of(double effect) noexcept;

/// The outer section of an incompressible solid shell full of liquid, under a needle opposite the holding pipette, and
/// the needle's force on it, as smooth functions of sizes, stiffening, elongation and depth: fitted to solids
/// of revolution computed for 640 geometries, each round, of a wall that stiffens, and out of round
/// (`resources/shapes/indented_solid.py`, which prints what the fit leaves). Constant once made: for any number of
/// threads.
class IndentedSolid {
 public:
  /// The shipped one. Throws InputError when its file is damaged.
  static const IndentedSolid& shipped();

  /// Rest angles from the contact point of the section's points, rad, 0 to pi: of their directions from the centre.
  const Eigen::VectorXd& angle_rad() const noexcept { return angle_rad_; }

  /// The half-section (x across, z towards the needle) over the outer radius (the geometric mean of length and width),
  /// with its derivatives by the depth over that radius and by the parameters; (2 x n) each.
  struct Section {
    Eigen::Matrix2Xd places, by_depth;
    std::array<Eigen::Matrix2Xd, kParameters> by_parameter;
  };
  /// With the needle `depth_ratio` outer radii deep. Parameters and depth beyond the fitted range are taken as at its
  /// border.
  Section section(const SolidParameters& parameters, double depth_ratio) const;

  /// ln of the force over modulus and outer radius squared, and of the liquid's pressure over the modulus, up to a
  /// constant each; the force's derivatives by the parameters and by the depth.
  struct Load {
    double log_force = 0.0, log_pressure = 0.0;
    SolidParameters by_parameter = SolidParameters::Zero();
    double by_depth = 0.0;
  };
  /// Parameters likewise; deeper than fitted the force goes on with the power of the depth that it has there (GetFEM,
  /// 0.85 to 0.95 radii deep: 4 % RMS), the pressure stays. Precondition: a depth above 0.
  Load load(const SolidParameters& parameters, double depth_ratio) const;

  /// The parameters nearest to `parameters` within the fitted range.
  SolidParameters within_range(const SolidParameters& parameters) const;
  double deepest_ratio() const noexcept { return deepest_ratio_; }

 private:
  IndentedSolid() = default;
  /// An ellipse, and its derivative by the elongation.
  std::array<Eigen::Matrix2Xd, 2> rest(double elongation) const;
  /// (terms x 7): its values, and their derivatives by the parameters and the depth.
  using Basis = Eigen::Matrix<double, Eigen::Dynamic, kParameters + 2>;
  Basis basis(const SolidParameters& parameters, double depth_ratio) const;

  SolidParameters centre_, width_, lowest_, highest_;
  double depth_centre_ = 0.0, deepest_ratio_ = 0.0;
  Eigen::Matrix<int, kParameters + 1, Eigen::Dynamic>
      powers_;                        // (6 x terms): of the parameters, and the depth's polynomial's degree
  Eigen::MatrixXd section_;           // (2 n x terms)
  Eigen::VectorXd force_, pressure_;  // (terms)
  Eigen::VectorXd angle_rad_;
};

}  // namespace pellucida
