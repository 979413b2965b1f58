#include "pellucida/bench/MechanicsBench.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

#include "pellucida/dynamics/ExplicitSprings.h"
#include "pellucida/linear_algebra/InstructionSet.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/membrane/SphereMesh.h"

namespace pellucida {
namespace {

/// Processor time of this thread, us: other programs don't count.
double thread_time_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// Eq. (1) and (4) as one would write them down.
void naive_step(const SpringTerm& springs, double node_mass_kg, double damping_uN_s_per_um, double dt_s,
                MotionState& state, Eigen::Matrix3Xd& force_uN) {
  force_uN.setZero();
  for (const auto& s : springs.springs()) {
    const Eigen::Vector3d p = state.x_um.col(s.i) - state.x_um.col(s.j);
    const Eigen::Vector3d v = state.v_um_per_s.col(s.i) - state.v_um_per_s.col(s.j);
    const double length = p.norm();
    const double strain = length / s.rest_length_um - 1.0;
    const double k =
        s.area_um2 / (s.rest_length_um * s.rest_length_um) * (s.k2_uN_per_um + s.k1_uN_per_um * strain * strain);
    const Eigen::Vector3d f =
        (k * (s.rest_length_um / length - 1.0) - damping_uN_s_per_um * v.dot(p) / p.squaredNorm()) * p;
    force_uN.col(s.i) += f;
    force_uN.col(s.j) -= f;
  }
  state.v_um_per_s += (dt_s / node_mass_kg) * force_uN;
  state.x_um += dt_s * state.v_um_per_s;
}

}  // namespace

SolveTimes measure_warm_solves(CellProfile profile, int mesh_frequency, double step_um, double to_um) {
  profile.mesh_frequency = mesh_frequency;
  Indenter indenter(profile, setup_for_configuration(profile, 1));
  SolveTimes times;
  times.node_count = static_cast<int>(indenter.model().rest().points_um.cols());
  times.spring_count = static_cast<int>(indenter.model().springs().count());
  const int steps = static_cast<int>(to_um / step_um);
  int factorizations = 0;
  for (int k = 1; k <= 2 * steps; ++k) {
    const double depth_um = step_um * (k <= steps ? k : 2 * steps - k);
    const double start_us = thread_time_us();
    const IndentationState state = indenter.advance_to(depth_um);
    const double taken_us = thread_time_us() - start_us;
    if (state.report.status != SolveStatus::kConverged) ++times.failed_count;
    if (depth_um < 1.0) continue;
    times.step_us.push_back(taken_us);
    factorizations += state.report.factorizations;
  }
  times.factorizations_per_frame = factorizations / static_cast<double>(times.step_us.size());
  return times;
}

ExplicitTimes measure_explicit_steps(CellProfile profile, int mesh_frequency, double seconds) {
  // A mesh and connectors; what they are attached to doesn't matter here.
  const TriangleMesh mesh = make_sphere_mesh(profile.mid_radius_um, {mesh_frequency, profile.mesh_grading});
  const double scale = profile.membrane_stiffness_uN_per_um() * profile.body.k2_ratio;
  const Eigen::Index n = mesh.points_um.cols();
  const SpringTerm springs(
      mesh, triangle_pairs(mesh.triangles),
      {Eigen::VectorXd::Constant(n, scale), Eigen::VectorXd::Constant(n, scale * profile.body.k1_over_k2)});
  ExplicitSprings kernel(mesh, springs, profile.node_mass_kg, profile.damping_uN_s_per_um);
  MotionState state{1.02 * mesh.points_um, Eigen::Matrix3Xd::Zero(3, n)};
  kernel.set_state(state);
  Eigen::Matrix3Xd force(3, n);

  // A step so small that nothing moves far, however many there are.
  constexpr double kStep_s = 1e-9;
  ExplicitTimes times;
  times.node_count = static_cast<int>(n);
  times.spring_count = static_cast<int>(springs.count());
  times.lane_use_ratio = kernel.lane_use_ratio();
  times.ns_per_spring_step = times.plain_ns_per_spring_step = times.naive_ns_per_spring_step =
      std::numeric_limits<double>::infinity();
  const int round = std::max(1, static_cast<int>(2e6 / static_cast<double>(springs.count())));
  const double each_ns = 1e3 / (static_cast<double>(springs.count()) * round);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(3.0 * seconds);
  do {
    double start_us = thread_time_us();
    kernel.step(kStep_s, round);
    times.ns_per_spring_step = std::min(times.ns_per_spring_step, each_ns * (thread_time_us() - start_us));
    limit_instruction_set(InstructionSet::kPlain);
    start_us = thread_time_us();
    kernel.step(kStep_s, round);
    times.plain_ns_per_spring_step = std::min(times.plain_ns_per_spring_step, each_ns * (thread_time_us() - start_us));
    limit_instruction_set(InstructionSet::kAvx512);
    start_us = thread_time_us();
    for (int k = 0; k < round; ++k) {
      naive_step(springs, profile.node_mass_kg, profile.damping_uN_s_per_um, kStep_s, state, force);
    }
    times.naive_ns_per_spring_step = std::min(times.naive_ns_per_spring_step, each_ns * (thread_time_us() - start_us));
  } while (std::chrono::steady_clock::now() < end);
  return times;
}

}  // namespace pellucida
