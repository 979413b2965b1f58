#include "pellucida/mechanics/ShapeAudit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "SectionContours.h"
#include "pellucida/mechanics/RevolvedContour.h"
#include "pellucida/membrane/Indenter.h"
#include "support/TestProfiles.h"

namespace pellucida {
namespace {

constexpr double kThickness_um = 5.0;

/// Placement of C in W for a needle direction of the section.
Eigen::Matrix3d rotation_of(const Eigen::Vector2d& z) {
  Eigen::Matrix3d rotation;
  rotation << -z.y(), 0.0, z.x(), z.x(), 0.0, z.y(), 0.0, 1.0, 0.0;
  return rotation;
}

struct Pushed {
  explicit Pushed(int configuration, double depth_um, double turn_rad = 0.7)
      : profile(load_profile("mouse-oocyte")), indenter(profile, setup_for_configuration(profile, configuration)) {
    indenter.advance_to(depth_um);
    observation.center_um = {200.0, 150.0};
    observation.rest_outer_radius_um = 52.5;
    z = {std::cos(turn_rad), std::sin(turn_rad)};
    testing::add_contours(observation, indenter.model().rest(), indenter.positions_um(), z, kThickness_um);
  }
  ShapeAudit audit(ShapeAuditor& auditor, const Eigen::Matrix3Xd& x_um) const {
    auditor.set_model(indenter.model().rest());
    return auditor.audit(observation, x_um, rotation_of(z), {200.0, 150.0, 0.0}, kThickness_um);
  }
  CellProfile profile;
  Indenter indenter;
  Observation observation;
  Eigen::Vector2d z;
};

TEST(ShapeAudit, AContourThatIsTheModelsLeavesNoResidual) {
  for (const double turn : {0.0, 0.7, -2.5}) {
    const Pushed pushed(3, 20.0, turn);
    ShapeAuditor auditor;
    const ShapeAudit audit = pushed.audit(auditor, pushed.indenter.positions_um());
    EXPECT_LT(audit.residual_rms_um, 1e-9) << turn;
    EXPECT_LT(audit.unexplained_asymmetry_um, 1e-9) << turn;
    EXPECT_LT(std::abs(audit.dimple_residual_um), 1e-9) << turn;
    EXPECT_NEAR(audit.noise_um, 0.1, 1e-12);
  }
}

TEST(ShapeAudit, ADepthThatIsWrongShowsInTheDimpleWithItsSign) {
  const Pushed deep(1, 20.0), shallow(1, 17.0);
  ShapeAuditor auditor;
  // The contour lies 3 um farther out than the model.
  const ShapeAudit audit = shallow.audit(auditor, deep.indenter.positions_um());
  EXPECT_NEAR(audit.dimple_residual_um, 3.0, 0.2);
  EXPECT_GT(audit.residual_rms_um, 0.5);
  EXPECT_LT(audit.unexplained_asymmetry_um, 1e-9);
}

TEST(ShapeAudit, AsymmetryIsWhatNoSurfaceOfRevolutionShows) {
  ShapeAuditor auditor;
  const Pushed straight(1, 30.0), across(3, 30.0);
  EXPECT_LT(straight.audit(auditor, straight.indenter.positions_um()).asymmetry_um, 1e-9);
  const ShapeAudit seen = across.audit(auditor, across.indenter.positions_um());
  EXPECT_GT(seen.asymmetry_um, 1.5);
  // The model that knows the holder explains it; one with the needle opposite the holder doesn't.
  EXPECT_LT(seen.unexplained_asymmetry_um, 1e-9);
  EXPECT_GT(across.audit(auditor, straight.indenter.positions_um()).unexplained_asymmetry_um, 1.5);
}

TEST(ShapeAudit, WithoutAContourNothingIsMeasured) {
  Pushed pushed(1, 10.0);
  pushed.observation.outer.reset();
  ShapeAuditor auditor;
  EXPECT_TRUE(std::isnan(pushed.audit(auditor, pushed.indenter.positions_um()).residual_rms_um));
}

TEST(ShapeAudit, NeedleContactOfALineBesideTheCentre) {
  Observation o;
  o.center_um = {100.0, 100.0};
  o.rest_outer_radius_um = 50.0;
  o.needle = NeedlePose{};
  o.needle->direction = {1.0, 0.0};
  o.needle->tip_um = {80.0, 70.0};
  // The line y = 70 passes 30 um beside the centre and enters the circle at x = 100 - 40.
  const NeedleContact contact = needle_contact(o);
  EXPECT_NEAR(contact.offset_um, 30.0, 1e-12);
  EXPECT_NEAR((contact.entry_um - Eigen::Vector2d(60.0, 70.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(contact.tip_depth_um, 20.0, 1e-12);
  o.needle->tip_um = {20.0, 160.0};
  EXPECT_LT(needle_contact(o).offset_um, -50.0);
  EXPECT_LT(needle_contact(o).tip_depth_um, 0.0);
}

TEST(RevolvedContour, NodesLieOnTheContourTheyAreLaidOn) {
  const Pushed deep(1, 20.0), shallow(1, 19.0);
  ShapeAuditor auditor;
  shallow.audit(auditor, deep.indenter.positions_um());
  const Eigen::Matrix3Xd laid = lay_on_contour(deep.indenter.model().rest(), deep.indenter.positions_um(), auditor);
  const double before = shallow.audit(auditor, deep.indenter.positions_um()).residual_rms_um;
  EXPECT_LT(shallow.audit(auditor, laid).residual_rms_um, 0.13 * before);
  // Also in the directions that the image doesn't show: the dimple's whole rim has moved alike.
  const auto observed = observe_revolved(deep.indenter.model().rest(), deep.indenter.positions_um(), auditor, 1e-6);
  EXPECT_EQ(static_cast<Eigen::Index>(observed.size()), laid.cols());
}

}  // namespace
}  // namespace pellucida
