#include "CyclicBandSolver.h"

#include <cstddef>

namespace pellucida {

void CyclicBandSolver::reset(int n) {
  size_ = n;
  const auto count = static_cast<std::size_t>(n);
  for (std::vector<double>* entries : {&diagonal_, &next_, &second_next_}) entries->assign(count, 0.0);
  for (std::vector<double>* factor : {&inverse_pivot_, &below_, &second_below_, &border_a_, &border_b_})
    factor->resize(count);
}

bool CyclicBandSolver::factorize() noexcept {
  const int n = size_, band = n - 2;
  const double *a0 = diagonal_.data(), *a1 = next_.data(), *a2 = second_next_.data();
  double *l1 = below_.data(), *l2 = second_below_.data(), *inverse = inverse_pivot_.data();
  double *la = border_a_.data(), *lb = border_b_.data();
  double aa = a0[n - 2], ab = a1[n - 2], bb = a0[n - 1];
  // The factor's columns j - 1 and j - 2 times their pivots.
  double low1 = 0.0, low2 = 0.0, low2_before = 0.0;
  double edge_a = 0.0, edge_b = 0.0, edge_a_before = 0.0, edge_b_before = 0.0;
  for (int j = 0; j < band; ++j) {
    const double f1 = j > 0 ? l1[j - 1] : 0.0, f2 = j > 1 ? l2[j - 2] : 0.0;
    const double pivot = a0[j] - f1 * low1 - f2 * low2_before;
    if (!(pivot > 0.0)) return false;
    inverse[j] = 1.0 / pivot;

    // What couples this row to the last two: the corners at the beginning, the band at the end.
    double a = j == 0 ? a2[n - 2] : 0.0;
    double b = j == 0 ? a1[n - 1] : j == 1 ? a2[n - 1] : 0.0;
    if (j == band - 1) {
      a += a1[j];
      b += a2[j];
    } else if (j == band - 2) {
      a += a2[j];
    }
    a -= f1 * edge_a + f2 * edge_a_before;
    b -= f1 * edge_b + f2 * edge_b_before;

    const double c1 = j + 1 < band ? a1[j] - f1 * low2 : 0.0;
    const double c2 = j + 2 < band ? a2[j] : 0.0;
    l1[j] = c1 * inverse[j];
    l2[j] = c2 * inverse[j];
    la[j] = a * inverse[j];
    lb[j] = b * inverse[j];
    aa -= a * la[j];
    ab -= a * lb[j];
    bb -= b * lb[j];
    low1 = c1;
    low2_before = low2;
    low2 = c2;
    edge_a_before = edge_a;
    edge_b_before = edge_b;
    edge_a = a;
    edge_b = b;
  }
  const double determinant = aa * bb - ab * ab;
  if (!(aa > 0.0) || !(determinant > 0.0)) return false;
  corner_aa_ = bb / determinant;
  corner_ab_ = -ab / determinant;
  corner_bb_ = aa / determinant;
  return true;
}

void CyclicBandSolver::solve(double* x) const noexcept {
  const int n = size_, band = n - 2;
  const double *l1 = below_.data(), *l2 = second_below_.data(), *inverse = inverse_pivot_.data();
  const double *la = border_a_.data(), *lb = border_b_.data();
  double a = x[n - 2], b = x[n - 1];
  for (int j = 0; j < band; ++j) {
    if (j > 0) x[j] -= l1[j - 1] * x[j - 1];
    if (j > 1) x[j] -= l2[j - 2] * x[j - 2];
    a -= la[j] * x[j];
    b -= lb[j] * x[j];
  }
  x[n - 2] = corner_aa_ * a + corner_ab_ * b;
  x[n - 1] = corner_ab_ * a + corner_bb_ * b;
  for (int j = band - 1; j >= 0; --j) {
    x[j] = x[j] * inverse[j] - la[j] * x[n - 2] - lb[j] * x[n - 1];
    if (j + 1 < band) x[j] -= l1[j] * x[j + 1];
    if (j + 2 < band) x[j] -= l2[j] * x[j + 2];
  }
}

void CyclicBandSolver::inverse_diagonal(double* out) const noexcept {
  const int n = size_, band = n - 2;
  out[n - 2] = corner_aa_;
  out[n - 1] = corner_bb_;
  // Entries of the inverse between the rows j + 1 and j + 2 and the last two.
  double z11 = 0.0, z12 = 0.0, z22 = 0.0, z1a = 0.0, z1b = 0.0, z2a = 0.0, z2b = 0.0;
  for (int j = band - 1; j >= 0; --j) {
    const double f1 = j + 1 < band ? below_[static_cast<std::size_t>(j)] : 0.0;
    const double f2 = j + 2 < band ? second_below_[static_cast<std::size_t>(j)] : 0.0;
    const double fa = border_a_[static_cast<std::size_t>(j)], fb = border_b_[static_cast<std::size_t>(j)];
    const double z1 = -(f1 * z11 + f2 * z12 + fa * z1a + fb * z1b);
    const double z2 = -(f1 * z12 + f2 * z22 + fa * z2a + fb * z2b);
    const double za = -(f1 * z1a + f2 * z2a + fa * corner_aa_ + fb * corner_ab_);
    const double zb = -(f1 * z1b + f2 * z2b + fa * corner_ab_ + fb * corner_bb_);
    const double z0 = inverse_pivot_[static_cast<std::size_t>(j)] - (f1 * z1 + f2 * z2 + fa * za + fb * zb);
    out[j] = z0;
    z22 = z11;
    z2a = z1a;
    z2b = z1b;
    z12 = z1;
    z11 = z0;
    z1a = za;
    z1b = zb;
  }
}

}  // namespace pellucida
