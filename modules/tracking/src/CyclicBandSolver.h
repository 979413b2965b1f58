#pragma once
#include <vector>

namespace pellucida {

/// Symmetric positive definite system with two bands on each side of the diagonal that close round the corners, as of a
/// closed snake: A(i, i), A(i, i+1), A(i, i+2), indices modulo n. Root-free Cholesky of the first n - 2 rows as a band,
/// with the last two as a dense border that takes up all the fill. Cost about 40 n flops; memory is kept.
class CyclicBandSolver {
 public:
  /// n >= 5 unknowns, all entries 0.
  void reset(int n);
  int size() const noexcept { return size_; }

  // Entries to fill before factorize(): A(i, i), A(i, (i+1) % n), A(i, (i+2) % n).
  double* diagonal() noexcept { return diagonal_.data(); }
  double* next() noexcept { return next_.data(); }
  double* second_next() noexcept { return second_next_.data(); }

  /// False when the matrix is not positive definite; nothing may be solved then.
  bool factorize() noexcept;
  /// Replaces the right-hand side by the solution.
  void solve(double* x) const noexcept;
  /// The diagonal of the inverse, entry by entry, by Takahashi's recursion over the factor's own pattern.
  void inverse_diagonal(double* out) const noexcept;

 private:
  int size_ = 0;
  std::vector<double> diagonal_, next_, second_next_;
  // The factor: pivots, the band below them, and the last two rows.
  std::vector<double> inverse_pivot_, below_, second_below_, border_a_, border_b_;
  double corner_aa_ = 1.0, corner_ab_ = 0.0, corner_bb_ = 1.0;  // inverse of the last 2 x 2 block
};

}  // namespace pellucida
