// One contour, two read-outs: the equilibrium bears noise, prescribing every node doesn't.
#include "pellucida/teaching/ReadoutComparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "pellucida/core/Error.h"
#include "pellucida/simulation/CellReference.h"

namespace pellucida {
namespace {

TrueSection of_finite_elements(double depth_um) {
  const CellReference reference = CellReference::load("mouse-oocyte", 1);
  const auto section = reference.section(depth_um);
  return {section.outer_um, section.inner_um, reference.angle_rad(), reference.force_uN(depth_um)};
}

class ReadoutTest : public testing::Test {
 protected:
  ReadoutPair read(double depth_um, double noise_um, const std::string& contour, const std::string& laying,double draw = 1.0) {
    ReadoutParameters p;
    p.depth_um = depth_um;
    p.noise_um = noise_um;
    p.contour = contour;
    p.draw = draw;p.laying=laying;
    const TrueSection section =
        is_of_finite_elements(p) ? of_finite_elements(depth_um) : comparison_.own_section(depth_um);
    return comparison_.read(p, section).value();
  }
  ReadoutComparison comparison_{9};
};

TEST_F(ReadoutTest, Numbers) {
  for (const char* l : {"nearest","equal-distances","true-places"}) for (const char* contour : {"model", "finite-elements"})
    for (const double noise : {0.0, 0.1,0.3})
      for (const double depth : {5.0, 10.0, 20.0, 44.0}) {
        const auto p = read(depth, noise, contour,l);
        std::printf("%s %s noise %.2f depth %.0f true %.2f eq %.2f naive %.2f field eq %.3f naive %.3f\n", l,contour, noise,
                    depth, p.true_force_uN, p.equilibrium.force_uN, p.prescribed.force_uN,
                    p.equilibrium.shape.field_uN.colwise().norm().maxCoeff(),
                    p.prescribed.shape.field_uN.colwise().norm().maxCoeff());
      }
}

}  // namespace
}  // namespace pellucida
