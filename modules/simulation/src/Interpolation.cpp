#include "Interpolation.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

// End slope of the monotone cubic: three points, limited so that the curve keeps its direction.
double end_slope(double h0, double h1, double d0, double d1) {
  const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0) return 0.0;
  if (d0 * d1 <= 0 && std::abs(slope) > 3 * std::abs(d0)) return 3 * d0;
  return slope;
}

Eigen::Index cell_of(const Eigen::VectorXd& knots, double value) {
  const double* first = knots.data();
  const auto upper = std::upper_bound(first, first + knots.size(), value) - first;
  return std::clamp<Eigen::Index>(upper - 1, 0, knots.size() - 2);
}

}  // namespace

Eigen::VectorXd monotone_slopes(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  const Eigen::Index n = x.size();
  const Eigen::VectorXd h = x.tail(n - 1) - x.head(n - 1);
  const Eigen::VectorXd d = (y.tail(n - 1) - y.head(n - 1)).cwiseQuotient(h);
  if (n == 2) return Eigen::VectorXd::Constant(2, d(0));

  Eigen::VectorXd slopes(n);
  slopes(0) = end_slope(h(0), h(1), d(0), d(1));
  slopes(n - 1) = end_slope(h(n - 2), h(n - 3), d(n - 2), d(n - 3));
  for (Eigen::Index i = 1; i < n - 1; ++i) {
    const double a = h(i - 1) + 2 * h(i), b = 2 * h(i - 1) + h(i);
    slopes(i) = d(i - 1) * d(i) <= 0 ? 0.0 : (a + b) / (a / d(i) + b / d(i - 1));
  }
  return slopes;
}

HermiteWeights hermite_weights(const Eigen::VectorXd& knots, double value) {
  HermiteWeights w;
  w.cell = cell_of(knots, value);
  const double h = knots(w.cell + 1) - knots(w.cell);
  const double t = std::clamp((value - knots(w.cell)) / h, 0.0, 1.0);
  const double t2 = t * t, t3 = t2 * t;
  w.y0 = 2 * t3 - 3 * t2 + 1;
  w.y1 = 3 * t2 - 2 * t3;
  w.m0 = h * (t3 - 2 * t2 + t);
  w.m1 = h * (t3 - t2);
  return w;
}

PeriodicSpline::PeriodicSpline(Eigen::VectorXd x, Eigen::VectorXd y, double period) : period_(period) {
  const Eigen::Index n = x.size();
  x_.resize(n + 1);
  y_.resize(n + 1);
  x_ << x, x(0) + period;
  y_ << y, y(0);
  // Continuity of the first derivative at every knot gives one row each of a positive definite cyclic band.
  Eigen::SparseMatrix<double> band(n, n);
  band.reserve(Eigen::VectorXi::Constant(n, 3));
  Eigen::VectorXd right(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index before = (i + n - 1) % n, after = (i + 1) % n;
    const double h0 = x_(before + 1) - x_(before), h1 = x_(i + 1) - x_(i);
    band.coeffRef(i, before) += h0 / 6;
    band.coeffRef(i, i) += (h0 + h1) / 3;
    band.coeffRef(i, after) += h1 / 6;
    right(i) = (y_(i + 1) - y_(i)) / h1 - (y_(before + 1) - y_(before)) / h0;
  }
  const Eigen::VectorXd second = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(band).solve(right);
  second_.resize(n + 1);
  second_ << second, second(0);
}

double PeriodicSpline::operator()(double x) const {
  x -= period_ * std::floor((x - x_(0)) / period_);
  const Eigen::Index i = cell_of(x_, x);
  const double h = x_(i + 1) - x_(i), a = (x_(i + 1) - x) / h, b = 1 - a;
  return a * y_(i) + b * y_(i + 1) + ((a * a * a - a) * second_(i) + (b * b * b - b) * second_(i + 1)) * h * h / 6;
}

}  // namespace pellucida
