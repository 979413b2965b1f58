// The zona's modulus from a tongue in the holding pipette, on tongues of finer elements with errors of measurement.
#include "pellucida/identification/Aspiration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "pellucida/core/Error.h"
#include "pellucida/fem/AspirationReference.h"

namespace pellucida {
namespace {

TEST(Aspiration, TheModulusComesBackWithinItsError) {
  const CellProfile profile = load_profile("mouse-oocyte");
  constexpr double kTrue_kPa = 40.0;
  // Another thickness and lip than those assumed, and finer elements.
  AspiratedShell truth{
      .outer_radius_um = profile.mid_radius_um + 3.0, .thickness_um = 6.0, .mouth_radius_um = 9.0, .lip_width_um = 2.5};
  AspirationReference reference(truth, 1.0);
  const double tongue_um = reference.rest_tongue_um() + 5.0;
  const double suction_kPa = kTrue_kPa * reference.run(tongue_um).steps.back().suction_ratio;
  struct Errors {
    double suction_ratio, tongue_um, mouth_um, thickness_um;
  };
  double squares = 0.0;
  int count = 0;
  for (const Errors& e : {Errors{1.0, 0.0, 0.0, 0.0}, Errors{1.03, 0.3, -0.2, 0.2}, Errors{0.97, -0.3, 0.3, -0.3}}) {
    const ScaleMeasurement seen{.suction_kPa = suction_kPa * e.suction_ratio,
                                .tongue_um = tongue_um + e.tongue_um,
                                .mouth_radius_um = 9.0 + e.mouth_um,
                                .zona_thickness_um = 6.0 + e.thickness_um};
    const AspiratedModulus modulus = aspirated_modulus(seen, profile);
    const double off = std::log(modulus.modulus_kPa / kTrue_kPa);
    std::printf("%.1f kPa (40), sigma %.1f %%; half-space formula %.1f kPa\n", modulus.modulus_kPa,
                100.0 * modulus.relative_sigma, modulus.half_space_modulus_kPa);
    EXPECT_LT(std::abs(off), 2.0 * modulus.relative_sigma);
    EXPECT_GT(modulus.relative_sigma, 0.05);
    EXPECT_LT(modulus.relative_sigma, 0.3);
    // The formula takes the shell for a half-space.
    EXPECT_LT(modulus.half_space_modulus_kPa, 0.6 * kTrue_kPa);
    squares += off * off;
    ++count;
  }
  EXPECT_LT(std::sqrt(squares / count), 0.15);
}

TEST(Aspiration, FillsInWhatTheScaleNeeds) {
  const CellProfile profile = load_profile("mouse-oocyte");
  const ScaleMeasurement seen{.suction_kPa = 5.0, .tongue_um = 5.0, .mouth_radius_um = 10.0};
  const ScaleMeasurement filled = with_modulus(seen, profile);
  EXPECT_GT(filled.modulus_kPa, 0.0);
  // Unseen thickness is uncertain.
  EXPECT_GT(filled.modulus_sigma_percent, 20.0);
  // A solid is softer than the shell that the springs follow: 0.740 for 0.919 uN at 44 um.
  EXPECT_NEAR(filled.modulus_of_profile_ratio, 1.28, 0.06);
  EXPECT_EQ(with_modulus(filled, profile).modulus_kPa, filled.modulus_kPa);
  const ScaleMeasurement push{.known_force_uN = 1.0, .at_indentation_um = 5.0};
  EXPECT_EQ(with_modulus(push, profile).modulus_kPa, 0.0);
}

TEST(Aspiration, ATongueShorterThanTheCapIsRefused) {
  const CellProfile profile = load_profile("mouse-oocyte");
  EXPECT_THROW(with_modulus({.suction_kPa = 5.0, .tongue_um = 0.2, .mouth_radius_um = 10.0}, profile), UsageError);
}

}  // namespace
}  // namespace pellucida
