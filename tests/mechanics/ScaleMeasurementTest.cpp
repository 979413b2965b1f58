#include "pellucida/mechanics/ScaleMeasurement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

TEST(ScaleMeasurement, NumbersGivenTogetherAreSeparatedByWay) {
  EXPECT_TRUE(separated({}).empty());
  const ScaleMeasurement force{.known_force_uN = 0.7, .at_indentation_um = 5.0};
  EXPECT_EQ(way_of(force), ScaleWay::kForce);
  EXPECT_EQ(way_of({.known_stiffness_uN_per_um = 0.1, .at_indentation_um = 5.0}), ScaleWay::kStiffness);
  EXPECT_EQ(way_of({.fibre_stiffness_uN_per_um = 0.1, .fibre_deflection_um = 8.0, .at_indentation_um = 5.0}),
            ScaleWay::kFibre);
  ScaleMeasurement both = force;
  both.suction_kPa = 2.0;
  both.tongue_um = 9.0;
  both.mouth_radius_um = 10.0;
  const auto parts = separated(both);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(way_of(parts[0]), ScaleWay::kForce);
  EXPECT_EQ(way_of(parts[1]), ScaleWay::kAspiration);
  EXPECT_EQ(parts[0].suction_kPa, 0.0);
  EXPECT_EQ(parts[1].at_indentation_um, 0.0);
  EXPECT_THROW(way_of(both), UsageError);
}

TEST(ScaleMeasurement, WhatIsMissingOrContradictsIsRefusedByName) {
  const auto refused = [](const ScaleMeasurement& measurement, const std::string& word) {
    try {
      separated(measurement);
    } catch (const UsageError& error) {
      return std::string(error.what()).find(word) != std::string::npos;
    }
    return false;
  };
  EXPECT_TRUE(refused({.known_force_uN = 0.7}, "indentation"));
  EXPECT_TRUE(refused({.at_indentation_um = 5.0}, "known force"));
  EXPECT_TRUE(refused({.known_force_uN = 0.7, .known_stiffness_uN_per_um = 0.1, .at_indentation_um = 5.0}, "one of"));
  EXPECT_TRUE(refused({.fibre_stiffness_uN_per_um = 0.1, .at_indentation_um = 5.0}, "deflection"));
  EXPECT_TRUE(refused({.suction_kPa = 2.0, .mouth_radius_um = 10.0}, "tongue"));
  EXPECT_TRUE(refused({.known_force_uN = std::nan(""), .at_indentation_um = 5.0}, "known_force_uN"));
  EXPECT_TRUE(refused({.known_force_uN = 0.7, .at_indentation_um = 5.0, .known_force_sigma_percent = 0.0},
                      "known_force_sigma_percent"));
}

TEST(ScaleMeasurement, AFibresForceIsStiffnessTimesDeflection) {
  const ScaleMeasurement fibre{.fibre_stiffness_uN_per_um = 0.05,
                               .fibre_deflection_um = 10.0,
                               .fibre_deflection_sigma_um = 0.4,
                               .at_indentation_um = 6.0,
                               .known_force_sigma_percent = 3.0};
  const Palpation push = push_of(fibre);
  EXPECT_DOUBLE_EQ(push.known_force_uN, 0.5);
  EXPECT_DOUBLE_EQ(push.relative_sigma, 0.05);
  EXPECT_EQ(push.indentation_um, 6.0);
  EXPECT_EQ(describe(fibre), "a fibre bent by 10.0 um: a push of 0.5 uN at 6.0 um, +- 5 %");
}

TEST(ScaleEstimate, OneModulusIsTheWeightedMeanOfTheLogarithms) {
  ScaleEstimate estimate({1.0, 0.4}, 0.1, 0.05);
  estimate.add_modulus(1.5, 0.16);
  const CellScale scale = estimate.result();
  EXPECT_NEAR(scale.ratio, std::sqrt(1.5), 1e-9);
  EXPECT_NEAR(scale.relative_sigma, 0.4 / std::sqrt(2.0), 1e-9);
  EXPECT_FALSE(scale.has_geometry);
}

// A push knows the product of stiffness and sizes, which is what forces need; the model's error stays.
TEST(ScaleEstimate, APushTakesTheSizesErrorWithItAndNotTheModels) {
  ScaleEstimate estimate({1.0, 0.46}, 0.12, 0.04);
  estimate.add_push(1.3, 1e-8);
  const CellScale scale = estimate.result();
  EXPECT_TRUE(scale.has_geometry);
  EXPECT_NEAR(scale.relative_sigma, 0.04, 0.001);
  // Pushes share it: a thousand of them are no better.
  for (int k = 0; k < 1000; ++k) estimate.add_push(1.3, 1e-4);
  EXPECT_GT(estimate.result().relative_sigma, 0.039);
}

TEST(ScaleEstimate, TheOrderDoesNotMatterAndEachMeasurementNarrows) {
  ScaleEstimate one({1.0, 0.46}, 0.12, 0.04), other({1.0, 0.46}, 0.12, 0.04), push({1.0, 0.46}, 0.12, 0.04);
  one.add_push(1.3, 0.0025);
  one.add_modulus(1.1, 0.01);
  other.add_modulus(1.1, 0.01);
  other.add_push(1.3, 0.0025);
  push.add_push(1.3, 0.0025);
  EXPECT_NEAR(one.result().ratio, other.result().ratio, 1e-12);
  EXPECT_NEAR(one.result().relative_sigma, other.result().relative_sigma, 1e-12);
  EXPECT_LT(one.result().relative_sigma, push.result().relative_sigma);
  EXPECT_LT(one.result().ratio, push.result().ratio);
  EXPECT_GT(one.result().ratio, 1.1);
}

// Bayes' rule, held against random cells: the interval holds what it says.
TEST(ScaleEstimate, HoldsRandomCells) {
  constexpr double kSpread = 0.46, kGeometry = 0.12, kModel = 0.03, kForce = 0.05, kModulus = 0.15;
  unsigned state = 1;
  const auto uniform = [&] {
    state = state * 1664525u + 1013904223u;
    return (static_cast<double>(state >> 8) + 0.5) / 16777216.0;
  };
  const auto normal = [&] { return std::sqrt(-2.0 * std::log(uniform())) * std::cos(2.0 * M_PI * uniform()); };
  int held = 0, count = 2000;
  double squares = 0.0;
  for (int k = 0; k < count; ++k) {
    const double s = kSpread * normal(), g = kGeometry * normal(), m = kModel * normal();
    ScaleEstimate estimate({1.0, kSpread}, kGeometry, kModel);
    estimate.add_push(std::exp(s + g + m + kForce * normal()), kForce * kForce);
    estimate.add_modulus(std::exp(s + kModulus * normal()), kModulus * kModulus);
    const CellScale scale = estimate.result();
    const double off = std::log(scale.ratio) - (s + g);
    squares += off * off;
    held += std::abs(off) < 1.96 * scale.relative_sigma ? 1 : 0;
  }
  EXPECT_NEAR(held / static_cast<double>(count), 0.95, 0.015);
  EXPECT_LT(std::sqrt(squares / count), 0.065);
}

}  // namespace
}  // namespace pellucida
