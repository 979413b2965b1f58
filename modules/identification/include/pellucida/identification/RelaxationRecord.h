#pragma once
#include <Eigen/Core>
#include <filesystem>

namespace pellucida {

/// A ramp-and-hold record: the cell is pressed in and held. The force before the ramp is subtracted.
struct RelaxationRecord {
  Eigen::VectorXd time_s;          ///< (n) rising
  Eigen::VectorXd height_um;       ///< (n) of the probe; falls as it presses
  Eigen::VectorXd force_uN;        ///< (n) minus the mean before the ramp
  Eigen::Index ramp_begin = 0;     ///< first sample of the ramp; before it the probe rests, free
  Eigen::Index hold_begin = 0;     ///< first sample of the hold; up to the end
  double baseline_uN = 0.0;        ///< what was subtracted
  double baseline_sigma_uN = 0.0;  ///< standard deviation of the samples before the ramp: the sensor's noise
};

/// Reads a CSV file with the columns segment, style, time_s, height_um, force_uN; style is `pause`, `extend` or
/// `retract`, one ramp (`extend`) between two pauses; samples after the hold are ignored. Throws InputError, with file
/// and reason, when a column is missing, a number isn't one, times don't rise, or a part lacks samples.
RelaxationRecord read_relaxation_record(const std::filesystem::path& file);

}  // namespace pellucida
