#include "pellucida/identification/MeasuredCurve.h"

#include <gtest/gtest.h>

#include <fstream>

#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"

namespace pellucida {
namespace {

class MeasuredCurveFile : public ::testing::Test {
 protected:
  std::filesystem::path with(const std::string& text) {
    const auto file = folder_ / "curve.csv";
    std::ofstream(file) << text;
    return file;
  }
  /// The text of the error that reading `text` ends in.
  std::string error_of(const std::string& text) {
    try {
      read_measured_curve(with(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
};

TEST_F(MeasuredCurveFile, IsReadInAnyOrder) {
  const MeasuredCurve curve =
      read_measured_curve(with("time_s,force_uN,indentation_um\n0,3,20\n1,0,0\n2,1,10\n3,5,30\n"));
  EXPECT_EQ(curve.indentation_um, Eigen::Vector4d(0.0, 10.0, 20.0, 30.0));
  EXPECT_EQ(curve.force_uN, Eigen::Vector4d(0.0, 1.0, 3.0, 5.0));
}

TEST_F(MeasuredCurveFile, ATableTooLongForACurveIsRefused) {
  std::string text = "indentation_um,force_uN\n";
  for (int i = 0; i <= 10000; ++i) text += std::to_string(i) + ",1\n";
  EXPECT_NE(error_of(text).find("10001 rows"), std::string::npos);
}

TEST_F(MeasuredCurveFile, FaultsAreNamed) {
  EXPECT_NE(error_of("indentation_um,force\n1,1\n").find("force_uN"), std::string::npos);
  EXPECT_NE(error_of("indentation_um,force_uN\n1,x\n").find("not a number"), std::string::npos);
  EXPECT_NE(error_of("indentation_um,force_uN\n-1,1\n2,2\n3,3\n4,4\n").find("below 0"), std::string::npos);
  EXPECT_NE(error_of("indentation_um,force_uN\n1,\n2,2\n3,3\n4,4\n").find("row 1"), std::string::npos);
  EXPECT_NE(error_of("indentation_um,force_uN\n0,0\n2,2\n3,3\n").find("three"), std::string::npos);
  EXPECT_NE(error_of("").find("header"), std::string::npos);
}

TEST_F(MeasuredCurveFile, ThatIsntThereIsAnInputError) {
  EXPECT_THROW(read_measured_curve(folder_ / "none.csv"), InputError);
}

}  // namespace
}  // namespace pellucida
