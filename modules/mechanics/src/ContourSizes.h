#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "CellPlacement.h"
#include "pellucida/core/Observation.h"
#include "pellucida/membrane/IndentedSolid.h"

namespace pellucida {

/// Sizes of a cell and of the tools on it, as a picture at rest shows them, with the standard deviations of their
/// logarithms.
struct SizesPrior {
  LogSizes mean = LogSizes::Zero(), sigma = LogSizes::Zero();
};

/// What the outer contours of a contact add to that: how wide a dimple is, and where the cell bulges, depends on the
/// wall's thickness and on both tools. The most likely sizes (maximum a posteriori) given the contours at depths 0.08
/// outer radii apart, against the sections of a solid (`IndentedSolid`), by Gauss and Newton's method; the difference
/// between cell and solid is normal and correlated along the contour and over the depth. Only for a needle opposite the
/// holding pipette, which is what the solid is. One thread at a time; allocates.
class ContourSizes {
 public:
  ContourSizes() : solid_(IndentedSolid::shipped()) {}

  /// What an untouched cell's outline differs from its circle by.
  void add_rest(const Observation& observation, const CellPlacement& placement);
  /// A contour in contact at that depth. True where it is the first one at a depth, so that an estimate is worth its
  /// time.
  bool add(const Observation& observation, const CellPlacement& placement, double depth_um);
  /// Another model: the contours are forgotten, the outline at rest is kept.
  void clear() noexcept {
    contours_.clear();
    start_.reset();
  }
  int contour_count() const noexcept { return static_cast<int>(contours_.size()); }
  void forget() {
    clear();
    rest_count_ = 0;
  }

  struct Sizes {
    LogSizes mean;
    Eigen::Matrix3d covariance;
  };
  /// Sizes that the picture shows well stay as they are. Nothing where it shows all of them, where too little was seen
  /// in contact, or where no sizes explain it.
  std::optional<Sizes> estimate(const SizesPrior& prior);

  /// How force and pressure of a cell of sizes `to` compare with those of sizes `from`, by the solid: ln ratios, and
  /// the force's derivatives by the logarithms of `to`.
  struct ForceChange {
    double log_ratio = 0.0, log_pressure_ratio = 0.0;
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  };
  ForceChange force_change(const LogSizes& from, const LogSizes& to, double depth_ratio) const;

 private:
  struct Seen {
    double depth_ratio = 0.0;
    MembraneContour contour;  // frame C: x across, z towards the needle; um
  };
  struct Misfit;
  static MembraneContour in_cell(const Observation& observation, const CellPlacement& placement);
  Eigen::VectorXd offsets(const MembraneContour& contour, const Eigen::Matrix2Xd& places,
                          const Eigen::Matrix2Xd& normals) const;
  Misfit misfit(const LogSizes& sizes) const;
  Eigen::MatrixXd covariance_um2(const Misfit& seen) const;

  const IndentedSolid& solid_;
  std::vector<Seen> contours_;  // by rising depth
  double radius_um_ = 0.0;      // outer, of the cell they show
  Eigen::VectorXd rest_;        // (n) um, by node of the solid's half-section
  int rest_count_ = 0;
  std::optional<LogSizes> start_;  // the last estimate, where the next one begins
};

}  // namespace pellucida
