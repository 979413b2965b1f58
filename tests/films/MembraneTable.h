#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

namespace pellucida::test {

/// What a specimen's wall carries at one depth, by the angle from the needle's pole at rest: `NAME-1-membrane.csv` of
/// tests/specimens, an axisymmetric solid.
struct MembraneRow {
  double theta0_rad = 0.0;
  /// Of liquid, needle and holder on the wall, per area of the middle surface at rest: away from the axis, and along it
  /// towards the needle.
  double load_r_kPa = 0.0, load_z_kPa = 0.0;
  double tension_uN_per_um = 0.0;  ///< half the trace of the stress resultant, per present length
};

class MembraneTable {
 public:
  /// Throws InputError where the file can't be read.
  explicit MembraneTable(const std::string& path);

  struct Depth {
    double indentation_um = 0.0;
    std::vector<MembraneRow> rows;  ///< by rising angle
    /// Between the rows; the nearest one's beyond them.
    MembraneRow at(double theta0_rad) const;
    /// The load averaged over the disk of `half_rad` about a direction, uN/um^2; (r, z) in the meridional plane of that
    /// direction. Across it the average is 0.
    Eigen::Vector2d load_uN_per_um2(double theta0_rad, double half_rad) const;
  };
  const std::vector<Depth>& depths() const noexcept { return depths_; }

 private:
  std::vector<Depth> depths_;
};

}  // namespace pellucida::test
