#include "V4l2Exposure.h"

#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <cerrno>
#include <map>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// A driver as the kernel's documentation has it: it refuses a time while it chooses it itself.
struct EmulatedDriver {
  int least = 3, most = 2047, step = 1;
  int automatic_value = V4L2_EXPOSURE_APERTURE_PRIORITY;
  bool has_time = true, has_mode = true, lost = false;
  std::map<unsigned, int> values{{V4L2_CID_EXPOSURE_ABSOLUTE, 250},
                                 {V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_APERTURE_PRIORITY}};

  V4l2Port port() {
    return [this](unsigned long request, void* argument) { return answer(request, argument); };
  }

  int answer(unsigned long request, void* argument) {
    if (lost) return fail(ENODEV);
    if (request == VIDIOC_QUERYCTRL) {
      auto& control = *static_cast<v4l2_queryctrl*>(argument);
      if (control.id == V4L2_CID_EXPOSURE_ABSOLUTE && has_time) {
        control.minimum = least;
        control.maximum = most;
        control.step = step;
        control.flags = values[V4L2_CID_EXPOSURE_AUTO] == V4L2_EXPOSURE_MANUAL ? 0 : V4L2_CTRL_FLAG_INACTIVE;
        return 0;
      }
      return control.id == V4L2_CID_EXPOSURE_AUTO && has_mode ? 0 : fail(EINVAL);
    }
    if (request == VIDIOC_QUERYMENU) {
      const auto index = static_cast<int>(static_cast<v4l2_querymenu*>(argument)->index);
      return index == automatic_value || index == V4L2_EXPOSURE_MANUAL ? 0 : fail(EINVAL);
    }
    auto& control = *static_cast<v4l2_control*>(argument);
    if (request == VIDIOC_G_CTRL) {
      control.value = values.at(control.id);
      return 0;
    }
    if (request != VIDIOC_S_CTRL) return fail(ENOTTY);
    const bool is_time = control.id == V4L2_CID_EXPOSURE_ABSOLUTE;
    if (is_time && has_mode && values[V4L2_CID_EXPOSURE_AUTO] != V4L2_EXPOSURE_MANUAL) return fail(EIO);
    if (is_time && (control.value < least || control.value > most)) return fail(ERANGE);
    if (!is_time && control.value != automatic_value && control.value != V4L2_EXPOSURE_MANUAL) return fail(EINVAL);
    values[control.id] = control.value;
    return 0;
  }

  static int fail(int reason) {
    errno = reason;
    return -1;
  }
};

TEST(V4l2Exposure, ATimeEndsTheAutomaticAndIsHeldToThePeriod) {
  EmulatedDriver driver;
  const auto exposure = find_v4l2_exposure(driver.port(), "v4l2:0", 30.0);
  ASSERT_TRUE(exposure);
  const CameraExposure::State before = exposure->state();
  EXPECT_TRUE(before.automatic);
  EXPECT_TRUE(before.has_automatic);
  EXPECT_NEAR(before.least_ms, 0.3, 1e-9);
  EXPECT_NEAR(before.most_ms, 33.3, 1e-9) << "a period at 30 Hz";
  exposure->set_time_ms(12.34);
  EXPECT_FALSE(exposure->state().automatic);
  EXPECT_NEAR(exposure->state().time_ms, 12.3, 1e-9);
  exposure->set_time_ms(500.0);
  EXPECT_NEAR(exposure->state().time_ms, 33.3, 1e-9);
  exposure->set_time_ms(0.0);
  EXPECT_NEAR(exposure->state().time_ms, 0.3, 1e-9);
  exposure->set_automatic();
  EXPECT_TRUE(exposure->state().automatic);
}

TEST(V4l2Exposure, StepsOfTheDriverAreKept) {
  EmulatedDriver driver;
  driver.least = 10;
  driver.step = 25;
  const auto exposure = find_v4l2_exposure(driver.port(), "v4l2:0", 10.0);
  ASSERT_TRUE(exposure);
  exposure->set_time_ms(5.0);
  EXPECT_EQ((driver.values[V4L2_CID_EXPOSURE_ABSOLUTE] - 10) % 25, 0);
  EXPECT_NEAR(exposure->state().time_ms, 5.0, 1.25);
}

TEST(V4l2Exposure, ADriverThatBeginsAtNoneOffersTheShortestTime) {
  EmulatedDriver driver;
  driver.least = 0;
  const auto exposure = find_v4l2_exposure(driver.port(), "v4l2:0", 30.0);
  ASSERT_TRUE(exposure);
  EXPECT_NEAR(exposure->state().least_ms, 0.1, 1e-9);
  exposure->set_time_ms(0.0);
  EXPECT_NEAR(exposure->state().time_ms, 0.1, 1e-9);
}

TEST(V4l2Exposure, EitherKindOfAutomaticIsFound) {
  EmulatedDriver driver;
  driver.automatic_value = V4L2_EXPOSURE_AUTO;
  const auto exposure = find_v4l2_exposure(driver.port(), "v4l2:0", 30.0);
  ASSERT_TRUE(exposure);
  exposure->set_time_ms(5.0);
  exposure->set_automatic();
  EXPECT_EQ(driver.values[V4L2_CID_EXPOSURE_AUTO], V4L2_EXPOSURE_AUTO);
}

TEST(V4l2Exposure, WhatACameraLacksIsNotOffered) {
  EmulatedDriver driver;
  driver.has_time = false;
  EXPECT_FALSE(find_v4l2_exposure(driver.port(), "v4l2:0", 30.0));
  driver.has_time = true;
  driver.has_mode = false;
  const auto manual = find_v4l2_exposure(driver.port(), "v4l2:0", 30.0);
  ASSERT_TRUE(manual);
  EXPECT_FALSE(manual->state().has_automatic);
  manual->set_time_ms(8.0);
  EXPECT_NEAR(manual->state().time_ms, 8.0, 1e-9);
  EXPECT_THROW(manual->set_automatic(), UsageError);
  EXPECT_FALSE(find_v4l2_exposure(driver.port(), "v4l2:0", 5000.0)) << "the shortest time is longer than a period";
}

TEST(V4l2Exposure, ALostCameraIsADeviceError) {
  EmulatedDriver driver;
  const auto exposure = find_v4l2_exposure(driver.port(), "v4l2:0", 30.0);
  ASSERT_TRUE(exposure);
  driver.lost = true;
  EXPECT_THROW(exposure->state(), DeviceError);
  EXPECT_THROW(exposure->set_time_ms(5.0), DeviceError);
}

}  // namespace
}  // namespace pellucida
