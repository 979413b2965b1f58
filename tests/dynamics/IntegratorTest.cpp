// Time stepping: order, stability limits, energy, and the explicit kernel. Prints the tables of the module's README.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>

#include "pellucida/dynamics/ExplicitSprings.h"
#include "pellucida/dynamics/Integrator.h"
#include "pellucida/linear_algebra/InstructionSet.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/membrane/SphereMesh.h"
#include "support/TestProfiles.h"

namespace pellucida {
namespace {

using testing::coarse_profile;
using testing::shaken;
using Maker = std::unique_ptr<Integrator> (*)(const Dynamics&);

struct Specimen {
  explicit Specimen(double node_mass_kg, double damping_uN_s_per_um = 0.0)
      : model(coarse_profile(), setup_for_configuration(coarse_profile(), 1)),
        dynamics{model.energy(), model.springs(), node_mass_kg, damping_uN_s_per_um} {}

  MotionState at_rest() const {
    return {model.rest().points_um, Eigen::Matrix3Xd::Zero(3, model.rest().points_um.cols())};
  }

  /// The highest angular frequency at rest, by power iteration on the gradient's change.
  double highest_frequency_per_s() const {
    const Eigen::Matrix3Xd rest = model.rest().points_um;
    Eigen::Matrix3Xd mode = shaken(Eigen::Matrix3Xd::Zero(3, rest.cols()), 1.0, 5u);
    double stiffness = 0.0;
    for (int k = 0; k < 400; ++k) {
      mode /= mode.norm();
      Eigen::Matrix3Xd above = Eigen::Matrix3Xd::Zero(3, rest.cols()), below = above;
      model.energy().add(rest + 1e-4 * mode, &above, nullptr);
      model.energy().add(rest - 1e-4 * mode, &below, nullptr);
      mode = (above - below) / 2e-4;
      stiffness = mode.norm();
    }
    return std::sqrt(stiffness / dynamics.node_mass_kg);
  }

  MembraneModel model;
  Dynamics dynamics;
};

/// Whether free vibration from a small shake stays small.
bool is_stable(Maker make, double dt_s, int steps) {
  Specimen specimen(1e-8);
  MotionState state = specimen.at_rest();
  state.v_um_per_s = shaken(state.v_um_per_s, 0.01, 3u);
  const double energy = specimen.dynamics.total_energy_uN_um(state);
  const auto integrator = make(specimen.dynamics);
  for (int k = 0; k < steps; ++k) {
    if (!integrator->step(state, dt_s)) return false;
    if (!(state.v_um_per_s.squaredNorm() * 0.5e-8 < 30.0 * energy)) return false;
  }
  return true;
}

/// The largest stable step, as a multiple of 1 / omega_max, to 2 %.
double stability_limit(Maker make, double low, double high, int steps) {
  const double frequency = Specimen(1e-8).highest_frequency_per_s();
  while (high / low > 1.02) {
    const double middle = std::sqrt(low * high);
    (is_stable(make, middle / frequency, steps) ? low : high) = middle;
  }
  return low;
}

TEST(StabilityLimit, IsTwoOverTheHighestFrequencyForSymplecticEuler) {
  const double limit = stability_limit(make_symplectic_euler, 1.0, 4.0, 400);
  const double physical_s = 2.0 / Specimen(1e-12).highest_frequency_per_s();
  std::printf("symplectic Euler: stable below %.2f / omega_max; 2 / omega_max is %.2g s at 1e-12 kg a node\n", limit,
              physical_s);
  EXPECT_NEAR(limit, 2.0, 0.04);
}

TEST(StabilityLimit, IsTheSquareRootOfTwelveOverTheHighestFrequencyForLinearAcceleration) {
  const double limit = stability_limit(make_linear_acceleration, 2.5, 5.0, 200);
  std::printf("linear acceleration: stable below %.2f / omega_max\n", limit);
  EXPECT_NEAR(limit, std::sqrt(12.0), 0.02);
}

TEST(StabilityLimit, HasImplicitEulerNone) {
  const double frequency = Specimen(1e-8).highest_frequency_per_s();
  for (const double multiple : {3.0, 30.0, 1000.0}) {
    EXPECT_TRUE(is_stable(make_implicit_euler, multiple / frequency, 40)) << multiple;
  }
}

/// Free vibration of the pressed and released membrane for about twenty periods of the slowest modes. Returns the
/// energy at the end over that at the start, less one, and the largest excursion of it on the way.
std::pair<double, double> energy_change(Maker make, double dt_s, double duration_s) {
  Specimen specimen(1e-8);
  MotionState state = specimen.at_rest();
  for (Eigen::Index n = 0; n < state.x_um.cols(); ++n) {
    const double z = state.x_um(2, n) / 50.0;
    state.v_um_per_s.col(n) =
        400.0 * Eigen::Vector3d(-0.5 * state.x_um(0, n) / 50.0, -0.5 * state.x_um(1, n) / 50.0, z);
  }
  const double begin = specimen.dynamics.total_energy_uN_um(state);
  const auto integrator = make(specimen.dynamics);
  double worst = 0.0;
  for (double t = 0.0; t < duration_s; t += dt_s) {
    EXPECT_TRUE(integrator->step(state, dt_s));
    worst = std::max(worst, std::abs(specimen.dynamics.total_energy_uN_um(state) / begin - 1.0));
  }
  return {specimen.dynamics.total_energy_uN_um(state) / begin - 1.0, worst};
}

TEST(EnergyDrift, IsNoneForSymplecticEulerLittleForLinearAccelerationAndALossForImplicitEuler) {
  constexpr double kDuration_s = 0.004;
  const double dt_s = 0.5 / Specimen(1e-8).highest_frequency_per_s();
  const auto symplectic = energy_change(make_symplectic_euler, dt_s, kDuration_s);
  const auto linear = energy_change(make_linear_acceleration, dt_s, kDuration_s);
  const auto implicit = energy_change(make_implicit_euler, dt_s, kDuration_s);
  std::printf(
      "free vibration, dt = %.2g s, %.3f s: energy %+.4f (symplectic Euler; within %.4f), %+.4f (linear "
      "acceleration; within %.4f), %+.4f (implicit Euler)\n",
      dt_s, kDuration_s, symplectic.first, symplectic.second, linear.first, linear.second, implicit.first);
  EXPECT_LT(symplectic.second, 0.05);
  EXPECT_LT(linear.second, 0.0016);
  EXPECT_LT(implicit.first, -0.1);
}

/// Two per cent along z at the same volume.
void stretch(Eigen::Matrix3Xd& x_um) {
  x_um.row(2) *= 1.02;
  x_um.topRows<2>() /= std::sqrt(1.02);
}

/// Error of the displacement after a short motion against a far finer one.
double motion_error(Maker make, double dt_s, double duration_s, const Eigen::Matrix3Xd& exact_um) {
  Specimen specimen(1e-6, 1e-5);
  MotionState state = specimen.at_rest();
  stretch(state.x_um);
  state.v_um_per_s.row(0) = 2.0 * state.x_um.row(1);
  const auto integrator = make(specimen.dynamics);
  const int steps = static_cast<int>(std::lround(duration_s / dt_s));
  for (int k = 0; k < steps; ++k) EXPECT_TRUE(integrator->step(state, dt_s));
  return exact_um.size() == 0 ? 0.0 : (state.x_um - exact_um).norm();
}

Eigen::Matrix3Xd fine_motion(double duration_s) {
  Specimen specimen(1e-6, 1e-5);
  MotionState state = specimen.at_rest();
  stretch(state.x_um);
  state.v_um_per_s.row(0) = 2.0 * state.x_um.row(1);
  const auto integrator = make_linear_acceleration(specimen.dynamics);
  for (int k = 0; k < 256; ++k) EXPECT_TRUE(integrator->step(state, duration_s / 256));
  return state.x_um;
}

TEST(Order, IsOneForTheEulersAndTwoForLinearAccelerationWithoutDampers) {
  constexpr double kDuration_s = 2e-4;
  const Eigen::Matrix3Xd exact = fine_motion(kDuration_s);
  for (const auto& [make, order] : {std::pair<Maker, double>{make_symplectic_euler, 1.0},
                                    {make_implicit_euler, 1.0},
                                    {make_linear_acceleration, 2.0}}) {
    const double coarse = motion_error(make, kDuration_s / 16, kDuration_s, exact);
    const double fine = motion_error(make, kDuration_s / 32, kDuration_s, exact);
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.022);
  }
}

/// The force after a ramp of 20 um/s to 6 um, over the quasi-static one.
double ramp_force_ratio(Maker make, double node_mass_kg, double damping_uN_s_per_um, double dt_s) {
  constexpr double kSpeed_um_per_s = 20.0, kDepth_um = 6.0;
  Specimen specimen(node_mass_kg, damping_uN_s_per_um);
  MotionState state = specimen.at_rest();
  const auto integrator = make(specimen.dynamics);
  const int steps = static_cast<int>(std::lround(kDepth_um / kSpeed_um_per_s / dt_s));
  for (int k = 1; k <= steps; ++k) {
    specimen.model.set_depth(kDepth_um * k / steps);
    EXPECT_TRUE(integrator->step(state, dt_s));
  }
  const double force = specimen.model.tip().force_uN(state.x_um).dot(specimen.model.setup().push);
  Indenter indenter(coarse_profile(), setup_for_configuration(coarse_profile(), 1));
  return force / indenter.advance_to(kDepth_um).push_force_uN;
}

TEST(RampForce, IsQuasiStaticWithLittleMassOrImplicitSteps) {
  const double light = ramp_force_ratio(make_symplectic_euler, 1e-8, 1e-5, 1e-5);
  const double heavy = ramp_force_ratio(make_symplectic_euler, 1e-6, 1e-5, 1e-4);
  const double linear = ramp_force_ratio(make_linear_acceleration, 1e-6, 1e-5, 2e-4);
  const double implicit = ramp_force_ratio(make_implicit_euler, 1e-12, 1e-5, 1.0 / 120.0);
  std::printf(
      "ramp of 20 um/s to 6 um, b = 1e-5 uN s/um, force over quasi-static: symplectic Euler %.3f (1e-8 kg, 10 "
      "us), %.3f (1e-6 kg, 100 us); linear acceleration %.3f (1e-6 kg, 200 us); implicit Euler %.3f (1e-12 kg, "
      "8.3 ms)\n",
      light, heavy, linear, implicit);
  EXPECT_NEAR(light, 1.0, 0.017);
  EXPECT_NEAR(implicit, 1.0, 3e-4);
}

TEST(Damping, NeverAddsEnergyWhateverTheIntegrator) {
  for (const Maker make : {make_implicit_euler, make_linear_acceleration}) {
    Specimen specimen(1e-8, 2e-5);
    MotionState state = specimen.at_rest();
    state.v_um_per_s = shaken(state.v_um_per_s, 20.0, 9u);
    const auto integrator = make(specimen.dynamics);
    double energy = specimen.dynamics.total_energy_uN_um(state);
    const double dt_s = 0.2 / specimen.highest_frequency_per_s();
    for (int k = 0; k < 30; ++k) {
      ASSERT_TRUE(integrator->step(state, dt_s));
      const double next = specimen.dynamics.total_energy_uN_um(state);
      EXPECT_LT(next, energy * (1.0 + 1e-4)) << integrator->name();
      energy = next;
    }
  }
}

class Kernel : public ::testing::TestWithParam<int> {
 protected:
  Kernel()
      : mesh_(make_sphere_mesh(50.0, {GetParam(), 1.3})),
        springs_(mesh_, triangle_pairs(mesh_.triangles),
                 {Eigen::VectorXd::LinSpaced(mesh_.points_um.cols(), 1.0, 3.0),
                  Eigen::VectorXd::LinSpaced(mesh_.points_um.cols(), -0.2, -0.9)}) {}
  TriangleMesh mesh_;
  SpringTerm springs_;
};

TEST_P(Kernel, HasTheForcesOfEquationOne) {
  const Eigen::Index n = mesh_.points_um.cols();
  ExplicitSprings kernel(mesh_, springs_, 1e-8, 3e-3);
  const MotionState state{shaken(mesh_.points_um, 0.5, 4u), shaken(Eigen::Matrix3Xd::Zero(3, n), 30.0, 5u)};
  kernel.set_state(state);
  Eigen::Matrix3Xd expected = Eigen::Matrix3Xd::Zero(3, n);
  springs_.add(state.x_um, &expected, nullptr);
  expected = -expected;
  springs_.add_damping(state.x_um, state.v_um_per_s, 3e-3, expected);
  EXPECT_LT((kernel.spring_force_uN() - expected).cwiseAbs().maxCoeff(), 7e-6 * expected.cwiseAbs().maxCoeff());
  EXPECT_LT((kernel.state().x_um - state.x_um).cwiseAbs().maxCoeff(), 1.2e-7);
  EXPECT_EQ(kernel.spring_count(), springs_.count());
}

TEST_P(Kernel, MovesLikeSymplecticEulerInDoublePrecision) {
  const Eigen::Index n = mesh_.points_um.cols();
  ExplicitSprings kernel(mesh_, springs_, 1e-8, 1e-5);
  const Eigen::Matrix3Xd external = 1e-3 * mesh_.points_um;
  kernel.set_external_force(external);
  MotionState state{shaken(mesh_.points_um, 0.05, 4u), Eigen::Matrix3Xd::Zero(3, n)};
  kernel.set_state(state);
  constexpr double kStep_s = 2e-6;
  constexpr int kSteps = 2000;
  Eigen::Matrix3Xd force(3, n);
  for (int k = 0; k < kSteps; ++k) {
    force.setZero();
    springs_.add(state.x_um, &force, nullptr);
    force = external - force;
    springs_.add_damping(state.x_um, state.v_um_per_s, 1e-5, force);
    state.v_um_per_s += kStep_s / 1e-8 * force;
    state.x_um += kStep_s * state.v_um_per_s;
  }
  kernel.step(kStep_s, kSteps);
  const double moved = (state.x_um - mesh_.points_um).cwiseAbs().maxCoeff();
  EXPECT_GT(moved, 0.1);
  EXPECT_LT((kernel.state().x_um - state.x_um).cwiseAbs().maxCoeff(), 1e-6 * moved);
}

TEST_P(Kernel, GivesTheSameBitsWithAvx2) {
  if (instruction_set() < InstructionSet::kAvx2) {
    GTEST_SKIP() << "this machine has no AVX2: plain code would be compared with itself";
  }
  const MotionState state{shaken(mesh_.points_um, 0.05, 4u), Eigen::Matrix3Xd::Zero(3, mesh_.points_um.cols())};
  std::vector<MotionState> ends;
  for (const auto set : {InstructionSet::kPlain, InstructionSet::kAvx512}) {
    limit_instruction_set(set);
    ExplicitSprings kernel(mesh_, springs_, 1e-8, 1e-5);
    kernel.set_state(state);
    kernel.step(2e-6, 200);
    ends.push_back(kernel.state());
  }
  EXPECT_EQ(ends[0].x_um, ends[1].x_um);
  EXPECT_EQ(ends[0].v_um_per_s, ends[1].v_um_per_s);
  EXPECT_NE(ends[0].x_um, state.x_um);
}

TEST_P(Kernel, LosesNoSmallStep) {
  // 3 um/s for a second in steps of 3e-7 um, far below the spacing of single precision at the place reached.
  ExplicitSprings kernel(mesh_, springs_, 1e-8, 0.0);
  MotionState state{mesh_.points_um, Eigen::Vector3d(3.0, 0.0, 0.0).replicate(1, mesh_.points_um.cols())};
  state.x_um.row(0).array() += 20.0;
  kernel.set_state(state);
  kernel.step(1e-7, 20000);
  EXPECT_NEAR((kernel.state().x_um.row(0) - state.x_um.row(0)).mean(), 3.0 * 2e-3, 8e-8);
}

INSTANTIATE_TEST_SUITE_P(Frequencies, Kernel, ::testing::Values(1, 4, 9));

}  // namespace
}  // namespace pellucida
