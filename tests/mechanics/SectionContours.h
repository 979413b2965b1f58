#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/membrane/TriangleMesh.h"

namespace pellucida::testing {

/// Both contours of a model whose nodes are at `x_um` (frame C): the section y = 0, half a thickness to both sides, in
/// the image frame given by centre and the unit vector `z` (C's z in the image; C's y is out of it).
inline void add_contours(Observation& o, const TriangleMesh& rest, const Eigen::Matrix3Xd& x_um,
                         const Eigen::Vector2d& z, double thickness_um) {
  std::vector<int> nodes;
  for (Eigen::Index n = 0; n < rest.points_um.cols(); ++n) {
    if (std::abs(rest.points_um(1, n)) < 1e-6) nodes.push_back(static_cast<int>(n));
  }
  const auto angle = [&](int n) { return std::atan2(rest.points_um(0, n), rest.points_um(2, n)); };
  std::sort(nodes.begin(), nodes.end(), [&](int a, int b) { return angle(a) < angle(b); });

  // C's x is y cross z, y the image's normal: (-z.y, z.x).
  const Eigen::Vector2d x(-z.y(), z.x());
  const auto place = [&](int n) -> Eigen::Vector2d { return o.center_um + x_um(0, n) * x + x_um(2, n) * z; };
  const std::size_t count = nodes.size();
  Contour_um outer(2, static_cast<Eigen::Index>(count)), inner(2, static_cast<Eigen::Index>(count));
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector2d along = place(nodes[(k + 1) % count]) - place(nodes[(k + count - 1) % count]);
    Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()).normalized();
    const Eigen::Vector2d right = x, up = z;
    if (right.x() * up.y() - right.y() * up.x() < 0.0) normal = -normal;
    outer.col(static_cast<Eigen::Index>(k)) = place(nodes[k]) + 0.5 * thickness_um * normal;
    inner.col(static_cast<Eigen::Index>(k)) = place(nodes[k]) - 0.5 * thickness_um * normal;
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(count));
  o.outer = MembraneContour{Membrane::kOuter, outer, 0.1 * ones, ones};
  o.inner = MembraneContour{Membrane::kInner, inner, 0.1 * ones, ones};
}

}  // namespace pellucida::testing
