#include "presenters/TeachPresenter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "presenters/ParameterScale.h"

namespace pellucida {
namespace {

CellSnapshot snapshot() {
  CellSnapshot s;
  s.parameters.time_step_us = 100.0;
  s.parameters.node_mass_kg = 1e-6;
  s.parameters.integrator = "symplectic-euler";
  s.young_modulus_kPa = 141.0;
  s.stability.stable_step_s = 200e-6;
  s.depth_um = 20.04;
  s.force_uN = 1.971;
  s.volume_change_ratio = -0.0123;
  s.potential_energy_pJ = 20.0;
  s.kinetic_energy_pJ = 0.5;
  s.largest_speed_um_per_s = 1234.4;
  s.steps_per_s = 9876.0;
  s.pace_ratio = 0.5;
  return s;
}

TEST(TeachTexts, AreTheSnapshotsNumbers) {
  const TeachTexts texts = teach_texts(snapshot(), 1.95, dark_theme());
  EXPECT_EQ(texts.state.text, "In contact");
  EXPECT_EQ(texts.depth.text, "20.0 µm");
  EXPECT_EQ(texts.force.text, "1.97 µN");
  EXPECT_EQ(texts.force_note.text, "at rest: 1.95 µN");
  EXPECT_EQ(texts.volume.text, "-1.23 %");
  EXPECT_EQ(texts.energy.text, "20.5 pJ");
  EXPECT_EQ(texts.speed.text, "1234 µm/s");
  EXPECT_EQ(texts.rate.text, "9876 /s, 0.50×");
  // A computer that is too slow is said.
  EXPECT_EQ(texts.rate.color.css(), dark_theme().warning.css());
  EXPECT_TRUE(texts.blow_up.empty());
  EXPECT_TRUE(teach_texts(snapshot(), std::nan(""), dark_theme()).force_note.text.empty());
}

TEST(TeachTexts, ABlowUpNamesTheLimitThatWasBroken) {
  CellSnapshot s = snapshot();
  s.blow_up = BlowUp{BlowUpKind::kEnergyRanAway, 0.123, 250e-6, 146e-6, 5.0, 0.2};
  const TeachTexts texts = teach_texts(s, 0.0, light_theme());
  EXPECT_EQ(texts.state.text, "Blown up");
  for (const char* part : {"250 µs, is above", "146 µs", "symplectic-euler", "5.00 pJ", "0.200 pJ", "Home"}) {
    EXPECT_NE(texts.blow_up.find(part), std::string::npos) << part << " in " << texts.blow_up;
  }
  s.blow_up->stable_step_s = 300e-6;
  EXPECT_NE(teach_texts(s, 0.0, dark_theme()).blow_up.find("is below the limit"), std::string::npos);
  s.blow_up->stable_step_s = std::numeric_limits<double>::infinity();
  s.blow_up->kind = BlowUpKind::kNoSolution;
  EXPECT_NE(teach_texts(s, 0.0, dark_theme()).blow_up.find("not solved"), std::string::npos);
}

TEST(TeachTexts, ForceBetweenTwoPointsOfTheCurve) {
  EXPECT_DOUBLE_EQ(force_at_uN({0, 2, 4}, {0, 1, 3}, 3.0), 2.0);
  EXPECT_DOUBLE_EQ(force_at_uN({0, 2, 4}, {0, 1, 3}, 0.0), 0.0);
  EXPECT_TRUE(std::isnan(force_at_uN({0, 2, 4}, {0, 1, 3}, 4.1)));
  EXPECT_TRUE(std::isnan(force_at_uN({0, 2, 4}, {0, 1, 3}, -0.1)));
  EXPECT_TRUE(std::isnan(force_at_uN({}, {}, 1.0)));
}

TEST(TeachTexts, RowsOfForcesEndWithTheirSum) {
  NodeForces forces;
  forces.force_uN.fill(Eigen::Vector3d(0.0, 0.0, 0.1));
  const auto rows = force_rows(forces);
  ASSERT_EQ(rows.size(), kForceTermCount + 1);
  EXPECT_EQ(rows.front().name, "Meridian springs");
  EXPECT_TRUE(rows.back().is_residual);
  EXPECT_NEAR(rows.back().force_uN.z(), 0.9, 1e-12);
}

TEST(ParameterScale, PlacesAndNumbersGoTogether) {
  for (int k = 0; k < kTeachSliderCount; ++k) {
    const ParameterScale scale(static_cast<TeachSlider>(k));
    for (const double place : {0.0, 1.0}) EXPECT_NEAR(scale.place_of(scale.value_at(place)), place, 1e-12);
    const double middle = scale.value_at(0.5);
    EXPECT_NEAR(scale.value_at(scale.place_of(middle)) / middle, 1.0, 1e-9);
    EXPECT_LT(scale.value_at(0.2), scale.value_at(0.7));
    TeachingParameters p;
    scale.set(p, middle);
    EXPECT_EQ(scale.value_in(p), middle);
    EXPECT_NO_THROW(require_valid(p)) << scale.name;
  }
  EXPECT_EQ(ParameterScale(TeachSlider::kTimeStep).text(146.4), "146 µs");
  EXPECT_EQ(ParameterScale(TeachSlider::kTimeStep).text(15000.0), "15 ms");
  EXPECT_EQ(ParameterScale(TeachSlider::kMesh).text(9.0), "812 nodes");
}

TEST(StablePart, FollowsTheLimit) {
  const CellSnapshot s = snapshot();
  const StablePart step = stable_part(TeachSlider::kTimeStep, s);
  EXPECT_EQ(step.from, 0.0);
  EXPECT_NEAR(ParameterScale(TeachSlider::kTimeStep).value_at(step.to), 200.0, 1e-6);
  EXPECT_EQ(step.text, "stable below 200 µs");
  // Half of the limit: a quarter of the mass, or four times the modulus, would do.
  EXPECT_NEAR(ParameterScale(TeachSlider::kNodeMass).value_at(stable_part(TeachSlider::kNodeMass, s).from), 2.5e-7,
              1e-12);
  EXPECT_NEAR(ParameterScale(TeachSlider::kModulus).value_at(stable_part(TeachSlider::kModulus, s).to), 564.0, 1e-6);
  EXPECT_TRUE(stable_part(TeachSlider::kPace, s).text.empty());
  CellSnapshot implicit = s;
  implicit.stability.stable_step_s = std::numeric_limits<double>::infinity();
  EXPECT_EQ(stable_part(TeachSlider::kTimeStep, implicit).text, "stable at any step");
  EXPECT_EQ(stable_part(TeachSlider::kTimeStep, implicit).to, 1.0);
  EXPECT_TRUE(stable_part(TeachSlider::kNodeMass, implicit).text.empty());
}

}  // namespace
}  // namespace pellucida
