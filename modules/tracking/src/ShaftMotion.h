#pragma once
#include <Eigen/Core>
#include <optional>

#include "FrameSampler.h"
#include "NeedleModel.h"

namespace pellucida {

/// Where a rigid needle's tip is, by what its shaft looks like behind it: held against what was seen of the shaft while
/// nothing was touched and the tip was read. A shaft that widens says along the axis too where it is, even where the
/// tip itself is not seen; one that is the same all along says nothing.
///
/// The shaft's picture is a grid on the axis, its rows across, smoothed along the needle. Place along and across and
/// contrast are found by least squares (B. Lucas and T. Kanade, 1981), from each row without its mean and slope and
/// with a contrast that changes smoothly along the needle, so that the light does not matter; rows unlike the others
/// lose their say.
class ShaftMotion {
 public:
  /// Known well enough to say where the tip is.
  bool is_known() const noexcept { return frames_ >= kLeastFrames; }

  /// Where the tip is, px ahead of where it was due and across, with the standard deviation along; `likeness` 0..1: of
  /// what is seen of the shaft to what was learnt of it.
  struct Place {
    double ahead_px = 0.0, across_px = 0.0, sigma_px = 0.0, likeness = 0.0;
  };
  /// With the tip due at `due.tip`; the cell covers or touches the shaft up to `covered_px` behind it. Nothing where
  /// the shaft says nothing, too little of it is in view, or none was learnt.
  std::optional<Place> find(const FrameSampler& image, const NeedleAxis& due, double covered_px) const;

  /// Takes in the shaft of a frame in which nothing is touched and the tip was read at `read` to `sigma_px`; `found`:
  /// where the shaft has it, if it says. `half_width_px`: some way behind the tip; the first one sets how finely the
  /// shaft is sampled.
  void learn(const FrameSampler& image, const NeedleAxis& due, const std::optional<Place>& found,
             const Eigen::Vector2d& read, double sigma_px, double half_width_px);

 private:
  static constexpr int kLeastFrames = 3;
  static constexpr int kRows = 96, kColumns = 25, kUnknowns = 5;
  using Grid = Eigen::Array<float, kRows, kColumns, Eigen::RowMajor>;
  using Rows = Eigen::Array<float, kRows, 1>;

  void sample(const FrameSampler& image, const NeedleAxis& axis, Grid& grid, Rows& inside) const;
  void add(const FrameSampler& image, const NeedleAxis& axis);
  static double along_of(const NeedleAxis& axis);
  double drift_per_px() const;
  static void smooth(const Grid& grid, const Rows& seen, Grid& out);

  // Sums over the frames learnt: of the place along the image, px, and of the readings' distance from the shaft.
  struct Way {
    int count = 0;
    double mean_px = 0.0, mean_apart_px = 0.0, squares = 0.0, products = 0.0;
    void add(double way_px, double apart_px);
  };

  double step_px_ = 0.0;  // between samples
  int frames_ = 0;
  Grid sum_ = Grid::Zero();
  Rows count_ = Rows::Zero();                    // frames that showed each row
  double ahead_px_ = 0.0;                        // of the grid's own tip: the mean of the readings
  double read_sigma_px_ = 0.0, likeness_ = 0.0;  // likewise means
  Way way_;
};

}  // namespace pellucida
