#pragma once
#include <Eigen/Core>

namespace pellucida {

/// Derivatives at the knots of the monotone cubic through (x, y): Fritsch and Butland's weighted harmonic mean inside,
/// a one-sided three-point formula at the ends. `x` (n) strictly rising, n >= 2.
Eigen::VectorXd monotone_slopes(const Eigen::VectorXd& x, const Eigen::VectorXd& y);

/// Where `value` lies among rising knots: cell index in [0, n - 2] and the four weights of the cubic Hermite basis
/// there.
struct HermiteWeights {
  Eigen::Index cell = 0;
  double y0 = 1.0, y1 = 0.0;  ///< weights of the values at both ends
  double m0 = 0.0, m1 = 0.0;  ///< weights of the slopes at both ends
};
HermiteWeights hermite_weights(const Eigen::VectorXd& knots, double value);

/// Periodic cubic spline y(x), twice continuously differentiable.
class PeriodicSpline {
 public:
  /// `x` (n) strictly rising within one period, `y` (n); the period's end repeats the first value. n >= 3.
  PeriodicSpline(Eigen::VectorXd x, Eigen::VectorXd y, double period);
  double operator()(double x) const;

 private:
  Eigen::VectorXd x_;       // (n + 1), the last one is the first plus the period
  Eigen::VectorXd y_;       // (n + 1)
  Eigen::VectorXd second_;  // (n + 1) second derivatives
  double period_;
};

}  // namespace pellucida
