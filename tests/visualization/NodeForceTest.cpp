#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <set>

#include "ErrorBarFilter.h"
#include "ForceGlyphFilter.h"
#include "NodeForceFilter.h"
#include "pellucida/core_vtk/SceneData.h"
#include "visualization/SyntheticScene.h"

namespace pellucida {
namespace {

Eigen::Vector3d vector_at(vtkDataArray* array, vtkIdType node) {
  Eigen::Vector3d value;
  array->GetTuple(node, value.data());
  return value;
}

Eigen::Vector3d sum_of(vtkDataArray* array) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) sum += vector_at(array, i);
  return sum;
}

// A ball under a pressure of P, pushed at one pole by 3 uN and held at the other; its membrane bears what is left.
class NodeForces : public testing::Test {
 protected:
  static constexpr double kRadius_um = 40.0, kPressure_uN_per_um2 = 4e-4, kPush_uN = 3.0;

  NodeForces() {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(kRadius_um);
    sphere->SetThetaResolution(48);
    sphere->SetPhiResolution(48);
    sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    sphere->Update();
    surface->ShallowCopy(sphere->GetOutput());
    surface->GetPointData()->Initialize();
    const vtkIdType count = surface->GetNumberOfPoints();
    pressure_uN = Eigen::Matrix3Xd::Zero(3, count);
    // Exactly P grad V: the facets are closed.
    for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c) {
      vtkNew<vtkIdList> ids;
      surface->GetCellPoints(c, ids);
      Eigen::Matrix3d p;
      for (int k = 0; k < 3; ++k) surface->GetPoint(ids->GetId(k), p.col(k).data());
      const Eigen::Vector3d area = 0.5 * (p.col(1) - p.col(0)).cross(p.col(2) - p.col(0));
      for (int k = 0; k < 3; ++k) pressure_uN.col(ids->GetId(k)) += kPressure_uN_per_um2 / 3.0 * area;
    }
    Eigen::Matrix3Xd needle = Eigen::Matrix3Xd::Zero(3, count), holder = needle;
    std::vector<vtkIdType> top, bottom;
    for (vtkIdType i = 0; i < count; ++i) {
      if (surface->GetPoint(i)[2] > 0.96 * kRadius_um) top.push_back(i);
      if (surface->GetPoint(i)[2] < -0.9 * kRadius_um) bottom.push_back(i);
    }
    for (const vtkIdType i : top) needle(2, i) = -kPush_uN / static_cast<double>(top.size());
    for (const vtkIdType i : bottom) holder(2, i) = kPush_uN / static_cast<double>(bottom.size());
    const Eigen::Matrix3Xd membrane = -(pressure_uN + needle + holder);
    add(array_name::kForce, membrane);
    add(array_name::kNeedleForce, needle);
    add(array_name::kHolderForce, holder);
    // A tenth of the force; under the tools as much as they carry.
    Eigen::MatrixXd sigma = 0.1 * membrane.colwise().norm();
    for (const auto* touched : {&top, &bottom}) {
      for (const vtkIdType i : *touched) sigma(0, i) += (needle.col(i) + holder.col(i)).norm();
    }
    add(array_name::kForceSigma, sigma);
    touched_count = top.size() + bottom.size();
    needle_count = top.size();
  }

  void add(const char* name, const Eigen::MatrixXd& values) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(static_cast<int>(values.rows()));
    array->SetNumberOfTuples(values.cols());
    Eigen::Map<Eigen::MatrixXd>(array->GetPointer(0), values.rows(), values.cols()) = values;
    surface->GetPointData()->AddArray(array);
  }

  vtkPointData* forces(NodeForceKind kind) {
    filter->SetInputData(surface);
    filter->SetKind(kind);
    filter->Update();
    return filter->GetOutput()->GetPointData();
  }
  vtkDataArray* force(NodeForceKind kind) { return forces(kind)->GetArray(array_name::kForce); }

  vtkNew<vtkPolyData> surface;
  Eigen::Matrix3Xd pressure_uN;
  std::size_t touched_count = 0, needle_count = 0;
  vtkNew<NodeForceFilter> filter;
};

TEST_F(NodeForces, OfEachToolAddUpToItsWhole) {
  EXPECT_LT((sum_of(force(NodeForceKind::kNeedle)) - Eigen::Vector3d(0, 0, -kPush_uN)).norm(), 1e-12);
  EXPECT_LT((sum_of(force(NodeForceKind::kHolder)) - Eigen::Vector3d(0, 0, kPush_uN)).norm(), 1e-12);
  EXPECT_LT(sum_of(force(NodeForceKind::kTools)).norm(), 1e-12);
  EXPECT_EQ(vector_at(force(NodeForceKind::kTools), 0), vector_at(force(NodeForceKind::kNeedle), 0));
}

TEST_F(NodeForces, PressurePushesOutwardsAndAddsUpToZero) {
  vtkDataArray* pressure = force(NodeForceKind::kPressure);
  ASSERT_TRUE(pressure);
  double whole_uN = 0.0;
  for (vtkIdType i = 0; i < pressure->GetNumberOfTuples(); ++i) {
    EXPECT_LT((vector_at(pressure, i) - pressure_uN.col(i)).norm(), 1e-12);
    Eigen::Vector3d place;
    surface->GetPoint(i, place.data());
    EXPECT_GT(vector_at(pressure, i).dot(place), 0.0);
    whole_uN += vector_at(pressure, i).norm();
  }
  EXPECT_LT(sum_of(pressure).norm(), 1e-9);
  EXPECT_NEAR(whole_uN, kPressure_uN_per_um2 * 4.0 * std::numbers::pi * kRadius_um * kRadius_um, 0.02 * whole_uN);
}

// The membrane's own sigma under a tool says how that tool's force is spread: nothing that the liquid knows of.
TEST_F(NodeForces, TheirDeviationIsThatOfTheirKind) {
  vtkDataArray* sigma = forces(NodeForceKind::kPressure)->GetArray(array_name::kForceSigma);
  ASSERT_TRUE(sigma);
  for (vtkIdType i = 0; i < sigma->GetNumberOfTuples(); ++i) {
    EXPECT_NEAR(sigma->GetComponent(i, 0), 0.1 * pressure_uN.col(i).norm(), 1e-9);
  }
  sigma = forces(NodeForceKind::kMembrane)->GetArray(array_name::kForceSigma);
  EXPECT_GT(sigma->GetComponent(0, 0), kPush_uN / static_cast<double>(needle_count));
}

// Nothing is drawn for what a session of an earlier version lacks.
TEST_F(NodeForces, WhatASurfaceDoesNotHoldIsNotMadeUp) {
  surface->GetPointData()->RemoveArray(array_name::kNeedleForce);
  surface->GetPointData()->RemoveArray(array_name::kHolderForce);
  for (const NodeForceKind kind : kNodeForceKinds) {
    EXPECT_EQ(force(kind) != nullptr, kind == NodeForceKind::kMembrane) << static_cast<int>(kind);
  }
}

TEST_F(NodeForces, OfAToolAreSpreadOverWhatItTouches) {
  vtkNew<ForceGlyphFilter> glyphs;
  forces(NodeForceKind::kNeedle);
  glyphs->SetInputData(filter->GetOutput());
  glyphs->SetFullScaleUN(kPush_uN / static_cast<double>(needle_count));
  glyphs->Update();
  EXPECT_EQ(static_cast<std::size_t>(glyphs->GetOutput()->GetNumberOfPoints()),
            std::min<std::size_t>(needle_count, 250));
  EXPECT_GT(glyphs->GetOutput()->GetBounds()[4], 0.9 * kRadius_um);
  // Inwards: they end at their nodes.
  EXPECT_EQ(glyphs->GetOutput()->GetPointData()->GetArray("arrow_kind")->GetRange()[0], 1.0);
}

TEST_F(NodeForces, AreGreyWhereTheyCannotBeToldFromZero) {
  vtkNew<ForceGlyphFilter> glyphs;
  glyphs->SetMaximumCount(5000);
  glyphs->SetThresholdRatio(0.0);
  for (const NodeForceKind kind : {NodeForceKind::kTools, NodeForceKind::kPressure, NodeForceKind::kMembrane}) {
    forces(kind);
    glyphs->SetInputData(filter->GetOutput());
    glyphs->Update();
    vtkPointData* arrows = glyphs->GetOutput()->GetPointData();
    vtkIdType grey_count = 0;
    for (vtkIdType i = 0; i < glyphs->GetOutput()->GetNumberOfPoints(); ++i) {
      grey_count += std::isnan(arrows->GetArray("color_uN")->GetComponent(i, 0));
    }
    const vtkIdType expected = kind == NodeForceKind::kPressure ? 0 : static_cast<vtkIdType>(touched_count);
    EXPECT_EQ(grey_count, expected) << static_cast<int>(kind);
  }
}

TEST_F(NodeForces, HaveBarsAsLongAsTheirIntervals) {
  vtkNew<ForceGlyphFilter> glyphs;
  forces(NodeForceKind::kPressure);
  glyphs->SetInputData(filter->GetOutput());
  glyphs->SetMaximumCount(1);
  glyphs->SetFullScaleUN(node_force_quantile_uN(filter->GetOutput(), 1.0));
  glyphs->SetLongestArrowUm(20.0);
  vtkNew<ErrorBarFilter> bars;
  bars->SetInputConnection(glyphs->GetOutputPort());
  bars->SetCrossUm(0.5);
  bars->Update();
  // A stroke along the arrow, two crosses of two.
  ASSERT_EQ(bars->GetOutput()->GetNumberOfCells(), 5);
  double a[3], b[3];
  bars->GetOutput()->GetPoint(0, a);
  bars->GetOutput()->GetPoint(1, b);
  // 1.96 tenths to either side, about the arrow's head.
  EXPECT_NEAR(std::sqrt(vtkMath::Distance2BetweenPoints(a, b)), 2.0 * 0.196 * 20.0, 1e-4);
  EXPECT_NEAR(0.5 * (vtkMath::Norm(a) + vtkMath::Norm(b)), kRadius_um + 20.0, 1e-3);

  surface->GetPointData()->RemoveArray(array_name::kForceSigma);
  surface->Modified();
  forces(NodeForceKind::kPressure);
  bars->Update();
  EXPECT_EQ(bars->GetOutput()->GetNumberOfCells(), 0);
}

class ForceGlyphs : public testing::Test {
 protected:
  vtkPolyData* update() {
    filter->SetInputData(surface);
    filter->SetFullScaleUN(full_scale_uN);
    filter->SetThresholdRatio(0.0);
    filter->Update();
    return filter->GetOutput();
  }

  vtkSmartPointer<vtkPolyData> surface = test::synthetic_scene(25.0).surface.shallow_copy();
  double full_scale_uN = node_force_quantile_uN(surface, 1.0);
  vtkNew<ForceGlyphFilter> filter;
};

TEST_F(ForceGlyphs, AtMostTheCountAskedAndOnlyOuterNodes) {
  filter->SetMaximumCount(200);
  vtkPolyData* glyphs = update();
  EXPECT_LE(glyphs->GetNumberOfPoints(), 200);
  EXPECT_GE(glyphs->GetNumberOfPoints(), 150);
  // The inner membrane's rim is 40 um away from the axis at most.
  double bounds_um[6];
  glyphs->GetBounds(bounds_um);
  EXPECT_GT(bounds_um[5], 42.0);
}

TEST_F(ForceGlyphs, TheStrongestNodeIsAlwaysAmongThemAndHasTheLongestArrow) {
  filter->SetMaximumCount(1);
  filter->SetLongestArrowUm(20.0);
  vtkPolyData* glyphs = update();
  ASSERT_EQ(glyphs->GetNumberOfPoints(), 1);
  EXPECT_DOUBLE_EQ(glyphs->GetPointData()->GetArray("magnitude_uN")->GetComponent(0, 0), full_scale_uN);
  EXPECT_DOUBLE_EQ(glyphs->GetPointData()->GetArray("arrow_length_um")->GetComponent(0, 0), 20.0);
  // It pushes inward, so its arrow ends at the node.
  EXPECT_EQ(glyphs->GetPointData()->GetArray("arrow_kind")->GetComponent(0, 0), 1.0);
}

TEST_F(ForceGlyphs, NodesAreSpreadEvenly) {
  filter->SetMaximumCount(100);
  vtkPolyData* glyphs = update();
  double nearest_um = 1e9;
  // The strongest node (the first) is put in besides the even spread.
  for (vtkIdType i = 1; i < glyphs->GetNumberOfPoints(); ++i) {
    for (vtkIdType j = 1; j < i; ++j) {
      double a[3];
      double b[3];
      glyphs->GetPoint(i, a);
      glyphs->GetPoint(j, b);
      nearest_um = std::min(nearest_um, std::sqrt(vtkMath::Distance2BetweenPoints(a, b)));
    }
  }
  // A hundred discs of this distance cover a sphere of 48 um: sqrt(4 pi 48^2 / 100) = 17 um, half of it is even enough.
  EXPECT_GT(nearest_um, 8.5);
}

TEST_F(ForceGlyphs, TheSameNodesFromFrameToFrame) {
  filter->SetMaximumCount(150);
  update();
  const auto nodes_of = [&](vtkPolyData* s) {
    std::set<vtkIdType> nodes;
    for (vtkIdType i = 1; i < filter->GetOutput()->GetNumberOfPoints(); ++i) {
      double p[3];
      filter->GetOutput()->GetPoint(i, p);
      for (vtkIdType k = 0; k < s->GetNumberOfPoints() / 2; ++k) {
        double q[3];
        s->GetPoint(k, q);
        if (vtkMath::Distance2BetweenPoints(p, q) < 1e-12) nodes.insert(k);
      }
    }
    return nodes;
  };
  const auto first = nodes_of(surface);
  surface = test::synthetic_scene(26.0).surface.shallow_copy();
  update();
  EXPECT_EQ(nodes_of(surface), first);
}

TEST_F(ForceGlyphs, LogScaleLengthensSmallForces) {
  filter->SetMaximumCount(300);
  filter->SetLongestArrowUm(20.0);
  const auto least_um = [&](bool log_scale) {
    filter->SetLogScale(log_scale);
    return update()->GetPointData()->GetArray("arrow_length_um")->GetRange(0)[0];
  };
  const double linear_um = least_um(false);
  EXPECT_GT(least_um(true), 2.0 * linear_um);
}

TEST_F(ForceGlyphs, QuantilesOfTheForceGrowWithTheShare) {
  EXPECT_LT(node_force_quantile_uN(surface, 0.0), node_force_quantile_uN(surface, 0.5));
  EXPECT_LT(node_force_quantile_uN(surface, 0.5), node_force_quantile_uN(surface, 1.0));
}

TEST_F(ForceGlyphs, BeyondTheScaleAnArrowGrowsNoLongerThanHalfAsMuchAgain) {
  full_scale_uN *= 0.1;
  filter->SetMaximumCount(1);
  filter->SetLongestArrowUm(20.0);
  EXPECT_DOUBLE_EQ(update()->GetPointData()->GetArray("arrow_length_um")->GetComponent(0, 0), 30.0);
}

TEST_F(ForceGlyphs, WithoutForcesThereAreNoArrowsAndTheInputStaysAsItWas) {
  surface->GetPointData()->RemoveArray(array_name::kForce);
  const vtkMTimeType before = surface->GetMTime();
  EXPECT_EQ(update()->GetNumberOfPoints(), 0);
  EXPECT_EQ(surface->GetMTime(), before);
  EXPECT_EQ(node_force_quantile_uN(surface, 1.0), 0.0);
}

TEST_F(ForceGlyphs, AForceThatIsNoNumberGetsNoArrow) {
  vtkNew<vtkDoubleArray> bad;
  bad->DeepCopy(surface->GetPointData()->GetArray(array_name::kForce));
  bad->SetName(array_name::kForce);
  for (vtkIdType i = 0; i < bad->GetNumberOfTuples(); ++i) bad->SetComponent(i, 0, std::nan(""));
  surface->GetPointData()->AddArray(bad);
  EXPECT_EQ(update()->GetNumberOfPoints(), 0);
}

}  // namespace
}  // namespace pellucida
