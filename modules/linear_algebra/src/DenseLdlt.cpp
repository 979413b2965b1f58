#include "DenseLdlt.h"

#include <algorithm>
#include <cstring>

#include "pellucida/linear_algebra/InstructionSet.h"

namespace pellucida {
namespace {

/// Columns eliminated together before the rest is updated.
constexpr int kBlockColumns = 24;
/// Columns of the matrix that a micro-kernel updates at once.
constexpr int kTileColumns = 4;

#define PELLUCIDA_INLINE inline __attribute__((always_inline))

/// A register of W numbers.
template <int W>
struct Lanes {
  using Type __attribute__((vector_size(W * sizeof(double)))) = double;
};

template <int W>
PELLUCIDA_INLINE void load(typename Lanes<W>::Type& to, const double* from) {
  std::memcpy(&to, from, sizeof(to));
}

/// target -= strip * tile: 2 W rows by kTileColumns columns, the sum over `depth` products taken in order.
template <int W>
PELLUCIDA_INLINE void subtract_product(const double* strip, const double* tile, int depth, double* target,
                                       std::ptrdiff_t stride) {
  using Vector = typename Lanes<W>::Type;
  Vector sum[2][kTileColumns] = {};
  for (int k = 0; k < depth; ++k) {
    Vector low, high;
    load<W>(low, strip);
    load<W>(high, strip + W);
    for (int c = 0; c < kTileColumns; ++c) {
      sum[0][c] += low * tile[c];
      sum[1][c] += high * tile[c];
    }
    strip += 2 * W;
    tile += kTileColumns;
  }
  for (int c = 0; c < kTileColumns; ++c) {
    for (int half = 0; half < 2; ++half) {
      double* place = target + c * stride + half * W;
      Vector value;
      load<W>(value, place);
      value -= sum[half][c];
      std::memcpy(place, &value, sizeof(value));
    }
  }
}

/// target(i, j) -= sum_k L(i, k) d_k L(j, k) for the lower half of `columns` columns: `l` points at L's row of the
/// target's first row, its columns `l_stride` apart, d_k at pivot[k (l_stride + 1)].
template <int W>
PELLUCIDA_INLINE void update_lower(double* target, std::ptrdiff_t stride, int rows, int columns, const double* l,
                                   std::ptrdiff_t l_stride, const double* pivot, int depth, DenseWorkspace& workspace) {
  constexpr int kStripRows = 2 * W;
  const int tile_count = (columns + kTileColumns - 1) / kTileColumns;
  const auto tile_size = static_cast<std::size_t>(depth) * kTileColumns;
  workspace.tiles.resize(std::max(workspace.tiles.size(), tile_size * static_cast<std::size_t>(tile_count)));
  workspace.strip.resize(std::max(workspace.strip.size(), static_cast<std::size_t>(depth) * kStripRows));

  // D L^T of these columns, tile by tile; missing columns are zero.
  for (int t = 0; t < tile_count; ++t) {
    double* tile = workspace.tiles.data() + static_cast<std::size_t>(t) * tile_size;
    const int first = t * kTileColumns, count = std::min(kTileColumns, columns - first);
    for (int k = 0; k < depth; ++k, tile += kTileColumns) {
      const double d = pivot[k * (l_stride + 1)];
      for (int c = 0; c < kTileColumns; ++c) tile[c] = c < count ? d * l[k * l_stride + first + c] : 0.0;
    }
  }

  // Strip by strip of rows, every tile that reaches below the diagonal.
  for (int row = 0; row < rows; row += kStripRows) {
    const int count = std::min(kStripRows, rows - row);
    double* strip = workspace.strip.data();
    if (count == kStripRows) {
      for (int k = 0; k < depth; ++k)
        std::memcpy(strip + k * kStripRows, l + k * l_stride + row, sizeof(double) * kStripRows);
    } else {
      for (int k = 0; k < depth; ++k) {
        for (int r = 0; r < kStripRows; ++r) strip[k * kStripRows + r] = r < count ? l[k * l_stride + row + r] : 0.0;
      }
    }
    const int last_tile = std::min(tile_count, (row + count - 1) / kTileColumns + 1);
    for (int t = 0; t < last_tile; ++t) {
      const double* tile = workspace.tiles.data() + static_cast<std::size_t>(t) * tile_size;
      const int column = t * kTileColumns, width = std::min(kTileColumns, columns - column);
      double* corner = target + column * stride + row;
      if (count == kStripRows && width == kTileColumns) {
        subtract_product<W>(strip, tile, depth, corner, stride);
        continue;
      }
      // At the edge: by way of a whole tile.
      double whole[kStripRows * kTileColumns] = {};
      for (int c = 0; c < width; ++c) std::copy_n(corner + c * stride, count, whole + c * kStripRows);
      subtract_product<W>(strip, tile, depth, whole, kStripRows);
      for (int c = 0; c < width; ++c) std::copy_n(whole + c * kStripRows, count, corner + c * stride);
    }
  }
}

template <int W>
PELLUCIDA_INLINE void eliminate(double* panel, double* rest, int rows, int pivots, DenseWorkspace& workspace) {
  const std::ptrdiff_t stride = rows;
  for (int begin = 0; begin < pivots; begin += kBlockColumns) {
    const int end = std::min(pivots, begin + kBlockColumns);

    // Column by column inside the block.
    for (int j = begin; j < end; ++j) {
      double* column = panel + j * stride;
      const double pivot = column[j];
      const double inverse = 1.0 / pivot;
      for (int k = j + 1; k < end; ++k) {
        const double factor = column[k] * inverse;
        double* other = panel + k * stride;
        for (int i = k; i < rows; ++i) other[i] -= column[i] * factor;
      }
      for (int i = j + 1; i < rows; ++i) column[i] *= inverse;
    }

    // The panel's columns to the right.
    if (end < pivots) {
      update_lower<W>(panel + end * (stride + 1), stride, rows - end, pivots - end, panel + begin * stride + end,
                      stride, panel + begin * (stride + 1), end - begin, workspace);
    }
  }
  if (rows > pivots) {
    update_lower<W>(rest, rows - pivots, rows - pivots, rows - pivots, panel + pivots, stride, panel, pivots,
                    workspace);
  }
}

void eliminate_plain(double* panel, double* rest, int rows, int pivots, DenseWorkspace& workspace) {
  eliminate<2>(panel, rest, rows, pivots, workspace);
}

#if defined(__x86_64__)
// By default GCC splits 512-bit vectors in two; clang doesn't know the word.
#if defined(__clang__)
#define PELLUCIDA_AVX512 "avx512f"
#else
#define PELLUCIDA_AVX512 "avx512f,prefer-vector-width=512"
#endif
__attribute__((target("avx2"))) void eliminate_avx2(double* panel, double* rest, int rows, int pivots,
                                                    DenseWorkspace& workspace) {
  eliminate<4>(panel, rest, rows, pivots, workspace);
}
__attribute__((target(PELLUCIDA_AVX512))) void eliminate_avx512(double* panel, double* rest, int rows, int pivots,
                                                                DenseWorkspace& workspace) {
  eliminate<8>(panel, rest, rows, pivots, workspace);
}
#endif

}  // namespace

void eliminate_columns(double* panel, double* rest, int rows, int pivots, DenseWorkspace& workspace) {
  switch (instruction_set()) {
#if defined(__x86_64__)
    case InstructionSet::kAvx512:
      return eliminate_avx512(panel, rest, rows, pivots, workspace);
    case InstructionSet::kAvx2:
      return eliminate_avx2(panel, rest, rows, pivots, workspace);
#endif
    default:
      return eliminate_plain(panel, rest, rows, pivots, workspace);
  }
}

}  // namespace pellucida
