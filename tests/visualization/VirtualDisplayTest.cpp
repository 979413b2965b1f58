#include "pellucida/visualization/VirtualDisplay.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// Puts an environment variable back when the test ends.
class KeptVariable {
 public:
  explicit KeptVariable(const char* name) : name_(name) {
    if (const char* value = std::getenv(name)) value_ = value;
  }
  ~KeptVariable() {
    if (value_) {
      setenv(name_, value_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }

 private:
  const char* name_;
  std::optional<std::string> value_;
};

TEST(VirtualDisplay, StartsAServerWhereThereIsNoneAndPutsTheEnvironmentBack) {
  const KeptVariable kept("DISPLAY");
  unsetenv("DISPLAY");
  {
    const VirtualDisplay display;
    EXPECT_TRUE(display.started());
    EXPECT_TRUE(display_answers());
  }
  EXPECT_EQ(std::getenv("DISPLAY"), nullptr);
}

TEST(VirtualDisplay, ReplacesADisplayThatDoesNotAnswer) {
  const KeptVariable kept("DISPLAY");
  setenv("DISPLAY", ":32123", 1);
  EXPECT_FALSE(display_answers());
  {
    const VirtualDisplay display;
    EXPECT_TRUE(display.started());
    EXPECT_TRUE(display_answers());
  }
  EXPECT_STREQ(std::getenv("DISPLAY"), ":32123");
}

TEST(VirtualDisplay, LeavesADisplayThatAnswersAlone) {
  const KeptVariable kept("DISPLAY");
  unsetenv("DISPLAY");
  const VirtualDisplay first;
  const VirtualDisplay second;
  EXPECT_TRUE(first.started());
  EXPECT_FALSE(second.started());
}

TEST(VirtualDisplay, WithoutXvfbTheErrorNamesThePackage) {
  const KeptVariable kept_display("DISPLAY");
  const KeptVariable kept_path("PATH");
  unsetenv("DISPLAY");
  setenv("PATH", "/nonexistent", 1);
  try {
    const VirtualDisplay display;
    FAIL() << "no error";
  } catch (const DeviceError& error) {
    EXPECT_NE(std::string(error.what()).find("xvfb"), std::string::npos);
    EXPECT_EQ(error.code(), ExitCode::kDeviceMissing);
  }
}

}  // namespace
}  // namespace pellucida
