#include "PhysicalSize.h"

#include <gtest/gtest.h>

#include <limits>

namespace pellucida {
namespace {

double pixel_size(const std::string& description, double per_unit, ResolutionUnit unit) {
  return physical_size(description, per_unit, per_unit, unit).pixel_size_um.value_or(0.0);
}

TEST(PhysicalSize, ResolutionFineEnoughIsAMicroscopes) {
  EXPECT_NEAR(pixel_size("", 12121.2, ResolutionUnit::kCentimetre), 0.825, 1e-5);
  EXPECT_NEAR(pixel_size("", 25400.0 / 0.825, ResolutionUnit::kInch), 0.825, 1e-9);
}

TEST(PhysicalSize, PrintersResolutionSaysNothing) {
  for (const double dots_per_inch : {72.0, 96.0, 300.0, 600.0, 1200.0}) {
    EXPECT_EQ(pixel_size("", dots_per_inch, ResolutionUnit::kInch), 0.0) << dots_per_inch;
  }
  EXPECT_EQ(pixel_size("", 28.35, ResolutionUnit::kCentimetre), 0.0);
}

TEST(PhysicalSize, ResolutionWithoutUnitSaysNothing) {
  EXPECT_EQ(pixel_size("", 12121.2, ResolutionUnit::kNone), 0.0);
  EXPECT_EQ(pixel_size("", 0.0, ResolutionUnit::kInch), 0.0);
  EXPECT_EQ(pixel_size("", std::numeric_limits<double>::quiet_NaN(), ResolutionUnit::kInch), 0.0);
}

TEST(PhysicalSize, UnequalResolutionSaysNothing) {
  EXPECT_FALSE(physical_size("", 10000.0, 12000.0, ResolutionUnit::kCentimetre).pixel_size_um);
  EXPECT_TRUE(physical_size("", 10000.0, 10050.0, ResolutionUnit::kCentimetre).pixel_size_um);
}

TEST(PhysicalSize, ReadsImageJ) {
  const std::string head = "ImageJ=1.53t\nimages=3\nframes=3\n";
  for (const char* unit : {"micron", "um", "\xC2\xB5m", "\\u00B5m", "\xB5m"}) {
    EXPECT_NEAR(pixel_size(head + "unit=" + unit + "\nfinterval=0.1\n", 1.0 / 0.825, ResolutionUnit::kNone), 0.825,
                1e-9)
        << unit;
  }
  EXPECT_NEAR(pixel_size(head + "unit=nm\n", 0.01, ResolutionUnit::kNone), 0.1, 1e-9);
  EXPECT_NEAR(pixel_size(head + "unit=mm\n", 1000.0, ResolutionUnit::kNone), 1.0, 1e-9);
  EXPECT_EQ(pixel_size(head + "unit=pixel\n", 1.0, ResolutionUnit::kNone), 0.0);
  EXPECT_NEAR(*physical_size(head + "finterval=0.04\n", 0, 0, ResolutionUnit::kNone).frame_rate_hz, 25.0, 1e-9);
  EXPECT_NEAR(*physical_size(head + "fps=12.5\n", 0, 0, ResolutionUnit::kNone).frame_rate_hz, 12.5, 1e-9);
}

TEST(PhysicalSize, ReadsOme) {
  const std::string ome =
      R"(<OME><Image><Pixels PhysicalSizeX="0.325" PhysicalSizeXUnit="µm" TimeIncrement="0.5"/></Image></OME>)";
  EXPECT_NEAR(pixel_size(ome, 0.0, ResolutionUnit::kNone), 0.325, 1e-9);
  EXPECT_NEAR(*physical_size(ome, 0, 0, ResolutionUnit::kNone).frame_rate_hz, 2.0, 1e-9);
  EXPECT_NEAR(pixel_size(R"(<Pixels PhysicalSizeX="325" PhysicalSizeXUnit="nm"/>)", 0.0, ResolutionUnit::kNone), 0.325,
              1e-9);
  EXPECT_NEAR(pixel_size(R"(<Pixels PhysicalSizeX="0.65"/>)", 0.0, ResolutionUnit::kNone), 0.65, 1e-9);
}

TEST(PhysicalSize, ReadsPlainWords) {
  EXPECT_NEAR(pixel_size("Pixel width = 0.825 um, 8 bit", 0.0, ResolutionUnit::kNone), 0.825, 1e-9);
  EXPECT_NEAR(pixel_size("pixel_size: 825 nm", 0.0, ResolutionUnit::kNone), 0.825, 1e-9);
}

TEST(PhysicalSize, NonsenseSaysNothing) {
  for (const char* text : {"unit=micron\n", "pixel size = 0 um", "pixel size = -1 um", "pixel size = 0.8 parsec",
                           R"(PhysicalSizeX="nan")", "pixel size = 1e99 um", "finterval=0\n", "fps=-3\n"}) {
    const PhysicalSize size = physical_size(text, 0.0, 0.0, ResolutionUnit::kNone);
    EXPECT_FALSE(size.pixel_size_um) << text;
    EXPECT_FALSE(size.frame_rate_hz) << text;
  }
}

}  // namespace
}  // namespace pellucida
