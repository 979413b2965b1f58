#pragma once
#include <Eigen/Core>
#include <optional>

#include "GrayImage.h"

namespace pellucida {

/// Where a level set starts and what moves it. Ratios are of the mean radius of the start.
struct LevelSetSettings {
  double propagation = 0.0;   ///< > 0 grows until it meets an edge, < 0 shrinks, 0 only settles into edges near by
  double curvature = 0.6;     ///< smoothness
  double advection = 2.0;     ///< pull of the edges
  double margin_ratio = 0.5;  ///< how far beyond the start the region of interest reaches
  int iterations = 160;       ///< at most
  int radius_px = 36;         ///< the region of interest is reduced until the start's radius is about that
};

/// Refines a rough closed outline by a geodesic active contour (Caselles, Kimmel, Sapiro 1997), an embedding phi moved
/// by
///
///     d phi / dt = -A grad g . grad phi - P g |grad phi| + C g kappa |grad phi|,   g = 1 / (1 + (|grad I| / k)^2)
///
/// with A, P, C the settings' advection, propagation, curvature, kappa the curvature, grad I taken at the scale of two
/// reduced pixels, and k twice the median of |grad I| over the region of interest: an edge is what stands out from the
/// picture's own texture. `outline` (2 x n, px, n >= 3, any orientation).
/// Returns 128 points (positive area) where rays from the centre of the enclosed area leave it; nothing where the
/// contour has collapsed, or has run into the border of the region of interest on more than a quarter of the rays.
/// Cost: about 20 ms, whatever the size of the cell; allocates.
std::optional<Eigen::Matrix2Xd> refine_by_level_set(const GrayImage& image, const Eigen::Matrix2Xd& outline,
                                                    const LevelSetSettings& settings = {});

}  // namespace pellucida
