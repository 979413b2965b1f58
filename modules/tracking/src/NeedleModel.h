#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

namespace pellucida {

/// Where the needle is: tip and axis, px.
struct NeedleAxis {
  Eigen::Vector2d tip = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< shaft to tip

  Eigen::Vector2d across() const noexcept { return {-direction.y(), direction.x()}; }
  /// The point `behind` px behind the tip and `beside` px beside the axis.
  Eigen::Vector2d at(double behind, double beside) const noexcept {
    return tip - behind * direction + beside * across();
  }
};

/// What the needle looks like across: the relative grey value `image / medium - 1` as a function of the distance d from
/// its outline, outwards positive, learnt for each side. Any look fits in: two dark lines, a dark wedge, bright glass.
class NeedleLook {
 public:
  /// Empty tables from `-inside` to `outside` px, `step` px apart.
  void resize(double step, double inside, double outside);
  /// The same look on a table of another size.
  void reshape(double step, double inside, double outside);
  bool empty() const noexcept { return tables_[0].empty(); }
  double step() const noexcept { return step_; }
  double inside() const noexcept { return zero_ * step_; }
  double outside() const noexcept { return (count() - 1 - zero_) * step_; }
  int count() const noexcept { return static_cast<int>(tables_[0].size()); }

  /// Value and slope (per px) at distance d on side 0 (where the coordinate across is negative) or 1. Further out than
  /// the table 0, further in the innermost value.
  float value(int side, double d) const noexcept {
    const std::vector<float>& table = tables_[static_cast<std::size_t>(side)];
    const double x = d / step_ + zero_;
    const int last = static_cast<int>(table.size()) - 1;
    if (x >= last) return 0.0F;
    if (x <= 0.0) return table.front();
    const int i = static_cast<int>(x);
    const float t = static_cast<float>(x - i);
    return table[static_cast<std::size_t>(i)] * (1.0F - t) + table[static_cast<std::size_t>(i) + 1] * t;
  }
  float slope(int side, double d) const noexcept;

  /// One more sample of weight `weight`; `finish` makes means of all since `clear`, mixed with a share `keep` of what
  /// was known before, fills gaps, and subtracts the outer end, so that the medium is 0.
  void clear_samples();
  void add_sample(int side, double d, float value, float weight);
  void finish(double keep);

  /// Moves a side's zero of the distance by `by` px outwards: f(d) becomes f(d + by).
  void shift(int side, double by);
  /// Where a side's outline has its mark: the extremum of the line next to 0, else the steepest place of the flank.
  double mark(int side) const;
  /// Whether it is a line: the inside recovers towards the medium.
  bool is_line() const noexcept { return is_line_; }
  void set_line(bool line) noexcept { is_line_ = line; }
  /// Standard deviation of the line, or of the blur of the flank, px.
  double blur() const;
  /// Largest deviation from the medium: negative for a dark needle.
  double depth() const;
  /// How far the look is from a line that is the same on both its sides and on both sides of the needle: of the line,
  /// the larger difference of the two; 1 without a line. What defocus, relief or a halo make of an edge is uneven.
  double unevenness() const;

 private:
  float mean_at(double d) const { return 0.5F * (value(0, d) + value(1, d)); }

  double step_ = 0.5;
  int zero_ = 0;
  bool is_line_ = true;
  std::array<std::vector<float>, 2> tables_, sums_, weights_;
};

/// The needle's half width as a function of the way behind the tip: a cubic, carried on straight outside its range; and
/// how round its end is.
class NeedleCone {
 public:
  double half_width(double behind) const noexcept;
  double slope(double behind) const noexcept;
  /// Half width at the tip: the radius r with half_width(roundness r) = r, at least 0.5 px.
  double tip_radius() const noexcept { return radius_; }
  /// The same as the cubic has it, without that limit: 0 where it ends in a point.
  double fitted_tip_radius() const noexcept;
  /// Radius of the end's edge over the half width: 1, a half ball, to 0, cut off straight.
  double roundness() const noexcept { return roundness_; }
  void set_roundness(double roundness);

  /// Weighted least squares through (behind, half width); the degree follows the length. At least 3 points, in order.
  void fit(const std::vector<double>& behind, const std::vector<double>& half_width, const std::vector<double>& weight);
  /// The tip lies `by` px further ahead (behind grows by it) and the outline `wider` px further out.
  void move(double by, double wider);

  /// How far behind the tip it has been seen; further back `half_width` is a guess.
  double seen_to() const noexcept { return seen_to_; }
  void see_to(double behind) noexcept { seen_to_ = std::max(seen_to_, behind); }

 private:
  double fitted(double behind) const noexcept;
  void find_radius();
  double from_ = 0.0, to_ = 1.0, shift_ = 0.0, seen_to_ = 0.0;
  std::array<double, 4> c_{2.0, 0.0, 0.0, 0.0};
  double radius_ = 2.0, roundness_ = 1.0;
};

/// Appearance and shape together: what the needle should look like at a place `behind` its tip and `beside` its axis.
struct NeedleModel {
  NeedleLook look;
  NeedleCone cone;
  double unit_px = 1.0;  ///< spacing of stations along the shaft: grows with the blur, so that the cost does not
  int frames = 0;        ///< frames it was learnt from

  /// Relative grey values, the end included, of a line across the axis `behind` its tip: `count` of them `step` px
  /// apart, the first `beside` the axis.
  void line(double behind, double beside, double step, int count, float* values) const noexcept;
};

}  // namespace pellucida
