#pragma once
#include <cstddef>
#include <vector>

namespace pellucida {

/// Memory that `eliminate_columns` uses; kept by the caller from one front to the next.
struct DenseWorkspace {
  std::vector<double> strip;  ///< packed rows of L
  std::vector<double> tiles;  ///< packed columns of D L^T
};

/// Eliminates the first `pivots` columns of a symmetric dense matrix of `rows` rows, of which only the lower half is
/// looked at: afterwards `panel` holds L (unit diagonal, not stored) below the diagonal and D on it, and `rest` the
/// Schur complement. No pivoting: a vanishing pivot gives numbers that are not finite.
///
/// `panel` (rows x pivots) and `rest` ((rows - pivots) x (rows - pivots)) are column-major without gaps. Written for
/// SSE2, AVX2 and AVX-512, chosen as the program starts; each entry's operations and their order are the same in all
/// three and no multiplication is fused with an addition, so that the result is the same to the last bit.
void eliminate_columns(double* panel, double* rest, int rows, int pivots, DenseWorkspace& workspace);

}  // namespace pellucida
