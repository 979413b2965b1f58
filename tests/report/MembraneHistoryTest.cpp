#include "MembraneHistory.h"

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "SphereSurface.h"

namespace pellucida {
namespace {

TEST(MembraneState, AreaStrainOfASphereThatGrows) {
  const auto surface = test::sphere_surface(50.0, 1.1);
  const MembraneState state = membrane_state(surface);
  EXPECT_NEAR(state.area_strain_percent, 21.0, 1e-6);
  EXPECT_TRUE(std::isnan(state.mean_tension_uN_per_um) && std::isnan(state.largest_tension_uN_per_um));
}

TEST(MembraneState, AtRestTheStrainIsNought) {
  EXPECT_NEAR(membrane_state(test::sphere_surface(50.0, 1.0)).area_strain_percent, 0.0, 1e-9);
}

TEST(MembraneState, TensionOfTheOuterMembraneAlone) {
  const auto surface = test::sphere_surface(50.0, 1.0);
  test::add_tension(surface, 0.4, 0.9);
  const MembraneState state = membrane_state(surface);
  EXPECT_NEAR(state.mean_tension_uN_per_um, 0.4, 1e-9);
  EXPECT_NEAR(state.largest_tension_uN_per_um, 0.4, 1e-9);
}

TEST(MembraneState, WithoutArraysThereIsNothing) {
  EXPECT_TRUE(std::isnan(membrane_state(vtkSmartPointer<vtkPolyData>::New()).area_strain_percent));
  const auto surface = test::sphere_surface(50.0, 1.1);
  surface->GetPointData()->RemoveArray("displacement_um");
  EXPECT_TRUE(std::isnan(membrane_state(surface).area_strain_percent));
}

}  // namespace
}  // namespace pellucida
