#include "Contrast.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pellucida {
namespace {

constexpr double kPixel_um = 0.5;
constexpr int kSide = 240, kMiddle = 120;
constexpr double kRadius_um = 40;

// The light about a ball in the middle of the picture.
cv::Mat1f light_of(const Look::Contrast& look) {
  OpticalPath path;
  path.clear({kSide, kSide});
  add_ball(path, {{kMiddle * kPixel_um, kMiddle * kPixel_um}, kRadius_um, 0.015, 0.0}, kPixel_um);
  cv::Mat1f light;
  Contrast(look, kPixel_um).develop(path, 0.0, light);
  return light;
}

float at(const cv::Mat1f& light, double r_um, double angle) {
  return light(static_cast<int>(std::lround(kMiddle + r_um * std::sin(angle) / kPixel_um)),
               static_cast<int>(std::lround(kMiddle + r_um * std::cos(angle) / kPixel_um)));
}

TEST(Contrast, TheEmptyFieldIsOne) {
  for (const char* kind : {"bright-field", "hoffman", "dic", "phase"}) {
    Look::Contrast look;
    look.kind = kind;
    look.shading_ratio = 0;
    EXPECT_NEAR(light_of(look)(5, 5), 1, 1e-3) << kind;
  }
}

TEST(Contrast, DefocusOrdersDarkAndBright) {
  Look::Contrast look;
  for (const double sign : {1.0, -1.0}) {
    look.defocus_um = sign * 6;
    const cv::Mat1f light = light_of(look);
    // Outside the rim the path bends up, inside it bends down: dark outside for a positive defocus.
    float outside = 1, inside = 1;
    for (double r = kRadius_um - 3; r <= kRadius_um + 3; r += 0.25) {
      const float value = at(light, r, 0.8);
      (r > kRadius_um ? outside : inside) += value - 1;
    }
    EXPECT_LT(sign * (outside - inside), 0);
    EXPECT_GT(light(kMiddle, kMiddle), 0.5);
  }
}

TEST(Contrast, ReliefIsBrightWhereTheLightComesFromAndNothingBesideIt) {
  for (const char* kind : {"hoffman", "dic"})
    for (const double degrees : {0.0, 45.0, 200.0}) {
      Look::Contrast look;
      look.kind = kind;
      look.shear_angle_deg = degrees;
      const cv::Mat1f light = light_of(look);
      const double angle = degrees * CV_PI / 180, r = kRadius_um - 2;
      EXPECT_GT(at(light, r, angle), 1.3) << kind << degrees;
      EXPECT_LT(at(light, r, angle + CV_PI), 0.7) << kind << degrees;
      EXPECT_NEAR(at(light, r, angle + CV_PI / 2), 1, 0.15) << kind << degrees;
    }
}

TEST(Contrast, PhaseHasAHaloOfTheOtherKind) {
  Look::Contrast look;
  look.kind = "phase";
  cv::Mat1f light = light_of(look);
  EXPECT_LT(at(light, kRadius_um - 4, 1), 0.7);
  EXPECT_GT(at(light, kRadius_um + 2, 1), 1.2);
  // Shading off: the middle is nearer to the background than the rim.
  EXPECT_GT(at(light, 0, 0), at(light, kRadius_um - 4, 1));
  look.inverted = true;
  light = light_of(look);
  EXPECT_GT(at(light, kRadius_um - 4, 1), 1.2);
  EXPECT_LT(at(light, kRadius_um + 2, 1), 0.8);
}

TEST(Contrast, SteepGlassLosesItsLight) {
  Look::Contrast look;
  look.defocus_um = 0;
  OpticalPath path;
  path.clear({kSide, kSide});
  add_ball(path, {{60, 60}, kRadius_um, -0.33, 0.0}, kPixel_um);  // an air bubble
  cv::Mat1f light;
  Contrast(look, kPixel_um).develop(path, 0.0, light);
  EXPECT_LT(at(light, 0.9 * kRadius_um, 1), 0.1);
  EXPECT_NEAR(at(light, 0, 0), 1, 0.05);
}

}  // namespace
}  // namespace pellucida
