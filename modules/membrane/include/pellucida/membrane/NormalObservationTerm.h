#pragma once
#include <Eigen/Core>
#include <vector>

#include "pellucida/membrane/EnergyTerm.h"

namespace pellucida {

/// What a camera shows of the surface, as weak evidence: U = 1/2 sum omega_i A_i (n_i . (x_i - y_i))^2, y_i the
/// observed place of node i, n_i the unit normal there, A_i the area the node represents. Only the component along the
/// normal counts: a contour carries no information on where along itself a point came from. Keep omega below about 1e-6
/// uN/um^3 for E h = 0.09 uN/um (it scales with E h): more pulls the force with every error of shape.
class NormalObservationTerm final : public EnergyTerm {
 public:
  /// One node's observation.
  struct Observed {
    int node = 0;
    Eigen::Vector3d place_um = Eigen::Vector3d::Zero();  ///< y
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   ///< n, unit
    double area_um2 = 0.0;                               ///< A, >= 0
    double weight_uN_per_um3 = 0.0;                      ///< omega, >= 0
  };

  /// Sets the observations, any number of times, with or without a solver bound. Throws Error (internal error) when a
  /// node is not one of the bound matrix, or a normal is not of unit length.
  void set(std::vector<Observed> observed);
  const std::vector<Observed>& observed() const noexcept { return observed_; }

  void bind(const BlockMatrix& matrix) override;
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const override;

  /// Root mean square of n . (x - y), weighted with A, um: how far the model is from what is seen. 0 when nothing is.
  double residual_rms_um(const Eigen::Matrix3Xd& x_um) const;
  /// Sum of the forces with which the observations pull, uN: what they add to the balance of tip and holder.
  Eigen::Vector3d force_uN(const Eigen::Matrix3Xd& x_um) const;

 private:
  std::vector<Observed> observed_;
  std::vector<BlockSlot> diagonal_;  // of every node
};

}  // namespace pellucida
