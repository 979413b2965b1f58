#pragma once
#include <vtkPolyData.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace pellucida {

/// Carries what the model knows at its nodes to the nodes of a drawn surface, by the direction of both from the cell's
/// centre at rest. Two maps:
/// - extensive (force): each model node's share goes to the surface nodes round it in proportion to their area, and all
/// of it:
///   the columns sum to one, so that the sum of forces is kept. A model node with no surface node near gives to the
///   nearest.
/// - intensive (tension): barycentric interpolation in the model's triangles.
/// Only surface nodes marked as `carrier` take part in the extensive map.
class ForceTransfer {
 public:
  /// `model_directions` (3 x n) unit, `triangles` (3 x m) of the model; `surface_directions` (3 x s) unit;
  /// `surface_areas` (s) area of each surface node at rest in any unit, 0 for those that carry nothing.
  ForceTransfer(const Eigen::Matrix3Xd& model_directions, const Eigen::Matrix3Xi& triangles,
                const Eigen::Matrix3Xd& surface_directions, const Eigen::VectorXd& surface_areas);

  const Eigen::SparseMatrix<double, Eigen::RowMajor>& extensive() const noexcept { return extensive_; }  ///< (s x n)
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& intensive() const noexcept { return intensive_; }  ///< (s x n)

 private:
  Eigen::SparseMatrix<double, Eigen::RowMajor> extensive_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> intensive_;
};

}  // namespace pellucida
