#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "CellPlacement.h"
#include "pellucida/core/Observation.h"
#include "pellucida/membrane/IndentedSolid.h"

namespace pellucida {

/// A cell and the tools on it, as a picture at rest shows them and as its kind stiffens, with the standard deviations.
/// The elongation is that of the outline at rest, whatever is given.
struct ParametersPrior {
  SolidParameters mean = SolidParameters::Zero(), sigma = SolidParameters::Zero();
};

/// What the outer contours of a contact add to that: how wide a dimple is, and where the cell bulges, depends on the
/// wall's thickness, on how it stiffens with strain, and on both tools. The most likely parameters (maximum a
/// posteriori) given the contours at depths 0.08 outer radii apart, against the sections of a solid (`IndentedSolid`),
/// by Gauss and Newton's method, a step of bounded time at a time; the difference between cell and solid is normal and
/// correlated along the contour and over the depth. Only for a needle opposite the holding pipette, which is what the
/// solid is. One thread at a time; allocates.
class ContourSizes {
 public:
  ContourSizes() : solid_(IndentedSolid::shipped()) {}

  /// What an untouched cell's outline differs from its circle by.
  void add_rest(const Observation& observation, const CellPlacement& placement);
  /// ln of that outline's length (along the needle) over its width; 0 where too little was seen of it.
  double elongation() const noexcept { return elongation_; }
  /// A contour in contact at that depth, known to `depth_sigma_um`: counts where it is the first one at a depth.
  void add(const Observation& observation, const CellPlacement& placement, double depth_um, double depth_sigma_um);
  /// Another model: the contours are forgotten, the outline at rest is kept.
  void clear() noexcept;
  int contour_count() const noexcept { return static_cast<int>(contours_.size()); }
  void forget() {
    clear();
    rest_count_ = 0;
    elongation_ = 0.0;
  }

  struct Parameters {
    SolidParameters mean;
    Eigen::Matrix<double, kParameters, kParameters> covariance;
  };
  /// A step towards the most likely parameters, while contours were added since the last one was found. Takes as long
  /// as it takes to hold two contours against the solid.
  void step(ParametersPrior prior);
  /// Nothing is left to do.
  bool is_settled() const noexcept { return is_settled_; }
  /// As the last step left it, settled or not. Parameters that the prior knows well are as there. Nothing where it
  /// knows all of them, where too little was seen in contact, or where no parameters explain it.
  const std::optional<Parameters>& estimate() const noexcept { return estimate_; }
  /// A standard deviation up to this one is known well.
  static constexpr double kOpen = 0.2;

  /// How force and pressure of a cell of parameters `to` compare with those of `from`, by the solid: ln ratios, and
  /// the force's derivatives by the depth over the radius and by `to`.
  struct ForceChange {
    double log_ratio = 0.0, log_pressure_ratio = 0.0, by_depth = 0.0;
    SolidParameters slope = SolidParameters::Zero();
    ForceChange& operator-=(const ForceChange& other) {
      log_ratio -= other.log_ratio;
      log_pressure_ratio -= other.log_pressure_ratio;
      slope -= other.slope;
      return *this;
    }
  };
  ForceChange force_change(const SolidParameters& from, const SolidParameters& to, double depth_ratio) const;

 private:
  /// One row for each node of the solid's section that a contour shows.
  struct Misfit {
    Eigen::VectorXd residual_um;                                            // contour less solid, along the normal
    Eigen::Matrix<double, Eigen::Dynamic, kParameters> slope_um;            // of the solid, by its parameters
    std::vector<int> node;                                                  // of those that count
    Eigen::VectorXd depth_ratio, normal_z, depth_slope, edge_um, depth_um;  // the last two: standard deviations
    void resize(Eigen::Index rows);
  };
  struct Seen {
    double depth_ratio = 0.0;
    MembraneContour contour;               // frame C: x across, z towards the needle; um
    double edge_um = 0.0, depth_um = 0.0;  // standard deviations: of the contour, of that depth
    std::optional<SolidParameters> at;     // of the solid that it was last held against
    Misfit misfit;                         // there
  };
  static MembraneContour in_cell(const Observation& observation, const CellPlacement& placement);
  Eigen::VectorXd offsets(const MembraneContour& contour, const Eigen::Matrix2Xd& places,
                          const Eigen::Matrix2Xd& normals) const;
  double elongation_of_rest() const;
  bool hold_against_solid();
  Misfit misfit(const Seen& seen) const;
  Misfit misfit_of_all() const;
  void give_up() noexcept;
  Eigen::MatrixXd covariance_um2(const Misfit& seen) const;

  const IndentedSolid& solid_;
  std::vector<Seen> contours_;  // by rising depth
  double radius_um_ = 0.0;      // outer, of the cell they show
  Eigen::VectorXd rest_;        // (n) um, of the outline at rest from its circle, by node of the solid's half-section
  int rest_count_ = 0;
  double elongation_ = 0.0;            // of the outline at rest
  std::optional<SolidParameters> at_;  // the present estimate
  int steps_ = 0;                      // since a contour was added
  bool is_settled_ = true;
  std::optional<Parameters> estimate_;
};

}  // namespace pellucida
