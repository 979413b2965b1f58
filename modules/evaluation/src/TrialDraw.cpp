#include "TrialDraw.h"

#include <random>

namespace pellucida {
namespace {

/// Even draws, the same on every machine: the standard's distributions are not.
class Draw {
 public:
  Draw(std::uint64_t seed, std::uint32_t purpose) : random_(words(seed, purpose)) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1.0p-53;
  }

 private:
  static std::mt19937_64 words(std::uint64_t seed, std::uint32_t purpose) {
    std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), purpose};
    return std::mt19937_64(sequence);
  }
  std::mt19937_64 random_;
};

}  // namespace

DrawnOperator draw_operator(std::uint64_t seed, Modality modality) {
  Draw draw(seed, 0x7065726fU);
  DrawnOperator drawn;
  OperatorOptions& options = drawn.options;
  const auto spread = [&](double& value) { value *= draw.between(0.75, 1.25); };
  options.modality = modality;
  options.tremor_rms_m = draw.between(50e-6, 150e-6);
  options.tremor_Hz = draw.between(8.5, 11.5);
  options.visual_delay_s = draw.between(0.19, 0.26);
  options.haptic_delay_s = draw.between(0.11, 0.13);
  for (double* value : {&options.lateral_noise_um, &options.flat_depth_noise_um, &options.space_depth_noise_um,
                        &options.motor_noise_ratio, &options.look_interval_s, &options.fitts_slope_s}) {
    spread(*value);
  }
  for (double* value : {&drawn.arm.mass_kg, &drawn.arm.damping_N_s_per_m, &drawn.arm.stiffness_N_per_m,
                        &drawn.insertion_speed_um_per_s}) {
    spread(*value);
  }
  return drawn;
}

Placement draw_placement(std::uint64_t seed) {
  Draw draw(seed, 0x706c6163U);
  Placement place;
  place.center_x_um = draw.between(-5.0, 5.0);
  place.center_y_um = draw.between(-5.0, 5.0);
  place.turn_deg = draw.between(-20.0, 20.0);
  place.start_back_um = draw.between(20.0, 40.0);
  place.start_across_um = draw.between(-15.0, 15.0);
  place.start_out_um = draw.between(-15.0, 15.0);
  return place;
}

}  // namespace pellucida
