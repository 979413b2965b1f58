#pragma once
#include "pellucida/membrane/TriangleMesh.h"

namespace pellucida {

/// How the model's sphere is triangulated.
struct SphereMeshOptions {
  int frequency =
      8;  ///< each edge of an icosahedron in so many parts: 10 f^2 + 2 nodes. 1..100; even: nodes on the poles
  double grading = 1.0;  ///< > 0; nodes lie so many times closer at the +z pole than at the equator (and farther at -z)
};

/// A geodesic sphere with a regular six-sided lattice about both poles (+z and -z) and the planes x = 0 and y = 0 as
/// mirrors: needle at +z and holder anywhere in the plane y = 0 leave a symmetric problem symmetric, whichever side the
/// holder is on. Grading is the conformal map tan(theta'/2) = tan(theta/2) / grading, which keeps the triangles'
/// angles. Throws UsageError when an option is out of range.
TriangleMesh make_sphere_mesh(double radius_um, const SphereMeshOptions& options);

}  // namespace pellucida
