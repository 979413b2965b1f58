#pragma once
#include "Texture.h"
#include "pellucida/microscopy/OpticalRenderer.h"
#include "pellucida/microscopy/SeededNumbers.h"
#include "pellucida/simulation/Truth.h"

namespace pellucida {

/// The virtual microscope under a look: puts specimen, tools and dish together as a scene, and has it rendered. Of the
/// scenario's keys those of `optics` are not used.
class OpticalScene {
 public:
  /// Throws UsageError as OpticalRenderer.
  OpticalScene(const Scenario& scenario, const Look& look, const VirtualSpecimen& specimen);

  /// The frame, valid until the next call. `truth`, `state` and `stage` belong together.
  ImageView render(const Truth& truth, const SpecimenState& state, const StagePose& stage);
  /// Gives the truth's tools the look's outlines; takes away a holder that is not in view.
  void shape_tools(Truth& truth) const;

 private:
  void place_cell(const Truth& truth, const SpecimenState& state, const StagePose& stage);
  void place_dish(const Truth& truth, const StagePose& stage);

  Scenario scenario_;
  Look look_;
  SpecimenPose rest_pose_;
  Eigen::VectorXd material_angle_rad_;
  std::vector<SceneBall> lying_;      // debris on the glass, fixed in the picture
  std::vector<SceneBall> bystander_;  // places at rest, moved with the stage
  std::vector<double> touching_angle_rad_;
  std::vector<PassingParticle> passing_;
  MicroscopeScene scene_;
  OpticalRenderer renderer_;
};

}  // namespace pellucida
