#include "pellucida/reconstruction/Revolve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>
#include <vector>

#include "pellucida/core/Error.h"
#include "reconstruction/TestContours.h"

namespace pellucida {
namespace {

constexpr double kPi = std::numbers::pi;
const Eigen::Vector2d kCenter_um(300.0, 200.0);

RevolveOptions options(double step_deg, int points, double density = 0.4) {
  return {step_deg, points, density};
}

Eigen::Vector2d unit(double angle_rad) {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

// Closed, manifold and outward for any step, any direction, any ellipse.
TEST(Revolve, IsClosedAndOutward) {
  std::mt19937_64 random(20261120);
  std::uniform_real_distribution<double> angle_rad(-kPi, kPi);
  std::uniform_real_distribution<double> semi_axis_um(20.0, 80.0);
  for (const double step_deg : {5.0, 10.0, 22.5, 30.0, 60.0, 120.0}) {
    for (int trial = 0; trial < 5; ++trial) {
      const auto axis = unit(angle_rad(random));
      const auto contour = test::ellipse(300, kCenter_um, axis, semi_axis_um(random), semi_axis_um(random));
      const auto result = revolve(contour, kCenter_um, axis, options(step_deg, 25));
      ASSERT_TRUE(result);
      EXPECT_TRUE(is_closed_and_oriented(result->mesh)) << step_deg;
      EXPECT_GT(volume_um3(result->mesh), 0.0) << step_deg;
    }
  }
}

// V = 4/3 pi a b^2 of an ellipsoid of revolution (a along the axis); the sphere's area; error falls as the square of
// the step.
TEST(Revolve, VolumeAndAreaMeetTheClosedForms) {
  const auto axis = unit(0.7);
  const double a_um = 45.0;
  const double b_um = 55.0;
  const auto contour = test::ellipse(4000, kCenter_um, axis, a_um, b_um);
  const double exact_um3 = 4.0 / 3.0 * kPi * a_um * b_um * b_um;
  double last_error = 0.0;
  for (const int level : {1, 2, 4}) {
    const auto result = revolve(contour, kCenter_um, axis, options(20.0 / level, 16 * level + 1));
    ASSERT_TRUE(result);
    const double error = 1.0 - volume_um3(result->mesh) / exact_um3;
    EXPECT_GT(error, 0.0);  // inscribed
    if (level > 1) {
      EXPECT_NEAR(last_error / error, 4.0, 0.09);
    }
    last_error = error;
  }
  EXPECT_LT(last_error, 0.004);

  const auto sphere = revolve(test::ellipse(4000, kCenter_um, axis, 50.0, 50.0), kCenter_um, axis, options(5.0, 97));
  EXPECT_NEAR(area_um2(sphere->mesh) / (4.0 * kPi * 2500.0), 1.0, 0.0016);
}

// Pappus: V = 2 pi (distance of the half section's centroid from the axis) x (its area), for a dimpled section.
TEST(Revolve, ADimpledCellMeetsPappus) {
  const auto axis = unit(-2.0);
  const Eigen::Vector2d side(-axis.y(), axis.x());
  Contour_um contour(2, 6000);
  for (int i = 0; i < contour.cols(); ++i) {
    const double t = 2.0 * kPi * (i + 0.5) / static_cast<double>(contour.cols());
    const double radius_um = 50.0 - 30.0 * std::exp(-8.0 * (1.0 - std::cos(t)));
    contour.col(i) = kCenter_um + radius_um * (std::cos(t) * axis + std::sin(t) * side);
  }
  // Half section in polar form: area = 1/2 r^2 dt, centroid moment about the axis = 1/3 r^3 sin t dt.
  double moment_um3 = 0.0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double t = kPi * (i + 0.5) / kSteps;
    const double radius_um = 50.0 - 30.0 * std::exp(-8.0 * (1.0 - std::cos(t)));
    moment_um3 += radius_um * radius_um * radius_um / 3.0 * std::sin(t) * kPi / kSteps;
  }
  const auto result = revolve(contour, kCenter_um, axis, options(3.0, 161));
  ASSERT_TRUE(result);
  EXPECT_NEAR(volume_um3(result->mesh) / (2.0 * kPi * moment_um3), 1.0, 0.0012);
}

// A sphere of radius R with a paraboloid pressed in from its rim at height h, deeper than the centre: the cell at the
// peak of a deep push. V = sphere - 2 pi integral of rho (sqrt(R^2 - rho^2) - dimple(rho)) over the mouth.
TEST(Revolve, ADimpleDeeperThanTheCentreIsRevolved) {
  constexpr double kRadius_um = 52.0, kMouth_um = 30.0, kBottom_um = -8.0;
  const double rim_um = std::sqrt(kRadius_um * kRadius_um - kMouth_um * kMouth_um);
  const double rim_rad = std::asin(kMouth_um / kRadius_um);
  const auto axis = unit(2.1);
  const Eigen::Vector2d side(-axis.y(), axis.x());
  // From the bottom of the dimple to its rim and round to the far pole, then back on the other side.
  std::vector<Eigen::Vector2d> half;
  for (int i = 0; i < 400; ++i) {
    const double share = (i + 0.5) / 400.0;
    half.emplace_back(kBottom_um + (rim_um - kBottom_um) * share * share, kMouth_um * share);
  }
  for (int i = 0; i < 800; ++i) {
    const double polar_rad = rim_rad + (kPi - rim_rad) * (i + 0.5) / 800.0;
    half.emplace_back(kRadius_um * std::cos(polar_rad), kRadius_um * std::sin(polar_rad));
  }
  const auto count = static_cast<Eigen::Index>(half.size());
  Contour_um contour(2, 2 * count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector2d& p = half[static_cast<std::size_t>(i)];
    contour.col(i) = kCenter_um + p.x() * axis + p.y() * side;
    contour.col(2 * count - 1 - i) = kCenter_um + p.x() * axis - p.y() * side;
  }

  const auto result = revolve(contour, kCenter_um, axis, options(3.0, 161));
  ASSERT_TRUE(result) << result.error();
  EXPECT_TRUE(is_closed_and_oriented(result->mesh));
  const double cap_um3 = (std::pow(kRadius_um, 3) - std::pow(rim_um, 3)) / 3.0;
  const double bowl_um3 = 0.5 * kMouth_um * kMouth_um * 0.5 * (kBottom_um + rim_um);
  const double exact_um3 = 4.0 / 3.0 * kPi * std::pow(kRadius_um, 3) - 2.0 * kPi * (cap_um3 - bowl_um3);
  EXPECT_NEAR(volume_um3(result->mesh) / exact_um3, 1.0, 0.0015);
  // The needle's pole is the bottom of the dimple.
  EXPECT_NEAR((result->mesh.nodes_um.col(0).head<2>() - kCenter_um).dot(axis), kBottom_um, 1.6e-4);
}

TEST(Revolve, StartPointDoesNotMatter) {
  const auto axis = unit(2.5);
  const auto contour = test::ellipse(256, kCenter_um, axis, 48.0, 52.0);
  const auto reference = revolve(contour, kCenter_um, axis, options(30.0, 21));
  for (const int shift : {1, 100, 200}) {
    Contour_um turned(2, contour.cols());
    for (Eigen::Index i = 0; i < contour.cols(); ++i) turned.col(i) = contour.col((i + shift) % contour.cols());
    const auto result = revolve(turned, kCenter_um, axis, options(30.0, 21));
    EXPECT_LT((result->mesh.nodes_um - reference->mesh.nodes_um).cwiseAbs().maxCoeff(), 1e-9);
  }
}

// The image plane cuts the mesh in the contour itself, even when its halves differ.
TEST(Revolve, TheImagePlaneSectionIsTheContour) {
  const auto axis = unit(0.3);
  Contour_um contour = test::ellipse(2000, kCenter_um, axis, 50.0, 50.0);
  const Eigen::Vector2d side(-axis.y(), axis.x());
  for (Eigen::Index i = 0; i < contour.cols(); ++i) {
    const double across_um = side.dot(contour.col(i) - kCenter_um);
    if (across_um > 0.0) contour.col(i) += 0.1 * across_um * side;
  }
  const auto result = revolve(contour, kCenter_um, axis, options(30.0, 49));
  ASSERT_TRUE(result);
  int in_plane_count = 0;
  for (Eigen::Index i = 0; i < result->mesh.nodes_um.cols(); ++i) {
    const Eigen::Vector3d node_um = result->mesh.nodes_um.col(i);
    if (std::abs(node_um.z()) > 1e-9) continue;
    ++in_plane_count;
    const double distance_um = (contour.colwise() - node_um.head<2>()).colwise().norm().minCoeff();
    EXPECT_LT(distance_um, 0.1);
  }
  EXPECT_EQ(in_plane_count, 2 * 47 + 2);
}

// Node numbers are stable: pushing the pole in moves node 0 and leaves the far pole alone.
TEST(Revolve, NodesKeepTheirNumbers) {
  const auto axis = unit(0.0);
  const auto rest = revolve(test::ellipse(2000, kCenter_um, axis, 50.0, 50.0), kCenter_um, axis, options(30.0, 33));
  const Eigen::Index last = rest->mesh.nodes_um.cols() - 1;
  EXPECT_NEAR(rest->mesh.nodes_um(0, 0), 350.0, 1.2e-4);
  EXPECT_NEAR(rest->mesh.nodes_um(0, last), 250.0, 1.2e-4);
  // At rest, every node lies where its rest direction says.
  for (Eigen::Index i = 0; i <= last; ++i) {
    const Eigen::Vector3d place =
        Eigen::Vector3d(kCenter_um.x(), kCenter_um.y(), 0.0) + 50.0 * rest->rest_direction.col(i);
    EXPECT_LT((rest->mesh.nodes_um.col(i) - place).norm(), 1.2e-4);
  }
}

TEST(Revolve, OptionsOutOfRangeAreRefused) {
  EXPECT_THROW(validate(options(0.0, 25)), UsageError);
  EXPECT_THROW(validate(options(-30.0, 25)), UsageError);
  EXPECT_THROW(validate(options(7.0, 25)), UsageError);
  EXPECT_THROW(validate(options(30.0, 4)), UsageError);
  EXPECT_THROW(validate(options(30.0, 25, 0.0)), UsageError);
  EXPECT_NO_THROW(validate(options(60.0, 25)));
}

}  // namespace
}  // namespace pellucida
