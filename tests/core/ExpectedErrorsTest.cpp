#include <gtest/gtest.h>

#include "pellucida/core/Error.h"
#include "pellucida/core/Expected.h"

namespace pellucida {
namespace {

// The exit codes are a contract with scripts: the numbers themselves are asserted.
TEST(Error, EachKindCarriesItsExitCode) {
  EXPECT_EQ(static_cast<int>(UsageError("x").code()), 2);
  EXPECT_EQ(static_cast<int>(InputError("x").code()), 3);
  EXPECT_EQ(static_cast<int>(NothingMeasuredError("x").code()), 4);
  EXPECT_EQ(static_cast<int>(OutputError("x").code()), 5);
  EXPECT_EQ(static_cast<int>(DeviceError("x").code()), 6);
  EXPECT_STREQ(UsageError("pixel size 0; give a positive one").what(), "pixel size 0; give a positive one");
}

TEST(Expected, HoldsAValueOrAFailure) {
  const auto halve = [](int n) -> expected<int, std::string> {
    if (n % 2) return unexpected<std::string>("odd");
    return n / 2;
  };
  EXPECT_EQ(halve(8).value(), 4);
  EXPECT_EQ(halve(7).error(), "odd");
}

}  // namespace
}  // namespace pellucida
