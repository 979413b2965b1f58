#include "films/FilmManipulator.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "pellucida/simulation/VirtualSpecimen.h"

namespace pellucida::test {
namespace {

constexpr double kScaleSigma = 0.1, kAxesSigma_rad = 5.0 * std::numbers::pi / 180.0, kMostDelay_frames = 1.0;
constexpr double kMostPlay_px = 2.0, kMostPlay_um = 3.0, kNoise_px = 0.1;
constexpr double kMoves_um_per_s = 1e-6;

}  // namespace

FilmManipulator::FilmManipulator(const RandomFilm& film)
    : dice_(17 * film.seed + 3), needle_(film.scenario, VirtualSpecimen(film.scenario)) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const auto& image = film.scenario.image;
  const double scale = std::exp(kScaleSigma * normal(dice_)), turn_rad = kAxesSigma_rad * normal(dice_);
  calibration_ = scale * Eigen::Rotation2Dd(turn_rad).toRotationMatrix();
  delay_s_ = kMostDelay_frames * uniform(dice_) / image.frame_rate_hz;
  play_um_ = uniform(dice_) * std::min(kMostPlay_um, kMostPlay_px * image.pixel_size_um);
  noise_um_ = kNoise_px * image.pixel_size_um;
}

Eigen::Vector2d FilmManipulator::at(double time_s) {
  std::normal_distribution<double> normal;
  const NeedleCommand needle = needle_.at(time_s + delay_s_);
  const Eigen::Vector2d velocity = needle.velocity_um_per_s.eigen().head<2>();
  if (velocity.norm() > kMoves_um_per_s) heading_ = velocity.normalized();
  // The gears run ahead of the tip, by half their play either way.
  const Eigen::Vector2d motor = needle.tip_um.eigen().head<2>() + 0.5 * play_um_ * heading_;
  const Eigen::Vector2d noise(normal(dice_), normal(dice_));
  return calibration_ * motor + noise_um_ * noise;
}

}  // namespace pellucida::test
