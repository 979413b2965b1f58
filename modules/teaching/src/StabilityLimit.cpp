#include "pellucida/teaching/StabilityLimit.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace pellucida {
namespace {

constexpr double kDifference_um = 1e-4;
constexpr int kMostLanczosSteps = 60;
constexpr int kMostStepUpdates = 6;
constexpr double kStepTolerance = 1e-4;

using Vector = Eigen::VectorXd;

Eigen::Matrix3Xd as_nodes(const Vector& v) {
  return Eigen::Map<const Eigen::Matrix3Xd>(v.data(), 3, v.size() / 3);
}
Vector as_vector(const Eigen::Matrix3Xd& nodes) {
  return Eigen::Map<const Vector>(nodes.data(), nodes.size());
}

Vector stiffness_times(const Dynamics& dynamics, const Eigen::Matrix3Xd& x_um, const Vector& mode) {
  const Eigen::Matrix3Xd shift_um = kDifference_um * as_nodes(mode);
  Eigen::Matrix3Xd above = Eigen::Matrix3Xd::Zero(3, x_um.cols()), below = above;
  dynamics.energy.add(x_um + shift_um, &above, nullptr);
  dynamics.energy.add(x_um - shift_um, &below, nullptr);
  return as_vector(above - below) / (2.0 * kDifference_um);
}

Vector damping_times(const Dynamics& dynamics, const Eigen::Matrix3Xd& x_um, const Vector& mode) {
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, x_um.cols());
  dynamics.springs.add_damping(x_um, as_nodes(mode), dynamics.damping_uN_s_per_um, force);
  return -as_vector(force);
}

/// The largest eigenvalue of a symmetric operator; `mode` is the start, and its eigenvector afterwards (unit).
double largest_eigenvalue(const std::function<Vector(const Vector&)>& apply, Vector& mode, int steps) {
  std::vector<Vector> basis{mode.normalized()};
  Eigen::MatrixXd small = Eigen::MatrixXd::Zero(steps, steps);
  int size = 0;
  for (int k = 0; k < steps; ++k) {
    Vector next = apply(basis[static_cast<std::size_t>(k)]);
    small(k, k) = basis[static_cast<std::size_t>(k)].dot(next);
    size = k + 1;
    // Orthogonal to all before, twice: the plain recurrence loses that.
    for (int round = 0; round < 2; ++round) {
      for (const Vector& one : basis) next -= one.dot(next) * one;
    }
    const double rest = next.norm();
    if (size == steps || !(rest > 1e-10 * std::abs(small(0, 0)))) break;
    small(k, k + 1) = small(k + 1, k) = rest;
    basis.push_back(next / rest);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(small.topLeftCorner(size, size));
  mode.setZero();
  for (int k = 0; k < size; ++k) mode += solved.eigenvectors()(k, size - 1) * basis[static_cast<std::size_t>(k)];
  mode.normalize();
  return solved.eigenvalues()[size - 1];
}

}  // namespace

StabilityLimit StabilitySolver::solve(const Dynamics& dynamics, const Eigen::Matrix3Xd& x_um, IntegratorKind kind,
                                      int lanczos_steps) {
  const int steps = std::min(lanczos_steps, kMostLanczosSteps);
  if (mode_.size() != x_um.size()) {
    std::mt19937 generator(1u);
    std::normal_distribution<double> deviate;
    mode_.resize(x_um.size());
    for (double& part : mode_) part = deviate(generator);
  }
  const double mass_kg = dynamics.node_mass_kg;
  const auto stiffness = [&](const Vector& v) { return stiffness_times(dynamics, x_um, v); };
  StabilityLimit limit;
  limit.stiffest_mode_uN_per_um = largest_eigenvalue(stiffness, mode_, steps);
  limit.omega_max_per_s = std::sqrt(std::max(0.0, limit.stiffest_mode_uN_per_um) / mass_kg);
  if (kind == IntegratorKind::kImplicitEuler || !(limit.omega_max_per_s > 0.0)) return limit;
  if (kind == IntegratorKind::kLinearAcceleration) {
    limit.stable_step_s = std::sqrt(12.0) / limit.omega_max_per_s;
    return limit;
  }
  limit.stable_step_s = 2.0 / limit.omega_max_per_s;
  if (!(dynamics.damping_uN_s_per_um > 0.0)) return limit;

  // The step at which dt^2 K + 2 dt B reaches 4 m in the mode where it is largest; that mode depends on the step.
  Vector mode = mode_;
  for (int k = 0; k < kMostStepUpdates; ++k) {
    const double dt_s = limit.stable_step_s;
    largest_eigenvalue(
        [&](const Vector& v) -> Vector {
          return dt_s * dt_s * stiffness(v) + 2.0 * dt_s * damping_times(dynamics, x_um, v);
        },
        mode, steps);
    const double a = mode.dot(stiffness(mode)), b = mode.dot(damping_times(dynamics, x_um, mode));
    limit.stable_step_s = a > 0.0 ? (std::sqrt(b * b + 4.0 * a * mass_kg) - b) / a : 2.0 * mass_kg / b;
    if (std::abs(limit.stable_step_s - dt_s) < kStepTolerance * dt_s) break;
  }
  return limit;
}

}  // namespace pellucida
