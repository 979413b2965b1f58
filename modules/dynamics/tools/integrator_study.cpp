// What the three ways of stepping eq. (2) in time can do on the oocyte's model, found by experiment: the largest stable
// step, what a step does to the energy of a free vibration, how far the force on a slow ramp is from the quasi-static
// one, and what a second of motion costs. Prints the tables of docs/method.md. No options; about a minute.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <random>
#include <vector>

#include "pellucida/dynamics/Integrator.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/membrane/MembraneModel.h"

namespace {

using namespace pellucida;
using Maker = std::unique_ptr<Integrator> (*)(const Dynamics&);

constexpr double kDamping_uN_s_per_um = 1e-5;
constexpr double kSpeed_um_per_s = 20.0, kDepth_um = 20.0;

struct Method {
  const char* name;
  Maker make;
  double low, high;  // multiples of 1 / omega_max between which its limit lies; high 0: none is sought
};
const Method kMethods[] = {{"symplectic Euler", make_symplectic_euler, 0.02, 4.0},
                           {"implicit Euler", make_implicit_euler, 0.0, 0.0},
                           {"linear acceleration", make_linear_acceleration, 0.02, 6.0}};

double thread_time_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The shipped oocyte in configuration 1 on a coarse mesh: 162 nodes.
CellProfile profile() {
  CellProfile coarse = load_profile("mouse-oocyte");
  coarse.mesh_frequency = 4;
  return coarse;
}

struct Specimen {
  Specimen(double node_mass_kg, double damping_uN_s_per_um)
      : model(profile(), setup_for_configuration(profile(), 1)),
        dynamics{model.energy(), model.springs(), node_mass_kg, damping_uN_s_per_um} {}

  MotionState at_rest() const {
    return {model.rest().points_um, Eigen::Matrix3Xd::Zero(3, model.rest().points_um.cols())};
  }

  MembraneModel model;
  Dynamics dynamics;
};

// The stiffest mode's stiffness at rest, uN/um, by power iteration on the gradient's change.
double highest_stiffness_uN_per_um() {
  Specimen specimen(1.0, 0.0);
  const Eigen::Matrix3Xd rest = specimen.model.rest().points_um;
  std::mt19937 generator(5);
  std::normal_distribution<double> deviate;
  Eigen::Matrix3Xd mode(3, rest.cols());
  for (Eigen::Index k = 0; k < mode.size(); ++k) mode.data()[k] = deviate(generator);
  double stiffness = 0.0;
  for (int k = 0; k < 400; ++k) {
    mode /= mode.norm();
    Eigen::Matrix3Xd above = Eigen::Matrix3Xd::Zero(3, rest.cols()), below = above;
    specimen.model.energy().add(rest + 1e-4 * mode, &above, nullptr);
    specimen.model.energy().add(rest - 1e-4 * mode, &below, nullptr);
    mode = (above - below) / 2e-4;
    stiffness = mode.norm();
  }
  return stiffness;
}

// Whether a small shake stays small.
bool is_stable(Maker make, double node_mass_kg, double damping_uN_s_per_um, double dt_s, int steps) {
  Specimen specimen(node_mass_kg, damping_uN_s_per_um);
  MotionState state = specimen.at_rest();
  std::mt19937 generator(3);
  std::normal_distribution<double> deviate(0.0, 1e-6 / std::sqrt(node_mass_kg));
  for (Eigen::Index k = 0; k < state.v_um_per_s.size(); ++k) state.v_um_per_s.data()[k] = deviate(generator);
  const double begin = state.v_um_per_s.squaredNorm();
  const auto integrator = make(specimen.dynamics);
  for (int k = 0; k < steps; ++k)
    if (!integrator->step(state, dt_s) || !(state.v_um_per_s.squaredNorm() < 30.0 * begin)) return false;
  return true;
}

void print_stability(double stiffness_uN_per_um) {
  std::printf("largest stable step, us (times omega_max), without dampers and with b = %.0e uN s/um\n",
              kDamping_uN_s_per_um);
  std::printf("%-20s %-24s %-24s %-24s\n", "", "1e-6 kg a node", "1e-8 kg", "1e-12 kg");
  for (const Method& method : kMethods) {
    std::printf("%-20s", method.name);
    for (const double mass_kg : {1e-6, 1e-8, 1e-12}) {
      const double frequency_per_s = std::sqrt(stiffness_uN_per_um / mass_kg);
      if (method.high == 0.0) {
        bool stable = true;
        for (const double multiple : {3.0, 30.0, 1000.0})
          for (const double damping : {0.0, kDamping_uN_s_per_um})
            stable = stable && is_stable(method.make, mass_kg, damping, multiple / frequency_per_s, 40);
        std::printf(" %-24s", stable ? "none up to 1000" : "unstable");
        continue;
      }
      char text[64];
      int length = 0;
      for (const double damping : {0.0, kDamping_uN_s_per_um}) {
        double low = method.low / 20, high = method.high;
        while (high / low > 1.03) {
          const double middle = std::sqrt(low * high);
          (is_stable(method.make, mass_kg, damping, middle / frequency_per_s, 300) ? low : high) = middle;
        }
        length += std::snprintf(text + length, sizeof(text) - static_cast<std::size_t>(length), "%s%.3g (%.2f)",
                                damping > 0.0 ? ", " : "", 1e6 * low / frequency_per_s, low);
      }
      std::printf(" %-24s", text);
    }
    std::printf("\n");
  }
}

// Free vibration, 1e-8 kg a node, no dampers: the energy at the end, and how far it strayed on the way.
void print_energy(double stiffness_uN_per_um) {
  constexpr double kMass_kg = 1e-8, kDuration_s = 0.004;
  const double multiples[] = {0.25, 0.5, 1.0, 1.8};
  std::printf("\nfree vibration for %g s, 1e-8 kg a node, no dampers: energy at the end (largest stray), %%\n",
              kDuration_s);
  std::printf("%-20s", "step times omega_max");
  for (const double multiple : multiples) std::printf(" %-16.2f", multiple);
  std::printf("\n");
  for (const Method& method : kMethods) {
    std::printf("%-20s", method.name);
    for (const double multiple : multiples) {
      Specimen specimen(kMass_kg, 0.0);
      MotionState state = specimen.at_rest();
      for (Eigen::Index n = 0; n < state.x_um.cols(); ++n) {
        const Eigen::Vector3d p = state.x_um.col(n) / 50.0;
        state.v_um_per_s.col(n) = 400.0 * Eigen::Vector3d(-0.5 * p.x(), -0.5 * p.y(), p.z());
      }
      const double dt_s = multiple / std::sqrt(stiffness_uN_per_um / kMass_kg);
      const double begin = specimen.dynamics.total_energy_uN_um(state);
      const auto integrator = method.make(specimen.dynamics);
      double worst = 0.0, last = 0.0;
      bool done = true;
      for (double t = 0.0; done && t < kDuration_s; t += dt_s) {
        done = integrator->step(state, dt_s);
        last = specimen.dynamics.total_energy_uN_um(state) / begin - 1.0;
        worst = std::max(worst, std::abs(last));
      }
      char text[32] = "no step";
      if (done) std::snprintf(text, sizeof(text), "%+.2f (%.2f)", 100 * last, 100 * worst);
      std::printf(" %-16s", text);
    }
    std::printf("\n");
  }
}

struct Ramp {
  const Method& method;
  double node_mass_kg, dt_s;
};

// The needle at 20 um/s from rest: force against the quasi-static one, past the first 2 um.
void print_ramps(double stiffness_uN_per_um) {
  const Ramp ramps[] = {{kMethods[0], 1e-6, 1e-4},  {kMethods[0], 1e-8, 1e-5},       {kMethods[2], 1e-6, 2e-4},
                        {kMethods[2], 1e-8, 2e-5},  {kMethods[1], 1e-6, 1e-3},       {kMethods[1], 1e-8, 1e-3},
                        {kMethods[1], 1e-12, 1e-3}, {kMethods[1], 1e-12, 1.0 / 120}, {kMethods[1], 1e-12, 1.0 / 30}};
  std::vector<double> expected;
  Indenter indenter(profile(), setup_for_configuration(profile(), 1));
  constexpr int kSamples = 100;
  for (int k = 0; k <= kSamples; ++k) expected.push_back(indenter.advance_to(kDepth_um * k / kSamples).push_force_uN);
  std::printf(
      "\nramp of %g um/s to %g um, b = %.0e uN s/um: error of the force, %% of the quasi-static one, past 2 um\n",
      kSpeed_um_per_s, kDepth_um, kDamping_uN_s_per_um);
  std::printf("%-20s %8s %9s %10s %8s %8s %14s %14s\n", "", "kg", "step, us", "x omega", "RMS", "at end", "us a step",
              "s per second");
  for (const Ramp& ramp : ramps) {
    Specimen specimen(ramp.node_mass_kg, kDamping_uN_s_per_um);
    MotionState state = specimen.at_rest();
    const auto integrator = ramp.method.make(specimen.dynamics);
    const int steps = static_cast<int>(std::lround(kDepth_um / kSpeed_um_per_s / ramp.dt_s));
    double squares = 0.0, last = 0.0;
    int count = 0, sample = 1;
    bool done = true;
    const double start_s = thread_time_s();
    for (int k = 1; done && k <= steps; ++k) {
      const double depth_um = kDepth_um * k / steps;
      specimen.model.set_depth(depth_um);
      done = integrator->step(state, ramp.dt_s);
      // Between two samples the quasi-static force is all but straight.
      if (depth_um + 1e-9 < kDepth_um * sample / kSamples) continue;
      ++sample;
      const double place = depth_um / kDepth_um * kSamples;
      const int cell = std::min(static_cast<int>(place), kSamples - 1);
      const auto i = static_cast<std::size_t>(cell);
      const double wanted = expected[i] + (place - cell) * (expected[i + 1] - expected[i]);
      const double force = specimen.model.tip().force_uN(state.x_um).dot(specimen.model.setup().push);
      last = force / wanted - 1.0;
      if (depth_um < 2.0) continue;
      squares += last * last;
      ++count;
    }
    const double taken_s = thread_time_s() - start_s, seconds = kDepth_um / kSpeed_um_per_s;
    const double multiple = ramp.dt_s * std::sqrt(stiffness_uN_per_um / ramp.node_mass_kg);
    if (done)
      std::printf("%-20s %8.0e %9.1f %10.2f %8.2f %+8.2f %14.1f %14.2f\n", ramp.method.name, ramp.node_mass_kg,
                  1e6 * ramp.dt_s, multiple, 100 * std::sqrt(squares / count), 100 * last, 1e6 * taken_s / steps,
                  taken_s / seconds);
    else
      std::printf("%-20s %8.0e %9.1f %10.2f  no step\n", ramp.method.name, ramp.node_mass_kg, 1e6 * ramp.dt_s,
                  multiple);
    std::fflush(stdout);
  }
}

}  // namespace

int main() {
  const double stiffness_uN_per_um = highest_stiffness_uN_per_um();
  std::printf("oocyte, configuration 1, 162 nodes; stiffest mode %.0f uN/um, omega_max = sqrt(that / m)\n\n",
              stiffness_uN_per_um);
  print_stability(stiffness_uN_per_um);
  print_energy(stiffness_uN_per_um);
  print_ramps(stiffness_uN_per_um);
  return 0;
}
