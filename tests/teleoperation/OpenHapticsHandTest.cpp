#include "pellucida/teleoperation/OpenHapticsHand.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <limits>

#include "pellucida/core/Error.h"
#include "teleoperation/Eventually.h"

namespace pellucida {
namespace {

/// The hardware behind the stand-in library.
class Hardware {
 public:
  Hardware() : library_(dlopen(PELLUCIDA_HDAPI_STAND_IN, RTLD_NOW | RTLD_LOCAL)) {
    if (!library_) ADD_FAILURE() << dlerror();
    find(place, "stand_in_place");
    find(force, "stand_in_force");
    find(plug, "stand_in_plug");
    find(tick, "stand_in_tick");
    plug(true);
    tick(true);
    place(0.0, 0.0, 0.0, 0);
  }
  ~Hardware() { dlclose(library_); }

  void (*place)(double, double, double, int) = nullptr;
  void (*force)(double*) = nullptr;
  void (*plug)(bool) = nullptr;
  void (*tick)(bool) = nullptr;

  double force_x_N() const {
    double values_N[3];
    force(values_N);
    return values_N[0];
  }

 private:
  template <class Function>
  void find(Function& function, const char* name) {
    function = reinterpret_cast<Function>(dlsym(library_, name));
  }
  void* library_;
};

OpenHapticsOptions stand_in(const std::string& device = {}) {
  return {PELLUCIDA_HDAPI_STAND_IN, device};
}

std::string fault_of(const OpenHapticsOptions& options) {
  try {
    OpenHapticsHand hand(options);
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "opened";
}

class OpenHapticsHandTest : public testing::Test {
 protected:
  bool read(OpenHapticsHand& hand) { return hand.read(time_s_ += 1e-4, sample_); }

  Hardware hardware_;
  HandSample sample_;
  double time_s_ = 0.0;
};

TEST_F(OpenHapticsHandTest, TakesItsLimitsFromTheDriver) {
  OpenHapticsHand hand(stand_in());
  const DeviceSpecification& limits = hand.specification();
  EXPECT_EQ(limits.name, "Stand-in Touch");
  EXPECT_NEAR(limits.max_force_N, 3.3, 1e-12);
  EXPECT_NEAR(limits.max_continuous_force_N, 0.88, 1e-12);
  EXPECT_NEAR(limits.max_stiffness_N_per_m, 500.0, 1e-9);
  EXPECT_NEAR(limits.max_damping_N_s_per_m, 2.0, 1e-9);
  EXPECT_NEAR(limits.workspace_radius_m, 0.035, 1e-12);
}

TEST_F(OpenHapticsHandTest, ReadsMillimetresAsMetresAndButtons) {
  OpenHapticsHand hand(stand_in());
  hardware_.place(10.0, -20.0, 30.0, 3);
  eventually([&] { return read(hand) && sample_.position_m.x > 0.0; });
  EXPECT_NEAR(sample_.position_m.x, 0.010, 1e-12);
  EXPECT_NEAR(sample_.position_m.y, -0.020, 1e-12);
  EXPECT_NEAR(sample_.position_m.z, 0.030, 1e-12);
  EXPECT_TRUE(sample_.velocity_known);
  EXPECT_NEAR(sample_.velocity_m_per_s.x, 0.010, 1e-12);
  EXPECT_EQ(sample_.buttons, kClutch | kInject);
}

TEST_F(OpenHapticsHandTest, PutsTheForceOnTheHandAndLetsGoWhenNobodyRenewsIt) {
  OpenHapticsHand hand(stand_in());
  eventually([&] {
    hand.write({1.5, 0.0, 0.0});
    return hardware_.force_x_N() == 1.5;
  });
  // A force that is not a number changes nothing; silence releases.
  hand.write({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
  eventually([&] { return hardware_.force_x_N() == 0.0; });
}

TEST_F(OpenHapticsHandTest, IsLostWithTheCableSaysWhyAndANewOneComesBack) {
  {
    OpenHapticsHand hand(stand_in());
    eventually([&] { return hand.write({1.0, 0.0, 0.0}) && hardware_.force_x_N() == 1.0; });
    EXPECT_TRUE(hand.fault().empty());
    hardware_.plug(false);
    eventually([&] { return !read(hand); });
    EXPECT_FALSE(hand.write({1.0, 0.0, 0.0}));
    EXPECT_NE(hand.fault().find("Communication error"), std::string::npos) << hand.fault();
    eventually([&] { return hardware_.force_x_N() == 0.0; });
    // Plugged in again it stays lost, as its forces would be out of step.
    hardware_.plug(true);
    EXPECT_FALSE(read(hand));
  }
  OpenHapticsHand again(stand_in());
  EXPECT_TRUE(read(again));
}

TEST_F(OpenHapticsHandTest, IsLostWhenThePositionIsNotANumber) {
  OpenHapticsHand hand(stand_in());
  eventually([&] { return read(hand); });
  hardware_.place(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0, 0);
  eventually([&] { return !read(hand); });
  EXPECT_NE(hand.fault().find("not a number"), std::string::npos) << hand.fault();
  EXPECT_TRUE(sample_.position_m.eigen().allFinite());
}

TEST_F(OpenHapticsHandTest, IsLostWhenTheDriverFallsSilent) {
  OpenHapticsHand hand(stand_in());
  eventually([&] { return read(hand); });
  hardware_.tick(false);
  eventually([&] { return !hand.read(time_s_ += 0.01, sample_); });
  EXPECT_NE(hand.fault().find("fell silent"), std::string::npos) << hand.fault();
}

TEST_F(OpenHapticsHandTest, SaysWhyItCannotBeOpened) {
  const std::string missing = fault_of({"libNoSuchHaptics.so", {}});
  EXPECT_NE(missing.find("libNoSuchHaptics.so can't be loaded"), std::string::npos) << missing;
  EXPECT_EQ(open_haptics_trouble("libNoSuchHaptics.so"), missing);
  const std::string other = fault_of({"libm.so.6", {}});
  EXPECT_NE(other.find("no entry point hdInitDevice"), std::string::npos) << other;
  const std::string unnamed = fault_of(stand_in("Nobody"));
  EXPECT_NE(unnamed.find("\"Nobody\" (Device fault, 0x0301)"), std::string::npos) << unnamed;
  hardware_.plug(false);
  EXPECT_NE(fault_of(stand_in()).find("the default device"), std::string::npos);
  EXPECT_TRUE(open_haptics_trouble(PELLUCIDA_HDAPI_STAND_IN).empty());
}

}  // namespace
}  // namespace pellucida
