#include "presenters/ScalePresenter.h"

#include <gtest/gtest.h>

#include "pellucida/core/FieldTable.h"

namespace pellucida {
namespace {

CellProfile oocyte_of(double spread) {
  CellProfile profile;
  profile.name = "mouse-oocyte";
  profile.kind_spread_ratio = spread;
  return profile;
}

TEST(ScalePresenter, TheGaugeGoesFromTheKindToThisCell) {
  const ScaleTexts kind = scale_texts(nullptr, oocyte_of(0.46));
  EXPECT_EQ(kind.text.text, "±46 %");
  EXPECT_NE(kind.tip.find("Kind of cell ±46 %"), std::string::npos);
  EXPECT_FALSE(kind.is_own);
  Scene scene;
  scene.remarks.scale_ratio = 1.0;
  scene.remarks.scale_sigma_ratio = 0.46;
  EXPECT_EQ(scale_texts(&scene, oocyte_of(0.46)).text.text, "±46 %");
  scene.remarks.scale_ratio = 1.2;
  scene.remarks.scale_sigma_ratio = 0.08;
  scene.remarks.has_own_scale = true;
  const ScaleTexts own = scale_texts(&scene, oocyte_of(0.46));
  EXPECT_EQ(own.text.text, "±8 %");
  EXPECT_NE(own.tip.find("1.20 times as stiff"), std::string::npos);
  EXPECT_EQ(own.ratio, 1.2);
  EXPECT_EQ(own.kind_sigma, 0.46);
}

TEST(ScalePresenter, EveryRowOfTheFormsIsANumberOfTheMeasurement) {
  ScaleMeasurement measurement;
  const FieldList fields = fields_of(measurement);
  ASSERT_EQ(scale_forms().size(), 3U);
  for (const ScaleForm& form : scale_forms()) {
    for (const auto& [key, label] : form.rows) EXPECT_NE(fields.find(key), nullptr) << key;
  }
}

TEST(ScalePresenter, WhatThePictureKnowsIsFilledIn) {
  EXPECT_EQ(seen_for_scale(nullptr).at_indentation_um, 0.0);
  Scene scene;
  Observation observation;
  observation.state = CellState::kContact;
  observation.indentation_um = 7.5;
  observation.indentation_sigma_um = 0.3;
  observation.rest_outer_radius_um = 52.0;
  observation.rest_inner_radius_um = 46.0;
  scene.observation = std::make_shared<const Observation>(observation);
  EXPECT_EQ(seen_for_scale(&scene).at_indentation_um, 7.5);
  EXPECT_EQ(seen_for_scale(&scene).at_indentation_sigma_um, 0.3);
  EXPECT_EQ(seen_for_scale(&scene).zona_thickness_um, 6.0);
}

}  // namespace
}  // namespace pellucida
