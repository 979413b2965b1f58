// Against closed forms: a rubber balloon, and the point load on a spherical shell.
#include <gtest/gtest.h>

#include <cmath>

#include "GradedSphereMesh.h"
#include "NeoHookeanTerm.h"
#include "pellucida/fem/ShellReference.h"
#include "pellucida/membrane/AttachmentTerm.h"
#include "pellucida/membrane/EquilibriumSolver.h"
#include "pellucida/membrane/VolumeTerm.h"

namespace pellucida {
namespace {

// A balloon of an incompressible neo-Hookean membrane (Adkins and Rivlin, Phil. Trans. R. Soc. A 244, 1952): with
// l = r / R, P = 2 mu h / R (1/l - 1/l^7). Solved for: the liquid asks for more volume than there is, and the membrane
// takes the shape and pressure where both are in balance. The pressure falls beyond l = 7^(1/6) = 1.383.
TEST(ClosedForm, BalloonsPressureAgainstStretch) {
  constexpr double kRadius_um = 50.0, kThickness_um = 1.0, kModulus = 0.03;
  const GradedSphere sphere = make_graded_sphere_mesh(kRadius_um, 0.0, [](const Eigen::Vector3d&) { return 6.0; });
  NeoHookeanTerm membrane(sphere.mesh, kModulus, 0.5, kThickness_um);
  // Bonds a million times softer than the membrane keep it from drifting.
  AttachmentTerm anchor(sphere.mesh.points_um,
                        Eigen::VectorXd::Constant(sphere.mesh.points_um.cols(), 1e-6 * kModulus * kThickness_um));
  for (const double goal : {1.05, 1.2, 1.383, 1.7}) {
    TriangleMesh filled = sphere.mesh;
    filled.points_um *= goal;
    VolumeTerm liquid(filled, 1e3 * kModulus);
    EnergySum energy(static_cast<int>(sphere.mesh.points_um.cols()), kModulus * kThickness_um);
    energy.add_term(membrane);
    energy.add_term(anchor);
    energy.add_term(liquid);
    EquilibriumSolver solver(energy);
    Eigen::Matrix3Xd x = filled.points_um;
    SolveOptions options;
    options.tolerance_um = 1e-8;
    ASSERT_EQ(solver.solve(x, options).status, SolveStatus::kConverged) << goal;

    const double l = x.colwise().norm().mean() / kRadius_um;
    EXPECT_NEAR(l, goal, 1.4e-4 * goal);
    const double pressure = 2.0 * kModulus / 3.0 * kThickness_um / kRadius_um * (1.0 / l - std::pow(l, -7.0));
    EXPECT_NEAR(liquid.pressure_uN_per_um2(x), pressure, 0.007 * pressure) << goal;
  }
}

// Reissner (J. Math. Phys. 25, 1946), point load on a shallow, and so on a whole thin, sphere: k = 8 sqrt(E h D) / R
// = 4 E h^2 / (R sqrt(3 (1 - nu^2))). A tip much smaller than the bending length (R h)^1/2 / (12 (1 - nu^2))^1/4, a
// liquid that gives way, a holder far off; the depth is small against the thickness.
TEST(ClosedForm, SmallPointLoadOnAThinSphere) {
  ShellSpecimen specimen;
  specimen.thickness_um = 1.0;
  specimen.bulk_modulus_ratio = 1e-6;
  ShellContact contact;
  contact.tip_radius_um = 1.0;
  contact.tip_bond_per_um = 200.0;
  contact.holder_bond_per_um = 50.0;
  const double e = 1e-3 * specimen.young_modulus_kPa, h = specimen.thickness_um, nu = specimen.poisson_ratio;
  const double expected = 4.0 * e * h * h / (specimen.mid_radius_um * std::sqrt(3.0 * (1.0 - nu * nu)));
  const ShellCurve curve = ShellReference(specimen, contact).run(0.01, 0.01);
  ASSERT_EQ(curve.outcome, CurveOutcome::kComplete);
  const double found = curve.steps.back().axial_force_uN / 0.01;
  std::printf("stiffness %.6f uN/um, closed form %.6f\n", found, expected);
  EXPECT_NEAR(found, expected, 0.05 * expected);
}

}  // namespace
}  // namespace pellucida
