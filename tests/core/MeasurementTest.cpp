#include "pellucida/core/Measurement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/core/Table.h"
#include "support/DocsPage.h"

namespace pellucida {
namespace {

TEST(Measurement, HeaderIsTheContract) {
  EXPECT_EQ(measurement_header(),
            "frame,time_s,state,confidence,cell_x_um,cell_y_um,axis_deg,tip_x_um,tip_y_um,indentation_um,"
            "dimple_radius_um,contact_force_uN,contact_force_lower_uN,contact_force_upper_uN,pressure_Pa,volume_um3,"
            "frame_age_ms,lateral_force_uN,stiffness_uN_per_um,shape_residual_um,asymmetry_um,model_spread_percent,"
            "puncture_probability,contact_force_picture_lower_uN,contact_force_picture_upper_uN,"
            "contact_force_scale_lower_uN,contact_force_scale_upper_uN,expected_puncture_uN,expected_puncture_um,"
            "manipulator_x_um,manipulator_y_um,strain_stiffening,strain_stiffening_lower,strain_stiffening_upper");
  EXPECT_TRUE(measurement_header().starts_with(measurement_header_start()));
  EXPECT_TRUE(measurement_header_start().ends_with("volume_um3,frame_age_ms"));
}

TEST(Measurement, FileFormatPageHasTheColumnsInTheirOrder) {
  std::string rows;
  for (const auto& column : measurement_columns()) {
    rows +=
        "| `" + std::string(column.name) + "` | " + std::string(column.unit) + " | " + std::string(column.doc) + " |\n";
  }
  const std::string section = docs_section("file-format.md", "## measurements.csv");
  const auto start = section.find("| `confidence` |");
  ASSERT_NE(start, std::string::npos);
  EXPECT_EQ(section.substr(start, section.find("\n\n", start) + 1 - start), rows);
}

TEST(Measurement, RowReadsBackAndEmptyCellsMeanNotMeasured) {
  Measurement m;
  m.frame = 41;
  m.time_s = 1.3666667;
  m.state = CellState::kContact;
  m.confidence = 0.93;
  m.indentation_um = 12.25;
  m.contact_force_uN = 1.5;
  const std::string row = to_csv(m);
  EXPECT_EQ(row, "41,1.3666667,contact,0.93,,,,,,12.25,,1.5,,,,,,,,,,,,,,,,,,,,,,");
  const Measurement back = measurement_from_csv(row);
  EXPECT_EQ(back.frame, 41);
  EXPECT_EQ(back.state, CellState::kContact);
  EXPECT_DOUBLE_EQ(back.indentation_um, 12.25);
  EXPECT_TRUE(std::isnan(back.tip_x_um));
  EXPECT_EQ(to_csv(back), row);
}

TEST(Measurement, RowOfAnEarlierVersionLacksTheLaterColumns) {
  const Measurement old = measurement_from_csv("7,0.2,free,0.9,1,2,3,4,5,0,0,0,0,0,0,500000,12");
  EXPECT_EQ(old.frame_age_ms, 12.0);
  EXPECT_TRUE(std::isnan(old.lateral_force_uN) && std::isnan(old.puncture_probability));
}

TEST(Measurement, TheForcesSpreadSaysWhichOfItsPartsOpensTheInterval) {
  Measurement m;
  EXPECT_EQ(to_string(force_spread(m)), "");
  m.contact_force_uN = 2.0;
  m.contact_force_picture_lower_uN = 2.0 - 1.96 * 0.18;
  m.contact_force_picture_upper_uN = 2.0 + 1.96 * 0.18;
  m.contact_force_scale_lower_uN = 2.0 * std::exp(-1.96 * 0.46);
  m.contact_force_scale_upper_uN = 2.0 * std::exp(1.96 * 0.46);
  EXPECT_NEAR(force_spread(m).picture_ratio, 0.09, 1e-12);
  EXPECT_NEAR(force_spread(m).scale_ratio, 0.46, 1e-12);
  EXPECT_EQ(to_string(force_spread(m)), "picture +-9 %, kind of cell +-46 %");
  m.puncture_probability = 0.1;
  m.contact_force_scale_lower_uN = 2.0 * std::exp(-1.96 * 0.08);
  m.contact_force_scale_upper_uN = 2.0 * std::exp(1.96 * 0.08);
  EXPECT_EQ(to_string(force_spread(m)), "picture +-9 %, this cell +-8 %");
  // Neither a force of 0 nor a row of an earlier version has any.
  m.contact_force_uN = 0.0;
  EXPECT_EQ(to_string(force_spread(m)), "");
  const Measurement old = measurement_from_csv("7,0.2,contact,0.9,1,2,3,4,5,10,3,1.5,1.4,1.6,0,500000,12,0,0,0,0,0,");
  EXPECT_EQ(to_string(force_spread(old)), "");
}

TEST(Measurement, BrokenRowsNameTheColumn) {
  EXPECT_THROW(measurement_from_csv("1,2,free"), InputError);
  try {
    measurement_from_csv("1,2,free,high,,,,,,,,,,,,,");
    FAIL() << "a word in a numeric column was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("confidence"), std::string::npos);
  }
  EXPECT_THROW(measurement_from_csv("1,2,asleep,,,,,,,,,,,,,,"), InputError);
}

// A frame that was kept but not measured says so: it is not one in which the cell was lost.
TEST(Measurement, ARowWithoutAStateWasNotMeasured) {
  Measurement m;
  m.frame = 12;
  m.time_s = 0.4;
  const std::string row = to_csv(m);
  EXPECT_EQ(row, "12,0.4,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,");
  const Measurement back = measurement_from_csv(row);
  EXPECT_FALSE(back.state);
  EXPECT_TRUE(std::isnan(back.confidence));
  EXPECT_EQ(measurement_from_csv("12,0.4,lost,0,,,,,,,,,,,,,").state, CellState::kLost);
}

TEST(Measurement, StateNamesRoundTrip) {
  for (const char* name : {"no_cell", "free", "contact", "punctured", "lost"}) {
    const auto state = cell_state_from_string(name);
    ASSERT_TRUE(state) << name;
    EXPECT_EQ(to_string(*state), name);
  }
  EXPECT_FALSE(cell_state_from_string("gone"));
}

TEST(Measurement, FromObservationTakesOnlyWhatWasSeen) {
  Observation o;
  o.state = CellState::kFree;
  o.center_um = {10.0, 20.0};
  Measurement m = measurement_from(o);
  EXPECT_TRUE(std::isnan(m.cell_x_um));
  EXPECT_TRUE(std::isnan(m.axis_deg));

  o.outer = MembraneContour{};
  o.needle = NeedlePose{};
  o.axis = {0.0, 1.0};
  m = measurement_from(o);
  EXPECT_DOUBLE_EQ(m.cell_y_um, 20.0);
  EXPECT_DOUBLE_EQ(m.axis_deg, 90.0);  // +y is down in the image, and positive
}

}  // namespace
}  // namespace pellucida
