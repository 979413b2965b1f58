// What the contours of a contact say of thickness, tip and holding pipette. The contours are those of specimens
// computed with GetFEM, which share neither code nor elements with the solid that they are held against.
#include "ContourSizes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "SpecimenView.h"
#include "pellucida/mechanics/ForceObserver.h"
#include "pellucida/simulation/CellReference.h"

namespace pellucida {
namespace {

using testing::view_of;

constexpr double kOpenTip = 0.7, kOpenHolder = 0.4, kOpenThickness = 0.5, kSeen = 0.1, kOpenStiffening = 0.4;

/// Specimens of walls that stiffen by b = 0.37, 0.50 and 0.35; the second and third out of round, all sucked.
constexpr struct {
  const char* name;
  double stiffening;
} kStiffeningCells[] = {{"specimen-1003", 0.37}, {"specimen-1020", 0.50}, {"specimen-1067", 0.35}};

CellReference stiffening_cell(const char* name) {
  return CellReference::load(PELLUCIDA_SOURCE_DIR "/tests/data/stiffening/" + std::string(name), 1);
}

/// Its sizes, and a wall that doesn't stiffen.
SolidParameters parameters_of(const CellReference& cell) {
  const ReferenceGeometry& g = cell.geometry();
  const double radius_um = cell.outer_radius_um();
  return {std::log(g.thickness_um / radius_um), std::log(g.tip_radius_um / radius_um),
          std::log((g.holder_ring_um + g.holder_half_width_um) / radius_um), 0.0, 0.0};
}

std::optional<ContourSizes::Parameters> settled(ContourSizes& contours, const ParametersPrior& prior) {
  for (int step = 0; step < 100 && !contours.is_settled(); ++step) contours.step(prior);
  EXPECT_TRUE(contours.is_settled());
  return contours.estimate();
}

std::optional<ContourSizes::Parameters> estimate(const CellReference& cell, const ParametersPrior& prior) {
  ContourSizes contours;
  CellPlacement placement;
  for (int frame = 0; frame < 3; ++frame) {
    const Observation o = view_of(cell, 0.0);
    placement.update(o);
    contours.add_rest(o, placement);
  }
  for (double depth_um = 1.0; depth_um <= 40.0; depth_um += 0.5) {
    const Observation o = view_of(cell, depth_um);
    placement.update(o);
    contours.add(o, placement, depth_um, 0.2);
  }
  return settled(contours, prior);
}

class ContourSizesOf : public ::testing::TestWithParam<const char*> {};

TEST_P(ContourSizesOf, FindsASizeThatIsNotSeen) {
  const CellReference cell = CellReference::load(GetParam(), 1);
  const SolidParameters truth = parameters_of(cell);
  const double open[] = {kOpenThickness, kOpenTip, kOpenHolder};
  for (int size = 0; size < 3; ++size) {
    for (const double sign : {-1.0, 1.0}) {
      ParametersPrior prior{truth, SolidParameters::Constant(kSeen)};
      prior.sigma[size] = open[size];
      prior.mean[size] += sign * open[size];
      const auto found = estimate(cell, prior);
      ASSERT_TRUE(found) << size;
      const double error = found->mean[size] - truth[size], sigma = std::sqrt(found->covariance(size, size));
      EXPECT_LT(std::abs(error), 0.5 * open[size]) << "size " << size << ", prior off by " << sign * open[size];
      EXPECT_LT(std::abs(error), 2.0 * sigma) << "size " << size;
      EXPECT_LT(sigma, 0.7 * open[size]) << "size " << size;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Specimens, ContourSizesOf,
                         ::testing::Values("specimen-1", "specimen-3", "specimen-7", "specimen-9", "specimen-14",
                                           "specimen-18", "specimen-25", "specimen-34"),
                         [](const auto& which) {
                           std::string name = which.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(ContourSizes, FindsHowAWallStiffens) {
  for (const auto& [name, stiffening] : kStiffeningCells) {
    const CellReference cell = stiffening_cell(name);
    ParametersPrior prior{parameters_of(cell), SolidParameters::Constant(kSeen)};
    prior.sigma[kStiffening] = kOpenStiffening;
    const auto found = estimate(cell, prior);
    ASSERT_TRUE(found) << name;
    const double sigma = std::sqrt(found->covariance(kStiffening, kStiffening));
    EXPECT_NEAR(found->mean[kStiffening], stiffening_effect(stiffening), 2.5 * sigma) << name;
    EXPECT_LT(sigma, 0.75 * kOpenStiffening) << name;
    EXPECT_GT(found->mean[kStiffening], sigma) << name;
  }
}

TEST(ContourSizes, NoStiffeningIsFoundInAWallThatDoesNotStiffen) {
  for (const char* name : {"specimen-1", "specimen-3", "specimen-7", "specimen-9", "specimen-14", "specimen-18"}) {
    const CellReference cell = CellReference::load(name, 1);
    ParametersPrior prior{parameters_of(cell), SolidParameters::Constant(kSeen)};
    prior.sigma[kStiffening] = kOpenStiffening;
    const auto found = estimate(cell, prior);
    ASSERT_TRUE(found) << name;
    EXPECT_LT(found->mean[kStiffening], 2.0 * std::sqrt(found->covariance(kStiffening, kStiffening))) << name;
    EXPECT_GE(found->mean[kStiffening], 0.0) << name;
  }
}

TEST(ContourSizes, KnowsHowTheForceGoesWithTheSizes) {
  // One modulus and one middle radius in all of them.
  const CellReference usual = CellReference::load("specimen-9", 1);
  for (const char* name : {"specimen-1", "specimen-3", "specimen-7", "specimen-14", "specimen-18", "specimen-25"}) {
    const CellReference cell = CellReference::load(name, 1);
    const IndentedSolid& solid = IndentedSolid::shipped();
    for (const double depth_um : {10.0, 20.0, 30.0, 40.0}) {
      const auto log_force_of = [&](const CellReference& one) {
        const double radius_um = one.outer_radius_um();
        return solid.load(parameters_of(one), depth_um / radius_um).log_force + 2.0 * std::log(radius_um);
      };
      const double truth = std::log(cell.force_uN(depth_um) / usual.force_uN(depth_um));
      EXPECT_NEAR(log_force_of(cell) - log_force_of(usual), truth, 0.12) << name << " at " << depth_um << " um";
    }
  }
}

TEST(ContourSizes, LeavesWhatThePictureShows) {
  const CellReference cell = CellReference::load("specimen-9", 1);
  ParametersPrior prior{parameters_of(cell), {0.1, 0.15, 0.4, 0.1, 0.01}};
  prior.mean += SolidParameters{0.1, -0.1, 0.4, 0.0, 0.0};
  const auto found = estimate(cell, prior);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->mean[0], prior.mean[0]);
  EXPECT_EQ(found->mean[1], prior.mean[1]);
  EXPECT_LT(found->mean[2], prior.mean[2] - 0.1);
  prior.sigma[2] = 0.08;
  EXPECT_FALSE(estimate(cell, prior));
}

TEST(ContourSizes, ContoursOfNoSolidSayNothing) {
  // A cell that bulges where no needle makes it: by a tenth of its radius, on the way in.
  const CellReference cell = CellReference::load("specimen-9", 1);
  ContourSizes contours;
  CellPlacement placement;
  for (double depth_um = -1.0; depth_um <= 40.0; depth_um += 0.25) {
    Observation o = view_of(cell, std::max(0.0, depth_um));
    placement.update(o);
    if (depth_um <= 0.0) {
      contours.add_rest(o, placement);
      continue;
    }
    for (Eigen::Index k = 0; k < o.outer->points_um.cols(); ++k) {
      const double turn = std::atan2(o.outer->points_um(1, k), o.outer->points_um(0, k));
      o.outer->points_um.col(k) *= 1.0 + 0.1 * std::cos(6.0 * turn);
    }
    contours.add(o, placement, depth_um, 0.2);
  }
  ASSERT_GT(contours.contour_count(), 3);
  EXPECT_FALSE(settled(contours, {parameters_of(cell), {0.5, 0.15, 0.08, kOpenStiffening, 0.01}}));
}

struct Push {
  bool has_rest = true, shows_holder = true;         ///< an outline at rest; the holding pipette's width
  std::vector<ScaleMeasurement> scale_measurements;  ///< of this cell
};

/// The last estimate of a push to 40 um of which the picture shows so much.
ForceEstimate pushed(const CellReference& cell, const Push& push) {
  ForceObserver observer(load_profile("mouse-oocyte"));
  observer.set_scale_measurements(push.scale_measurements);
  ForceEstimate e;
  long frame = 0;
  for (double depth_um = -5.0; depth_um <= 40.0; depth_um += 0.5) {
    Observation o = view_of(cell, std::max(0.0, depth_um), frame++);
    o.rest_inner_radius_um = cell.inner_radius_um();
    if (!push.shows_holder) o.holder->outer_radius_um = 0.0;
    if (!push.has_rest && depth_um <= 0.0) o.outer->points_um.resize(2, 0);
    e = observer.process(o);
  }
  return e;
}

double log_error(const ForceEstimate& e, const CellReference& cell) {
  return std::log(e.contact_force_uN / cell.force_uN(40.0));
}

// At the sizes that the picture shows and the kind's own modulus: a wall that stiffens bears up to two thirds more.
TEST(ForceObserver, AWallThatStiffensIsSeenByItsContours) {
  for (const auto& [name, stiffening] : kStiffeningCells) {
    const CellReference cell = stiffening_cell(name);
    const ForceEstimate with = pushed(cell, {}), without = pushed(cell, {.has_rest = false});
    EXPECT_LT(std::abs(log_error(with, cell)), 0.1) << name;
    EXPECT_LT(log_error(without, cell), -0.1) << name;
    EXPECT_LE(with.by_picture.lower_uN, cell.force_uN(40.0)) << name;
    EXPECT_GE(with.by_picture.upper_uN, cell.force_uN(40.0)) << name;
  }
}

// A push that was measured has the wall in it at its own depth: counted twice there, the force deeper would be too
// large by as much.
TEST(ForceObserver, AfterAMeasuredPushTheWallCountsFromItsDepth) {
  const CellReference cell = stiffening_cell("specimen-1067");
  ScaleMeasurement known;
  known.at_indentation_um = 30.0;
  known.known_force_uN = cell.force_uN(known.at_indentation_um);
  known.known_force_sigma_percent = 1.0;
  known.at_indentation_sigma_um = 0.1;
  const ForceEstimate e = pushed(cell, {.scale_measurements = {known}});
  ASSERT_TRUE(e.sizes_by_contour);
  EXPECT_GT(e.sizes_by_contour->force_ratio, 1.0);
  EXPECT_LT(std::abs(log_error(e, cell)), 0.1);
}

TEST(ForceObserver, AHoldingPipetteOutOfSizeIsCorrectedByTheContours) {
  // The holder's width is not seen: at the kind's own the force is too large or too small.
  const CellReference cell = CellReference::load("specimen-14", 1);
  const ForceEstimate with = pushed(cell, {.shows_holder = false});
  const ForceEstimate without = pushed(cell, {.has_rest = false, .shows_holder = false});
  EXPECT_TRUE(with.sizes_by_contour);
  EXPECT_FALSE(without.sizes_by_contour);
  EXPECT_LT(std::abs(log_error(with, cell)), 0.7 * std::abs(log_error(without, cell)));
}

}  // namespace
}  // namespace pellucida
