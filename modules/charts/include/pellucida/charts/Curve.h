#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace pellucida {

/// A curve of a chart: points in the order in which they are joined. A `y` of NaN is a gap. The band's edges equal `y`
/// where there is no interval.
struct Curve {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> lower;  ///< as long as `y`
  std::vector<double> upper;  ///< as long as `y`

  std::size_t size() const noexcept { return y.size(); }
  bool empty() const noexcept { return y.empty(); }
  /// An edge of the band that is NaN becomes `y_value`.
  void add(double x_value, double y_value, double lower_value, double upper_value);
  void add(double x_value, double y_value) { add(x_value, y_value, y_value, y_value); }
  /// Nothing joins the points before and after; without effect at the beginning and after another gap.
  void add_gap();
};

/// The same curve with at most about `most` points: of each stretch of points without a gap the first, the least and
/// the greatest remain, so that peaks keep their height. Gaps remain.
Curve thinned(const Curve& curve, std::size_t most);

/// Places of the numbers that exceed all before them: of a needle's depths, the way in. NaN is none.
std::vector<std::size_t> way_in(std::span<const double> x);
/// The band of a curve that goes back and forth in `x`, along its way in alone: those of a hold and of the way back
/// would lie on it as one block. The curve's gaps are none of the band's.
Curve band_of_way_in(const Curve& curve);
/// Whether `x` never falls.
bool is_ascending(const Curve& curve);

}  // namespace pellucida
