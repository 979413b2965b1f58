#pragma once
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/simulation/Scenario.h"

namespace pellucida {

/// One granule of the ooplasm: where it lies at rest (OoplasmFlow's coordinates), its size, and how much lighter (or
/// darker, below 0) it is.
struct Granule {
  float ratio, angle, sigma_um, strength;
};

/// Granules spread evenly over a disc, fine and coarse ones, whose sum has about unit deviation. Seeded.
std::vector<Granule> make_granules(double disc_radius_um, double finest_sigma_um, std::uint64_t seed);

/// Adds a granule to `grain` (CV_32F) at a place in px; sigma in px.
void draw_granule(cv::Mat1f& grain, float x_px, float y_px, float sigma_px, float strength) noexcept;

/// Slow mottling at rest: a square of side 2 * `radius_um` about the centre, zero mean, unit deviation. Seeded.
class Mottling {
 public:
  Mottling(double radius_um, std::uint64_t seed);
  /// Value at a rest place relative to the centre, um; 0 outside the square.
  float at(float x_um, float y_um) const noexcept;

 private:
  cv::Mat1f cloud_;
  float origin_um_ = 0.0f, inverse_step_ = 0.0f;
};

/// A particle: a small ring, more or less out of focus.
struct Particle {
  double radius_um, depth, blur_um;
};
/// Multiplies a picture of transmittances (CV_32F, 1 = clear) by a particle at a place in px.
void draw_particle(cv::Mat1f& transmittance, double x_px, double y_px, const Particle& particle, double pixel_size_um);

/// Draws seeded debris that lies about.
void draw_debris(cv::Mat1f& transmittance, int count, double max_radius_um, double pixel_size_um, std::uint64_t seed);

/// A particle on its straight way across a field of view; where it leaves it comes in again on the other side.
struct PassingParticle {
  Particle particle;
  double x_ratio, y_ratio, angle_rad;  ///< place at time 0 as shares of the field, and direction
};
std::vector<PassingParticle> make_passing_particles(int count, double max_radius_um, std::uint64_t seed);
/// Where it is at a time, px.
Eigen::Vector2d passing_place_px(const PassingParticle& particle, const Scenario::Debris& debris, double time_s,
                                 const cv::Size& size, double pixel_size_um);

/// Particles that stick to the membrane: rest angles (rad, from the apex), away from needle and holder. Seeded.
std::vector<double> make_touching_angles(int count, double holder_angle_rad, std::uint64_t seed);
/// The middle of such a particle, in the frame of the section: it sinks in by a fifth of its radius. `angle_rad` (n)
/// the angles of the contour's points, rising.
Eigen::Vector2d touching_place_um(const Contour_um& outer_um, const Eigen::VectorXd& angle_rad, double at_rad,
                                  double radius_um);

}  // namespace pellucida
