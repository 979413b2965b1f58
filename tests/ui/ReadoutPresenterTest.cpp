#include "presenters/ReadoutPresenter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pellucida {
namespace {

bool equal_colors(const Color& a, const Color& b) {
  return a.css() == b.css();
}

Scene measured_scene() {
  Scene scene;
  Measurement& m = scene.measurement;
  m.state = CellState::kContact;
  m.confidence = 0.93;
  m.indentation_um = 23.4;
  m.contact_force_uN = 3.42;
  m.contact_force_lower_uN = 3.10;
  m.contact_force_upper_uN = 3.75;
  m.pressure_Pa = 152.0;
  return scene;
}

CellProfile oocyte() {
  CellProfile profile;
  profile.name = "mouse-oocyte";
  profile.description = "Mouse oocyte, zona pellucida";
  return profile;
}

TEST(ReadoutPresenter, ShowsTheScenesFigures) {
  const Scene scene = measured_scene();
  const ReadoutTexts texts = readout_texts(&scene, oocyte());
  EXPECT_EQ(texts.state.text, "Contact");
  EXPECT_TRUE(equal_colors(texts.state.color, state_color(CellState::kContact)));
  EXPECT_EQ(texts.indentation.text, "23.4 µm");
  EXPECT_EQ(texts.force.text, "3.42 µN");
  EXPECT_EQ(texts.force_note.text, "95 %: 3.10 – 3.75 µN");
  EXPECT_EQ(texts.pressure.text, "152 Pa");
  EXPECT_EQ(texts.confidence.text, "93 %");
  EXPECT_EQ(force_notice(scene).text, "");
}

TEST(ReadoutPresenter, SaysWhichPartOpensTheInterval) {
  Scene scene = measured_scene();
  EXPECT_EQ(readout_texts(&scene, oocyte()).force_parts.text, "");
  Measurement& m = scene.measurement;
  m.contact_force_picture_lower_uN = m.contact_force_uN * (1.0 - 1.96 * 0.09);
  m.contact_force_picture_upper_uN = m.contact_force_uN * (1.0 + 1.96 * 0.09);
  m.contact_force_scale_lower_uN = m.contact_force_uN * std::exp(-1.96 * 0.46);
  m.contact_force_scale_upper_uN = m.contact_force_uN * std::exp(1.96 * 0.46);
  EXPECT_EQ(readout_texts(&scene, oocyte()).force_parts.text, "picture ±9 %, kind of cell ±46 %");
  EXPECT_EQ(readout_texts(&scene, oocyte()).force_parts_short, "±9 %, kind ±46 %");
  EXPECT_NE(readout_texts(&scene, oocyte()).force_tip.find("single cells of this kind"), std::string::npos);
  m.puncture_probability = 0.02;
  EXPECT_EQ(readout_texts(&scene, oocyte()).force_parts.text, "picture ±9 %, this cell ±46 %");
}

TEST(ReadoutPresenter, BeforeTheFirstSceneThereAreDashesAndTheProfile) {
  const ReadoutTexts texts = readout_texts(nullptr, oocyte());
  EXPECT_EQ(texts.state.text, "Waiting");
  EXPECT_EQ(texts.force.text, "–");
  EXPECT_EQ(texts.force_note.text, "");
  EXPECT_EQ(texts.confidence.text, "–");
  EXPECT_EQ(texts.profile.text, "mouse-oocyte");
  EXPECT_NE(texts.profile_tip.find("Mouse oocyte, zona pellucida"), std::string::npos);
}

TEST(ReadoutPresenter, WarnsOfAWeakMeasurement) {
  Scene scene = measured_scene();
  scene.measurement.confidence = 0.3;
  EXPECT_TRUE(equal_colors(readout_texts(&scene, oocyte()).confidence.color, palette::kWarning));
}

// A wrong pixel size: no force, and why.
TEST(ReadoutPresenter, AMissingForceHasItsReason) {
  Scene scene = measured_scene();
  scene.measurement.contact_force_uN = Measurement::kNotMeasured;
  scene.remarks.reason =
      "no cell of profile mouse-oocyte: its radius is 105 um, the profile's 50 um; check the pixel size";
  const ReadoutTexts texts = readout_texts(&scene, oocyte());
  EXPECT_EQ(texts.force.text, "–");
  EXPECT_EQ(texts.force_note.text, "no force, see below");
  EXPECT_TRUE(equal_colors(texts.force_note.color, palette::kWarning));
  EXPECT_NE(texts.force_tip.find("its radius is 105 um"), std::string::npos);
  EXPECT_EQ(force_notice(scene).text, "No force: " + scene.remarks.reason);
}

TEST(ReadoutPresenter, ADoubtfulForceIsMarkedAndSaysWhy) {
  Scene scene = measured_scene();
  scene.remarks.warning = "the contour does not match the model's";
  const ReadoutTexts texts = readout_texts(&scene, oocyte());
  EXPECT_EQ(texts.force_note.text, "95 %: 3.10 – 3.75 µN");
  EXPECT_TRUE(equal_colors(texts.force_note.color, palette::kWarning));
  EXPECT_EQ(force_notice(scene).text, "Force in doubt: the contour does not match the model's");
}

// 44 % beside an interval of +-10 %: what it is of, each by itself.
TEST(ReadoutPresenter, TheSpreadOfTheModelsIsExplained) {
  Scene scene = measured_scene();
  EXPECT_EQ(readout_texts(&scene, oocyte()).force_tip.find("Other models"), std::string::npos);
  scene.remarks.point_load_uN = 1.35;
  scene.remarks.table_uN = 3.40;
  scene.measurement.model_spread_percent = 35.2;
  const std::string tip = readout_texts(&scene, oocyte()).force_tip;
  EXPECT_NE(tip.find("point-load formula 1.35 µN, finite-element table 3.40 µN (spread 35 %)"), std::string::npos)
      << tip;
}

}  // namespace
}  // namespace pellucida
