#include "pellucida/core_vtk/ObservationData.h"

#include <gtest/gtest.h>
#include <vtkFieldData.h>

#include <cmath>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

MembraneContour circle(Membrane membrane, double radius_um, int count) {
  MembraneContour contour;
  contour.membrane = membrane;
  contour.points_um.resize(2, count);
  contour.confidence.resize(count);
  contour.sigma_um.resize(count);
  for (int i = 0; i < count; ++i) {
    const double angle_rad = 2.0 * M_PI * i / count;
    contour.points_um.col(i) << 300.1 + radius_um * std::cos(angle_rad), 200.3 + radius_um * std::sin(angle_rad);
    contour.confidence[i] = 1.0 / (i + 1.0);
    contour.sigma_um[i] = 0.01 + 0.001 * i / 3.0;
  }
  return contour;
}

/// Every number is one that 32 bit can't hold.
Observation full_observation() {
  Observation o;
  o.time_s = 12.1 / 3.0;
  o.frame_index = 121;
  o.state = CellState::kPunctured;
  o.confidence = 0.1;
  o.rotation_rad = 0.7 / 3.0;
  o.outer = circle(Membrane::kOuter, 50.7, 24);
  o.inner = circle(Membrane::kInner, 45.3, 20);
  o.oolemma = circle(Membrane::kOolemma, 41.1, 16);
  o.center_um << 300.1, 200.3;
  o.axis << std::cos(0.1), std::sin(0.1);
  o.rest_outer_radius_um = 50.7;
  o.rest_inner_radius_um = 45.3;
  o.indentation_um = 7.1 / 3.0;
  o.indentation_sigma_um = 0.1 / 3.0;
  o.dimple_radius_um = 9.1;
  o.rest_beyond_um = -1.1 / 3.0;
  o.side_bulge_um = 1.3 / 3.0;
  o.pierced_probability = 0.2 / 3.0;
  o.needle.emplace();
  o.needle->tip_um << 351.1, 200.7;
  o.needle->direction << -std::cos(0.1), -std::sin(0.1);
  o.needle->tip_radius_um = 2.1;
  o.needle->confidence = 0.7;
  o.needle->tip_sigma_um = 0.3;
  o.needle->tip_radius_sigma = 0.2;
  o.needle->evidence = kShaftEdges | kDimple;
  o.needle->outline_um.resize(2, 3);
  o.needle->outline_um << 351.1, 360.1, 370.1, 200.7, 201.7, 202.7;
  o.holder.emplace();
  o.holder->mouth_um << 250.1, 200.1;
  o.holder->direction << -1.0, 0.1;
  o.holder->outer_radius_um = 30.1;
  o.holder->confidence = 0.9;
  o.holder->outer_radius_sigma = 0.35;
  o.holder->outline_um.resize(2, 2);
  o.holder->outline_um << 250.1, 240.1, 190.1, 180.1;
  return o;
}

void expect_same(const std::optional<MembraneContour>& one, const std::optional<MembraneContour>& other) {
  ASSERT_EQ(one.has_value(), other.has_value());
  if (!one) return;
  EXPECT_EQ(one->membrane, other->membrane);
  EXPECT_EQ(one->points_um, other->points_um);
  EXPECT_EQ(one->sigma_um, other->sigma_um);
  EXPECT_EQ(one->confidence, other->confidence);
}

void expect_same(const Observation& one, const Observation& other) {
  EXPECT_EQ(one.time_s, other.time_s);
  EXPECT_EQ(one.frame_index, other.frame_index);
  EXPECT_EQ(one.state, other.state);
  EXPECT_EQ(one.confidence, other.confidence);
  expect_same(one.outer, other.outer);
  expect_same(one.inner, other.inner);
  expect_same(one.oolemma, other.oolemma);
  EXPECT_EQ(one.center_um, other.center_um);
  EXPECT_EQ(one.rotation_rad, other.rotation_rad);
  EXPECT_EQ(one.rest_outer_radius_um, other.rest_outer_radius_um);
  EXPECT_EQ(one.rest_inner_radius_um, other.rest_inner_radius_um);
  EXPECT_EQ(one.axis, other.axis);
  EXPECT_EQ(one.indentation_um, other.indentation_um);
  EXPECT_EQ(one.indentation_sigma_um, other.indentation_sigma_um);
  EXPECT_EQ(one.dimple_radius_um, other.dimple_radius_um);
  ASSERT_EQ(one.needle.has_value(), other.needle.has_value());
  if (one.needle) {
    EXPECT_EQ(one.needle->tip_um, other.needle->tip_um);
    EXPECT_EQ(one.needle->direction, other.needle->direction);
    EXPECT_EQ(one.needle->tip_radius_um, other.needle->tip_radius_um);
    EXPECT_EQ(one.needle->confidence, other.needle->confidence);
    EXPECT_EQ(one.needle->tip_sigma_um, other.needle->tip_sigma_um);
    EXPECT_EQ(one.needle->evidence, other.needle->evidence);
    EXPECT_EQ(one.needle->outline_um, other.needle->outline_um);
  }
  ASSERT_EQ(one.holder.has_value(), other.holder.has_value());
  if (one.holder) {
    EXPECT_EQ(one.holder->mouth_um, other.holder->mouth_um);
    EXPECT_EQ(one.holder->direction, other.holder->direction);
    EXPECT_EQ(one.holder->outer_radius_um, other.holder->outer_radius_um);
    EXPECT_EQ(one.holder->confidence, other.holder->confidence);
    EXPECT_EQ(one.holder->outline_um, other.holder->outline_um);
  }
}

TEST(ObservationData, ARoundedObservationComesBackToTheBit) {
  Observation o = full_observation();
  round_as_stored(o);
  const auto read = read_observation(make_membranes(o), make_tools(o));
  ASSERT_TRUE(read);
  expect_same(*read, o);
}

TEST(ObservationData, RoundingMovesNoPointFartherThan32BitDo) {
  const Observation exact = full_observation();
  Observation rounded = exact;
  round_as_stored(rounded);
  EXPECT_NE(rounded.outer->points_um, exact.outer->points_um);
  EXPECT_LT((rounded.outer->points_um - exact.outer->points_um).cwiseAbs().maxCoeff(), 3e-5);
  EXPECT_EQ(rounded.indentation_um, exact.indentation_um);
}

TEST(ObservationData, WhatWasNotSeenIsNotThereAfterwards) {
  Observation o;
  o.state = CellState::kLost;
  round_as_stored(o);
  const auto read = read_observation(make_membranes(o), make_tools(o));
  ASSERT_TRUE(read);
  expect_same(*read, o);

  o.outer = circle(Membrane::kOuter, 50.0, 12);
  o.outer->sigma_um.resize(0);
  o.outer->confidence.resize(0);
  round_as_stored(o);
  EXPECT_EQ(o.outer->confidence, Eigen::VectorXd::Ones(12));  // as the file has it
  const auto contour = read_observation(make_membranes(o), make_tools(o));
  ASSERT_TRUE(contour);
  expect_same(*contour, o);
}

TEST(ObservationData, AnEarlierVersionsFilesHoldNoObservation) {
  const Observation o = full_observation();
  const auto membranes = make_membranes(o);
  membranes->GetFieldData()->RemoveArray(array_name::kObservation);
  EXPECT_FALSE(read_observation(membranes, make_tools(o)));
  EXPECT_FALSE(read_observation(nullptr, make_tools(o)));
}

}  // namespace
}  // namespace pellucida
