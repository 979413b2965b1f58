#pragma once
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "EdgeProfile.h"
#include "Texture.h"
#include "pellucida/microscopy/OoplasmFlow.h"
#include "pellucida/microscopy/SeededNumbers.h"
#include "pellucida/simulation/Scenario.h"
#include "pellucida/simulation/Truth.h"
#include "pellucida/simulation/VirtualSpecimen.h"

namespace pellucida {

/// Draws a frame of the virtual microscope. Every object is a transmittance: light of the field, multiplied by what
/// debris, cell, holder and needle let through, then blurred by the defocus, then counted with shot and read noise.
/// Edges are functions of the exact signed distance to a contour, so lines are anti-aliased and sub-pixel exact.
class Renderer {
 public:
  Renderer(const Scenario& scenario, const VirtualSpecimen& specimen);

  /// The frame as 8 or 16 bit grey, valid until the next call. `truth`, `state` and `stage` belong together.
  const cv::Mat& render(const Truth& truth, const SpecimenState& state, const StagePose& stage);

 private:
  void draw_cell(const Truth& truth, const SpecimenState& state);
  void draw_bystanders(const StagePose& stage);
  void draw_particles(const SpecimenState& state, double time_s);
  void draw_holder(const HolderPose& holder, const Eigen::Vector2d& center_um);
  void draw_droplets(const Truth& truth);
  void draw_needle(const NeedlePose& needle, double out_of_plane_um);
  void draw_grain(const Eigen::Vector2d& map_center_um, const cv::Rect& window);
  template <class Pixel>
  void count_light(long frame_index, float lamp);

  Scenario scenario_;
  HolderRim rim_;
  SpecimenPose rest_pose_, pose_;       // at rest, and in the frame being drawn
  Eigen::VectorXd material_angle_rad_;  // of the section's points, from that of the material under the needle
  Eigen::VectorXd section_angle_rad_;   // the same in the frame being drawn, from the section's axis
  double inner_radius_um_;
  double needle_edge_out_of_plane_um_ = 0.0;  // the needle's place that its edge is made for
  EdgeProfile outer_edge_, inner_edge_, ooplasm_edge_, ooplasm_weight_, holder_edge_, needle_edge_, bubble_edge_,
      droplet_edge_;
  OoplasmFlow flow_;
  std::vector<Granule> granules_;
  Mottling mottling_;
  std::vector<double> touching_angle_rad_;
  std::vector<PassingParticle> passing_;
  NoiseBank noise_;
  cv::Mat1f background_;  // ratio of full scale
  cv::Mat1f light_;       // the frame being drawn
  cv::Mat1f outer_distance_um_, inner_distance_um_, ooplasm_distance_um_, grain_;
  std::vector<float> counted_;  // a row of light with its noise
  cv::Mat frame_;
};

}  // namespace pellucida
