#include "pellucida/visualization/Readout.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

TEST(Readout, NumbersCarryTheirUnits) {
  Measurement m;
  m.indentation_um = 23.42;
  m.contact_force_uN = 3.416;
  m.contact_force_lower_uN = 3.1;
  m.contact_force_upper_uN = 3.75;
  m.pressure_Pa = 151.6;
  m.confidence = 0.968;
  EXPECT_EQ(readout::indentation(m), "23.4 µm");
  EXPECT_EQ(readout::force(m), "3.42 µN");
  EXPECT_EQ(readout::force_interval(m), "3.10 – 3.75 µN");
  EXPECT_EQ(readout::pressure(m), "152 Pa");
  EXPECT_EQ(readout::confidence(m), "97 %");
  EXPECT_EQ(readout::time(12.4), "12.40 s");
  EXPECT_EQ(readout::milliseconds(17.6), "18 ms");
}

TEST(Readout, NotMeasuredIsADashAndNoInterval) {
  const Measurement m;
  EXPECT_EQ(readout::indentation(m), "–");
  EXPECT_EQ(readout::force(m), "–");
  EXPECT_EQ(readout::force_interval(m), "");
  EXPECT_EQ(readout::pressure(m), "–");
}

TEST(Readout, NoNegativeZero) {
  EXPECT_EQ(readout::number(-0.001, 2), "0.00");
  EXPECT_EQ(readout::number(-0.006, 2), "-0.01");
}

TEST(Readout, PlainHasNoTrailingZeros) {
  EXPECT_EQ(readout::plain(0.05), "0.05");
  EXPECT_EQ(readout::plain(20.0), "20");
}

}  // namespace
}  // namespace pellucida
